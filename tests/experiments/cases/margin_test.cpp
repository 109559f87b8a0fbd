// SPDX-License-Identifier: GPL-3.0-or-later
// Which wrong answers are right about a ball of nearly the same radius.
#include "experiments/cases/margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"

namespace touchstone::cases {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Polygon square() { return Polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}); }

/// Is this value of a key, as JSON, within the margin?
bool within(const Shapes& shapes, double margin, const std::string& key, const std::string& value) {
  const StatedAnswer answer = stated_in(nlohmann::json::parse("{\"" + key + "\":" + value + "}"));
  return AnswersWithin(shapes, margin).has(*find_key(key), answer);
}

TEST(Margin, IsAShareOfTheLargestCoordinateOrALength) {
  const Shapes shapes{Ball{{1, 2, 3}, 0.5}, square()};
  EXPECT_EQ(margin_of("2^-20").length(shapes), 4 * 0x1p-20);
  EXPECT_EQ(margin_of("1e-6").length(shapes), 4e-6);
  EXPECT_EQ(margin_of("1e-6m").length(shapes), 1e-6);
  EXPECT_EQ(margin_of("2^-3m").length(shapes), 0.125);
  EXPECT_EQ(margin_of("0.5").length(Shapes{Ball{{1, 2, 3}, 8}, square()}), 4);
  EXPECT_EQ(margin_of("0.5").length(Shapes{Motion(Ball{{1, 2, 3}, 0.5}, {0, 0, -16}), square()}), 8);
  for (const char* text : {"", "m", "2^", "2^0.5", "0", "-1", "1e999", "2^2000", "nan", "1 m", "2^-2000"})
    EXPECT_THROW((void)margin_of(text), std::invalid_argument) << text;
}

// The ball touches the square in a face, an edge or a vertex if its radius grows by `gap`.
TEST(AnswersWithin, HaveAContactIfAndOnlyIfTheRadiusIsOffByNoMore) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    workloads::Random random(2026, i, 61);
    const double gap = std::ldexp(1.0, -static_cast<int>(random.integer(3, 30)));
    const double x = random.coin() ? 2 : 7, y = random.coin() ? 2 : -4;  // distances 0, 3, 4 and 5 in the plane
    const bool apart = random.coin();
    const double distance = std::hypot(x > 4 ? 3 : 0, y < 0 ? 4 : 0);
    const Ball ball{{x, y, distance > 0 ? 0.0 : 1.0}, (distance > 0 ? distance : 1) + (apart ? -gap : gap)};
    const Shapes shapes{ball, square()};
    const std::string contact = apart ? "true" : "false", relation = apart ? "\"overlapping\"" : "\"separate\"";
    EXPECT_EQ(within(shapes, gap, "contact", contact), apart) << i;  // touching balls touch
    EXPECT_TRUE(within(shapes, gap * 1.01, "contact", contact)) << i;
    EXPECT_FALSE(within(shapes, gap * 0.99, "contact", contact)) << i;
    EXPECT_TRUE(within(shapes, gap * 1.01, "relation", relation)) << i;
    EXPECT_FALSE(within(shapes, gap * 0.99, "relation", relation)) << i;
    EXPECT_TRUE(within(shapes, gap * 1.01, "relation", "\"touching\"")) << i;
    EXPECT_FALSE(within(shapes, gap * 0.99, "relation", "\"touching\"")) << i;
  }
}

TEST(AnswersWithin, HaveThePlaneAndItsTangentWithTheRadius) {
  const Shapes shapes{Ball{{2, 2, 1}, 0.75}, square()};
  EXPECT_TRUE(within(shapes, 0.25, "plane", "\"intersects\""));
  EXPECT_FALSE(within(shapes, 0.125, "plane", "\"intersects\""));
  EXPECT_FALSE(within(shapes, 0.25, "plane", "\"behind\""));
  EXPECT_TRUE(within(shapes, 0.25, "plane_tangent", "true"));
  EXPECT_FALSE(within(shapes, 0.125, "plane_tangent", "true"));
}

TEST(AnswersWithin, HaveTheEdgesBetweenThoseOfTheSmallestAndTheLargestBall) {
  const Shapes shapes{Ball{{2, 1, 0}, 1.5}, square()};  // edge 0 at 1; edges 1 and 3 at 2; edge 2 at 3
  EXPECT_TRUE(within(shapes, 0.5, "edges_hit", "[0,1]"));
  EXPECT_TRUE(within(shapes, 0.5, "edges_hit", "[0,1,3]"));
  EXPECT_FALSE(within(shapes, 0.25, "edges_hit", "[0,1]"));
  EXPECT_FALSE(within(shapes, 0.5, "edges_hit", "[1]")) << "edge 0 is hit in any case";
  EXPECT_FALSE(within(shapes, 0.5, "edges_hit", "[0,2]"));
  EXPECT_FALSE(within(shapes, 0.5, "edges_hit", "[1,0]"));
}

TEST(AnswersWithin, HaveNumbersThatAreOffByTheMargin) {
  const Shapes shapes{Ball{{2, 2, 1}, 0.75}, square()};
  for (const char* key : {"distance", "depth", "off_plane"}) {
    const double exact = key == std::string("distance") ? 1 : key == std::string("depth") ? -0.25 : 0;
    EXPECT_TRUE(within(shapes, 0.125, key, std::to_string(exact + 0.125))) << key;
    EXPECT_FALSE(within(shapes, 0.125, key, std::to_string(exact - 0.25))) << key;
    EXPECT_FALSE(within(shapes, 0.125, key, "null")) << key;
  }
}

TEST(AnswersWithin, HavePointsNearThePolygonThatAreHardlyFartherThanTheClosest) {
  const Shapes shapes{Ball{{2, 2, 1}, 0.75}, square()};
  EXPECT_TRUE(within(shapes, 0.01, "point", "[2.1,2,0.005]")) << "farther by 0.0004";
  EXPECT_FALSE(within(shapes, 0.01, "point", "[2.5,2,0]")) << "on the polygon, and too far";
  EXPECT_FALSE(within(shapes, 0.01, "point", "[2,2,0.02]")) << "off the polygon";
  EXPECT_FALSE(within(shapes, 0.01, "point", "[2,2,null]"));
  // Closest points in two places: both are right with any margin.
  const Shapes middle{Ball{{2, 2, 0}, 1}, Polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                                                  {{{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}})};
  EXPECT_TRUE(within(middle, 0x1p-40, "point", "[2,3,0]"));
}

TEST(AnswersWithin, HaveNormalsThatLeadToSuchPoints) {
  const Shapes shapes{Ball{{2, 2, 1}, 0.75}, square()};
  EXPECT_TRUE(within(shapes, 0.01, "contact_normal", "[0.1,0,0.995]"));
  EXPECT_FALSE(within(shapes, 0.01, "contact_normal", "[0.3,0,0.954]"));
  EXPECT_FALSE(within(shapes, 0.01, "contact_normal", "[0,0,-1]"));
  EXPECT_FALSE(within(shapes, 0.01, "contact_normal", "[0,0,1.01]")) << "too long";
}

TEST(AnswersWithin, HaveTheFootOnEitherSideOfABoundaryThatIsNear) {
  const Shapes inner{Ball{{3.875, 2, 100}, 1}, square()}, middle{Ball{{2, 2, 100}, 1}, square()};
  for (const char* foot : {"\"boundary\"", "\"outside\""}) {
    EXPECT_TRUE(within(inner, 0.125, "foot", foot));
    EXPECT_FALSE(within(inner, 0.0625, "foot", foot));
    EXPECT_FALSE(within(middle, 0.125, "foot", foot));
  }
}

TEST(AnswersWithin, HaveFeaturesThatAreHardlyFartherThanTheNearest) {
  const Shapes shapes{Ball{{3.875, 2, 0.5}, 1}, square()};  // the face at 0.5, edge 1 at 0.515
  EXPECT_TRUE(within(shapes, 0.03, "nearest", R"({"kind":"edge","index":1})"));
  EXPECT_FALSE(within(shapes, 0.01, "nearest", R"({"kind":"edge","index":1})"));
  EXPECT_FALSE(within(shapes, 0.03, "nearest", R"({"kind":"edge","index":3})"));
  EXPECT_FALSE(within(shapes, 0.03, "nearest", R"({"kind":"edge","index":99})"));
  const Shapes corner{Ball{{5, 3.875, 0}, 1}, square()};  // edge 1 at 1, vertex 2 at 1.008
  EXPECT_TRUE(within(corner, 0.01, "nearest", R"({"kind":"vertex","index":2})"));
  EXPECT_FALSE(within(corner, 0.005, "nearest", R"({"kind":"vertex","index":2})"));
  EXPECT_FALSE(within(corner, 0.01, "nearest", R"({"kind":"vertex","index":99})"));
  const Shapes outer{Ball{{4.125, 2, 0.5}, 1}, square()};  // the foot is outside
  EXPECT_TRUE(within(outer, 0.125, "nearest", R"({"kind":"face"})"));
  EXPECT_FALSE(within(outer, 0.0625, "nearest", R"({"kind":"face"})"));
}

TEST(AnswersWithin, HaveTimesBetweenThoseOfTheOuterRadii) {
  const Shapes falls{Motion(Ball{{2, 2, 3}, 1}, {2, 2, -1}), square()};  // touches at 1/2
  EXPECT_TRUE(within(falls, 0.25, "time", "0.5625"));
  EXPECT_FALSE(within(falls, 0.125, "time", "0.5625"));
  EXPECT_FALSE(within(falls, 0.25, "time", "null"));
  EXPECT_TRUE(within(falls, 0.25, "point", "[2.1,2,0]"));
  EXPECT_FALSE(within(falls, 0.25, "point", "[4,2,0]"));
  EXPECT_TRUE(within(falls, 0.25, "contact_normal", "[0,0,1]"));
  EXPECT_FALSE(within(falls, 0.25, "contact_normal", "[0,0,-1]"));
  const Shapes ends_above{Motion(Ball{{2, 2, 3}, 1}, {2, 2, 1.125}), square()};
  EXPECT_TRUE(within(ends_above, 0.125, "contact", "true"));
  EXPECT_TRUE(within(ends_above, 0.25, "first", "\"way\""));
  EXPECT_FALSE(within(ends_above, 0.0625, "first", "\"way\""));
  EXPECT_TRUE(within(ends_above, 0.25, "time", "1"));
  EXPECT_FALSE(within(ends_above, 0.25, "time", "0.5"));
}

// The exact answers about the same ball with a slightly larger or smaller radius are within the margin, key by key.
TEST(AnswersWithin, HaveTheAnswersOfEveryRadiusInBetween) {
  using workloads::BallPlace;
  int asked = 0;
  for (const auto way : {workloads::Way::Static, workloads::Way::Across, workloads::Way::Along, workloads::Way::Start})
    for (const BallPlace place : {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::LatticeTangent})
      for (std::uint64_t i = 0; i < 60; ++i) {
        workloads::Sample sample = workloads::sample({.ball = place, .vertices = 6, .way = way}, 3, i);
        const Shapes shapes{sample.question(), std::move(sample.polygon)};
        const double margin = margin_of("2^-20").length(shapes);
        const AnswersWithin within(shapes, margin);
        for (const double share : {-0.9, -0.5, 0.5, 0.9}) {
          const double radius = std::max(shapes.ball().radius + share * margin, 0.0);
          const PartialAnswer answer = exact_answer({with_radius(shapes.question, radius), shapes.polygon});
          const StatedAnswer other = stated(answer);
          for (const auto& [name, text] : other.texts) {
            EXPECT_TRUE(within.has(*find_key(name), other))
                << sample.id << ", " << share << ", " << name << ' ' << text;
            ++asked;
          }
        }
      }
  EXPECT_GT(asked, 20'000);
}

TEST(AnswersWithin, DependOnNoScale) {
  for (const int scale : {-660, 0, 660}) {
    const auto at = [&](double x, double y, double z) -> Eigen::Vector3d {
      return {std::ldexp(x, scale), std::ldexp(y, scale), std::ldexp(z, scale)};
    };
    const auto text = [](const Eigen::Vector3d& v) { return nlohmann::json{v.x(), v.y(), v.z()}.dump(); };
    const Polygon wide({at(-50, -50, 0), at(50, -50, 0), at(50, 50, 0), at(-50, 50, 0)});
    const Shapes shapes{Ball{at(0, 0, 10), std::ldexp(10.0, scale)}, wide};
    const double margin = std::ldexp(0x1p-14, scale);
    EXPECT_FALSE(within(shapes, margin, "point", text(at(40, 0, 0)))) << scale;
    EXPECT_TRUE(within(shapes, margin, "point", text(at(0x1p-12, 0, 0)))) << scale;
    EXPECT_FALSE(within(shapes, margin, "nearest", R"({"kind":"vertex","index":2})")) << scale;
  }
}

// The distance rounds to infinity, so it does not tell which points are near the closest one.
TEST(AnswersWithin, OfBallsFarAwayAreTheExactOnes) {
  constexpr double kHuge = 0x1.8p1023;
  const Shapes shapes{Ball{{kHuge, kHuge, kHuge}, 1}, square()};
  EXPECT_TRUE(within(shapes, kHuge, "distance", "null"));
  EXPECT_FALSE(within(shapes, 1, "point", "[0,0,0]"));
  EXPECT_FALSE(within(shapes, 1, "nearest", R"({"kind":"vertex","index":0})"));
  const Shapes large{Ball{{0, 0, 1}, kHuge}, square()};
  EXPECT_TRUE(within(large, kHuge, "contact", "true")) << "no radius is infinite";
}

TEST(AnswersWithin, OfMovingBallsAreNotThoseOfOtherTimes) {
  const Polygon wide({{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}});
  const Shapes starts{Motion(Ball{{0, 0, 10}, 100}, {0, 0, 5}), wide};
  EXPECT_FALSE(within(starts, 1e-4, "point", "[40,0,0]"));
  EXPECT_TRUE(within(starts, 1e-4, "point", "[0.0001,0,0]"));
  const Shapes grazes{Motion(Ball{{-100, 0, 10}, 10}, {100, 0, 10}), wide};
  EXPECT_TRUE(within(grazes, 1e-4, "contact_normal", "[0,0,1]"));
  EXPECT_FALSE(within(grazes, 1e-4, "contact_normal", "[0,0,-1]"));
  const Shapes ends{Motion(Ball{{0, 0, 100}, 10}, {0, 0, 10}), wide};
  EXPECT_FALSE(within(ends, 1e-4, "time", "7"));
  const Shapes misses{Motion(Ball{{0, 0, 100}, 10}, {0, 0, 12.5}), wide};
  EXPECT_FALSE(within(misses, 2, "point", "[0,0,1.5]"));
}

TEST(AnswersWithin, HaveLiftedVertices) {
  const Shapes shapes{Ball{{10, 7, 1}, 1}, Polygon({{0, 0, 0}, {10, 0, 10}, {10, 10, 0}, {0, 10, 10}})};
  EXPECT_FALSE(within(shapes, 0.01, "nearest", R"({"kind":"vertex","index":2})")) << "as lifted it is at 5";
}

TEST(AnswersWithin, LackWhatDoesNotHaveTheFormOfTheContract) {
  const Shapes shapes{Ball{{2, 2, 1}, 0.75}, square()};
  EXPECT_FALSE(within(shapes, kInfinity, "contact", "1"));
  EXPECT_FALSE(AnswersWithin(shapes, 1).has(*find_key("contact"), {}));
}

// Two squares beside each other at heights 0 and 0.01, below a ball between them, and a third one far below.
MeshShapes steps(const Question& question) {
  Mesh mesh;
  for (const auto& [x, z] : {std::pair(0.0, 0.0), std::pair(4.0, 0.01), std::pair(0.0, -3.0)}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, z}, {x + 4, 0, z}, {x + 4, 4, z}, {x, 4, z}});
    mesh.faces.push_back({first, first + 1, first + 2, first + 3});
  }
  return {question, PosedMesh(std::move(mesh))};
}

TEST(AnswersWithin, OfAMeshNameAFaceThatIsNearlyAsNear) {
  const MeshShapes at_rest = steps(Ball{{4, 2, 1}, 1});
  ASSERT_EQ(exact_answer(at_rest).face, 1U);
  const auto within = [&](const MeshShapes& shapes, double margin, const char* key, const char* answer) {
    return AnswersWithin(shapes, margin).has(*find_key(key), stated_in(nlohmann::json::parse(answer)));
  };
  EXPECT_TRUE(within(at_rest, 0.011, "face", R"({"face":0})"));
  EXPECT_FALSE(within(at_rest, 0.009, "face", R"({"face":0})"));
  EXPECT_FALSE(within(at_rest, 0.011, "face", R"({"face":2})"));
  EXPECT_FALSE(within(at_rest, 0.011, "face", R"({"face":3})"));
  EXPECT_TRUE(within(at_rest, 0.011, "touched", R"({"touched":[1]})"));
  EXPECT_FALSE(within(at_rest, 0.011, "touched", R"({"touched":[0,1,2]})"));
  EXPECT_FALSE(within(at_rest, 0.009, "touched", R"({"touched":[0]})"))
      << "face 1 is touched with the least radius, too";
  // The other keys are about the face that the answer names.
  EXPECT_TRUE(within(at_rest, 0.011, "nearest", R"({"face":0,"nearest":{"kind":"edge","index":1}})"));
  EXPECT_FALSE(within(at_rest, 0.011, "nearest", R"({"face":0,"nearest":{"kind":"edge","index":0}})"));
  EXPECT_FALSE(within(at_rest, 0.011, "nearest", R"({"face":9,"nearest":{"kind":"edge","index":1}})"));
  EXPECT_FALSE(within(at_rest, 0.011, "point", R"({"face":2,"point":[4,2,-3]})")) << "true of a face that is far away";
  EXPECT_FALSE(within(at_rest, 0.011, "contact_normal", R"({"face":1,"contact_normal":[0,0,1.01]})"));
  const MeshShapes deep = steps(Ball{{4, 2, 1}, 1.5});
  EXPECT_FALSE(within(deep, 0.011, "contact", R"({"face":2,"contact":false})"));
  EXPECT_TRUE(within(at_rest, 0.011, "distance", R"({"distance":1})"));

  const MeshShapes falling = steps(Motion({{4, 2, 3}, 1}, {4, 2, 0}));
  EXPECT_TRUE(within(falling, 0.011, "face", R"({"face":0})"));
  EXPECT_FALSE(within(falling, 0.004, "face", R"({"face":0})"));
  EXPECT_FALSE(within(falling, 0.011, "face", R"({"face":2})"));
  const MeshShapes starts = steps(Motion({{4, 2, 0.5}, 0.51}, {4, 2, 0}));  // in face 1 by 0.02, in face 0 by 0.01
  EXPECT_TRUE(within(starts, 0.02, "depth", R"({"face":0,"depth":0.01})"));
  EXPECT_FALSE(within(starts, 0.02, "depth", R"({"face":0,"depth":0.1})"));
}

}  // namespace
}  // namespace touchstone::cases
