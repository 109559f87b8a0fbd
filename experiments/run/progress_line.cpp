// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/progress_line.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace touchstone::run {

ProgressLine::ProgressLine(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), shown_(isatty(STDERR_FILENO) == 1), begin_(Clock::now()), last_(begin_) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::operator()(std::uint64_t done) {
  constexpr std::chrono::milliseconds kInterval(200);
  const auto now = Clock::now();
  if (!shown_ || now - last_ < kInterval) return;
  last_ = now;
  const double share = static_cast<double>(done) / static_cast<double>(total_);
  const double spent = std::chrono::duration<double>(now - begin_).count();
  fmt::print(stderr, "\r{}: {:.0f} %, {:.0f} s left \033[K", what_, 100 * share, spent / share - spent);
  std::fflush(stderr);
}

}  // namespace touchstone::run
