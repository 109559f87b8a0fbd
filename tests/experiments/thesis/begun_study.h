// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/study.h"

namespace touchstone::thesis_tests {

/// The study without what needs samples or time.
inline const thesis_figures::Study& begun() {
  static const thesis_figures::Study study = thesis_figures::begin_study({});
  return study;
}

}  // namespace touchstone::thesis_tests
