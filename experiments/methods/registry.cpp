// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/registry.h"

#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>

#include "geometry/io/detail/legible.h"

namespace touchstone::methods {

namespace {

struct Added {
  std::vector<void (*)(MethodList& list)> functions;
  bool called = false;
};

Added& added() {
  static Added added;
  return added;
}

}  // namespace

void add_methods(void (*add)(MethodList& list)) {
  if (added().called) throw std::logic_error("methods are added after one was asked for");
  added().functions.push_back(add);
}

const MethodList& all_methods() {
  static const MethodList methods = [] {
    MethodList list;
    add_exact(list);
    add_filtered(list);
    add_fast(list);
    add_fast_wide(list);
    add_plain(list);
    add_cgal_kernels(list);
    add_thesis(list);
    for (const auto add : added().functions) add(list);
    added().called = true;
    add_engines(list);
    return list;
  }();
  return methods;
}

namespace {

/// The engines of the user, by name.
struct Engines {
  struct Added {
    std::string command;
    std::unique_ptr<Method> method;
  };
  std::mutex mutex;
  std::map<std::string, Added, std::less<>> added;
};

Engines& engines() {
  static Engines engines;
  return engines;
}

}  // namespace

const Method* find_method(std::string_view name) {
  for (const auto& method : all_methods())
    if (method->name() == name) return method.get();
  const std::lock_guard lock(engines().mutex);
  const auto engine = engines().added.find(name);
  return engine == engines().added.end() ? nullptr : engine->second.method.get();
}

const Method& add_engine(const Engine& engine) {
  const auto refuse = [&](const char* reason) {
    throw std::invalid_argument("engine " + io::legible(engine.command) + ": " + io::legible(engine.name) + reason +
                                "; COMMAND=NAME gives another name");
  };
  if (io::all_legible(engine.name) != engine.name) refuse(" has control characters");
  for (const auto& method : all_methods())
    if (method->name() == engine.name || engine.name == "all") refuse(" is the name of a method of this program");
  const std::lock_guard lock(engines().mutex);
  auto& [command, method] = engines().added[engine.name];
  if (method && command != engine.command) refuse(" is the name of another engine");
  command = engine.command;
  if (!method) method = external_method(engine.name, "an engine: " + engine.command, engine.command);
  return *method;
}

std::vector<const Method*> find_methods(const std::vector<std::string>& names) {
  std::vector<const Method*> found;
  for (const std::string& name : names) {
    if (name == "all")
      for (const auto& method : all_methods()) found.push_back(method.get());
    else if (const Method* method = find_method(name))
      found.push_back(method);
    else
      throw std::invalid_argument("there is no method \"" + name + "\"; `touchstone methods` lists them");
  }
  return found;
}

}  // namespace touchstone::methods
