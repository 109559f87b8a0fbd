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

/// In the thesis's order of moves and by ways that are found, by three arms.
template <class Act>
void in_every_cell(const Act& act) {
  for (const auto& changes : {std::vector<std::string>{},
                              kSecondCase,
                              {"material.slot=A"},
                              {"material.slot=C"},
                              {"storage.radius=250"},
                              {"step=0.5"}})
    act(aristo(changes), changes.empty() ? "case 1" : changes[0]);
  const Cell least = read_cell(kAristo.parent_path() / "least/cell.json");
  act({least, build_model(least)}, "least");
  const run_tests::MelfaMeshes meshes;
  const Cell real = read_cell(kAristo.parent_path() / "melfa.json", meshes.scratch.path, {kMelfaTable});
  act({real, build_model(real)}, "melfa");
}

TEST(Landing, NoPartMovesUnlessItIsHeld) { in_every_cell(nothing_jumps); }

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

// Between two guides, 1.2 thousandths of a mm from the piece.
TEST(Landing, WhatSlidesTooCloselyIsNotLetGo) {
  const auto guide = [](int number, const std::string& from, const std::string& to) {
    return "machine.parts[" + std::to_string(number) + R"(]={"name":"guide)" + std::to_string(number) +
           R"(","box":{"from":[-30,)" + from + R"(,0],"to":[30,)" + to + ",14]}}";
  };
  const Cell cell = read_cell(kAristo.parent_path() / "least/cell.json", std::nullopt,
                              {"step=0.02", "storage.home=-20", "machine.home=20", "material.drop=15",
                               guide(1, "10.0012", "16"), guide(2, "-16", "-10.0012")});
  const Process process = simulate({cell, build_model(cell)});
  EXPECT_NE(process.failure.find("slides along machine/guide"), std::string::npos) << process.failure;
  EXPECT_EQ(process.cause, FailureCause::Misplaced);
}

// With the arm nearly stretched, a mm of height takes nearly a degree of each joint.
TEST(Landing, AStretchedArmPutsItsPieceDown) {
  const run_tests::MelfaMeshes meshes;
  const Cell real =
      read_cell(kAristo.parent_path() / "melfa.json", meshes.scratch.path, {kMelfaTable, "storage.radius=840"});
  EXPECT_EQ(simulate({real, build_model(real)}).failure, "");
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
  /// Whether their boxes meet.
  [[nodiscard]] bool is_near(const Body& other) const { return box_.intersects(other.box_); }
  /// Whether one of the two goes through the other.
  [[nodiscard]] bool goes_through(const Body& other) const {
    const Eigen::AlignedBox3d both = box_.intersection(other.box_);
    if (both.isEmpty()) return false;
    const std::vector<const Boxed*> others = other.in(both);
    for (const Boxed* a : others.empty() ? others : in(both))
      for (const Boxed* b : others)
        if (a->box.intersects(b->box) && (crosses(a->corners, b->corners) || crosses(b->corners, a->corners)))
          return true;
    return false;
  }

  const std::string name;

 private:
  struct Boxed {
    Corners corners;
    Eigen::AlignedBox3d box;
  };
  [[nodiscard]] std::vector<const Boxed*> in(const Eigen::AlignedBox3d& region) const {
    if (posed_.empty())
      for (const NamedTriangle& each : *all_) {
        posed_.push_back({posed(pose_, each.triangle), {}});
        for (const Eigen::Vector3d& v : posed_.back().corners) posed_.back().box.extend(v);
      }
    std::vector<const Boxed*> found;
    for (const Boxed& each : posed_)
      if (each.box.intersects(region)) found.push_back(&each);
    return found;
  }

  const std::vector<NamedTriangle>* all_;
  Eigen::AlignedBox3d own_, box_;
  Pose pose_;
  mutable std::vector<Boxed> posed_;
};

/// Everything that moves: links, the gripper, its fingers and, last, the material.
class MovingBodies {
 public:
  explicit MovingBodies(const Workcell& workcell) : workcell_(&workcell) {
    for (const Covered& part : workcell.covered())
      if (part.carrier == Carrier::Link && part.link > 0)
        bodies.emplace_back(part.name, part.triangles), frames_.push_back(part.link);
    bodies.emplace_back("gripper", workcell.gripper());
    for (const auto& finger : workcell.fingers()) bodies.emplace_back("finger", finger);
    bodies.emplace_back("material", workcell.material());
  }
  void move(const kinematics::Angles& angles, const MaterialTransfer& state) {
    const std::vector<Pose> poses = workcell_->arm().link_poses(angles);
    std::size_t b = 0;
    for (const std::size_t frame : frames_) bodies[b++].move(poses[frame]);
    bodies[b++].move(poses.back());
    for (std::size_t f = 0; f < workcell_->fingers().size(); ++f) {
      const double way = state.grip ? state.grip->fingers[f].way : 0;
      bodies[b++].move({poses.back().rotation, poses.back() * workcell_->cell().gripper.fingers->shift(f, way)});
    }
    bodies[b].move(material_at(*workcell_, angles, state));
  }

  std::vector<Body> bodies;

 private:
  const Workcell* workcell_;
  std::vector<std::size_t> frames_;
};

/// Returns the angles that lead from one stop to the next, at most a tenth of a degree apart.
std::vector<kinematics::Angles> dense(const kinematics::Angles& from, const kinematics::Angles& to) {
  double most = 0;
  for (std::size_t k = 0; k < from.size(); ++k) most = std::max(most, std::abs(to[k] - from[k]));
  const double samples = std::max(1.0, std::ceil(10 * most));
  std::vector<kinematics::Angles> all;
  for (double i = 1; i <= samples; ++i) {
    all.push_back(from);
    for (std::size_t k = 0; k < from.size(); ++k) all.back()[k] += i / samples * (to[k] - from[k]);
  }
  return all;
}

/// Requires that nothing that moves goes through what stands, or through what else moves and is not near it at home.
void nothing_goes_through(const Workcell& workcell, const std::string& name) {
  const Process process = simulate(workcell);
  ASSERT_EQ(process.failure, "") << name;
  std::vector<std::vector<NamedTriangle>> owned(workcell.names().size());
  for (const NamedTriangle& each : workcell.standing_triangles()) owned[each.owner].push_back(each);
  std::vector<Body> standing;
  for (std::size_t owner = 0; owner < owned.size(); ++owner)
    if (!owned[owner].empty()) standing.emplace_back(workcell.names()[owner], owned[owner]);
  MovingBodies moving(workcell);
  moving.move(process.stops.front().commanded, process.transfers.front());
  std::vector<std::pair<const Body*, const Body*>> apart;
  for (const Body& body : moving.bodies) {
    for (const Body& still : standing) apart.emplace_back(&body, &still);
    for (const Body* other = &body + 1; other <= &moving.bodies.back(); ++other)
      if (!body.is_near(*other)) apart.emplace_back(&body, other);
  }
  std::size_t asked = 0;
  for (std::size_t i = 1; i < process.stops.size(); ++i)
    for (const auto& angles : dense(process.stops[i - 1].commanded, process.stops[i].commanded)) {
      moving.move(angles, process.holding(i));
      ++asked;
      for (const auto& [body, other] : apart)
        EXPECT_FALSE(body->goes_through(*other)) << name << ": " << body->name << ", " << other->name << ", stop " << i;
    }
  EXPECT_GT(asked, 1000U) << name;
}

TEST(Landing, NothingGoesThroughAnything) { in_every_cell(nothing_goes_through); }

TEST(Landing, AHandThatDoesNotStayLevelSaysSo) {
  const Process process = simulate(aristo(preset(kAristo, "locked wrist")));
  EXPECT_NE(process.failure, "");
}

}  // namespace
}  // namespace touchstone::cell
