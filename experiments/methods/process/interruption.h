// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace touchstone::methods {

/// While one exists, the first SIGINT or SIGTERM ends this process with harness::kInterrupted, though not within a
/// Writing. A second one ends it as ever. Engines end with this process (see Supervisor). One at a time.
///
/// It does not wait for the judge to look: that may be reading, from a terminal or an engine, for as long as they like.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();
};

/// While one exists, an interruption waits, so that what is written is whole. On one thread only.
class Writing {
 public:
  Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
  ~Writing();
};

/// Leaves interruptions to the other threads, of which one writes.
void leave_interruptions_to_others();

}  // namespace touchstone::methods
