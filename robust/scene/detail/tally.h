// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "robust/scene/counts.h"

namespace touchstone::scene {

/// Counts nothing, at no cost.
struct NoTally {
  void ask(std::size_t, std::size_t) const {}
  [[nodiscard]] static bool answered() { return false; }
};

/// Counts what becomes of the faces of one question.
class Tally {
 public:
  explicit Tally(FaceCounts& counts) : counts_(counts) {}

  /// Faces, with so many edges, that are missed by a box unless `meet` or `pass` is told of them.
  void ask(std::size_t faces, std::size_t edges) {
    at(CullOutcome::Box) += faces;
    counts_.edges_ += edges;
  }
  /// A face that was tested.
  void meet(CullOutcome outcome, filtered::Stage slowest, std::size_t edges_looked_at) {
    --at(CullOutcome::Box);
    ++at(outcome);
    ++counts_.stages_[static_cast<std::size_t>(slowest)];
    counts_.edges_looked_at_ += edges_looked_at;
  }
  /// A face that no box misses, after the answer.
  void pass() {
    --at(CullOutcome::Box);
    ++at(CullOutcome::Known);
  }

  /// Is it known that some face is touched? Told by those who need no more.
  void answer() { answered_ = true; }
  [[nodiscard]] bool answered() const { return answered_; }

 private:
  std::uint64_t& at(CullOutcome outcome) { return counts_.outcomes_[static_cast<std::size_t>(outcome)]; }

  FaceCounts& counts_;
  bool answered_ = false;
};

}  // namespace touchstone::scene
