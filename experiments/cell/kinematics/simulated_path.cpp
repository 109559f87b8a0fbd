// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/simulated_path.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "experiments/cell/first_contact/stepped_contact.h"

namespace touchstone::kinematics {
namespace {

std::string_view name_of(AristoJoint joint) {
  constexpr std::array<std::string_view, 3> names{"base", "shoulder", "elbow"};
  return names.at(joint);
}

class PathSimulation {
 public:
  PathSimulation(const Layout& layout, const Station& storage)
      : layout_(layout), storage_(storage), chain_(aristo(layout.coupling)), arm_(layout), angles_(home_pose(layout)) {
    obstacles_.polygons = material_in_storage(layout, storage);
    faces_of_storage_ = obstacles_.polygons.size();
    for (Polygon& face : material_at_machine(layout)) obstacles_.polygons.push_back(std::move(face));
  }

  /// Until the material is gripped and clear of the storage. False: the shoulder would have to move, and must not.
  [[nodiscard]] bool pick(Approach approach) {
    if (approach == Approach::Above) {
      come_down_at(storage_, rise_over_edge());
      grip();
      lift();
      return true;
    }
    const double beside = layout_.sphere_radius - layout_.gap;
    const auto commands = arm_.inverse(
        {std::sqrt(storage_.radius * storage_.radius + beside * beside), storage_.height + layout_.side / 2});
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the side of the material is out of reach");
    if (std::abs(commands->shoulder) >= 0.5) {
      if (approach == Approach::SideWithoutShoulder) return false;
      move_as_planned(kShoulder, commands->shoulder);
    }
    move_as_planned(kElbow, commands->elbow);
    record(up_to_contact(kBase, static_cast<int>(std::lround(storage_.azimuth - commanded(kBase))), true));
    grip();
    return true;
  }
  void place() { come_down_at(layout_.machine(), layout_.sphere_radius); }

  SimulatedPath path;

 private:
  /// Relative to home.
  [[nodiscard]] double commanded(AristoJoint joint) const { return angles_[joint] - home_pose(layout_)[joint]; }

  /// Of the centre over the upper face in storage, where the sphere comes down beside it and touches its edge.
  [[nodiscard]] double rise_over_edge() const {
    const double r = layout_.sphere_radius, beside = std::max(0.0, layout_.gap);
    return beside < r ? std::sqrt(r * r - beside * beside) : 0;
  }

  [[nodiscard]] Arc arc(AristoJoint joint, double degrees) const {
    try {
      return chain_.arc(angles_, joint, degrees, sphere_center(layout_));
    } catch (const std::out_of_range& beyond) {
      throw SimulationFailure(FailureCause::JointLimit,
                              fmt::format("{} {:+}: {}", name_of(joint), degrees, beyond.what()));
    }
  }

  [[nodiscard]] std::string_view touched(const FirstContact& contact) const {
    return contact.face < faces_of_storage_ ? "the material in storage" : "the material at the machine";
  }

  void require_free(AristoJoint joint, int degrees) const {
    if (const auto contact = first_contact(arc(joint, degrees), layout_.sphere_radius, obstacles_))
      throw SimulationFailure(FailureCause::InTheWay,
                              fmt::format("{} {:+}: the sphere touches {} after {:.2f} degrees", name_of(joint),
                                          degrees, touched(*contact), contact->high));
  }

  void record(const Move& move) {
    angles_[move.joint] += move.degrees;
    path.moves.push_back(move);
  }

  void move_as_planned(AristoJoint joint, double target) {
    const double exact = target - commanded(joint);
    const int degrees = static_cast<int>(std::lround(exact));
    require_free(joint, degrees);
    record({joint, Until::Planned, degrees, exact, {}, 0.5 - std::abs(exact - degrees)});
  }

  /// A move of at most so many degrees that ends at the first whole degree at which the sphere touches what it is to.
  [[nodiscard]] Move up_to_contact(AristoJoint joint, int most, bool in_storage) const {
    const Arc way = arc(joint, most);
    const auto contact = first_contact(way, layout_.sphere_radius, obstacles_);
    if (!contact)
      throw SimulationFailure(FailureCause::NoContact,
                              fmt::format("{} {:+}: the sphere touches nothing", name_of(joint), most));
    if ((contact->face < faces_of_storage_) != in_storage)
      throw SimulationFailure(FailureCause::InTheWay,
                              fmt::format("{} {:+}: the sphere touches {}", name_of(joint), most, touched(*contact)));
    const auto stop = stepped_contact(way, layout_.sphere_radius, 1, obstacles_);
    if (!stop || stop->degrees != std::ceil(contact->high))
      throw SimulationFailure(FailureCause::NoContact,
                              fmt::format("{} {:+}: steps of 1 degree pass over the contact at {:.2f}", name_of(joint),
                                          most, contact->high));
    const int degrees = static_cast<int>(stop->stop) * (most < 0 ? -1 : 1);
    const double left = stop->degrees - contact->low;
    return {joint, Until::Contact, degrees, std::copysign(contact->low, most), contact, std::min(left, 1 - left)};
  }

  /// The elbow as planned, the base, then the shoulder down to the upper face.
  void come_down_at(const Station& station, double rise) {
    const bool in_storage = faces_of_storage_ > 0;
    const auto commands = arm_.inverse({station.radius, station.height + layout_.side + rise});
    if (!commands) throw SimulationFailure(FailureCause::OutOfReach, "the upper face of the material is out of reach");
    move_as_planned(kElbow, commands->elbow);
    const int turn = static_cast<int>(std::lround(station.azimuth - commanded(kBase)));
    require_free(kBase, turn);
    record({kBase, Until::Facing, turn, station.azimuth - commanded(kBase), {}, 1});
    const int most = static_cast<int>(std::floor(chain_.room(angles_, kShoulder, true)));
    record(up_to_contact(kShoulder, most, in_storage));
  }

  /// What has been gripped is no obstacle any more.
  void grip() {
    obstacles_.polygons.erase(obstacles_.polygons.begin(),
                              obstacles_.polygons.begin() + static_cast<std::ptrdiff_t>(faces_of_storage_));
    faces_of_storage_ = 0;
  }

  void lift() {
    const double shoulder = commanded(kShoulder), elbow = commanded(kElbow), from = arm_.reach({shoulder, elbow}).up;
    const auto clear = [&](double up) { return arm_.reach({shoulder - up, elbow}).up >= from + layout_.clearance; };
    int degrees = 0;
    while (!clear(degrees))
      if (++degrees > 90) throw SimulationFailure(FailureCause::NoContact, "shoulder: no lift clears the storage");
    double low = std::max(0, degrees - 1), high = degrees;
    for (int i = 0; i < 60; ++i) (clear((low + high) / 2) ? high : low) = (low + high) / 2;
    require_free(kShoulder, -degrees);
    record({kShoulder, Until::Cleared, -degrees, -high, {}, std::min(degrees - high, 1 - (degrees - high))});
  }

  const Layout& layout_;
  const Station& storage_;
  Chain chain_;
  SphereArm arm_;
  Angles angles_;
  scene::Faces obstacles_;  // in storage first
  std::size_t faces_of_storage_;
};

}  // namespace

int SimulatedPath::to_storage(AristoJoint joint) const {
  int sum = 0;
  for (const Move& move : moves) {
    if (move.joint == joint) sum += move.degrees;
    if (move.until == Until::Contact) break;
  }
  return sum;
}

int SimulatedPath::net(AristoJoint joint) const {
  int sum = 0;
  for (const Move& move : moves)
    if (move.joint == joint) sum += move.degrees;
  return sum;
}

SimulatedPath simulate(const Layout& layout, const Station& storage) {
  SimulatedPath none;
  for (const Approach approach : {Approach::SideWithoutShoulder, Approach::Above, Approach::Side}) {
    PathSimulation simulation(layout, storage);
    try {
      if (!simulation.pick(approach)) continue;
      simulation.place();
      return std::move(simulation.path);
    } catch (const SimulationFailure& failed) {
      if (approach == Approach::Above) none.failure = fmt::format("from above: {}", failed.what());
      if (approach == Approach::Side) none.failure += fmt::format("; from the side: {}", failed.what());
      none.cause = failed.cause;
    }
  }
  return none;
}

std::string difference(const SimulatedPath& path, const Captions& captions) {
  if (!path.complete()) return path.failure;
  std::vector<std::pair<AristoJoint, int>> expected{{kElbow, captions.elbow}, {kBase, captions.base}};
  if (captions.shoulder != 0) expected.emplace_back(kShoulder, captions.shoulder);
  if (captions.lift != 0) expected.emplace_back(kShoulder, captions.lift);
  expected.emplace_back(kElbow, captions.elbow_to_machine);
  expected.emplace_back(kBase, captions.base_to_machine);
  expected.emplace_back(kShoulder, captions.shoulder_to_machine);
  if (path.moves.size() != expected.size())
    return fmt::format("{} moves where the captions name {}", path.moves.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.joint != expected[i].first || move.degrees != expected[i].second)
      return fmt::format("move {}: {} {:+} where the caption says {} {:+}", i + 1, name_of(move.joint), move.degrees,
                         name_of(expected[i].first), expected[i].second);
  }
  return "";
}

}  // namespace touchstone::kinematics
