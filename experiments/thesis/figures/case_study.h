// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiments/thesis/cell/browser/recording.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/figures/flowchart.h"
#include "geometry/contact/answer.h"

namespace touchstone::figures {

/// The cell after a move of a case study.
struct Moment {
  std::string name;  ///< `case 1, home`, `case 1, move 2`
  std::size_t stop;  ///< of the process
};

/// The end of a move that stops at contact: the touched face, tested at the stop and one step before.
struct Stop {
  std::size_t move;
  std::string face;  ///< of the material, in words: `upper face`, `counter-clockwise side`, ...
  Answer at, before;
  Eigen::Vector3d center_at, center_first,
      center_before;              ///< the sphere's, at the stop, at first contact, a step before
  bool thesis_at, thesis_before;  ///< whether the thesis's method finds contact with any face
};

/// One of the two case studies of chapter 6: the whole process of the cell, from home by storage and machine back.
struct CaseStudy {
  cell::Cell cell;
  Pose copy;  ///< of the virtual copy of the material at the machine
  cell::Process process;
  std::vector<cell::browser::Snapshot> snapshots;      ///< one for each stop
  std::vector<Moment> moments;                         ///< home, then after each move
  std::vector<Stop> stops;                             ///< the first contact in storage, and that at the machine
  std::uint64_t asked = 0;                             ///< pairs of sphere and face that could touch: whose boxes meet
  std::array<std::uint64_t, kMethods.size()> wrong{};  ///< wrong answers of each method to these

  [[nodiscard]] std::size_t moves_to_machine() const;
};

/// Studies a case in a cell. Requires a cover of its arm.
[[nodiscard]] CaseStudy study_case(const cell::Cell& cell, const std::vector<cell::ModelPart>& parts,
                                   const std::shared_ptr<const std::vector<cell::Covered>>& covered,
                                   std::size_t number);

}  // namespace touchstone::figures
