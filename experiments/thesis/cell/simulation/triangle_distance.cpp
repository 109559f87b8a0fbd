// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace touchstone::cell {
namespace {

constexpr std::uint32_t kMostInLeaf = 4;

}  // namespace

TriangleTree::TriangleTree(std::vector<NamedTriangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  touchstone::Box whole;
  for (std::uint32_t i = begin; i < end; ++i) whole = whole.joined(box(triangles_[i].triangle));
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({whole, begin, end, {0, 0}});
  if (end - begin <= kMostInLeaf) return number;
  Eigen::Index longest = 0;
  (whole.high - whole.low).maxCoeff(&longest);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const NamedTriangle& a, const NamedTriangle& b) {
    return a.triangle.a[longest] + a.triangle.b[longest] + a.triangle.c[longest] <
           b.triangle.a[longest] + b.triangle.b[longest] + b.triangle.c[longest];
  });
  const std::uint32_t low = build(begin, middle), high = build(middle, end);
  nodes_[number].children[0] = low;
  nodes_[number].children[1] = high;
  return number;
}

namespace {

using Vertices = std::array<Eigen::Vector3d, 3>;
constexpr double kProjecting = 1e-14;  // of coordinates: more than a projection is off
constexpr double kPosing = 1e-13;      // of coordinates: more than a posed point is off

struct Nearest {
  Eigen::Vector3d one = Eigen::Vector3d::Zero(), other = Eigen::Vector3d::Zero();
  double squared = std::numeric_limits<double>::infinity();

  void take(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    if (const double d = (a - b).squaredNorm(); d < squared) *this = {a, b, d};
  }
};

/// The nearest points of two segments, which may be points. Source: [ericson2005, 5.1.9].
void take_edges(const Eigen::Vector3d& p, const Eigen::Vector3d& u, const Eigen::Vector3d& q, const Eigen::Vector3d& v,
                Nearest& nearest) {
  const Eigen::Vector3d r = p - q;
  const double a = u.squaredNorm(), e = v.squaredNorm(), b = u.dot(v), c = u.dot(r), f = v.dot(r);
  const auto clamped = [](double x) { return std::clamp(x, 0.0, 1.0); };
  double s = 0;
  if (const double parallel = a * e - b * b; a > 0 && parallel > 0) s = clamped((b * f - c * e) / parallel);
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0 || t > 1 || !(e > 0)) {
    t = clamped(t);
    s = a > 0 ? clamped((b * t - c) / a) : 0;
  }
  nearest.take(p + s * u, q + t * v);
}

/// Whether the projection of a point onto the plane of a triangle is in it, and where; `n` is the normal.
bool foot_inside(const Eigen::Vector3d& point, const Vertices& v, const Eigen::Vector3d& n, Eigen::Vector3d& foot) {
  const double length = n.squaredNorm();
  if (!(length > 0)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if ((v[(i + 1) % 3] - v[i]).cross(point - v[i]).dot(n) < 0) return false;
  foot = point - n * (n.dot(point - v[0]) / length);
  return true;
}

/// Whether an edge of the first triangle goes through the second one.
bool pierces(const Vertices& edges, const Vertices& v, const Eigen::Vector3d& n) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d &p = edges[i], &q = edges[(i + 1) % 3];
    const double a = n.dot(p - v[0]), b = n.dot(q - v[0]);
    if ((a > 0) == (b > 0) && a != 0 && b != 0) continue;
    const double share = a == b ? 0 : a / (a - b);
    Eigen::Vector3d foot;
    if (foot_inside(p + share * (q - p), v, n, foot)) return true;
  }
  return false;
}

/// By how much the projections onto the line from one point to another are certainly apart.
double apart(const Vertices& first, const Vertices& second, const Eigen::Vector3d& along) {
  const double length = along.norm();
  if (!(length > 0)) return 0;
  double high = -std::numeric_limits<double>::infinity(), low = -high, size = 0;
  for (const Eigen::Vector3d& v : first)
    high = std::max(high, along.dot(v)), size = std::max(size, v.cwiseAbs().maxCoeff());
  for (const Eigen::Vector3d& v : second)
    low = std::min(low, along.dot(v)), size = std::max(size, v.cwiseAbs().maxCoeff());
  return std::max(0.0, ((low - high) / length) * (1 - kProjecting) - kProjecting * size);
}

/// By how much their projections onto a normal, onto a line across two edges, or within a plane across an edge are
/// certainly apart: two triangles that do not touch are apart along one of these. `n` and `m` are the normals.
double apart_along_normals(const Vertices& first, const Eigen::Vector3d& n, const Vertices& second,
                           const Eigen::Vector3d& m) {
  double most = 0;
  const auto take = [&](const Eigen::Vector3d& along) {
    most = std::max({most, apart(first, second, along), apart(first, second, -along)});
  };
  take(n);
  take(m);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d u = first[(i + 1) % 3] - first[i], v = second[(i + 1) % 3] - second[i];
    take(n.cross(u));
    take(m.cross(v));
    for (std::size_t k = 0; k < 3; ++k) take(u.cross(second[(k + 1) % 3] - second[k]));
  }
  return most;
}

double size_of(const Triangle& t) {
  return std::max({t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(), t.c.cwiseAbs().maxCoeff()});
}

Triangle posed(const Pose& pose, const Triangle& t) { return {pose * t.a, pose * t.b, pose * t.c}; }

/// A distance that two boxes, or a box and the ball around one, are at least apart.
double apart(const touchstone::Box& one, const touchstone::Box& other) {
  return (one.low - other.high).cwiseMax(other.low - one.high).cwiseMax(0).norm();
}

}  // namespace

DistanceBounds distance(const Triangle& first, const Triangle& second) {
  const Vertices a{first.a, first.b, first.c}, b{second.a, second.b, second.c};
  Nearest nearest;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) take_edges(a[i], a[(i + 1) % 3] - a[i], b[k], b[(k + 1) % 3] - b[k], nearest);
  const Eigen::Vector3d n = (a[1] - a[0]).cross(a[2] - a[0]), m = (b[1] - b[0]).cross(b[2] - b[0]);
  Eigen::Vector3d foot;
  for (std::size_t i = 0; i < 3; ++i) {
    if (foot_inside(a[i], b, m, foot)) nearest.take(a[i], foot);
    if (foot_inside(b[i], a, n, foot)) nearest.take(foot, b[i]);
  }
  const double upper = std::sqrt(nearest.squared);
  double lower = apart(a, b, nearest.other - nearest.one);
  if (!(lower > 0)) lower = apart_along_normals(a, n, b, m);  // rounding has turned a short way
  if (lower > 0) return {lower, std::max(lower, upper)};
  return {0, pierces(a, b, m) || pierces(b, a, n) ? 0 : upper};
}

DistanceOfTrees distance(const TriangleTree& moving, const Pose& pose, const TriangleTree& still, double cutoff) {
  DistanceOfTrees bounds{{cutoff, std::numeric_limits<double>::infinity()}};
  if (moving.nodes_.empty() || still.nodes_.empty()) return bounds;
  using Node = TriangleTree::Node;
  const auto beside = [&](const Node& mine, const Node& its) {
    const Eigen::Vector3d half = (mine.box.high - mine.box.low) / 2;
    const Eigen::Vector3d center = pose * (mine.box.low + half);
    // The posed box has these half lengths along the axes.
    const Eigen::Vector3d reach = pose.rotation.cwiseAbs() * half;
    const double off = kPosing * (center.cwiseAbs().maxCoeff() + reach.maxCoeff() + its.box.high.cwiseAbs().maxCoeff() +
                                  its.box.low.cwiseAbs().maxCoeff());
    return apart({center - reach, center + reach}, its.box) - off;
  };
  std::vector<std::pair<double, std::pair<std::uint32_t, std::uint32_t>>> open;
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    if (const double least = beside(moving.nodes_[i], still.nodes_[j]); least < bounds.lower)
      open.push_back({least, {i, j}});
  };
  add(0, 0);
  while (!open.empty()) {
    const auto [least, pair] = open.back();
    open.pop_back();
    if (least >= bounds.lower) continue;
    const Node &mine = moving.nodes_[pair.first], &its = still.nodes_[pair.second];
    const bool leaf = mine.children[0] == 0, other_leaf = its.children[0] == 0;
    if (!leaf || !other_leaf) {
      const bool mine_first = other_leaf || (!leaf && (mine.box.high - mine.box.low).squaredNorm() >
                                                          (its.box.high - its.box.low).squaredNorm());
      const auto before = open.size();
      for (const std::uint32_t child : (mine_first ? mine : its).children)
        mine_first ? add(child, pair.second) : add(pair.first, child);
      if (open.size() == before + 2 && open[before].first < open[before + 1].first)  // the nearer one is taken first
        std::swap(open[before], open[before + 1]);
      continue;
    }
    for (std::uint32_t i = mine.begin; i < mine.end; ++i) {
      const Triangle triangle = posed(pose, moving.triangles_[i].triangle);
      const touchstone::Box around = box(triangle);
      const double off = kPosing * size_of(triangle);
      for (std::uint32_t j = its.begin; j < its.end; ++j) {
        const Triangle& other = still.triangles_[j].triangle;
        if (apart(around, box(other)) - off - kPosing * size_of(other) >= bounds.lower) continue;
        const DistanceBounds here = distance(triangle, other);
        if (const double lower = std::max(0.0, here.lower - off); lower < bounds.lower) {
          bounds.lower = lower;
          bounds.owner = moving.triangles_[i].owner, bounds.other = still.triangles_[j].owner;
        }
        bounds.upper = std::min(bounds.upper, here.upper + off);
      }
    }
  }
  return bounds;
}

namespace {

constexpr double kRoundingOfDistance = 3e-13;  // of coordinates: some roundings of a posed distance
constexpr int kMostHalvings = 10'000;

double size_of(const touchstone::Box& box) {
  return std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
}

}  // namespace

StraightWay until_touch(const TriangleTree& moving, const Pose& pose, const Eigen::Vector3d& direction, double most,
                        const TriangleTree& still) {
  const double near = kRoundingOfDistance * (size_of(moving.whole()) + pose.translation.cwiseAbs().maxCoeff() + most);
  StraightWay result{0, false, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < kMostHalvings; ++i) {
    const Pose here{pose.rotation, pose.translation + result.way * direction};
    const DistanceOfTrees left = distance(moving, here, still, most - result.way + near);
    if (left.lower > most - result.way) return {most, false, std::numeric_limits<double>::infinity()};
    result.gap = left.upper, result.owner = left.owner, result.other = left.other;
    if (left.lower <= near) break;
    result.way += left.lower;
  }
  result.touches = true;
  return result;
}

}  // namespace touchstone::cell
