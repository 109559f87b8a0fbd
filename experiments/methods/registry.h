// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/process/engine.h"
#include "experiments/program/command.h"

namespace touchstone::methods {

/// Adds the methods of a room above this one, which all_methods has before the engines. Call it at the start of the
/// program: throws std::logic_error if anything has asked for a method, because nobody would then see them.
void add_methods(void (*add)(MethodList& list));

/// Returns every method of this build, in the order of `touchstone methods`.
[[nodiscard]] const MethodList& all_methods();

/// Returns the method of that name, one of this build or an engine that add_engine has added, or nullptr.
[[nodiscard]] const Method* find_method(std::string_view name);

/// Adds an engine as a method, which lasts until the program ends, and returns it; the same engine is added once.
/// Throws std::invalid_argument, which names the engine, if its name is that of another method or engine, or has
/// control bytes.
const Method& add_engine(const Engine& engine);

/// Returns the methods of these names, in this order; `all` selects every method of this build. Throws
/// std::invalid_argument, which names the first unknown one.
[[nodiscard]] std::vector<const Method*> find_methods(const std::vector<std::string>& names);

/// The methods that a command line selects: those of this program by their names, and engines of the user.
struct Selection {
  std::vector<std::string> names;
  std::vector<std::string> engines{};  ///< each as engine_of reads it

  /// Returns the named methods, then the engines, each once and in their order. A name may be that of an engine. Throws
  /// as find_methods and add_engine do.
  [[nodiscard]] std::vector<const Method*> methods() const;
  /// Returns the names of these methods, joined by commas, for the comparison of runs. Throws likewise.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool empty() const { return names.empty() && engines.empty(); }
};

/// Declares the option --engine, which may be repeated.
program::Option declare_engines(program::Command& command, std::vector<std::string>& engines,
                                const std::string& about =
                                    "An engine of yours, asked like a method: COMMAND or "
                                    "COMMAND=NAME; may be repeated");

/// Declares --methods and --engine. If only engines are given, they replace the default methods. Returns the option
/// --methods.
program::Option declare_methods(program::Command& command, Selection& selection,
                                const std::string& about = "Methods, separated by commas: names, or all");

/// The same for a study: both options change results.
void declare_compared_methods(program::Command& command, Selection& selection);

}  // namespace touchstone::methods
