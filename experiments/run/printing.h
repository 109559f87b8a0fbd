// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/run/command.h"
#include "experiments/run/table.h"

namespace touchstone::run {

/// Flushes standard output: at the end of every command, and before others write there or to standard error.
///
/// Throws std::runtime_error, `standard output: cannot be written: No space left on device`, if that fails or if any
/// earlier output failed. The error persists: once output is lost, the rest is incomplete.
void flush_standard_output();

/// Throws std::runtime_error, worded likewise, if standard output is closed or full, so that a command need not compute
/// what it cannot print. A pipe without a reader is not noticed.
void require_standard_output();

/// Returns the message of an exception that ended a command. `fmt::print` does not name the file; this names standard
/// output.
[[nodiscard]] std::string message_of(const std::exception& error);

/// The output of a command: its text or, with --json, its tables or, with --quiet, nothing.
struct Printing {
  bool json = false, quiet = false;
  std::vector<TableDescription> tables;  ///< that the run writes; set by the command before it runs

  [[nodiscard]] bool prints_text() const { return !json && !quiet; }
  /// Prints the result of a run whose tables lie in the folder, and flushes standard output. Throws as tables_json and
  /// flush_standard_output do.
  void print(const std::string& text, const std::filesystem::path& folder) const;
  /// The same for a run that keeps no tables unless asked: with --json, write(folder) writes them to a folder that
  /// exists until then. Throws what `write` throws, too.
  void print(const std::string& text, const std::function<void(const std::filesystem::path&)>& write) const;
};

/// Declares --quiet and --json, after the other options.
void declare_printing(Command& command, Printing& printing);

}  // namespace touchstone::run
