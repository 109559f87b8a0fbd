// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/shapes.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/outline.h"

namespace touchstone::stability {
namespace {

double between(Random& random, double lowest, double highest) { return lowest + (highest - lowest) * random.unit(); }

/// Its bounding box becomes the square of side 2 about zero.
Flat flat_of(const workloads::LatticeLoop& loop) {
  const workloads::LatticeBox box = workloads::bounding_box(loop);
  const auto middle = [](std::int64_t low, std::int64_t high) { return static_cast<double>(low + high) / 2; };
  const auto half = [](std::int64_t low, std::int64_t high) { return static_cast<double>(high - low) / 2; };
  const double middle_x = middle(box.low.x, box.high.x), middle_y = middle(box.low.y, box.high.y);
  const double half_x = half(box.low.x, box.high.x), half_y = half(box.low.y, box.high.y);
  Flat flat;
  for (const auto& p : loop)
    flat.points.push_back(
        {(static_cast<double>(p.x) - middle_x) / half_x, (static_cast<double>(p.y) - middle_y) / half_y});
  return flat;
}

workloads::LatticeLoop lattice_outline(Random& random) {
  switch (random.integer(0, 5)) {
    case 0: return workloads::triangle(random);
    case 1: return workloads::star(random, 8);
    case 2: return workloads::comb(random, 8);
    case 3: return workloads::letter_l(random);
    case 4: return workloads::letter_u(random);
    default: return workloads::letter_e(random);
  }
}

double distance_to_edge(FlatPoint a, FlatPoint b, FlatPoint p) {
  const double x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
  const double along = length2 > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length2, 0.0, 1.0) : 0;
  const double dx = p.x - a.x - along * x, dy = p.y - a.y - along * y;
  return std::sqrt(dx * dx + dy * dy);
}

/// The point at `t` in [0, 8) on the boundary of the square |x|, |y| <= 1, counterclockwise.
FlatPoint on_square(double t) {
  const int side = std::min(3, static_cast<int>(t / 2));
  const double along = t - 2 * side - 1;
  switch (side) {
    case 0: return {1, along};
    case 1: return {-along, 1};
    case 2: return {-1, -along};
    default: return {along, -1};
  }
}

}  // namespace

Flat flat_triangle(Random& random) { return flat_of(workloads::triangle(random)); }

Flat flat_outline(Random& random) { return flat_of(lattice_outline(random)); }

Flat flat_lattice_outline(Random& random) {
  const workloads::LatticeLoop loop = lattice_outline(random);
  const auto size = static_cast<double>(workloads::bounding_box(loop).size());
  Flat flat{{}, {}, size, size};
  for (const auto& p : loop) flat.points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  return flat;
}

Flat flat_crack(Random& random, double angle) {
  const double depth = between(random, 0.9, 1.4), tilt = between(random, -0.2, 0.2);
  const double mouth = angle * (depth * depth + tilt * tilt) / depth / 2;
  const double left = -between(random, 0.9, 1.1), right = between(random, 0.9, 1.1);
  return {
      {{left, 0}, {-mouth, 0}, {tilt, depth}, {mouth, 0}, {right, 0}, {right, 2}, {left, 2}}, {2, 1, 3}, 2, 2 * mouth};
}

Flat flat_bend(Random& random, double turn) {
  const double middle = between(random, -0.5, 0.5), height = between(random, 0.5, 0.9);
  const double sag = turn * (1 - middle * middle) / 2;
  return {{{-1 - middle, sag}, {0, 0}, {1 - middle, sag}, {1 - middle, 1.6}, {0, height}, {-1 - middle, 1.6}},
          {1, 0, 2},
          2,
          std::max(sag, 0x1p-60)};
}

Flat flat_cut_corner(Random& random, double distance) {
  const double cut = std::min(1.2, 2 * distance) / std::sqrt(2), dent = between(random, 1.0, 1.6);
  return {{{cut, 0}, {2, 0}, {2, 2}, {1, dent}, {0, 2}, {0, cut}}, {0, 5}, 2, 2 * cut};
}

Flat flat_pocket(Random& random, double mouth) {
  const double half = std::min(1.2, 2 * mouth) / 2;
  const double depth = between(random, 0.8, 1.2), width = between(random, 0.62, 0.8);
  return {
      {{-1, 0}, {-half, 0}, {-width, depth}, {width, depth}, {half, 0}, {1, 0}, {1, 2}, {-1, 2}}, {1, 4}, 2, 2 * half};
}

Flat flat_straight_run(Random& random, std::size_t count) {
  constexpr double kLength = 0x1p20;
  const double height = std::round(between(random, 0.5, 1) * kLength);
  Flat flat{{{0, 0}}, {}, kLength, kLength / static_cast<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + between(random, 0.1, 0.9)) / static_cast<double>(count);
    flat.critical.push_back(flat.points.size());
    flat.points.push_back({std::clamp(std::round(share * kLength), 1.0, kLength - 1), 0});
  }
  const FlatPoint dent{std::round(between(random, 0.3, 0.7) * kLength), std::round(height * between(random, 0.3, 0.7))};
  for (const FlatPoint p : {FlatPoint{kLength, 0}, {kLength, height}, dent, {0, height}}) flat.points.push_back(p);
  return flat;
}

Flat flat_star(Random& random, std::size_t count) {
  constexpr double kRadius = 0x1p40;
  const double turn = 8 * random.unit(), step = 8 / static_cast<double>(count);
  Flat flat{{}, {}, 2 * kRadius, 2 * kRadius * step};
  flat.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // One direction in the first three quarters of each part of the square's boundary.
    const double t = std::fmod((static_cast<double>(i) + 0.75 * random.unit()) * step + turn, 8);
    const double radius = kRadius * between(random, 0.2, 1);
    const FlatPoint direction = on_square(t);
    flat.points.push_back({std::round(direction.x * radius), std::round(direction.y * radius)});
  }
  return flat;
}

bool contains(const Flat& flat, FlatPoint point) {
  bool inside = false;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const FlatPoint a = flat.points[i], b = flat.points[flat.next(i)];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

double clearance(const Flat& flat, FlatPoint point) {
  double least = INFINITY;
  for (std::size_t i = 0; i < flat.points.size(); ++i)
    least = std::min(least, distance_to_edge(flat.points[i], flat.points[flat.next(i)], point));
  return least;
}

double twice_area(const Flat& flat) {
  double sum = 0;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const FlatPoint a = flat.points[i], b = flat.points[flat.next(i)];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace touchstone::stability
