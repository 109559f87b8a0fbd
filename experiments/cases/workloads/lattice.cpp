// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::workloads {
namespace {

/// Calls f(a, b) for every edge of the outline.
template <class F>
void for_each_edge(const Outline& outline, F f) {
  const auto edges_of = [&f](const LatticeLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) f(loop[i], loop[(i + 1) % loop.size()]);
  };
  edges_of(outline.outer);
  for (const LatticeLoop& hole : outline.holes) edges_of(hole);
}

double squared_distance(LatticePoint point, LatticePoint a, LatticePoint b) {
  const LatticePoint along = b - a;
  const auto length2 = static_cast<double>(dot(along, along));
  const auto foot = static_cast<double>(dot(point - a, along));
  if (foot <= 0) return static_cast<double>(dot(point - a, point - a));
  if (foot >= length2) return static_cast<double>(dot(point - b, point - b));
  const auto area = static_cast<double>(cross(along, point - a));
  return area * area / length2;
}

}  // namespace

std::int64_t LatticeBox::size() const { return std::max(high.x - low.x, high.y - low.y); }

bool Corner::convex() const {
  const std::int64_t turn = cross(here - previous, next - here);
  return region_on_left ? turn > 0 : turn < 0;
}

LatticeBox bounding_box(const LatticeLoop& loop) {
  LatticeBox box{loop.front(), loop.front()};
  for (const LatticePoint& p : loop) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

std::int64_t twice_area(const LatticeLoop& loop) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

bool is_convex(const LatticeLoop& loop) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const LatticePoint a = loop[i], b = loop[(i + 1) % loop.size()], c = loop[(i + 2) % loop.size()];
    const std::int64_t turn = cross(b - a, c - b);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return !(left && right);
}

std::size_t vertex_count(const Outline& outline) {
  std::size_t count = outline.outer.size();
  for (const LatticeLoop& hole : outline.holes) count += hole.size();
  return count;
}

Corner corner(const Outline& outline, std::size_t i) {
  const LatticeLoop* loop = &outline.outer;
  for (auto hole = outline.holes.begin(); i >= loop->size(); ++hole) {
    i -= loop->size();
    loop = &*hole;
  }
  const std::size_t n = loop->size();
  const bool outer = loop == &outline.outer;
  return {(*loop)[(i + n - 1) % n], (*loop)[i], (*loop)[(i + 1) % n], (twice_area(*loop) > 0) == outer};
}

bool contains(const Outline& outline, LatticePoint point) {
  bool inside = false;
  for_each_edge(outline, [&](LatticePoint a, LatticePoint b) {
    if ((a.y > point.y) == (b.y > point.y)) return;
    if ((cross(b - a, point - a) > 0) == (b.y > a.y)) inside = !inside;
  });
  return inside;
}

double clearance(const Outline& outline, LatticePoint point) {
  double least = std::numeric_limits<double>::infinity();
  for_each_edge(outline,
                [&](LatticePoint a, LatticePoint b) { least = std::min(least, squared_distance(point, a, b)); });
  return std::sqrt(least);
}

}  // namespace touchstone::workloads
