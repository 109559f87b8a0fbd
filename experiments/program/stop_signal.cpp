// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/stop_signal.h"

namespace touchstone::program {
namespace {

std::atomic<bool> requested_once = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

extern "C" void request(int) {
  requested_once = true;
  handle_end_signals(SIG_DFL);
}

}  // namespace

void handle_end_signals(void (*handler)(int)) {
  for (const int signal : kEndSignals) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) std::signal(signal, handler);
  }
}

StopSignal::StopSignal() {
  requested_once = false;
  handle_end_signals(request);
}

StopSignal::~StopSignal() { handle_end_signals(SIG_DFL); }

const std::atomic<bool>& StopSignal::requested() const { return requested_once; }

}  // namespace touchstone::program
