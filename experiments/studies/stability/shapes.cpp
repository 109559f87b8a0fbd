// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "experiments/cases/workloads/outline.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/studies/stability/scene.h"

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

namespace {

using Site = BallPlacement::Site;

/// By the even-odd rule in doubles: possibly wrong near the boundary.
bool contains(const Flat& flat, FlatPoint point) {
  bool inside = false;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const FlatPoint a = flat.points[i], b = flat.points[flat.next(i)];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

double distance_to_edge(FlatPoint a, FlatPoint b, FlatPoint p) {
  const double x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
  const double along = length2 > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length2, 0.0, 1.0) : 0;
  const double dx = p.x - a.x - along * x, dy = p.y - a.y - along * y;
  return std::sqrt(dx * dx + dy * dy);
}

/// The distance to the nearest edge, in doubles.
double clearance(const Flat& flat, FlatPoint point) {
  double least = INFINITY;
  for (std::size_t i = 0; i < flat.points.size(); ++i)
    least = std::min(least, distance_to_edge(flat.points[i], flat.points[flat.next(i)], point));
  return least;
}

/// Signed, in doubles; positive for a counterclockwise outline.
double twice_area(const Flat& flat) {
  double sum = 0;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const FlatPoint a = flat.points[i], b = flat.points[flat.next(i)];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

/// Draws in the plane of an outline, and heights above it.
class Draw {
 public:
  Draw(Random& random, const Flat& flat, const workloads::Frame& frame)
      : random_(random), flat_(flat), frame_(frame), turn_(twice_area(flat) < 0 ? -1 : 1) {}

  BallPlacement face() {
    FlatPoint best = flat_.points[0];
    double best_clearance = -1;
    for (int i = 0; i < kTries && best_clearance < flat_.size / 32; ++i) {
      const FlatPoint& corner = flat_.points[index()];
      const FlatPoint point{corner.x + signed_length(flat_.size), corner.y + signed_length(flat_.size)};
      if (!contains(flat_, point)) continue;
      const double found = clearance(flat_, point);
      if (found > best_clearance) best = point, best_clearance = found;
    }
    return {Site::Face, frame_.at(best.x, best.y, signed_height())};
  }

  BallPlacement edge() {
    const std::size_t i = edge_index();
    return {Site::Edge, away(along(i), outward(i))};
  }

  BallPlacement vertex() {
    const std::size_t i = critical_or_any();
    const FlatPoint here = flat_.points[i];
    const FlatPoint a = unit(flat_.points[flat_.previous(i)], here), b = unit(flat_.points[flat_.next(i)], here);
    FlatPoint out{a.x + b.x, a.y + b.y};
    const double length = std::sqrt(out.x * out.x + out.y * out.y);
    out = length > 0x1p-20 ? FlatPoint{out.x / length, out.y / length} : outward(i);
    return {Site::Vertex, away(here, out)};
  }

  /// The foot at, inside and outside of an edge.
  void feet(std::vector<BallPlacement>& placements) {
    const std::size_t i = edge_index();
    const FlatPoint on = along(i), out = outward(i);
    const double height = signed_height(), radius = 2 * std::abs(height) * frame_.unit;
    const Eigen::Vector3d center = frame_.at(on.x, on.y, height);
    const auto axis = static_cast<int>(random_.integer(0, 2));
    for (const int doubles : {0, 1, -1}) {
      Eigen::Vector3d moved = center;
      moved[axis] = workloads::move_by_doubles(moved[axis], doubles);
      placements.push_back({Site::Foot, moved, Nearness::OneDouble, radius});
    }
    for (const auto& [nearness, share] : {std::pair{Nearness::Close, 0x1p-31}, {Nearness::Ample, 0x1p-5}})
      for (const int sign : {1, -1}) {
        const double step = sign * share * flat_.size;
        const FlatPoint foot{on.x + step * out.x, on.y + step * out.y};
        if (nearness == Nearness::Ample && clearance(flat_, foot) < 0.9 * std::abs(step)) continue;
        placements.push_back({Site::Foot, frame_.at(foot.x, foot.y, height), nearness, radius});
      }
  }

 private:
  static constexpr int kTries = 200;

  static FlatPoint unit(FlatPoint from, FlatPoint to) {
    const double x = to.x - from.x, y = to.y - from.y, length = std::sqrt(x * x + y * y);
    return {x / length, y / length};
  }

  std::size_t index() {
    return static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(flat_.points.size()) - 1));
  }
  std::size_t critical_or_any() {
    if (flat_.critical.empty() || random_.coin()) return index();
    const auto last = static_cast<std::int64_t>(flat_.critical.size()) - 1;
    return flat_.critical[static_cast<std::size_t>(random_.integer(0, last))];
  }
  std::size_t edge_index() {
    const std::size_t i = critical_or_any();
    return random_.coin() ? i : flat_.previous(i);
  }
  FlatPoint along(std::size_t i) {
    const FlatPoint a = flat_.points[i], b = flat_.points[flat_.next(i)];
    const double share = 0.1 + 0.8 * random_.unit();
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }
  /// Of length 1, from the edge away from the region.
  [[nodiscard]] FlatPoint outward(std::size_t i) const {
    const FlatPoint d = unit(flat_.points[i], flat_.points[flat_.next(i)]);
    return {turn_ * d.y, -turn_ * d.x};
  }
  /// From half of the size down to a 64th.
  double length(double size) {
    const auto halvings = static_cast<int>(random_.integer(0, 4));
    return std::ldexp(size * (0.25 + 0.25 * random_.unit()), -halvings);
  }
  double signed_length(double size) { return random_.coin() ? length(size) : -length(size); }
  /// Of the outline's size, or of what is stressed.
  double any_length() { return length(random_.coin() ? flat_.size : std::min(flat_.size, flat_.feature)); }
  double signed_height() { return random_.coin() ? any_length() : -any_length(); }

  /// Some way from a point of the boundary, between `out` and the two normals.
  Eigen::Vector3d away(FlatPoint from, FlatPoint out) {
    const double t = 2 * random_.unit() - 1;  // rational points of the half circle
    const double in_plane = (flat_.critical.empty() ? length(flat_.size) : any_length()) * ((1 - t * t) / (1 + t * t));
    const double height = any_length() * (2 * t / (1 + t * t));
    return frame_.at(from.x + in_plane * out.x, from.y + in_plane * out.y, height);
  }

  Random& random_;
  const Flat& flat_;
  const workloads::Frame& frame_;
  double turn_;
};

}  // namespace

std::string_view to_string(Nearness nearness) {
  switch (nearness) {
    case Nearness::OneDouble: return "one-double";
    case Nearness::Close: return "close";
    case Nearness::Ample: break;
  }
  return "ample";
}

std::vector<BallPlacement> draw_placements(Random& random, const Flat& flat, const workloads::Frame& frame) {
  Draw draw(random, flat, frame);
  std::vector<BallPlacement> placements;
  placements.push_back(draw.face());
  placements.push_back(draw.edge());
  placements.push_back(draw.vertex());
  draw.feet(placements);
  return placements;
}

}  // namespace touchstone::stability
