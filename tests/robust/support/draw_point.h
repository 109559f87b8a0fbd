// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "experiments/cases/workloads/random.h"

namespace touchstone::contact_tests {

/// Uniform in the cube of coordinates from -size to size.
[[nodiscard]] inline Eigen::Vector3d draw_point(workloads::Random& random, double size = 1) {
  return size * Eigen::Vector3d{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
}

}  // namespace touchstone::contact_tests
