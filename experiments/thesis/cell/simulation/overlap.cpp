// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/overlap.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/simulation/moving_parts.h"
#include "experiments/thesis/cell/simulation/triangle_distance.h"

namespace touchstone::cell {
namespace {

struct Piece {
  std::uint32_t name;
  std::vector<NamedTriangle> triangles;
  touchstone::Box box;
};

struct Thing {
  std::string name;
  std::vector<Piece> parts;
  TriangleTree tree;
};

std::vector<Thing> things_of(const Workcell& workcell) {
  std::vector<std::pair<std::string, std::vector<Piece>>> found;
  for (const NamedTriangle& each : workcell.standing_triangles()) {
    const std::string& part = workcell.names()[each.owner];
    const std::string name = part.substr(0, part.find('/'));
    auto thing = std::ranges::find(found, name, &std::pair<std::string, std::vector<Piece>>::first);
    if (thing == found.end()) thing = found.insert(thing, {name, {}});
    auto& parts = thing->second;
    if (parts.empty() || parts.back().name != each.owner) parts.push_back({each.owner, {}, {}});
    parts.back().triangles.push_back(each);
    parts.back().box = parts.back().box.joined(box(each.triangle));
  }
  std::vector<Thing> things;
  for (auto& [name, parts] : found) {
    std::vector<NamedTriangle> all;
    for (const Piece& part : parts) all.insert(all.end(), part.triangles.begin(), part.triangles.end());
    things.push_back({name, std::move(parts), TriangleTree(std::move(all))});
  }
  return things;
}

bool lies_in(const touchstone::Box& inner, const touchstone::Box& outer) {
  return (inner.low.array() >= outer.low.array()).all() && (inner.high.array() <= outer.high.array()).all();
}

/// Whether a closed surface winds round a point that is not on it: the sum of solid angles, in quarters of a sphere.
/// Source: [vanoosterom1983].
bool winds_round(const std::vector<NamedTriangle>& surface, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const auto& [t, owner] : surface) {
    const Eigen::Vector3d a = t.a - point, b = t.b - point, c = t.c - point;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return std::abs(sum) > std::numbers::pi;
}

/// Whether one of two parts lies in the other, if their surfaces are apart: then one vertex tells for all.
bool nested(const Piece& one, const Piece& other) {
  return (lies_in(one.box, other.box) && winds_round(other.triangles, one.triangles.front().triangle.a)) ||
         (lies_in(other.box, one.box) && winds_round(one.triangles, other.triangles.front().triangle.a));
}

Hindrance in_each_other(const std::string& one, const std::string& other) {
  return {0, fmt::format("{} and {} stand one in the other", one, other), {one, other}};
}

}  // namespace

std::optional<Hindrance> overlap_of_things(const Workcell& workcell) {
  const std::vector<Thing> things = things_of(workcell);
  const std::vector<std::string>& names = workcell.names();
  for (std::size_t i = 0; i < things.size(); ++i)
    for (std::size_t j = i + 1; j < things.size(); ++j) {
      constexpr double kNear = std::numeric_limits<double>::min();
      if (const auto met = distance(things[i].tree, {}, things[j].tree, kNear); met.lower < kNear)
        return Hindrance{0,
                         fmt::format("{} stands in {}", names[met.owner], names[met.other]),
                         {names[met.owner], names[met.other]}};
      for (const Piece& part : things[i].parts)
        for (const Piece& other : things[j].parts)
          if (nested(part, other)) return in_each_other(names[part.name], names[other.name]);
    }
  return std::nullopt;
}

std::optional<Hindrance> nested_at_home(const Workcell& workcell) {
  const std::vector<Pose> links = workcell.arm().link_poses(workcell.arm().home);
  const std::vector<Thing> things = things_of(workcell);
  std::vector<Covered> arm = workcell.covered();
  std::erase_if(arm, [](const Covered& part) { return part.carrier == Carrier::Material; });
  for (std::size_t i = 0; i < workcell.fingers().size(); ++i)
    arm.push_back({"gripper/" + workcell.cell().gripper.fingers->parts[i].name, Carrier::Finger, links.size() - 1,
                   workcell.fingers()[i]});
  for (const Covered& covered : arm) {
    Piece part{0, covered.triangles, {}};
    for (auto& [triangle, owner] : part.triangles) {
      for (Eigen::Vector3d* const v : {&triangle.a, &triangle.b, &triangle.c}) *v = links[covered.link] * *v;
      part.box = part.box.joined(box(triangle));
    }
    for (const Thing& thing : things)
      for (const Piece& piece : thing.parts)
        if (nested(part, piece)) return in_each_other(covered.name, workcell.names()[piece.name]);
  }
  return std::nullopt;
}

}  // namespace touchstone::cell
