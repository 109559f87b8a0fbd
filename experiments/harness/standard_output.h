// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

namespace touchstone::harness {

/// Writes what standard output still holds back: at the end of every command, and before others write there or to
/// standard error.
///
/// Throws std::runtime_error, `standard output: cannot be written: No space left on device`, where that fails, and
/// where anything failed that was printed before. The error stays: once lost, output is not whole again.
void flush_standard_output();

/// What an exception that ended a command says. `fmt::print` names no file; this names standard output.
[[nodiscard]] std::string message_of(const std::exception& error);

}  // namespace touchstone::harness
