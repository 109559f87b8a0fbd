// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/wait_for_events.h"

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace touchstone::methods {

bool wait_for_events(std::span<pollfd> events, int milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::milliseconds(milliseconds);
  for (int left = milliseconds;;) {
    const int found = poll(events.data(), events.size(), left);
    if (found >= 0 || errno != EINTR) return found > 0;
    if (milliseconds < 0) continue;
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    left = std::max(0, static_cast<int>(rest.count()));
  }
}

}  // namespace touchstone::methods
