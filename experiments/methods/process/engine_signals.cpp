// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/process/engine_signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "experiments/run/stop_signal.h"

namespace touchstone::methods {
namespace {

std::atomic<bool> is_writing = false, is_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "used within a signal handler");

[[noreturn]] void leave() {
  constexpr std::string_view message = "touchstone: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(run::kInterrupted);
}

extern "C" void interrupt_judge(int) {
  run::handle_end_signals(SIG_DFL);
  is_interrupted = true;
  if (!is_writing) leave();
}

}  // namespace

KillEngineOnSignal::KillEngineOnSignal() { run::handle_end_signals(interrupt_judge); }

KillEngineOnSignal::~KillEngineOnSignal() { run::handle_end_signals(SIG_DFL); }

DeferSignals::DeferSignals() { is_writing = true; }

DeferSignals::~DeferSignals() {
  is_writing = false;
  if (is_interrupted) leave();
}

}  // namespace touchstone::methods
