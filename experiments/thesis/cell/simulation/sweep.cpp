// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/sweep.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
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

constexpr double kRoundingOfReach = 1e-12;  // of the arm's reach: more than a posed point is off
constexpr double kRests = 1e-9;  // of the arm's reach: what lies so little higher than held material is below it

}  // namespace

/// A move of one joint, and what is to be shown clear of what on it.
class SweptMove {
 public:
  SweptMove(const Sweep& sweep, const kinematics::Angles& from, const Step& step, const MaterialTransfer& state,
            std::uint64_t& queries, const Allowed& allowed)
      : cell_(*sweep.workcell_),
        arm_(cell_.arm()),
        parts_(sweep.parts_),
        from_(from),
        step_(step),
        state_(state),
        queries_(queries),
        reach_(cell_.plane().furthest()) {
    for (const Moved joint : {kBase, kShoulder, kElbow})
      if (step.by[joint] != 0) turns_.emplace_back(arm_, from, joint);
    not_below_.emplace(not_below(allowed.resting));
    for (const MovingPart& part : parts_) {
      if (!turns_.empty() && !moves(part.link)) continue;
      if (!part.is_there(state_)) continue;
      if (part.mover == Mover::Sphere) {
        if (allowed.sphere) continue;
        concerns_.push_back({&part, &sweep.without_floor_, nullptr});
        if (allowed.copy != nullptr)
          concerns_.push_back({&part, &cell_.material_tree(), nullptr, inverse(allowed.copy->pose)});
        continue;
      }
      if (part.mover == Mover::Held) {
        concerns_.push_back({&part, &*not_below_, nullptr});
        continue;
      }
      concerns_.push_back({&part, arm_.links[part.link].frame ? &cell_.standing() : &sweep.without_floor_, nullptr});
      if (state_.lies) concerns_.push_back({&part, &cell_.material_tree(), nullptr, inverse(state_.lies->pose)});
    }
    for (const auto& [i, j] : sweep.pairs_) {
      const MovingPart &one = parts_[i], &other = parts_[j];
      if (!one.is_there(state_) || !other.is_there(state_)) continue;
      const auto apart = [&](const JointTurn& turn) { return turn.motion(one.link) != turn.motion(other.link); };
      if (turns_.empty() || std::ranges::any_of(turns_, apart)) concerns_.push_back({&one, &other.triangles, &other});
    }
  }

  [[nodiscard]] bool is_clear() {
    const double end = std::abs(step_.degrees);
    return std::ranges::all_of(concerns_, [&](const Concern& concern) {
      const double rate = rate_of(concern), before = distance_at(concern, 0, rate * end).lower;
      if (before > rate * end) return true;
      const auto apart = [&](double degrees, const Clearance& part) {
        return distance_at(concern, degrees, rate * (part.end - part.begin)).lower;
      };
      Clearance whole{0, before, end, 0};
      whole.at_end = apart(end, whole);
      return by_halves(
          whole,
          [&](const Clearance& part) {
            if (!(part.at_begin > 0 && part.at_end > 0)) return Next::Stop;
            if (part.least(rate) > 0) return Next::Done;
            return part.end - part.begin > kFinest * cell_.cell().step ? Next::Halve : Next::Stop;
          },
          apart);
    });
  }

  [[nodiscard]] std::optional<Hindrance> first() {
    std::optional<Hindrance> earliest;
    for (const Concern& concern : concerns_) {
      const double end = earliest ? earliest->degrees : std::abs(step_.degrees), finest = kFinest * cell_.cell().step;
      const double rate = rate_of(concern);
      const auto apart = [&](double degrees, double moved) { return distance_at(concern, degrees, moved).lower; };
      const double before = apart(0, rate * end);
      if (before > rate * end) continue;
      const auto touch = first_touch(
          {0, before, end, apart(end, rate * end)}, rate, finest,
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
    const TriangleTree* still;          // or those of the other part
    const MovingPart* other;            // null for what stands
    std::optional<Pose> to_still = {};  // if `still` is not in the cell's frame
  };

  [[nodiscard]] const std::vector<Pose>& links(double degrees) {
    auto& links = links_[degrees];
    if (!links.empty()) return links;
    return links = arm_.link_poses(step_.after(from_, degrees));
  }
  [[nodiscard]] Pose pose(const MovingPart& part, double degrees) { return part.pose(links(degrees), state_); }
  [[nodiscard]] bool moves(std::size_t link) const {
    return std::ranges::any_of(turns_,
                               [&](const JointTurn& turn) { return turn.motion(link) != JointTurn::Motion::None; });
  }
  /// By how much the distance changes at most, per degree.
  [[nodiscard]] double rate_of(const Concern& concern) {
    if (turns_.empty()) return 0;
    if (concern.other == nullptr) return speed(*concern.part, step_);
    Step between = step_;  // what moves both alike does not change their distance
    for (const JointTurn& turn : turns_)
      if (turn.motion(concern.part->link) == turn.motion(concern.other->link)) between.by[turn.joint()] = 0;
    return speed(*concern.part, between) + speed(*concern.other, between);
  }
  /// By how much a point of a part moves at most, per degree of the whole step.
  [[nodiscard]] double speed(const MovingPart& part, const Step& step) {
    return moved(arm_, from_, step, part.link, part.around(pose(part, 0))) / std::abs(step_.degrees);
  }
  /// The distance at an angle, if it is less than what the parts move, reduced by more than rounding.
  [[nodiscard]] DistanceOfTrees distance_at(const Concern& concern, double degrees, double moved) {
    ++queries_;
    const double rounding = kRoundingOfReach * reach_;
    Pose at = pose(*concern.part, degrees);
    if (concern.other != nullptr) at = within(inverse(pose(*concern.other, degrees)), at);
    if (concern.to_still) at = within(*concern.to_still, at);
    const double beside = concern.part->radius * JointTurn::kGenerous + rounding;
    DistanceOfTrees found = distance(concern.part->triangles, at, *concern.still, moved + rounding + beside);
    found.lower -= beside;
    return found;
  }

  /// What stands, the floor included, less what held material may rest on.
  [[nodiscard]] TriangleTree not_below(bool may_rest) {
    if (!state_.in_flange) return TriangleTree({});
    std::vector<NamedTriangle> standing = cell_.standing_parts();
    if (!may_rest) return TriangleTree(std::move(standing));
    const double height = lowest_of_held() + kRests * reach_;
    std::erase_if(standing, [&](const NamedTriangle& each) { return box(each.triangle).high.z() <= height; });
    return TriangleTree(std::move(standing));
  }
  /// A height that held material does not sink below on the whole move.
  [[nodiscard]] double lowest_of_held() {
    const Pose from = within(links(0).back(), *state_.in_flange),
               to = within(links(std::abs(step_.degrees)).back(), *state_.in_flange);
    double turned = 0, lowest = std::numeric_limits<double>::infinity();
    for (const double by : step_.by) turned += std::abs(by) * (std::numbers::pi / 180);
    // What several joints move changes its height at a rate that differs by less than this from one end to the other.
    const double bend = 2 * reach_ * turned * turned;
    for (const NamedTriangle& each : cell_.material())
      for (const Eigen::Vector3d& vertex : {each.triangle.a, each.triangle.b, each.triangle.c}) {
        const Eigen::Vector3d point = from * vertex;
        const double rise = turns_.size() > 1 ? (to * vertex).z() - point.z() : 0;
        if (turns_.size() > 1 && std::abs(rise) <= bend) return -std::numeric_limits<double>::infinity();
        lowest = std::min(lowest, point.z() + (turns_.size() == 1 ? lowest_on_arc(point) : std::min(0.0, rise)));
      }
    return lowest;
  }
  /// By how much a point that turns about the axis sinks below its height at the start, at most: 0 or less.
  [[nodiscard]] double lowest_on_arc(const Eigen::Vector3d& point) const {
    const JointTurn& turn = turns_.front();
    // What is shifted goes along the arc of the joint that makes up for the turning.
    const bool shifted = turn.motion(arm_.links.size() - 1) == JointTurn::Motion::Shifted;
    const Eigen::Vector3d axis = turn.axis() * (step_.degrees < 0 ? -1 : 1),
                          arm = (shifted ? *turn.pivot() : point) - turn.on_axis();
    const double c = (arm - arm.dot(axis) * axis).z(), s = axis.cross(arm).z();
    const double end = std::abs(step_.degrees) * (std::numbers::pi / 180);
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
  Step step_;
  std::vector<JointTurn> turns_;  // none for the arm at rest
  const MaterialTransfer& state_;
  std::uint64_t& queries_;
  std::map<double, std::vector<Pose>> links_;  // by degrees
  double reach_;
  std::optional<TriangleTree> not_below_;
  std::vector<Concern> concerns_;
};

Sweep::Sweep(const Workcell& workcell, bool sphere_alone)
    : workcell_(&workcell),
      sphere_alone_(sphere_alone),
      parts_(moving_parts(workcell, true)),
      without_floor_(workcell.standing_triangles()) {
  std::erase_if(parts_, [&](const MovingPart& part) { return sphere_alone && part.mover != Mover::Sphere; });
  const Arm& arm = workcell.arm();
  const std::vector<Pose> home = arm.link_poses(arm.home);
  const auto frame = [&](const MovingPart& part) {
    return arm.links[part.link].frame ? static_cast<long>(*arm.links[part.link].frame) : -1;
  };
  const double near = kRoundingOfReach * workcell.plane().furthest();
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (std::size_t j = i + 1; j < parts_.size(); ++j) {
      const MovingPart &one = parts_[i], &other = parts_[j];
      if (std::abs(frame(one) - frame(other)) <= 1 || other.mover == Mover::Sphere) continue;
      const bool held = one.mover == Mover::Held || other.mover == Mover::Held;
      const Pose relative = within(inverse(home[other.link]), home[one.link]);
      if (held || distance(one.triangles, relative, other.triangles, 2 * near).lower > near) pairs_.emplace_back(i, j);
    }
}

std::optional<Hindrance> Sweep::along(const kinematics::Angles& from, Moved joint, double degrees,
                                      const MaterialTransfer& state, std::uint64_t& queries) const {
  return along(from, step_of(joint, degrees), state, queries);
}

std::optional<Hindrance> Sweep::along(const kinematics::Angles& from, const Step& step, const MaterialTransfer& state,
                                      std::uint64_t& queries, const Allowed& allowed) const {
  return SweptMove(*this, from, step, state, queries, allowed).first();
}

bool Sweep::is_clear(const kinematics::Angles& from, const Step& step, const MaterialTransfer& state,
                     std::uint64_t& queries, const Allowed& allowed) const {
  return SweptMove(*this, from, step, state, queries, allowed).is_clear();
}

std::optional<Hindrance> Sweep::at_rest(const kinematics::Angles& commanded, const MaterialTransfer& state,
                                        std::uint64_t& queries) const {
  return SweptMove(*this, commanded, step_of(kBase, 0), state, queries, {}).first();
}

}  // namespace touchstone::cell
