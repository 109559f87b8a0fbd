// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchstone::methods {

/// While one exists, the first SIGINT or SIGTERM ends this process with harness::kInterrupted, though not within a
/// Writing. A second one ends it as ever. Engines end with this process (see Supervisor). One at a time.
///
/// It does not wait for the judge to look: that may be reading, from a terminal or an engine, for as long as they like.
class KillEngineOnSignal {
 public:
  KillEngineOnSignal();
  KillEngineOnSignal(const KillEngineOnSignal&) = delete;
  KillEngineOnSignal& operator=(const KillEngineOnSignal&) = delete;
  ~KillEngineOnSignal();
};

/// While one exists, an interruption waits, so that what is written is whole. On one thread only.
class DeferSignals {
 public:
  DeferSignals();
  DeferSignals(const DeferSignals&) = delete;
  DeferSignals& operator=(const DeferSignals&) = delete;
  ~DeferSignals();
};

/// Leaves interruptions to the other threads, of which one writes.
void leave_signals_to_other_threads();

}  // namespace touchstone::methods
