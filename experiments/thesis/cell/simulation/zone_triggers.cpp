// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/zone_triggers.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "experiments/thesis/cell/simulation/moving_parts.h"

namespace touchstone::cell {
namespace {

/// A virtual object in the cell: what is within `radius` of the triangles, or in the box.
struct Posed {
  TriangleTree triangles;
  double radius = 0;
  std::optional<Eigen::AlignedBox3d> box;
  Pose to_zone;
};

struct Shaper {
  const Pose& pose;

  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const { return pose * point; }
  Posed operator()(const Zone::Face& face) const {
    std::vector<NamedTriangle> fan;
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
      fan.push_back({{at(face.corners[0]), at(face.corners[i]), at(face.corners[i + 1])}, 0});
    return {TriangleTree(std::move(fan)), 0, {}, {}};
  }
  Posed operator()(const Eigen::AlignedBox3d& box) const {
    std::vector<NamedTriangle> sides;
    const auto corner = [&](int number) {
      return at(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(number)));
    };
    for (const auto& [a, b, c, d] :
         {std::array{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
      sides.push_back({{corner(a), corner(b), corner(c)}, 0});
      sides.push_back({{corner(a), corner(c), corner(d)}, 0});
    }
    return {TriangleTree(std::move(sides)), 0, box, inverse(pose)};
  }
  Posed operator()(const Zone::Capsule& capsule) const {
    return {TriangleTree({{{at(capsule.from), at(capsule.to), at(capsule.to)}, 0}}), capsule.radius, {}, {}};
  }
};

/// One part of a mover and one virtual object.
class Watch {
 public:
  Watch(const Workcell& cell, const MovingPart& part, const Posed& zone) : cell_(cell), part_(part), zone_(zone) {}

  /// A lower bound of their distance; 0 if the part may be in.
  [[nodiscard]] double apart(const std::vector<Pose>& links, const MaterialTransfer& state, double cutoff) const {
    const Pose pose = part_.pose(links, state);
    const double lower =
        part_.distance_from(zone_.triangles, pose, cutoff + zone_.radius).lower - zone_.radius * JointTurn::kGenerous;
    return lower > 0 && !within_box(pose) ? lower : 0;
  }

  /// The first angle of a way, from 0 to `degrees` of the joint's step, up to which the part is certainly outside; none
  /// if it is on the whole way.
  [[nodiscard]] std::optional<double> comes_in(const Stop& from, const Step& step, const MaterialTransfer& state,
                                               double moved, double at_begin, double at_end) const {
    const double degrees = std::abs(step.degrees), rate = degrees > 0 ? moved / degrees : 0;
    return first_touch({0, at_begin, degrees, at_end}, rate, kFinest * cell_.cell().step,
                       [&](double middle, const Clearance& part) {
                         return apart(cell_.arm().link_poses(step.after(from.commanded, middle)), state,
                                      rate * (part.end - part.begin));
                       });
  }

 private:
  // Surfaces that are apart: then one vertex tells, for each of a part's surfaces.
  [[nodiscard]] bool within_box(const Pose& pose) const {
    if (!zone_.box) return false;
    const Pose in_zone = within(zone_.to_zone, pose);
    return part_.triangles.any(
        [&](const NamedTriangle& each) { return zone_.box->contains(Eigen::Vector3d(in_zone * each.triangle.a)); });
  }

  const Workcell& cell_;
  const MovingPart& part_;
  const Posed& zone_;
};

/// Follows the parts of one mover and one virtual object along the run.
class Follower {
 public:
  Follower(const Workcell& cell, const Process& process, std::size_t zone, Mover mover)
      : cell_(cell), process_(process), zone_(zone), mover_(mover) {}

  void is_out(std::size_t stop) {
    if (open_) triggers.back().until = stop;
    open_ = false;
  }
  void is_in(std::size_t after, double degrees, const std::string& part, const Step* step, std::size_t until) {
    if (!open_) {
      kinematics::Angles angles = process_.stops[after].commanded;
      if (step != nullptr) angles = step->after(angles, degrees);
      triggers.push_back({zone_, mover_, part, after, degrees, until, cell_.arm().sphere_at(angles).center});
      open_ = true;
    }
    triggers.back().until = until;
  }
  std::vector<Trigger> triggers;

 private:
  const Workcell& cell_;
  const Process& process_;
  std::size_t zone_;
  Mover mover_;
  bool open_ = false;
};

std::vector<Trigger> triggers_of(const Workcell& cell, const Process& process, const std::vector<MovingPart>& parts,
                                 std::size_t number, Mover mover) {
  const Posed zone = std::visit(Shaper{cell.cell().zones[number].pose}, cell.cell().zones[number].shape);
  Follower follower(cell, process, number, mover);
  for (const Stretch& stretch : stretches_of(process)) {
    if (mover == Mover::Held && stretch.state->slot) {
      follower.is_out(stretch.first);
      continue;
    }
    std::vector<double> apart(parts.size(), 0);
    std::vector<Pose> links = cell.arm().link_poses(process.stops[stretch.first].commanded);
    const auto measured = [&](std::size_t p, double known, double moved) {
      return known > moved ? known : Watch(cell, parts[p], zone).apart(links, *stretch.state, kAhead * moved + 1e-9);
    };
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (parts[p].mover != mover) continue;
      apart[p] = Watch(cell, parts[p], zone).apart(links, *stretch.state, cell.plane().furthest());
      if (!(apart[p] > 0) && stretch.first == stretch.last)
        follower.is_in(stretch.first, 0, parts[p].name, nullptr, stretch.first);
    }
    for (std::size_t stop = stretch.first; stop < stretch.last; ++stop) {
      const Stop &from = process.stops[stop], &to = process.stops[stop + 1];
      const WayBetween way = way_between(cell.arm(), parts, from, to, links, *stretch.state);
      links = cell.arm().link_poses(to.commanded);
      std::optional<std::pair<double, std::size_t>> earliest;
      for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].mover != mover) continue;
        const double before = apart[p];
        apart[p] = measured(p, std::max(0.0, before - way.moved[p]), way.moved[p]);
        const auto in =
            Watch(cell, parts[p], zone).comes_in(from, way.step, *stretch.state, way.moved[p], before, apart[p]);
        if (in && (!earliest || *in < earliest->first)) earliest = {*in, p};
        if (!in && !(apart[p] > 0) && !earliest) earliest = {std::abs(way.step.degrees), p};
      }
      if (earliest)
        follower.is_in(stop, earliest->first, parts[earliest->second].name, &way.step, stop + 1);
      else
        follower.is_out(stop);
    }
  }
  return std::move(follower.triggers);
}

/// Where the parts that come into an object have got to, in the words of a move.
std::string where(const Workcell& cell, const Process& process, const Trigger& trigger) {
  const std::size_t next = trigger.after + 1;
  if (next >= process.stops.size()) return "at the end";
  const std::size_t number = process.stops[next].move;
  if (number >= process.moves.size()) return "in a move that is not completed";
  const Move& move = process.moves[number];
  std::size_t first = next;
  while (first > 1 && process.stops[first - 1].move == number) --first;
  const double turned =
      std::abs(process.stops[trigger.after].commanded[move.joint] - process.stops[first - 1].commanded[move.joint]) +
      trigger.degrees;
  return fmt::format("{} {} {:+g}: after {:.2f} degrees", to_string(move.phase),
                     cell.arm().chain.joints()[move.joint].name, move.degrees, turned);
}

}  // namespace

std::vector<Trigger> zone_triggers(const Workcell& workcell, const Process& process, bool sphere_alone) {
  std::vector<Trigger> all;
  if (workcell.cell().zones.empty()) return all;
  const std::vector<MovingPart> parts = moving_parts(workcell);
  for (std::size_t zone = 0; zone < workcell.cell().zones.size(); ++zone)
    for (const Mover mover : kMovers) {
      if (sphere_alone && mover != Mover::Sphere) continue;
      for (Trigger& trigger : triggers_of(workcell, process, parts, zone, mover)) all.push_back(std::move(trigger));
    }
  std::ranges::stable_sort(all, {}, [](const Trigger& t) { return std::tuple(t.after, t.degrees, t.zone); });
  return all;
}

void stop_at_zones(const Workcell& workcell, Process& process) {
  const auto& zones = workcell.cell().zones;
  const auto stopping = [&](const Trigger& trigger) { return zones[trigger.zone].stops; };
  const auto found = std::ranges::find_if(process.triggers, stopping);
  if (found == process.triggers.end()) return;
  const Trigger trigger = *found;
  const std::string place = where(workcell, process, trigger);
  Stuck stuck{
      fmt::format("{} {} comes into the zone {}, which stops the robot", place, trigger.part, zones[trigger.zone].name),
      process.stops[trigger.after].commanded,
      {trigger.part, zones[trigger.zone].name}};
  if (trigger.after + 1 < process.stops.size()) {
    const Step step = step_between(process.stops[trigger.after], process.stops[trigger.after + 1]);
    stuck.commanded = step.after(stuck.commanded, trigger.degrees);
  }
  const std::size_t move = process.stops[trigger.after].move;
  const bool completed =
      trigger.after > 0 && (trigger.after + 1 == process.stops.size() || process.stops[trigger.after + 1].move != move);
  process.moves.resize(std::min(process.moves.size(), move + (completed ? 1 : 0)));
  process.stops.resize(trigger.after + 1);
  std::erase_if(process.transfers, [&](const MaterialTransfer& transfer) { return transfer.stop > trigger.after; });
  std::erase_if(process.triggers, [&](const Trigger& t) {
    return std::tuple(t.after, t.degrees) > std::tuple(trigger.after, trigger.degrees);
  });
  for (Trigger& each : process.triggers) each.until = std::min(each.until, trigger.after);
  process.failure = stuck.reason;
  process.stuck = std::move(stuck);
  process.cause = FailureCause::InTheWay;
}

}  // namespace touchstone::cell
