// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/selection.h"

#include <algorithm>
#include <exception>

#include "experiments/methods/registry.h"

namespace touchstone::methods {
namespace {

/// Returns the fault of a text that should be an engine.
std::string engine_fault(const std::string& text) {
  try {
    (void)engine_of(text);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

std::vector<const cases::Method*> Selection::methods() const {
  std::vector<const cases::Method*> added, all;
  for (const std::string& engine : engines) added.push_back(&add_engine(engine_of(engine)));
  all = find_methods(names);
  for (const cases::Method* engine : added)
    if (std::ranges::find(all, engine) == all.end()) all.push_back(engine);
  return all;
}

std::string Selection::text() const {
  std::string text;
  for (const cases::Method* method : methods()) text.append(text.empty() ? "" : ",").append(method->name());
  return text;
}

program::Option declare_engines(program::Command& command, std::vector<std::string>& engines,
                                const std::string& about) {
  return command.texts("--engine", engines, about, engine_fault).takes("COMMAND");
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
