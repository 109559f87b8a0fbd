// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

namespace touchstone::program {

enum class Colour { Red, Green, Bold };

/// Returns whether output may be coloured: the stream is a terminal, the environment variable NO_COLOR is missing or
/// empty (no-color.org), and TERM is not `dumb`.
[[nodiscard]] bool takes_colours(std::FILE* stream);

/// Returns the text in that colour if the stream takes colours, else the text.
[[nodiscard]] std::string coloured(const std::string& text, Colour colour, std::FILE* stream);

/// Returns the text of the line after `seconds` of work, which finished `done` items of `total`: the share that is done,
/// and the time left at this pace.
[[nodiscard]] std::string progress_text(const std::string& what, std::uint64_t done, std::uint64_t total,
                                        double seconds);

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
