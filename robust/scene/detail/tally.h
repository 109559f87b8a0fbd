// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/scene/counts.h"

namespace touchstone::scene {

/// Counts nothing, at no cost: stands in for Tally.
struct NoTally {
  void ask(std::size_t, std::size_t) const {}
  [[nodiscard]] static bool answered() { return false; }
};

/// Counts the outcomes of the faces of one query.
class Tally {
 public:
  explicit Tally(FaceCounts& counts) : counts_(counts) {}

  /// Registers `faces` faces with `edges` edges in total. Each counts as culled by a box until `meet` or `pass` reports
  /// otherwise.
  void ask(std::size_t faces, std::size_t edges) {
    at(CullOutcome::Box) += faces;
    counts_.edges_ += edges;
  }
  /// Reports a face that was tested.
  void meet(CullOutcome outcome, filtered::Stage slowest, std::size_t edges_looked_at) {
    --at(CullOutcome::Box);
    ++at(outcome);
    ++counts_.stages_[static_cast<std::size_t>(slowest)];
    counts_.edges_looked_at_ += edges_looked_at;
  }
  /// Reports a face that no box misses, but that was not tested because the answer was known.
  void pass() {
    --at(CullOutcome::Box);
    ++at(CullOutcome::Known);
  }

  /// Records that some face is touched, by walks for which that is the answer.
  void answer() { answered_ = true; }
  [[nodiscard]] bool answered() const { return answered_; }

 private:
  std::uint64_t& at(CullOutcome outcome) { return counts_.outcomes_[static_cast<std::size_t>(outcome)]; }

  FaceCounts& counts_;
  bool answered_ = false;
};

}  // namespace touchstone::scene
