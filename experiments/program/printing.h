// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

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

/// Returns the number with its noun: `1 ball`, `2 balls`.
[[nodiscard]] inline std::string counted(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

enum class Colour { Red, Green, Bold };

/// Returns whether output may be coloured: the stream is a terminal, the environment variable NO_COLOR is missing or
/// empty (no-color.org), and TERM is not `dumb`.
[[nodiscard]] bool takes_colours(std::FILE* stream);

/// Returns the text in that colour if the stream takes colours, else the text.
[[nodiscard]] std::string coloured(const std::string& text, Colour colour, std::FILE* stream);

/// A line on standard error, if that is a terminal: the task, percentage and time left. The line is erased at the end.
class ProgressLine {
 public:
  /// `wanted`: whether there is a line at all.
  ProgressLine(std::string what, std::uint64_t total, bool wanted = true);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// `done`: the finished items.
  void operator()(std::uint64_t done);
  /// Erases the line, before another is printed to standard error.
  void erase() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool shown_;
  Clock::time_point begin_, last_;
};

}  // namespace touchstone::program
