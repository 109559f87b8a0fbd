// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/motion.h"

#include <gmpxx.h>

#include "robust/exact/detail/nearest_double.h"

namespace touchstone::stability {
namespace {

/// With the operations in this order on every machine.
Eigen::Vector3d product(const Eigen::Matrix3d& m, const Eigen::Vector3d& p) {
  Eigen::Vector3d result;
  for (int row = 0; row < 3; ++row) result[row] = m(row, 0) * p[0] + m(row, 1) * p[1] + m(row, 2) * p[2];
  return result;
}

}  // namespace

Eigen::Matrix3d small_rotation(workloads::Random& random) {
  // A quaternion (a, v) turns by 2 atan(|v| / a): 1.0 degree for |v| / a = 1 / 115.
  std::int64_t x = 0, y = 0, z = 0;
  while (x * x + y * y + z * z < 400) {
    x = random.integer(-100, 100);
    y = random.integer(-100, 100);
    z = random.integer(-100, 100);
  }
  std::int64_t a = 0;
  while (a * a < 115 * 115 * (x * x + y * y + z * z)) ++a;
  const auto unit = static_cast<double>(a * a + x * x + y * y + z * z);
  const auto entry = [unit](std::int64_t numerator) { return static_cast<double>(numerator) / unit; };  // one rounding
  Eigen::Matrix3d matrix;
  matrix << entry(a * a + x * x - y * y - z * z), entry(2 * (x * y - a * z)), entry(2 * (x * z + a * y)),
      entry(2 * (x * y + a * z)), entry(a * a - x * x + y * y - z * z), entry(2 * (y * z - a * x)),
      entry(2 * (x * z - a * y)), entry(2 * (y * z + a * x)), entry(a * a - x * x - y * y + z * z);
  return matrix;
}

std::vector<Eigen::Vector3d> rotated_in_steps(std::vector<Eigen::Vector3d> points, const Eigen::Matrix3d& matrix,
                                              std::uint64_t steps) {
  for (std::uint64_t step = 0; step < steps; ++step)
    for (Eigen::Vector3d& point : points) point = product(matrix, point);
  return points;
}

Eigen::Matrix3d pose_in_steps(const Eigen::Matrix3d& matrix, std::uint64_t steps) {
  Eigen::Matrix3d pose = Eigen::Matrix3d::Identity();
  for (std::uint64_t step = 0; step < steps; ++step)
    for (int column = 0; column < 3; ++column) {
      const Eigen::Vector3d before = pose.col(column);
      pose.col(column) = product(matrix, before);
    }
  return pose;
}

Eigen::Vector3d posed(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& point) {
  Eigen::Vector3d result;
  for (int row = 0; row < 3; ++row) {
    mpq_class sum = 0;
    for (int column = 0; column < 3; ++column) sum += mpq_class(matrix(row, column)) * mpq_class(point[column]);
    result[row] = exact::detail::nearest_double(sum.get_num(), sum.get_den());
  }
  return result;
}

}  // namespace touchstone::stability
