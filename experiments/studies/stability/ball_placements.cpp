// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/ball_placements.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "experiments/cases/workloads/ulp.h"

namespace touchstone::stability {
namespace {

using Site = BallPlacement::Site;

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
