// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/registry.h"

#include <map>
#include <mutex>
#include <stdexcept>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/engines/engines.h"
#include "experiments/methods/process/external_method.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::methods {

const std::vector<std::unique_ptr<Method>>& all_methods() {
  static const std::vector<std::unique_ptr<Method>> methods = [] {
    std::vector<std::unique_ptr<Method>> list;
    add_exact(list);
    add_filtered(list);
    add_fast(list);
    add_fast_double_double(list);
    add_fast_mpfr(list);
    add_interval(list);
    add_rational(list);
    add_cgal_kernels(list);
    add_thesis(list);
    add_engines(list);
    return list;
  }();
  return methods;
}

namespace {

constexpr std::string_view kExternal = "exec:";

const Method* find_external(const std::string& name) {
  const std::string command = name.substr(kExternal.size());
  if (io::all_legible(name) != name)
    throw std::invalid_argument(io::legible(name) + ": is not printable text in UTF-8");
  if (command.find_first_not_of(' ') == std::string::npos) throw std::invalid_argument(name + ": the command is empty");
  if (command.find_first_of(",\"") != std::string::npos)
    throw std::invalid_argument(name + ": a command in a list of methods has no comma and no \"; use a script");
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Method>> found;
  const std::lock_guard lock(mutex);
  auto& method = found[name];
  if (!method) method = external_method(name, "an external program", command);
  return method.get();
}

}  // namespace

const Method* find_method(std::string_view name) {
  if (name.starts_with(kExternal)) return find_external(std::string(name));
  for (const auto& method : all_methods())
    if (method->name() == name) return method.get();
  return nullptr;
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

std::string selected_names(const std::vector<std::string>& names) {
  std::string selected;
  for (const Method* method : find_methods(names)) selected.append(selected.empty() ? "" : ",").append(method->name());
  return selected;
}

}  // namespace touchstone::methods
