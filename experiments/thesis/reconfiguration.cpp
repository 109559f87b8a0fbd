// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/reconfiguration.h"

#include <algorithm>
#include <array>
#include <utility>

namespace touchstone::thesis_figures {

using namespace kinematics;

std::string_view word(Outcome outcome) {
  constexpr std::array<std::string_view, 6> words{"from the side", "from above",     "out of reach",
                                                  "joint limit",   "in the way", "no contact"};
  return words[static_cast<std::size_t>(outcome)];
}

Outcome outcome_of(const Rehearsal& rehearsal) {
  if (rehearsal.complete()) {
    const auto contact = std::ranges::find(rehearsal.moves, Until::Contact, &Move::until);
    return contact->joint == kBase ? Outcome::FromSide : Outcome::FromAbove;
  }
  constexpr std::array<std::pair<std::string_view, Outcome>, 3> reasons{{{"out of reach", Outcome::OutOfReach},
                                                                         {"beyond its limits", Outcome::JointLimit},
                                                                         {"the sphere touches the", Outcome::InTheWay}}};
  const std::string_view all = rehearsal.failure;
  const std::size_t last = all.find("; from the side");
  for (const auto& [words, outcome] : reasons)
    if (all.find(words, last == std::string_view::npos ? 0 : last) != std::string_view::npos) return outcome;
  return Outcome::Nothing;
}

Place try_place(const Layout& layout, double angle, double radius, double height) {
  const Rehearsal rehearsal = rehearse(layout, {kStorageHome + angle, radius, height});
  return {angle, radius, height, outcome_of(rehearsal), rehearsal.failure};
}

Run longest_run(const std::vector<Place>& places) {
  Run best{1, 0};
  for (std::size_t i = 0; i < places.size();) {
    std::size_t end = i;
    while (end < places.size() && completes(places[end].outcome)) ++end;
    if (end > i && (best.first > best.last || end - i > best.last - best.first + 1)) best = {i, end - 1};
    i = std::max(end, i + 1);
  }
  return best;
}

}  // namespace touchstone::thesis_figures
