// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing jumps, and nothing goes through anything: what is put down lies where it was lowered to, what is held stays
// in the hand. Poses, gaps and crossings are computed here by triangles, without the simulation's distances.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners posed(const Pose& pose, const Triangle& t) { return {pose * t.a, pose * t.b, pose * t.c}; }

/// Where the material is with the arm at some angles, in the state that a transfer leaves.
Pose material_at(const Workcell& workcell, const kinematics::Angles& angles, const MaterialTransfer& state) {
  return state.slot ? state.lies->pose : within(workcell.arm().link_poses(angles).back(), *state.in_flange);
}

/// How far a vertex of the material is moved from one pose to another.
double moved(const Workcell& workcell, const Pose& from, const Pose& to) {
  double most = 0;
  for (const auto& [t, owner] : workcell.material())
    for (const Eigen::Vector3d& v : {t.a, t.b, t.c}) most = std::max(most, (from * v - to * v).norm());
  return most;
}

void nothing_jumps(const Workcell& workcell, const std::string& name) {
  const Process process = simulate(workcell);
  ASSERT_EQ(process.failure, "") << name;
  ASSERT_EQ(process.transfers.size(), 5U) << name;
  for (std::size_t i = 1; i < process.stops.size(); ++i) {
    const MaterialTransfer& state = process.holding(i);
    if (!state.slot) continue;
    const auto at = [&](std::size_t stop) {
      return material_at(workcell, process.stops[stop].commanded, process.holding(i));
    };
    EXPECT_LE(moved(workcell, at(i - 1), at(i)), 1e-9) << name << ", stop " << i;
  }
  for (std::size_t i = 1; i < process.transfers.size(); ++i) {
    const MaterialTransfer &before = process.transfers[i - 1], &after = process.transfers[i];
    const kinematics::Angles& angles = process.stops[after.stop].commanded;
    EXPECT_LE(moved(workcell, material_at(workcell, angles, before), material_at(workcell, angles, after)), 1e-9)
        << name << ", transfer " << i;
    EXPECT_EQ(after.landing.has_value(), after.slot.has_value()) << name;
    EXPECT_LE(after.landing ? after.landing->gap : 0, 1e-9) << name;
  }
}

TEST(Landing, NoPartMovesUnlessItIsHeld) {
  for (const auto& changes : {std::vector<std::string>{},
                              kSecondCase,
                              {"material.slot=A"},
                              {"material.slot=C"},
                              {"storage.radius=250"},
                              {"step=0.5"}})
    nothing_jumps(aristo(changes), changes.empty() ? "" : changes[0]);
  const Cell least = read_cell(kAristo.parent_path() / "least/cell.json");
  nothing_jumps({least, build_model(least)}, "least");
  const run_tests::MelfaMeshes meshes;
  const Cell real = read_cell(kAristo.parent_path() / "melfa.json", meshes.scratch.path, {kMelfaTable});
  nothing_jumps({real, build_model(real)}, "melfa");
}

// The floor of the vice is 373 mm high, that of a slot of the storage 239.
TEST(Landing, TheUndersideLiesOnTheFloorOfItsPlace) {
  for (const auto& changes : {std::vector<std::string>{}, kSecondCase}) {
    const Workcell workcell = aristo(changes);
    const Process process = simulate(workcell);
    ASSERT_EQ(process.failure, "");
    for (const std::size_t i : {2U, 4U}) {
      const MaterialTransfer& put = process.transfers.at(i);
      const double floor = i == 2 ? 373 : 239;
      EXPECT_EQ(put.landing.value().support, i == 2 ? "machine/vice" : "storage/deck");
      EXPECT_GT(put.landing->way, 1);
      for (const double x : {-20.0, 20.0})
        for (const double y : {-20.0, 20.0}) {
          const double height = (put.lies->pose * Eigen::Vector3d(x, y, 0)).z() - floor;
          EXPECT_GT(height, 0);
          EXPECT_LE(height, 1e-9);
        }
      EXPECT_LT(put.shift, 10);
    }
  }
}

// Straight down and straight up again: the sphere keeps its place in the plan, and each joint the angle that it had.
TEST(Landing, TheHandGoesStraightDownAndBackToWhereItWas) {
  const Workcell workcell = aristo();
  const Process process = simulate(workcell);
  std::size_t straight = 0;
  for (std::size_t i = 1; i < process.stops.size(); ++i) {
    const Move& move = process.moves.at(process.stops[i].move);
    if (move.until != Until::Landed && move.until != Until::Raised) continue;
    ++straight;
    const Eigen::Vector3d way = process.stops[i].sphere.center - process.stops[i - 1].sphere.center;
    EXPECT_LT(way.head<2>().norm(), 1e-9);
    EXPECT_GT(move.until == Until::Landed ? -way.z() : way.z(), 0);
  }
  EXPECT_GE(straight, 4U);
  for (std::size_t m = 0; m + 1 < process.moves.size(); ++m) {
    if (process.moves[m].until != Until::Landed) continue;
    EXPECT_EQ(process.moves[m + 1].until, Until::Raised);
    const auto last_of = [&](std::size_t move) {
      std::size_t last = 0;
      for (std::size_t i = 1; i < process.stops.size(); ++i)
        if (process.stops[i].move == move) last = i;
      return last;
    };
    EXPECT_EQ(process.stops[last_of(m - 1)].commanded, process.stops[last_of(m + 1)].commanded);
  }
}

/// Whether an edge of one triangle goes through the inside of another, by more than rounding.
bool crosses(const Corners& edges, const Corners& face) {
  const Eigen::Vector3d normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d &p = edges[i], &q = edges[(i + 1) % 3];
    const double a = normal.dot(p - face[0]), b = normal.dot(q - face[0]);
    if (!((a > 1e-7 && b < -1e-7) || (a < -1e-7 && b > 1e-7))) continue;
    const Eigen::Vector3d at = p + a / (a - b) * (q - p);
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d side = face[(k + 1) % 3] - face[k];
      inside &= normal.dot(side.normalized().cross(at - face[k])) > 1e-7;
    }
    if (inside) return true;
  }
  return false;
}

/// A part at rest or one that moves. Its triangles are posed only where its box meets another one.
class Body {
 public:
  Body(std::string given, const std::vector<NamedTriangle>& all, const Pose& at = {})
      : name(std::move(given)), all_(&all) {
    for (const NamedTriangle& each : all)
      for (const Eigen::Vector3d& v : {each.triangle.a, each.triangle.b, each.triangle.c}) own_.extend(v);
    move(at);
  }
  void move(const Pose& pose) {
    pose_ = pose;
    posed_.clear();
    const Eigen::Vector3d half = own_.sizes() / 2, reach = pose.rotation.cwiseAbs() * half,
                          center = pose * Eigen::Vector3d(own_.center());
    box_ = {center - reach, center + reach};
  }
  /// Whether one of the two goes through the other.
  [[nodiscard]] bool goes_through(const Body& other) const {
    const Eigen::AlignedBox3d both = box_.intersection(other.box_);
    if (both.isEmpty()) return false;
    const std::vector<Corners> others = other.in(both);
    for (const Corners& a : others.empty() ? others : in(both))
      for (const Corners& b : others)
        if (crosses(a, b) || crosses(b, a)) return true;
    return false;
  }

  const std::string name;

 private:
  [[nodiscard]] std::vector<Corners> in(const Eigen::AlignedBox3d& region) const {
    if (posed_.empty())
      for (const NamedTriangle& each : *all_) {
        posed_.push_back({posed(pose_, each.triangle), {}});
        for (const Eigen::Vector3d& v : posed_.back().first) posed_.back().second.extend(v);
      }
    std::vector<Corners> found;
    for (const auto& [corners, box] : posed_)
      if (box.intersects(region)) found.push_back(corners);
    return found;
  }

  const std::vector<NamedTriangle>* all_;
  Eigen::AlignedBox3d own_, box_;
  Pose pose_;
  mutable std::vector<std::pair<Corners, Eigen::AlignedBox3d>> posed_;
};

/// Requires that no link, gripper, finger or held part goes through what stands, and no hand through the part: at every
/// stop and between the stops.
void nothing_goes_through(const Workcell& workcell, const std::string& name) {
  const Process process = simulate(workcell);
  ASSERT_EQ(process.failure, "") << name;
  std::vector<std::vector<NamedTriangle>> owned(workcell.names().size());
  for (const NamedTriangle& each : workcell.standing_triangles()) owned[each.owner].push_back(each);
  std::vector<Body> standing, links, hand;
  for (std::size_t owner = 0; owner < owned.size(); ++owner)
    if (!owned[owner].empty()) standing.emplace_back(workcell.names()[owner], owned[owner]);
  std::vector<std::size_t> frames;
  for (const Covered& part : workcell.covered())
    if (part.carrier == Carrier::Link && part.link > 0)
      links.emplace_back(part.name, part.triangles), frames.push_back(part.link);
  hand.emplace_back("gripper", workcell.gripper());
  for (std::size_t f = 0; f < 2; ++f) hand.emplace_back("finger", workcell.fingers()[f]);
  Body part("material", workcell.material());
  for (std::size_t i = 1; i < process.stops.size(); ++i)
    for (const double share : {0.5, 1.0}) {
      kinematics::Angles angles = process.stops[i - 1].commanded;
      for (std::size_t k = 0; k < angles.size(); ++k) angles[k] += share * (process.stops[i].commanded[k] - angles[k]);
      const std::vector<Pose> poses = workcell.arm().link_poses(angles);
      const MaterialTransfer& state = process.holding(i);
      for (std::size_t b = 0; b < links.size(); ++b) links[b].move(poses[frames[b]]);
      hand[0].move(poses.back());
      for (std::size_t f = 0; f < 2; ++f) {
        const double way = state.grip ? state.grip->fingers[f].way : 0;
        const Eigen::Vector3d shift = workcell.cell().gripper.fingers->shift(f, way);
        hand[f + 1].move({poses.back().rotation, poses.back() * shift});
      }
      part.move(material_at(workcell, angles, state));
      for (const Body& its : hand) EXPECT_FALSE(its.goes_through(part)) << name << ": " << its.name << ", stop " << i;
      const auto require_free = [&](const Body& body) {
        for (const Body& still : standing)
          EXPECT_FALSE(body.goes_through(still)) << name << ": " << body.name << ", " << still.name << ", stop " << i;
      };
      std::ranges::for_each(links, require_free);
      std::ranges::for_each(hand, require_free);
      require_free(part);
    }
}

// In the thesis's order of moves, and by ways that are found.
TEST(Landing, NothingGoesThroughAnything) {
  nothing_goes_through(aristo(), "case 1");
  nothing_goes_through(aristo(kSecondCase), "case 2");
  nothing_goes_through(aristo({"storage.radius=250"}), "found");
}

TEST(Landing, AHandThatDoesNotStayLevelSaysSo) {
  const Process process = simulate(aristo(preset(kAristo, "locked wrist")));
  EXPECT_NE(process.failure, "");
}

}  // namespace
}  // namespace touchstone::cell
