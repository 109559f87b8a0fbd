// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/counts.h"

#include <numeric>

namespace touchstone::scene {

std::string_view to_string(CullOutcome outcome) {
  constexpr std::array<std::string_view, kCullOutcomes> words{"box", "known", "slab", "foot", "edges", "touched"};
  return words[static_cast<std::size_t>(outcome)];
}

std::uint64_t FaceCounts::faces() const {
  return std::accumulate(outcomes_.begin(), outcomes_.end(), std::uint64_t{0});
}

FaceCounts& FaceCounts::operator+=(const FaceCounts& other) {
  for (std::size_t i = 0; i < kCullOutcomes; ++i) outcomes_[i] += other.outcomes_[i];
  for (std::size_t i = 0; i < stages_.size(); ++i) stages_[i] += other.stages_[i];
  edges_ += other.edges_;
  edges_looked_at_ += other.edges_looked_at_;
  return *this;
}

}  // namespace touchstone::scene
