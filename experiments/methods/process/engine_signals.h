// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchstone::methods {

/// While an object of this class exists, the first of run::kEndSignals that is not ignored ends this process with
/// run::kInterrupted, except during a DeferSignals. A second signal ends the process as usual. Engines end with
/// this process (see Supervisor). At most one may exist.
///
/// The handler does not wait until the judge checks a flag: the judge may block for any time while it reads from a
/// terminal or an engine.
class KillEngineOnSignal {
 public:
  KillEngineOnSignal();
  KillEngineOnSignal(const KillEngineOnSignal&) = delete;
  KillEngineOnSignal& operator=(const KillEngineOnSignal&) = delete;
  ~KillEngineOnSignal();
};

/// While an object of this class exists, signals are deferred, so that output is complete. For one thread only.
class DeferSignals {
 public:
  DeferSignals();
  DeferSignals(const DeferSignals&) = delete;
  DeferSignals& operator=(const DeferSignals&) = delete;
  ~DeferSignals();
};

}  // namespace touchstone::methods
