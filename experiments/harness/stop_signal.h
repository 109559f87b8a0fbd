// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace touchstone::harness {

/// While an object of this class exists, the first SIGINT or SIGTERM (with which `mpirun` ends its processes) only sets
/// `requested`; a second one ends the process as usual. At most one may exist.
class StopSignal {
 public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  [[nodiscard]] const std::atomic<bool>& requested() const;
};

/// The exit status of an interrupted run.
inline constexpr int kInterrupted = 130;

}  // namespace touchstone::harness
