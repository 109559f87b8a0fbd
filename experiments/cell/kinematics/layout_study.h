// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/kinematics/rehearsal.h"
#include "experiments/cell/kinematics/solve_layout.h"

/// What `touchstone cell layout` computes: the layouts in which the captioned angles come out, the one that is chosen,
/// and what that one predicts.
namespace touchstone::kinematics {

/// A home pose of the family and its layout.
struct Member {
  Coupling coupling;
  LinkAngles home;
  std::optional<Layout> layout;  ///< none where there is no solution
  std::string failure;           ///< why the captions do not come out; empty where they do
};

/// A chosen value, and how far it may be changed, all others kept, while the captions of both cases come out.
struct Choice {
  std::string name, unit;
  double value, lowest, highest;
};

/// A storage somewhere, and what comes out there.
struct Prediction {
  std::size_t place;  ///< whose radius it has: 0 or 1, as in Layout
  double angle, height;
  Rehearsal rehearsal;
};

struct LayoutStudy {
  std::vector<Member> grid;        ///< leans and elevations by 5 degrees
  std::vector<Member> one_height;  ///< elevations by 1 degree: those with one height of the storage in both cases
  Layout chosen;
  std::vector<Rehearsal> cases;  ///< in the chosen layout
  std::vector<Choice> choices;
  std::vector<Prediction> angles;   ///< every whole angle from -60 to 60, both places
  std::vector<Prediction> heights;  ///< both cases' storage raised and lowered by 10 mm and more
};

/// Told how much of `layout_work` is done.
using LayoutProgress = std::function<void(std::uint64_t done)>;
[[nodiscard]] std::uint64_t layout_work();

/// Nothing where it was stopped. Cost: some 10 s.
[[nodiscard]] std::optional<LayoutStudy> study_layout(const std::atomic<bool>& stop, const LayoutProgress& progress);

}  // namespace touchstone::kinematics
