// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/units.h"

#include <cmath>
#include <limits>

namespace touchstone::statistics {
namespace {

double error(double difference, double unit) {
  return std::isfinite(difference) ? std::abs(difference) / unit : std::numeric_limits<double>::infinity();
}

}  // namespace

double unit_in_last_place(double value) {
  constexpr int kLowest = std::numeric_limits<double>::min_exponent - 1;
  if (std::abs(value) < std::numeric_limits<double>::min()) return std::numeric_limits<double>::denorm_min();
  return std::ldexp(std::numeric_limits<double>::epsilon(), std::max(std::ilogb(value), kLowest));
}

double number_error(double computed, double exact) { return error(computed - exact, unit_in_last_place(exact)); }

double point_error(const Eigen::Vector3d& computed, const Eigen::Vector3d& exact) {
  const double unit = unit_in_last_place(exact.cwiseAbs().maxCoeff());
  double largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max(largest, error(computed[k] - exact[k], unit));
  return largest;
}

}  // namespace touchstone::statistics
