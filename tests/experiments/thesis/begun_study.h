// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cell/kinematics/solve_layout.h"
#include "experiments/thesis/study.h"

namespace touchstone::thesis_tests {

/// The study without what it links from other studies, of the chosen layout.
inline const thesis_figures::Study& begun() {
  static const thesis_figures::Study study = thesis_figures::begin_study({}, kinematics::chosen_layout());
  return study;
}

}  // namespace touchstone::thesis_tests
