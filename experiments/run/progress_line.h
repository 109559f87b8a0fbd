// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace touchstone::run {

/// One line on standard error, if that is a terminal: what is being done, percentage and time left; wiped at the end.
class ProgressLine {
 public:
  ProgressLine(std::string what, std::uint64_t total);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void operator()(std::uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool shown_;
  Clock::time_point begin_, last_;
};

}  // namespace touchstone::run
