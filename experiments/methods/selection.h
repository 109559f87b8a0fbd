// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/program/command.h"

namespace touchstone::methods {

/// The methods that a command line selects: those of this program by their names, and engines of the user.
struct Selection {
  std::vector<std::string> names;
  std::vector<std::string> engines{};  ///< each as engine_of reads it

  /// Returns the named methods, then the engines, each once and in their order. A name may be that of an engine. Throws
  /// as find_methods and add_engine do.
  [[nodiscard]] std::vector<const cases::Method*> methods() const;
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
