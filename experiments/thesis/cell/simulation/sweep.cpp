// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/sweep.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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

}  // namespace

std::optional<Hindrance> overlap_of_things(const Workcell& workcell) {
  const std::vector<Thing> things = things_of(workcell);
  const std::vector<std::string>& names = workcell.names();
  const auto hindrance = [&](const char* words, std::uint32_t one, std::uint32_t other) {
    return Hindrance{0, fmt::format(fmt::runtime(words), names[one], names[other]), {names[one], names[other]}};
  };
  for (std::size_t i = 0; i < things.size(); ++i)
    for (std::size_t j = i + 1; j < things.size(); ++j) {
      constexpr double kNear = std::numeric_limits<double>::min();
      if (const auto met = distance(things[i].tree, {}, things[j].tree, kNear); met.lower < kNear)
        return hindrance("{} stands in {}", met.owner, met.other);
      // Surfaces that are apart: one vertex tells for all of a part.
      for (const Piece& part : things[i].parts)
        for (const Piece& other : things[j].parts)
          if ((lies_in(part.box, other.box) && winds_round(other.triangles, part.triangles.front().triangle.a)) ||
              (lies_in(other.box, part.box) && winds_round(part.triangles, other.triangles.front().triangle.a)))
            return hindrance("{} and {} stand one in the other", part.name, other.name);
    }
  return std::nullopt;
}

namespace {

constexpr double kRounding = 1e-12;  // of the arm's reach: more than a posed point is off
constexpr double kRests = 1e-9;      // of the arm's reach: what lies so little higher than held material is below it

}  // namespace

/// A move of one joint, and what is to be shown clear of what on it.
class SweptMove {
 public:
  /// `joint` is empty for the arm at rest.
  SweptMove(const Sweep& sweep, const kinematics::Angles& from, std::optional<Moved> joint, double degrees,
            const Sweep::Load& load, std::uint64_t& queries)
      : cell_(*sweep.workcell_),
        arm_(cell_.arm()),
        parts_(sweep.parts_),
        from_(from),
        joint_(joint),
        turn_(arm_, from, joint),
        degrees_(degrees),
        load_(load),
        queries_(queries),
        reach_(cell_.plane().furthest()),
        not_below_(not_below()) {
    for (const MovingPart& part : parts_) {
      if (joint_ && turn_.motion(part.link) == JointTurn::Motion::None) continue;
      if (part.mover == Mover::Held) {
        if (load_.held) concerns_.push_back({&part, &not_below_, nullptr});
        continue;
      }
      concerns_.push_back({&part, arm_.links[part.link].frame ? &cell_.standing() : &sweep.without_floor_, nullptr});
      if (load_.material) concerns_.push_back({&part, &cell_.material_in(*load_.material), nullptr});
    }
    for (const auto& [i, j] : sweep.pairs_) {
      const MovingPart &one = parts_[i], &other = parts_[j];
      if ((one.mover == Mover::Held || other.mover == Mover::Held) && !load_.held) continue;
      if (!joint_ || turn_.motion(one.link) != turn_.motion(other.link))
        concerns_.push_back({&one, &other.triangles, &other});
    }
  }

  [[nodiscard]] std::optional<Hindrance> first() {
    std::optional<Hindrance> earliest;
    for (const Concern& concern : concerns_) {
      const double end = earliest ? earliest->degrees : std::abs(degrees_), finest = kFinest * cell_.cell().step;
      const double rate = speed(*concern.part) + (concern.other != nullptr ? speed(*concern.other) : 0);
      const auto apart = [&](double degrees, double moved) { return distance_at(concern, degrees, moved).lower; };
      const auto touch = first_touch(
          {0, apart(0, rate * end), end, apart(end, rate * end)}, rate, finest,
          [&](double middle, const Clearance& part) { return apart(middle, rate * (part.end - part.begin)); });
      if (!touch || (earliest && *touch >= end)) continue;
      const DistanceOfTrees there = distance_at(concern, *touch, 2 * rate * finest);
      const std::string& other = concern.other != nullptr ? concern.other->name : cell_.names()[there.other];
      earliest = Hindrance{*touch, concern.part->name + " touches " + other, {concern.part->name, other}};
    }
    return earliest;
  }

 private:
  struct Concern {
    const MovingPart* part;
    const TriangleTree* still;  // or those of the other part
    const MovingPart* other;    // null for what stands
  };

  [[nodiscard]] const std::vector<Pose>& links(double degrees) {
    auto& links = links_[degrees];
    if (!links.empty()) return links;
    kinematics::Angles angles = from_;
    if (joint_) angles[*joint_] += std::copysign(degrees, degrees_);
    return links = arm_.link_poses(angles);
  }
  [[nodiscard]] Pose pose(const MovingPart& part, double degrees) {
    const Pose& link = links(degrees)[part.link];
    return part.mover == Mover::Held ? within(link, *load_.held) : link;
  }
  /// By how much a point of a part moves at most, per degree.
  [[nodiscard]] double speed(const MovingPart& part) {
    const Ball whole = part.around(pose(part, 0));
    return turn_.moved(turn_.motion(part.link), whole.center, whole.radius, 1);
  }
  /// The distance at an angle, if it is less than what the parts move, reduced by more than rounding.
  [[nodiscard]] DistanceOfTrees distance_at(const Concern& concern, double degrees, double moved) {
    ++queries_;
    const double rounding = kRounding * reach_;
    Pose at = pose(*concern.part, degrees);
    if (concern.other != nullptr) at = within(inverse(pose(*concern.other, degrees)), at);
    DistanceOfTrees found = distance(concern.part->triangles, at, *concern.still, moved + 2 * rounding);
    found.lower -= rounding;
    return found;
  }

  /// What stands, the floor included, less what held material may rest on.
  [[nodiscard]] TriangleTree not_below() {
    if (!load_.held) return TriangleTree({});
    std::vector<NamedTriangle> standing = cell_.standing_parts();
    const double height = lowest_of_held() + kRests * reach_;
    std::erase_if(standing, [&](const NamedTriangle& each) { return box(each.triangle).high.z() <= height; });
    return TriangleTree(std::move(standing));
  }
  /// The least height of held material on the whole move.
  [[nodiscard]] double lowest_of_held() {
    const Pose held = within(links(0).back(), *load_.held);
    const bool turned = turn_.motion(arm_.links.size() - 1) == JointTurn::Motion::Turned;
    double lowest = std::numeric_limits<double>::infinity();
    for (const NamedTriangle& each : cell_.material())
      for (const Eigen::Vector3d& vertex : {each.triangle.a, each.triangle.b, each.triangle.c}) {
        const Eigen::Vector3d point = held * vertex;
        // What is shifted goes along the arc of the joint that makes up for the turning.
        const Eigen::Vector3d goes_round = turned || !joint_ ? point : *turn_.pivot();
        lowest = std::min(lowest, point.z() + lowest_on_arc(goes_round));
      }
    return lowest;
  }
  /// By how much a point that turns about the axis sinks below its height at the start, at most: 0 or less.
  [[nodiscard]] double lowest_on_arc(const Eigen::Vector3d& point) const {
    if (!joint_) return 0;
    const Eigen::Vector3d axis = turn_.axis() * (degrees_ < 0 ? -1 : 1), arm = point - turn_.on_axis();
    const double c = (arm - arm.dot(axis) * axis).z(), s = axis.cross(arm).z();
    const double end = std::abs(degrees_) * (std::numbers::pi / 180);
    const auto height = [&](double angle) { return c * std::cos(angle) + s * std::sin(angle) - c; };
    double least = std::min(0.0, height(end));
    double bottom = std::atan2(s, c) + std::numbers::pi;
    while (bottom >= 2 * std::numbers::pi) bottom -= 2 * std::numbers::pi;
    if (bottom < end) least = std::min(least, -std::hypot(c, s) - c);
    return least;
  }

  const Workcell& cell_;
  const Arm& arm_;
  const std::vector<MovingPart>& parts_;
  const kinematics::Angles& from_;
  std::optional<Moved> joint_;
  JointTurn turn_;
  double degrees_;
  const Sweep::Load& load_;
  std::uint64_t& queries_;
  std::map<double, std::vector<Pose>> links_;  // by degrees
  double reach_;
  TriangleTree not_below_;
  std::vector<Concern> concerns_;
};

Sweep::Sweep(const Workcell& workcell)
    : workcell_(&workcell), parts_(moving_parts(workcell, true)), without_floor_(workcell.standing_triangles()) {
  std::erase_if(parts_, [](const MovingPart& part) { return part.mover == Mover::Sphere; });
  const Arm& arm = workcell.arm();
  const std::vector<Pose> home = arm.link_poses(arm.home);
  const auto frame = [&](const MovingPart& part) {
    return arm.links[part.link].frame ? static_cast<long>(*arm.links[part.link].frame) : -1;
  };
  const double near = kRounding * workcell.plane().furthest();
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (std::size_t j = i + 1; j < parts_.size(); ++j) {
      const MovingPart &one = parts_[i], &other = parts_[j];
      if (std::abs(frame(one) - frame(other)) <= 1) continue;
      const bool held = one.mover == Mover::Held || other.mover == Mover::Held;
      const Pose relative = within(inverse(home[other.link]), home[one.link]);
      if (held || distance(one.triangles, relative, other.triangles, 2 * near).lower > near) pairs_.emplace_back(i, j);
    }
}

std::optional<Hindrance> Sweep::along(const kinematics::Angles& from, Moved joint, double degrees, const Load& load,
                                      std::uint64_t& queries) const {
  return SweptMove(*this, from, joint, degrees, load, queries).first();
}

std::optional<Hindrance> Sweep::at_rest(const kinematics::Angles& commanded, const Load& load,
                                        std::uint64_t& queries) const {
  return SweptMove(*this, commanded, std::nullopt, 0, load, queries).first();
}

}  // namespace touchstone::cell
