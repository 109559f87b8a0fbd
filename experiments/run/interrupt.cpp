// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/interrupt.h"

#include <csignal>

namespace touchstone::run {
namespace {

std::atomic<bool> requested_once = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

extern "C" void request(int) {
  requested_once = true;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interrupt::Interrupt() {
  requested_once = false;
  std::signal(SIGINT, request);
}

Interrupt::~Interrupt() { std::signal(SIGINT, SIG_DFL); }

const std::atomic<bool>& Interrupt::requested() const { return requested_once; }

}  // namespace touchstone::run
