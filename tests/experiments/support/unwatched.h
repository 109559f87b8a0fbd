// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "experiments/program/sweep.h"

/// The control of a run in one process that is never stopped and shows no progress.
namespace touchstone::run_tests {

inline const std::atomic<bool> kNeverStop = false;
inline const program::Progress kSilent = [](std::uint64_t) {};

}  // namespace touchstone::run_tests
