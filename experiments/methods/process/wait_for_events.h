// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>

#include <span>

namespace touchstone::methods {

/// Waits for one of the events, at most `milliseconds` (-1: forever), as poll does; a signal does not end the wait.
/// Returns whether an event occurred.
[[nodiscard]] bool wait_for_events(std::span<pollfd> events, int milliseconds);

}  // namespace touchstone::methods
