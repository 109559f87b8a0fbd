// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/registry.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>

#include "experiments/program/built_with.h"
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

#define DECLARE_ENGINE(name) void add_##name(MethodList& list);
TOUCHSTONE_ENGINES(DECLARE_ENGINE)
#define ADD_ENGINE(name) add_##name(list);

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
    TOUCHSTONE_ENGINES(ADD_ENGINE)
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

std::vector<const Method*> Selection::methods() const {
  std::vector<const Method*> added, all;
  for (const std::string& engine : engines) added.push_back(&add_engine(engine_of(engine)));
  all = find_methods(names);
  for (const Method* engine : added)
    if (std::ranges::find(all, engine) == all.end()) all.push_back(engine);
  return all;
}

std::string Selection::text() const {
  std::string text;
  for (const Method* method : methods()) text.append(text.empty() ? "" : ",").append(method->name());
  return text;
}

program::Option declare_engines(program::Command& command, std::vector<std::string>& engines,
                                const std::string& about) {
  return command.texts("--engine", engines, about, program::readable_by(engine_of)).takes("COMMAND");
}

program::Option declare_methods(program::Command& command, Selection& selection, const std::string& about) {
  program::Option option = program::declare_methods(command, selection.names, about);
  declare_engines(command, selection.engines).replaces_default_of("--methods");
  return option;
}

void declare_compared_methods(program::Command& command, Selection& selection) {
  declare_methods(command, selection).changes_results([&selection] { return selection.text(); });
}

}  // namespace touchstone::methods
