// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

/// The study without what needs samples or time.
inline const figures::Study& begun() {
  static const figures::Study study = figures::begin_study({});
  return study;
}

}  // namespace touchstone::figures
