// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of first contact along arcs, against angles known in closed form and rationals on the arc.
#include "experiments/thesis/cell/first_contact/first_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/thesis/cell/kinematics/rational_judge.h"

namespace touchstone::kinematics {
namespace {

using scene::Faces;
using workloads::Random;
using Kind = FirstContact::Kind;

constexpr double kWidest = 1e-12;  // degrees
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rolls down from (1, 0, 0) about the y axis: at angle phi the centre is (cos phi, 0, -sin phi).
Arc falling(double degrees) { return {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, degrees}; }

/// A horizontal rectangle.
Polygon sheet(double x0, double x1, double y0, double y1, double z) {
  return Polygon({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
}

Faces faces_of(Polygon polygon) { return {{}, {std::move(polygon)}}; }

/// The enclosure is at most that wide and holds an angle that is known to a few units in the last place.
void expect_at(const std::optional<FirstContact>& contact, double degrees, Kind kind, Feature feature) {
  ASSERT_TRUE(contact.has_value());
  EXPECT_LE(contact->low, contact->high);
  EXPECT_LE(contact->high - contact->low, kWidest);
  EXPECT_NEAR(contact->low, degrees, 1e-13);
  EXPECT_EQ(contact->kind, kind);
  EXPECT_EQ(contact->feature, feature);
}

const Feature kFace{Feature::Kind::Face, 0};
Feature edge(std::size_t i) { return {Feature::Kind::Edge, i}; }
Feature vertex(std::size_t i) { return {Feature::Kind::Vertex, i}; }

struct BallOnArc {
  Arc arc;
  double radius;
  Faces faces;
  std::string replay;
};

/// An arc about a random axis through the neighbourhood of one or two polygons, which may be off their planes.
BallOnArc draw_move(std::uint64_t index) {
  workloads::Workload workload;
  const auto& families = workloads::all_families();
  workload.family = families[index % families.size()];
  workload.placement =
      index / families.size() % 2 == 0 ? workloads::Placement::LatticeFrame : workloads::Placement::Rotated;
  workload.vertices = 12;
  const auto placed = workloads::draw_placed_outline(workload, 2026, index);
  Random random(2026, index, 91);
  double size = 0;
  const Polygon& polygon = placed.polygon;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i)
    size = std::max(size, (polygon.vertex(i) - polygon.vertex(0)).norm());
  const auto vector = [&](double scale) {
    return Eigen::Vector3d{scale * (2 * random.unit() - 1), scale * (2 * random.unit() - 1),
                           scale * (2 * random.unit() - 1)};
  };
  const auto corner = [&] {
    return polygon.vertex(
        static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1)));
  };
  BallOnArc move;
  const auto halvings = static_cast<int>(random.integer(3, 9));
  move.radius = size * std::ldexp(1 + random.unit(), -halvings);
  const Eigen::Vector3d first = corner(), second = random.coin() ? first : corner();
  const Eigen::Vector3d aim = (first + second) / 2 + vector(move.radius);
  move.arc = {aim, aim + vector(0.7 * size), vector(1), 20 + 150 * random.unit()};
  move.arc.start = point_at(move.arc, 360 - move.arc.degrees * random.unit());
  move.faces.polygons.push_back(polygon);
  if (random.coin()) {  // a triangle across it
    const auto near_a_corner = [&] {
      const Eigen::Vector3d at = corner();
      return Eigen::Vector3d(at + vector(0.5 * size));
    };
    move.faces.triangles.push_back({corner(), near_a_corner(), near_a_corner()});
  }
  if (random.coin()) {  // a quadrilateral that is off its plane
    const Eigen::Vector3d at = corner(), u = vector(0.3 * size), v = vector(0.3 * size);
    move.faces.polygons.push_back(Polygon({at, at + u, Eigen::Vector3d(at + u + v + vector(0.03 * size)), at + v}));
    if (exact::validate(move.faces.polygons.back())) move.faces.polygons.pop_back();
  }
  move.replay = "draw_move(" + std::to_string(index) + ")";
  return move;
}

TEST(FirstContact, MeetsAPlaneWhereTheSineSays) {
  const Faces faces = faces_of(sheet(-2, 2, -2, 2, -0.5));
  expect_at(first_contact(falling(90), 0.125, faces), workloads::arc_sine(0.375), Kind::Transversal, kFace);
  expect_at(first_contact(falling(90), 0, faces), 30, Kind::Transversal, kFace);
}

TEST(FirstContact, MeetsAnEdgeAndAVertexWhereTheCosineSays) {
  // The edge x = 0.5, z = -1 at distance 1: |(cos, -sin) - (0.5, -1)|^2 = 1 where cos - ... : 2.25 - cos - 2 sin = 1.
  const double tilt = workloads::arc_tangent(2, 1), opening = workloads::arc_cosine(1.25 / std::sqrt(5.0));
  const Faces side = faces_of(Polygon({{0.5, -3, -1}, {0.5, 3, -1}, {0.5, 0, -9}}));
  expect_at(first_contact(falling(90), 1, side), tilt - opening, Kind::Transversal, edge(0));
  const Faces tip = faces_of(Polygon({{0.5, -1, -9}, {0.5, 0, -1}, {0.5, 1, -9}}));
  expect_at(first_contact(falling(90), 1, tip), tilt - opening, Kind::Transversal, vertex(1));
}

// One double of the height tells a touch from a miss and from a pass: no interval of angles could.
TEST(FirstContact, TellsGrazingFromMissingAndPassing) {
  const auto at_height = [](double z) { return first_contact(falling(180), 0.25, faces_of(sheet(-2, 2, -2, 2, z))); };
  expect_at(at_height(-1.25), 90, Kind::Grazing, kFace);
  EXPECT_FALSE(at_height(std::nextafter(-1.25, -kInfinity)).has_value());
  const auto passing = at_height(std::nextafter(-1.25, 0.0));
  ASSERT_TRUE(passing.has_value());
  EXPECT_EQ(passing->kind, Kind::Transversal);
  EXPECT_LE(passing->high - passing->low, kWidest);
  EXPECT_LT(passing->high, 90 - 1e-7);
}

TEST(FirstContact, GrazesAnEdgeAndAVertex) {
  expect_at(first_contact(falling(180), 0.25, faces_of(Polygon({{0, -1, -1.25}, {0, 1, -1.25}, {0, 0, -3}}))), 90,
            Kind::Grazing, edge(0));
  expect_at(first_contact(falling(180), 0.25, faces_of(Polygon({{0, 0, -1.25}, {0, 1, -3}, {0, -1, -3}}))), 90,
            Kind::Grazing, vertex(0));
}

// The ball slides along the plane at exactly its radius, and comes upon the face at its edge.
TEST(FirstContact, FindsTheEdgeOfAFaceThatItSlidesUpon) {
  const Arc level{{1, 0, 0.5}, {0, 0, 0}, {0, 0, 1}, 360};
  const Faces faces = faces_of(Polygon({{-2, 0, 0}, {0, 0, 0}, {0, 2, 0}, {-2, 2, 0}}));
  expect_at(first_contact(level, 0.5, faces), 90, Kind::Grazing, edge(1));
}

TEST(FirstContact, CoversTheWholeTurnAndItsEnd) {
  // The half plane y <= 0 near (0, -1): met at 270 - asin(1/4), seen from above about an axis of any length.
  const Faces wall = faces_of(Polygon({{-0.25, -2, -1}, {-0.25, 0, -1}, {-0.25, 0, 1}, {-0.25, -2, 1}}));
  for (const double length : {1.0, 0x1p-300, 3e200, 1e-3}) {
    const Arc turn{{1, 0, 0}, {0, 0, 0}, {0, 0, length}, 360};
    expect_at(first_contact(turn, 0, wall), 270 - workloads::arc_sine(0.25), Kind::Transversal, kFace);
  }
  const Faces behind = faces_of(sheet(-2, 2, -2, 2, -1));
  expect_at(first_contact(falling(90), 0, behind), 90, Kind::Grazing, kFace);
  EXPECT_TRUE(first_contact(falling(90), 0x1p-30, behind).has_value());
  EXPECT_FALSE(first_contact(falling(std::nextafter(30.0, 0.0)), 0, faces_of(sheet(-2, 2, -2, 2, -0.5))).has_value());
  EXPECT_TRUE(first_contact(falling(30), 0, faces_of(sheet(-2, 2, -2, 2, -0.5))).has_value());
  // From just behind a wall all the way round to its other side.
  const Arc round{{1, 0, 0}, {0, 0, 0}, {0, 0, 1}, 360};
  const Faces start = faces_of(Polygon({{0.5, -0.125, -1}, {2, -0.125, -1}, {2, -0.125, 1}, {0.5, -0.125, 1}}));
  expect_at(first_contact(round, 0, start), 360 - workloads::arc_sine(0.125), Kind::Transversal, kFace);
}

// Guarantee for every finite double: an exact scaling changes nothing, far beyond where squares over- and underflow.
TEST(FirstContact, IsTheSameAtEveryScale) {
  for (std::uint64_t index = 0; index < 10; ++index) {
    const BallOnArc move = draw_move(index);
    const auto expected = first_contact(move.arc, move.radius, move.faces);
    for (const int exponent : {-900, -400, 300, 900}) {
      const auto scaled = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d { return std::ldexp(1.0, exponent) * v; };
      Arc arc = move.arc;
      arc.start = scaled(arc.start), arc.point = scaled(arc.point);
      Faces faces;
      for (const Triangle& t : move.faces.triangles) faces.triangles.push_back({scaled(t.a), scaled(t.b), scaled(t.c)});
      for (const Polygon& polygon : move.faces.polygons) {
        std::vector<Loop> loops = workloads::loops_of(polygon);
        for (Loop& loop : loops)
          for (Eigen::Vector3d& v : loop) v = scaled(v);
        faces.polygons.push_back(workloads::polygon_of(loops));
      }
      const auto contact = first_contact(arc, std::ldexp(move.radius, exponent), faces);
      ASSERT_EQ(contact.has_value(), expected.has_value()) << move.replay << ", 2^" << exponent;
      if (!contact) continue;
      EXPECT_EQ(contact->low, expected->low) << move.replay << ", 2^" << exponent;
      EXPECT_EQ(contact->high, expected->high) << move.replay << ", 2^" << exponent;
      EXPECT_EQ(contact->feature, expected->feature) << move.replay << ", 2^" << exponent;
    }
  }
}

// The axis is a direction: a factor that is a power of two changes no bit, up to the largest and the smallest doubles.
TEST(FirstContact, IsTheSameForAnAxisOfAnyLength) {
  std::size_t contacts = 0;
  for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES; ++index) {
    BallOnArc move = draw_move(index);
    move.arc.axis = (8 * move.arc.axis).array().ceil();  // of whole numbers up to 8
    if (move.arc.axis.isZero(0)) continue;
    const auto expected = first_contact(move.arc, move.radius, move.faces);
    const auto stepped = stepped_contact(move.arc, move.radius, 1, move.faces);
    contacts += expected.has_value() ? 1 : 0;
    for (const int exponent : {-1074, -1070, -1030, -600, 600, 1020}) {
      const std::string replay = move.replay + ", axis times 2^" + std::to_string(exponent);
      Arc arc = move.arc;
      for (double& x : arc.axis) x = std::ldexp(x, exponent);
      EXPECT_EQ(point_at(arc, 37), point_at(move.arc, 37)) << replay;
      const auto contact = first_contact(arc, move.radius, move.faces);
      ASSERT_EQ(contact.has_value(), expected.has_value()) << replay;
      EXPECT_EQ(stepped_contact(arc, move.radius, 1, move.faces).has_value(), stepped.has_value()) << replay;
      if (!contact) continue;
      EXPECT_EQ(contact->low, expected->low) << replay;
      EXPECT_EQ(contact->high, expected->high) << replay;
      EXPECT_EQ(contact->feature, expected->feature) << replay;
    }
  }
  EXPECT_GT(contacts, TOUCHSTONE_SAMPLES / 4U);
}

// The longest and the shortest axis along a diagonal of space: a third of a turn leads from x to y.
TEST(FirstContact, FindsContactAboutTheLongestAndTheShortestAxis) {
  const Faces faces{{{{0, 1, 0}, {0.01, 1, 0}, {0, 1.01, 0}}}, {}};
  for (const double length : {1.5e308, std::numeric_limits<double>::max(), 5e-324, 3e-320, 1.0}) {
    const auto contact = first_contact({{1, 0, 0}, {0, 0, 0}, {length, length, length}, 240}, 0x1p-6, faces);
    ASSERT_TRUE(contact.has_value()) << length;
    EXPECT_LT(contact->high, 120) << length;
    EXPECT_GT(contact->low, 115) << length;
  }
}

TEST(DirectionOf, HasLengthOneHoweverUnevenTheVector) {
  for (const double x : {1e308, 1.0, 1e-300, 5e-324})
    for (const double y : {0.0, -1.0, 1e-308, 1.7e308}) {
      const Eigen::Vector3d direction = direction_of({x, y, 0});
      EXPECT_NEAR(direction.norm(), 1, 1e-15) << x << ' ' << y;
      EXPECT_EQ(std::signbit(direction.y()), std::signbit(y)) << x << ' ' << y;
    }
}

TEST(FirstContact, SaysThatTheBallTouchesBeforeItMoves) {
  const auto contact = first_contact(falling(90), 0.5, faces_of(sheet(0.5, 2, -2, 2, -0.5)));
  ASSERT_TRUE(contact.has_value());
  EXPECT_EQ(contact->kind, Kind::AtStart);
  EXPECT_EQ(contact->high, 0);
  EXPECT_EQ(contact->feature, kFace);
}

TEST(FirstContact, RestsWhereTheArcHasNoRadius) {
  const Arc rest{{0, 0, 1}, {0, 0, 0}, {0, 0, 1}, 360};
  EXPECT_FALSE(first_contact(rest, 0.5, faces_of(sheet(-2, 2, -2, 2, 0))).has_value());
  EXPECT_TRUE(first_contact(rest, 1, faces_of(sheet(-2, 2, -2, 2, 0))).has_value());
}

TEST(FirstContact, NamesTheLowestFaceOfAnEdgeThatTwoShare) {
  const Triangle left{{-2, -2, -0.5}, {2, -2, -0.5}, {2, 2, -0.5}}, right{{-2, -2, -0.5}, {2, 2, -0.5}, {-2, 2, -0.5}};
  const Arc onto_diagonal{{1, 1, 0}, {0, 0, 0}, {-1, 1, 0}, 90};  // stays in the plane x = y
  const auto contact = first_contact(onto_diagonal, 0.125, {{left, right}, {}});
  ASSERT_TRUE(contact.has_value());
  EXPECT_EQ(contact->face, 0U);
  EXPECT_EQ(contact->feature, edge(2));
  EXPECT_EQ(first_contact(onto_diagonal, 0.125, {{right, left}, {}}).value().feature, edge(0));
}

// A sheet that a step of 1 degree jumps over, and a step that is too fast for a plate.
TEST(FirstContact, FindsWhatSteppingMisses) {
  const double radius = 0.004;
  const Faces thin = faces_of(sheet(0.5, 1, -1, 1, -workloads::sine(30.5)));
  const Arc move = falling(60);
  EXPECT_FALSE(stepped_contact(move, radius, 1, thin).has_value());
  const auto contact = first_contact(move, radius, thin);
  ASSERT_TRUE(contact.has_value());
  EXPECT_NEAR(contact->low, 30.5 - radius / workloads::cosine(30.5) * 57.3, 1e-3);
  EXPECT_TRUE(stepped_contact(move, radius, 0.25, thin).has_value());
  EXPECT_TRUE(stepped_contact(move, 0.02, 1, thin).has_value());
  EXPECT_FALSE(stepped_contact(move, 0.02, 7, thin).has_value());
}

TEST(SteppedContact, StopsAtTheFirstStopThatTouchesAndNotBeyondTheEnd) {
  const Faces faces = faces_of(sheet(-2, 2, -2, 2, -0.5));
  const auto stop = stepped_contact(falling(90), 0.125, 1, faces);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->stop, 23U);  // asin(0.375) is 22.02
  EXPECT_EQ(stop->degrees, 23);
  EXPECT_EQ(stepped_contact(falling(90), 0, 0.5, faces).value().stop, 60U);  // exactly 30 degrees
  EXPECT_TRUE(stepped_contact(falling(23), 0.125, 1, faces).has_value());
  EXPECT_FALSE(stepped_contact(falling(22.99), 0.125, 1, faces).has_value());
  EXPECT_TRUE(first_contact(falling(22.99), 0.125, faces).has_value());
}

TEST(FirstContact, RefusesWhatIsNoMove) {
  const Faces faces = faces_of(sheet(-2, 2, -2, 2, -0.5));
  const auto message = [&](const Arc& arc) {
    return run_tests::message_of<std::invalid_argument>([&] { return first_contact(arc, 0.125, faces); });
  };
  Arc arc = falling(90);
  arc.axis = {0, 0, 0};
  EXPECT_EQ(message(arc), "the axis of the arc has length 0");
  EXPECT_EQ(message(falling(361)), "the arc turns by 361 degrees, not by 0 to 360");
  arc = falling(90);
  arc.start.x() = kInfinity;
  EXPECT_EQ(message(arc), "the arc has a coordinate that is not finite");
  EXPECT_THROW((void)first_contact(falling(90), -1, faces), Rejected);
  EXPECT_THROW((void)stepped_contact(falling(90), 1, 0, faces), std::invalid_argument);
}

// Planted: leaving out the edges, the vertices or one side of the plane; a box that is too small; the last root.
TEST(FirstContact, AgreesWithRationalsAlongRandomArcs) {
  std::size_t contacts = 0, misses = 0, kinds[3] = {0, 0, 0};
  for (std::uint64_t index = 0; index < 4 * TOUCHSTONE_SAMPLES; ++index) {
    const BallOnArc move = draw_move(index);
    const auto contact = first_contact(move.arc, move.radius, move.faces);
    const auto touched_at = [&](const ArcPoint& point) { return touches(point.center, move.radius, move.faces); };
    if (contact && contact->kind == Kind::AtStart) {
      EXPECT_TRUE(touched_at(exact_point(move.arc, 0))) << move.replay;
      continue;
    }
    const double end = contact ? contact->low : move.arc.degrees;
    for (int i = 0; i <= 6; ++i) {
      const ArcPoint point = exact_point_near(move.arc, end * i / 6 - (i == 6 ? 1e-11 : 0));
      EXPECT_FALSE(touched_at(point)) << move.replay << " at " << point.degrees << " degrees";
    }
    if (!contact) {
      ++misses;
      continue;
    }
    ++contacts;
    ++kinds[static_cast<std::size_t>(contact->feature.kind)];
    EXPECT_LE(contact->high - contact->low, kWidest) << move.replay;
    EXPECT_EQ(contact->kind, Kind::Transversal) << move.replay;
    // Balls that only scrape along leave at once: they are to be met between two angles of an open interval.
    EXPECT_TRUE(touched_at(exact_point_near(move.arc, contact->high + 1e-11))) << move.replay;
  }
  EXPECT_GT(contacts, 2U * TOUCHSTONE_SAMPLES);
  EXPECT_GT(misses, TOUCHSTONE_SAMPLES / 20U);
  for (const std::size_t kind : kinds) EXPECT_GT(kind, TOUCHSTONE_SAMPLES / 10U);
}

// Guarantee: where stepping finds a contact and has missed none, the first one lies within the last step.
TEST(FirstContact, LiesWithinTheStepAtWhichSteppingStops) {
  constexpr std::uint64_t kMoves = 5 * std::max(TOUCHSTONE_SAMPLES, 30);  // stepping misses none of fewer
  std::size_t within = 0, missed = 0;
  for (std::uint64_t index = 0; index < kMoves; ++index) {
    const BallOnArc move = draw_move(index);
    const auto first = first_contact(move.arc, move.radius, move.faces);
    const auto stepped = stepped_contact(move.arc, move.radius, 1, move.faces);
    if (!stepped) {
      missed += first.has_value() ? 1 : 0;
      continue;
    }
    ASSERT_TRUE(first.has_value()) << move.replay;
    EXPECT_LE(first->low, stepped->degrees) << move.replay;
    if (first->low > stepped->degrees - 1) ++within;
    const auto again = stepped_contact(move.arc, move.radius, 1.0 / 8, move.faces);
    ASSERT_TRUE(again.has_value()) << move.replay;
    EXPECT_LE(first->low, again->degrees) << move.replay;
  }
  EXPECT_GT(within, 2 * TOUCHSTONE_SAMPLES);
  EXPECT_GT(missed, 0U);
}

}  // namespace
}  // namespace touchstone::kinematics
