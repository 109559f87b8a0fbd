// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/sweep.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "experiments/thesis/cell/simulation/joint_turn.h"
#include "experiments/thesis/cell/simulation/triangle_gap.h"

namespace touchstone::cell {
namespace {

constexpr double kGenerous = JointTurn::kGenerous;
constexpr double kRounding = 1e-12;   // of the arm's reach: more than a posed point is off
constexpr double kRests = 1e-9;       // of the arm's reach: what lies so little higher than held material is below it
constexpr double kFinest = 1.0 / 64;  // of a step

}  // namespace

/// A move of one joint, and what is still to be shown clear of what in an interval of it.
class SweptMove {
 public:
  /// `joint` is empty for the arm at rest.
  SweptMove(const Sweep& sweep, const kinematics::Angles& from, std::optional<Moved> joint, double degrees,
            const Sweep::Load& load, std::uint64_t& queries)
      : cell_(*sweep.workcell_),
        arm_(cell_.arm()),
        from_(from),
        joint_(joint),
        turn_(arm_, from, joint),
        degrees_(degrees),
        load_(load),
        queries_(queries),
        in_the_way_(cell_.in_the_way(load.material, true)),
        fixed_in_the_way_(cell_.in_the_way(load.material, false)),
        reach_(cell_.plane().furthest()),
        finest_(cell_.cell().step * kFinest) {
    const auto& covered = cell_.covered();
    for (std::size_t i = 0; i < covered.size(); ++i)
      if (covered[i].carrier == Carrier::Link && (!joint_ || turn_.motion(covered[i].link) != Motion::None))
        concerns_.push_back({Concern::Kind::Part, i, 0});
    concerns_.push_back({Concern::Kind::Gripper, 0, 0});
    if (load_.held) concerns_.push_back({Concern::Kind::Held, 0, 0});
    for (const auto& [i, j] : sweep.pairs_) {
      const bool held = covered[i].carrier == Carrier::Material || covered[j].carrier == Carrier::Material;
      if (held && !load_.held) continue;
      if (!joint_ || turn_.motion(link_of(i)) != turn_.motion(link_of(j)))
        concerns_.push_back({Concern::Kind::Pair, i, j});
    }
    if (load_.held) lowest_ = lowest_of_held();
  }

  [[nodiscard]] std::optional<Hindrance> first() { return first(0, std::abs(degrees_), concerns_); }

 private:
  using Motion = JointTurn::Motion;
  struct Concern {
    enum class Kind { Part, Gripper, Held, Pair } kind;
    std::size_t first, second;  // of covered parts
  };
  struct Poses {
    std::vector<Pose> links;
    Pose held;
  };

  [[nodiscard]] std::size_t link_of(std::size_t covered) const {
    const Covered& part = cell_.covered()[covered];
    return part.carrier == Carrier::Material ? arm_.links.size() - 1 : part.link;
  }
  [[nodiscard]] Poses poses(double degrees) const {
    kinematics::Angles angles = from_;
    if (joint_) angles[*joint_] += std::copysign(degrees, degrees_);
    Poses poses{arm_.link_poses(angles), {}};
    if (load_.held) poses.held = within(poses.links.back(), *load_.held);
    return poses;
  }

  /// The least height of held material on the whole move.
  [[nodiscard]] double lowest_of_held() const {
    const Poses at = poses(0);
    const bool turned = turn_.motion(arm_.links.size() - 1) == Motion::Turned;
    double lowest = std::numeric_limits<double>::infinity();
    for (const NamedTriangle& each : cell_.material())
      for (const Eigen::Vector3d& vertex : {each.triangle.a, each.triangle.b, each.triangle.c}) {
        const Eigen::Vector3d point = at.held.rotation * vertex + at.held.translation;
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

  /// Goes through halves of the interval, the earlier first, with what could not be shown clear in the whole.
  std::optional<Hindrance> first(double begin, double end, const std::vector<Concern>& concerns) {
    const double half = (end - begin) / 2;
    const Poses at = poses(begin + half);
    std::vector<Concern> open;
    std::optional<Hindrance> found;
    for (const Concern& concern : concerns) {
      std::optional<Hindrance> met = meets(concern, at, half);
      if (!met) continue;
      if (!found) found = std::move(met);
      open.push_back(concern);
    }
    if (open.empty()) return std::nullopt;
    if (end - begin <= finest_) {
      found->degrees = begin;
      return found;
    }
    if (auto early = first(begin, begin + half, open)) return early;
    return first(begin + half, end, open);
  }

  [[nodiscard]] std::optional<Hindrance> meets(const Concern& concern, const Poses& at, double half) {
    const auto& covered = cell_.covered();
    switch (concern.kind) {
      case Concern::Kind::Part: return part_meets(covered[concern.first], at.links[covered[concern.first].link], half);
      case Concern::Kind::Gripper: {
        auto met = triangles_meet(cell_.gripper(), at.links.back(), half, cell_.standing(), {});
        if (!met && load_.material)
          met = triangles_meet(cell_.gripper(), at.links.back(), half, cell_.material_in(*load_.material), {});
        return met;
      }
      case Concern::Kind::Held: return triangles_meet(cell_.material(), at.held, half, cell_.standing(), lowest_);
      case Concern::Kind::Pair: break;
    }
    const Covered &one = covered[concern.first], &other = covered[concern.second];
    const auto pose_of = [&](const Covered& part) {
      return part.carrier == Carrier::Material ? at.held : at.links[part.link];
    };
    const auto by = [&](const Covered& part, std::size_t number) {
      const Ball whole = posed_generously(pose_of(part), part.cover.whole());
      return turn_.moved(turn_.motion(link_of(number)), whole.center, whole.radius, half);
    };
    ++queries_;
    if (!one.cover.may_be_near(pose_of(one), other.cover, pose_of(other),
                               by(one, concern.first) + by(other, concern.second)))
      return std::nullopt;
    return comes_near(one.name, one.cover.overhang() + other.cover.overhang(), other.name);
  }

  [[nodiscard]] Hindrance comes_near(const std::string& part, double within, const std::string& other) const {
    return {
        0, fmt::format("{} comes within {:.3g} {} of {}", part, within, cell_.cell().unit.name, other), {part, other}};
  }

  [[nodiscard]] std::optional<Hindrance> part_meets(const Covered& part, const Pose& pose, double half) {
    const Motion its = turn_.motion(part.link);
    const auto& objects = arm_.links[part.link].frame ? in_the_way_ : fixed_in_the_way_;
    std::string touched;
    const bool any = part.cover.any(pose, [&](const Ball& ball) {
      ++queries_;
      const Ball larger{ball.center, ball.radius + turn_.moved(its, ball.center, ball.radius, half)};
      if (!cell_.scene().touches(larger, objects)) return false;
      touched = cell_.scene().name(cell_.scene().touched(larger, objects).front().object);
      return true;
    });
    if (!any) return std::nullopt;
    return comes_near(part.name, part.cover.overhang(), touched);
  }

  /// `resting`: what lies no higher is out of the question.
  [[nodiscard]] std::optional<Hindrance> triangles_meet(const std::vector<NamedTriangle>& moving, const Pose& pose,
                                                        double half, const TriangleTree& still,
                                                        std::optional<double> resting) {
    const Motion its = turn_.motion(arm_.links.size() - 1);
    for (const NamedTriangle& each : moving) {
      ++queries_;
      const auto posed = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
        return pose.rotation * p + pose.translation;
      };
      const Triangle triangle{posed(each.triangle.a), posed(each.triangle.b), posed(each.triangle.c)};
      double keep = kRounding * reach_;
      for (const Eigen::Vector3d& vertex : {triangle.a, triangle.b, triangle.c})
        keep = std::max(keep, kRounding * reach_ + turn_.moved(its, vertex, 0, half));
      touchstone::Box around = box(triangle);
      around.low.array() -= keep * kGenerous;
      around.high.array() += keep * kGenerous;
      const NamedTriangle* met = still.find(around, [&](const NamedTriangle& other) {
        if (resting && box(other.triangle).high.z() <= *resting + kRests * reach_) return false;
        return !further_apart(triangle, other.triangle, keep);
      });
      if (met != nullptr) {
        const std::string &one = cell_.names()[each.owner], &other = cell_.names()[met->owner];
        return Hindrance{0, one + " touches " + other, {one, other}};
      }
    }
    return std::nullopt;
  }

  const Workcell& cell_;
  const Arm& arm_;
  const kinematics::Angles& from_;
  std::optional<Moved> joint_;
  JointTurn turn_;
  double degrees_;
  const Sweep::Load& load_;
  std::uint64_t& queries_;
  scene::Scene::Objects in_the_way_, fixed_in_the_way_;
  double reach_, finest_;
  double lowest_ = 0;
  std::vector<Concern> concerns_;
};

Sweep::Sweep(const Workcell& workcell) : workcell_(&workcell) {
  const Arm& arm = workcell.arm();
  const std::vector<Pose> home = arm.link_poses(arm.home);
  const auto& covered = workcell.covered();
  const auto frame = [&](const Covered& part) {
    const std::size_t link = part.carrier == Carrier::Material ? arm.links.size() - 1 : part.link;
    return arm.links[link].frame ? static_cast<long>(*arm.links[link].frame) : -1;
  };
  for (std::size_t i = 0; i < covered.size(); ++i)
    for (std::size_t j = i + 1; j < covered.size(); ++j) {
      if (std::abs(frame(covered[i]) - frame(covered[j])) <= 1) continue;
      const bool held = covered[i].carrier == Carrier::Material || covered[j].carrier == Carrier::Material;
      if (!held && covered[i].cover.may_be_near(home[covered[i].link], covered[j].cover, home[covered[j].link], 0))
        continue;
      pairs_.emplace_back(i, j);
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
