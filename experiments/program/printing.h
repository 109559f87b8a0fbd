// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

namespace touchstone::program {

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

/// Prints the text unless the command is to be quiet, and flushes standard output.
void print_result(const std::string& text, bool quiet);

}  // namespace touchstone::program
