// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cell/kinematics/simulated_path.h"
#include "experiments/thesis/flowchart.h"
#include "geometry/contact/answer.h"

namespace touchstone::thesis_figures {

/// The state of the arm after a move of a case study.
struct Moment {
  std::string name;              ///< `case 1, home`, `case 1, move 2`
  kinematics::Angles commanded;  ///< of every joint
  bool gripped;                  ///< whether the hand carries the material
  Eigen::Vector3d sphere;        ///< its centre in the cell
};

/// The end of a move that stops at contact: the touched face, tested at the stop and one step before.
struct Stop {
  std::size_t move;
  std::size_t face;  ///< of the material: 0 underside, 1 upper face, 2 towards the base, 3 away, 4 and 5 clockwise
                     ///< and counter-clockwise round the base
  Answer at, before;
  Eigen::Vector3d center_at, center_first,
      center_before;              ///< the sphere's, at the stop, at first contact, a step before
  bool thesis_at, thesis_before;  ///< whether the thesis's method finds contact with any face
};
/// Describes the face in a few words.
[[nodiscard]] std::string face_words(std::size_t face);

/// One of the two case studies of chapter 6.
struct CaseStudy {
  kinematics::Station storage;
  kinematics::SimulatedPath path;
  std::vector<Moment> moments;  ///< home, then after each move
  std::vector<Stop> stops;
  std::uint64_t asked = 0;                             ///< pairs of ball and face, at every degree of every move
  std::array<std::uint64_t, kMethods.size()> wrong{};  ///< wrong answers of each method
};

/// Studies case 0 or 1 in a layout. If the simulation fails, there are no moves.
[[nodiscard]] CaseStudy study_case(const kinematics::Layout& layout, std::size_t number);

}  // namespace touchstone::thesis_figures
