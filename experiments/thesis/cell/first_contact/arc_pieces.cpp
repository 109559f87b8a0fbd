// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/arc_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchstone::kinematics {
namespace {

constexpr double kWidest = 4;               // degrees of a piece
constexpr double kRoundingOfArc = 0x1p-40;  // of the largest numbers: some thousand times what rounding can do
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The point at an angle, by the C library: here it may be off by a little.
Eigen::Vector3d roughly_at(const Arc& arc, double degrees) {
  const Eigen::Vector3d unit = direction_of(arc.axis), v = arc.start - arc.point;
  const Eigen::Vector3d along = v.dot(unit) * unit;
  const double angle = degrees * std::numbers::pi / 180;
  return arc.point + along + std::cos(angle) * (v - along) + std::sin(angle) * unit.cross(v);
}

/// From the point of segment a b to that of segment c d that is nearest to it, about.
Eigen::Vector3d between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), determinant = uu * vv - uv * uv;
  const auto share = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; };
  double s = share(uv * v.dot(w) - vv * u.dot(w), determinant);
  const double t = share(v.dot(w + s * u), vv);
  s = share(u.dot(t * v - w), uu);
  return c + t * v - (a + s * u);
}

/// By how much the hull of points lies beyond that of two others in a direction, or they beyond it.
template <class Points>
double gap(const Points& points, const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& direction) {
  const double at_p = p.dot(direction), at_q = q.dot(direction);
  double low = kInfinity, high = -kInfinity;
  for (const Eigen::Vector3d& point : points) {
    const double at = point.dot(direction);
    low = std::min(low, at), high = std::max(high, at);
  }
  return std::max(low - std::max(at_p, at_q), std::min(at_p, at_q) - high);
}

}  // namespace

// Between its ends a piece of angle A of an arc of radius R leaves its chord by at most R (1 - cos(A / 2)) <= R A^2 /
// 8, and R is at most twice the sum of the largest coordinates.
ArcPieces::ArcPieces(const Arc& arc, double radius) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(arc.degrees / kWidest)));
  degrees_ = arc.degrees / static_cast<double>(count);
  const double size = arc.start.cwiseAbs().maxCoeff() + arc.point.cwiseAbs().maxCoeff() + radius;
  const double angle = degrees_ * std::numbers::pi / 180;
  margin_ = radius + 2 * size * angle * angle / 8 + kRoundingOfArc * size + std::numeric_limits<double>::min();
  if (!(size < 0x1p400)) margin_ = kInfinity;
  Eigen::Vector3d last = arc.start;
  for (std::size_t i = 1; i <= count; ++i) {
    const Eigen::Vector3d next = roughly_at(arc, i == count ? arc.degrees : static_cast<double>(i) * degrees_);
    const Box box = std::isfinite(margin_)
                        ? Box{last.cwiseMin(next).array() - margin_, last.cwiseMax(next).array() + margin_}
                        : Box{Eigen::Vector3d::Constant(-kInfinity), Eigen::Vector3d::Constant(kInfinity)};
    pieces_.push_back({last, next, box});
    last = next;
  }
}

template <class Test>
std::optional<ArcPieces::Range> ArcPieces::range(const Test& may_touch) const {
  const auto first = std::ranges::find_if(pieces_, may_touch);
  if (first == pieces_.end()) return std::nullopt;
  const auto end = std::find_if(pieces_.rbegin(), pieces_.rend(), may_touch).base();
  return Range{static_cast<double>(first - pieces_.begin()) * degrees_,
               static_cast<double>(end - pieces_.begin()) * degrees_};
}

std::optional<ArcPieces::Range> ArcPieces::near(const Box& box) const {
  return range([&](const Piece& piece) { return meet(piece.box, box); });
}

// Whatever the direction, what is further apart in it than the margin is further apart.
std::optional<ArcPieces::Range> ArcPieces::near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double lift) const {
  const double margin = margin_ + 2 * lift + kRoundingOfArc * (a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
  return range([&](const Piece& piece) {
    const Eigen::Vector3d direction = between(piece.begin, piece.end, a, b).stableNormalized();
    return !(gap(std::array{a, b}, piece.begin, piece.end, direction) > margin);
  });
}

std::optional<ArcPieces::Range> ArcPieces::near(const std::vector<Eigen::Vector3d>& points,
                                                const Eigen::Vector3d& normal, double lift) const {
  double size = 0;
  for (const Eigen::Vector3d& point : points) size = std::max(size, point.cwiseAbs().maxCoeff());
  const double margin = margin_ + 2 * lift + kRoundingOfArc * size;
  const Eigen::Vector3d direction = normal.stableNormalized();
  return range([&](const Piece& piece) { return !(gap(points, piece.begin, piece.end, direction) > margin); });
}

}  // namespace touchstone::kinematics
