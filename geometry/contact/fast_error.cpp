// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/fast_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/detail/required.h"

namespace touchstone::fast {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kNothing = std::numeric_limits<double>::infinity();

}  // namespace

// The constants exceed what they must cover by more than the roundings here, and than r for d takes.
double contact_error(const Ball& ball, const Triangle& triangle) {
  const auto& [a, b, c] = required(triangle);
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double kappa = longest / (b - a).cross(a - c).norm();
  if (!(kappa <= error::kMostSlender)) return kNothing;
  const double size = (a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c)).maxCoeff();
  return kUnit * (error::kTriangle * kappa + error::kTriangleSize) * (size + required(ball).radius);
}

double contact_error(const Ball& ball, const PreparedPolygon<double>& polygon) {
  const auto largest = [&](std::size_t i) {
    return (polygon.edges()[i].start - polygon.edges()[0].start).cwiseAbs().maxCoeff();
  };
  double products = 0, count = 1;
  for (std::size_t i = 0; polygon.next(i) != 0; i = polygon.next(i), ++count)
    products += largest(i) * largest(polygon.next(i));
  Eigen::Vector3d low = polygon.edges()[0].start, high = low;
  for (const auto& edge : polygon.edges()) low = low.cwiseMin(edge.start), high = high.cwiseMax(edge.start);
  const double kappa = products / std::sqrt(polygon.normal_squared());
  const double share = kUnit * (error::kPolygon * (count + 1) * kappa + error::kPolygonSize);
  if (polygon.off_plane() != 0 || !(share <= error::kMostShare)) return kNothing;
  return share * ((high - low).maxCoeff() + required(ball).radius);
}

}  // namespace touchstone::fast
