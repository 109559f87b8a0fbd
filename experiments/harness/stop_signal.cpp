// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/stop_signal.h"

#include <csignal>

namespace touchstone::harness {
namespace {

std::atomic<bool> requested_once = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

constexpr int kSignals[] = {SIGINT, SIGTERM};

extern "C" void request(int) {
  requested_once = true;
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
}

}  // namespace

StopSignal::StopSignal() {
  requested_once = false;
  for (const int signal : kSignals) std::signal(signal, request);
}

StopSignal::~StopSignal() {
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
}

const std::atomic<bool>& StopSignal::requested() const { return requested_once; }

}  // namespace touchstone::harness
