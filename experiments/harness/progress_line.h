// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace touchstone::harness {

/// What the line says after `seconds` of work that led from `before` to `done` of `total` things: the share of the
/// whole that is done, and the time left at this pace. What was done before does not count for the pace.
[[nodiscard]] std::string progress_text(const std::string& what, std::uint64_t before, std::uint64_t done,
                                        std::uint64_t total, double seconds);

/// One line on standard error, if that is a terminal: what is being done, percentage and time left; wiped at the end.
class ProgressLine {
 public:
  /// `before`: things that an earlier run has done.
  ProgressLine(std::string what, std::uint64_t total, std::uint64_t before = 0);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// `done`: of all, those of an earlier run included.
  void operator()(std::uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_, before_;
  bool shown_;
  Clock::time_point begin_, last_;
};

}  // namespace touchstone::harness
