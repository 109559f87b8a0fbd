// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/truth_as_given.h"

#include <gmpxx.h>

#include <array>
#include <cmath>

namespace touchstone::cases {
namespace {

template <class Number>
using Coordinates = std::array<Number, 3>;

template <class Number>
Coordinates<Number> difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {Number(a.x()) - Number(b.x()), Number(a.y()) - Number(b.y()), Number(a.z()) - Number(b.z())};
}

template <class Number>
Number dot(const Coordinates<Number>& a, const Coordinates<Number>& b) {
  return Number(a[0] * b[0]) + Number(a[1] * b[1]) + Number(a[2] * b[2]);
}

/// The square of the distance from a point to the segment from a to b, times `denominator`, which is positive.
template <class Number>
struct SegmentDistance {
  Number numerator, denominator;

  SegmentDistance(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const auto to_point = difference<Number>(point, a), along = difference<Number>(b, a);
    const Number share = dot(to_point, along);
    denominator = dot(along, along);
    if (share > 0 && share < denominator) {
      numerator = dot(to_point, to_point) * denominator - share * share;
      return;
    }
    const auto away = share <= 0 ? to_point : difference<Number>(point, b);
    numerator = dot(away, away);
    denominator = 1;
  }
};

/// The edges that the ball touches, ascending.
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    const Eigen::Vector3d &a = polygon.vertex(i), &b = polygon.vertex(polygon.next(i));
    // Twenty roundings of sums and products of these two squares: 2^-40 of both is far more. Where a product of squares
    // might leave the doubles, only the exact one tells.
    const double length2 = (b - a).squaredNorm(), squares = (ball.center - a).squaredNorm() + length2;
    const double radius2 = ball.radius * ball.radius;
    const SegmentDistance<double> rounded(ball.center, a, b);
    const double excess = rounded.numerator / rounded.denominator - radius2;
    if (length2 > 0x1p-400 && squares < 0x1p400 && std::abs(excess) > 0x1p-40 * (squares + radius2)) {
      if (excess < 0) hit.push_back(i);
      continue;
    }
    const SegmentDistance<mpq_class> exact(ball.center, a, b);
    const mpq_class radius(ball.radius);
    if (exact.numerator <= mpq_class(radius * radius * exact.denominator)) hit.push_back(i);
  }
  return hit;
}

}  // namespace

PartialAnswer TruthAsGiven::ask(const Ball& ball, QueryKind kind) const {
  if (kind == QueryKind::PlaneSide || kind == QueryKind::Foot) return contract_.ask(ball, kind);
  PartialAnswer answer;
  answer.edges_hit = edges_hit(ball, polygon_);
  answer.contact =
      !answer.edges_hit->empty() || (contract_.ask(ball, QueryKind::PlaneSide).plane == PlaneSide::Intersects &&
                                     contract_.ask(ball, QueryKind::Foot).foot != PointLocation::Outside);
  return answer;
}

}  // namespace touchstone::cases
