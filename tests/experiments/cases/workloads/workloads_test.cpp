// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "experiments/cases/workloads/outline.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/cases/workloads/workload.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"

namespace touchstone::workloads {
namespace {

constexpr std::uint64_t kWorkloadSeed = 2008;

/// FNV-1a over the bits of numbers, byte by byte.
class Hash {
 public:
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
  }
  void add(const Sample& sample) {
    for (int axis = 0; axis < 3; ++axis) add(sample.ball.center[axis]);
    add(sample.ball.radius);
    for (std::size_t loop = 0; loop < sample.polygon.loop_count(); ++loop) {
      add(std::uint64_t{sample.polygon.loop_end(loop)});
      for (std::size_t i = sample.polygon.loop_begin(loop); i < sample.polygon.loop_end(loop); ++i)
        for (int axis = 0; axis < 3; ++axis) add(sample.polygon.coordinates(axis)[i]);
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t hash(const Sample& sample) {
  Hash hash;
  hash.add(sample);
  return hash.value();
}

/// Returns every valid combination of family, placement and ball place.
std::vector<Workload> all_workloads() {
  std::vector<Workload> workloads;
  for (const Family family : all_families())
    for (const Placement placement : all_placements())
      for (const BallPlace ball : all_ball_places()) {
        if (ball == BallPlace::LatticeTangent && placement != Placement::LatticeFrame) continue;
        workloads.push_back({.family = family, .placement = placement, .ball = ball});
      }
  return workloads;
}

Workload with_holes(Workload workload, std::size_t holes) {
  workload.holes = holes;
  return workload;
}

// --- Random numbers ---

// Random123's own known answers for philox4x64-10: key and counter zero.
TEST(Random, IsPhilox4x64) {
  Random random(0, 0, 0);
  EXPECT_EQ(random.bits(), 0x16554d9eca36314cu);
  EXPECT_EQ(random.bits(), 0xdb20fe9d672d0fdcu);
  EXPECT_EQ(random.bits(), 0xd7e772cee186176bu);
  EXPECT_EQ(random.bits(), 0x7e68b68aec7ba23bu);
}

TEST(Random, DependsOnSeedSampleAndStream) {
  std::set<std::uint64_t> drawn;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    for (std::uint64_t sample = 0; sample < 4; ++sample)
      for (std::uint64_t stream = 0; stream < 4; ++stream) {
        Random random(seed, sample, stream), same(seed, sample, stream);
        for (int i = 0; i < 9; ++i) {
          const std::uint64_t bits = random.bits();
          EXPECT_EQ(bits, same.bits());
          EXPECT_TRUE(drawn.insert(bits).second);
        }
      }
}

TEST(Random, UnitLiesInTheHalfOpenIntervalOnMultiplesOf2ToMinus53) {
  Random random(kWorkloadSeed, 0);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.unit();
    EXPECT_TRUE(0 <= x && x < 1) << x;
    EXPECT_EQ(x * 0x1p53, static_cast<double>(static_cast<std::uint64_t>(x * 0x1p53)));
    sum += x;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.02);
}

TEST(Random, IntegerReachesBothBoundsAndNoMore) {
  Random random(kWorkloadSeed, 0);
  std::map<std::int64_t, int> counts;
  for (int i = 0; i < 10000; ++i) ++counts[random.integer(-2, 2)];
  EXPECT_EQ(counts.begin()->first, -2);
  EXPECT_EQ(counts.rbegin()->first, 2);
  for (const auto& [value, count] : counts) EXPECT_NEAR(count, 2000, 250) << value;

  EXPECT_EQ(random.integer(7, 7), 7);
  constexpr std::int64_t kLow = std::numeric_limits<std::int64_t>::min(),
                         kHigh = std::numeric_limits<std::int64_t>::max();
  bool negative = false, positive = false;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t x = random.integer(kLow, kHigh);
    negative = negative || x < 0;
    positive = positive || x > 0;
  }
  EXPECT_TRUE(negative && positive);
}

// For 3 * 2^62 values, 2^62 of 2^64 draws are rejected; otherwise the lowest third would occur half of the time.
TEST(Random, IntegerIsUnbiasedWhereTheRangeDoesNotDivide) {
  Random random(kWorkloadSeed, 0);
  constexpr std::int64_t kThird = std::int64_t{1} << 62;
  int lowest_third = 0;
  for (int i = 0; i < 9000; ++i) lowest_third += random.integer(-kThird, 2 * (kThird - 1) + 1) < 0;
  EXPECT_NEAR(lowest_third, 3000, 250);
}

TEST(Random, LogUniformHasBothSignsAndTheExponentsAskedFor) {
  Random random(kWorkloadSeed, 0);
  std::map<int, int> exponents;
  int negative = 0;
  for (int i = 0; i < 4000; ++i) {
    const double x = random.log_uniform(-1, 2);
    negative += x < 0;
    ++exponents[std::ilogb(x)];
  }
  EXPECT_NEAR(negative, 2000, 200);
  ASSERT_EQ(exponents.size(), 4u);
  for (const auto& [exponent, count] : exponents) EXPECT_NEAR(count, 1000, 150) << exponent;
  EXPECT_EQ(exponents.begin()->first, -1);
}

// --- Doubles as a line ---

TEST(MoveByDoubles, StepsAlongTheFiniteDoubles) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(move_by_doubles(1, 1), std::nextafter(1.0, 2.0));
  EXPECT_EQ(move_by_doubles(1, -1), std::nextafter(1.0, 0.0));
  EXPECT_EQ(move_by_doubles(0, -2), -2 * kTiny);
  EXPECT_EQ(move_by_doubles(-0.0, 2), 2 * kTiny);
  EXPECT_EQ(move_by_doubles(-kTiny, 2), kTiny);
  EXPECT_FALSE(std::signbit(move_by_doubles(-kTiny, 1)));
  EXPECT_EQ(move_by_doubles(move_by_doubles(-1.5, 1000), -1000), -1.5);
}

// --- Outlines ---

TEST(Outline, FamiliesButTriangleAndConvexAreNotConvex) {
  for (const Family family : all_families())
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Workload workload{.family = family, .vertices = 3 + i};
      const bool convex = family == Family::Triangle || family == Family::Convex;
      EXPECT_EQ(is_convex(draw_outline(workload, kWorkloadSeed, i).outer), convex) << to_string(family) << " " << i;
    }
}

TEST(Outline, StaysWithinTheLattice) {
  for (const Family family : all_families())
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Workload workload{
          .family = family, .vertices = 5 * i, .koch_dimension = 1.01 + 0.01 * static_cast<double>(i)};
      for (const LatticePoint& p : draw_outline(workload, kWorkloadSeed, i).outer)
        EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), kLatticeRadius) << to_string(family) << " " << i;
    }
}

TEST(Outline, HasTheVerticesAskedForAsNearlyAsTheFamilyAllows) {
  const auto count = [](Family family, std::size_t vertices, std::uint64_t index) {
    const Workload workload{.family = family, .vertices = vertices};
    return draw_outline(workload, kWorkloadSeed, index).outer.size();
  };
  for (std::uint64_t i = 0; i < 20; ++i)
    for (const std::size_t n : {8u, 24u, 64u, 192u}) {
      for (const Family family : {Family::Convex, Family::Star, Family::RandomSimple, Family::Spiral, Family::Comb})
        EXPECT_EQ(count(family, n, i), n) << to_string(family);
      EXPECT_EQ(count(Family::Triangle, n, i), 3u);
      EXPECT_EQ(count(Family::U, n, i), 8u);
      EXPECT_EQ(count(Family::L, n, i), 6u);
      EXPECT_EQ(count(Family::E, n, i), 12u);
      const std::size_t koch = count(Family::Koch, n, i);
      EXPECT_TRUE(koch == 12 || koch == 16 || koch == 48 || koch == 64 || koch == 192 || koch == 256) << koch;
    }
  for (const Family family : all_families()) EXPECT_GE(count(family, 0, 0), 3u);
}

// If the moves were unbounded, this test would not end.
TEST(Outline, IsFoundThoughTheMovesOfARandomSimplePolygonGoInCircles) {
  const Workload workload{.family = Family::RandomSimple, .vertices = 24};
  EXPECT_EQ(draw_outline(workload, 20261122, 949983).outer.size(), 24u);  // points of which three are collinear
}

TEST(Outline, KochDimensionChangesTheOutlineAndNothingElse) {
  const Workload workload{.family = Family::Koch};
  Workload rougher = workload;
  rougher.koch_dimension = 1.5;
  const LatticeLoop a = draw_outline(workload, kWorkloadSeed, 0).outer,
                    b = draw_outline(rougher, kWorkloadSeed, 0).outer;
  ASSERT_EQ(a.size(), b.size());
  std::size_t kept = 0;  // the base's vertices
  for (std::size_t i = 0; i < a.size(); ++i) kept += a[i] == b[i];
  EXPECT_GE(kept, 3u);
  EXPECT_LE(kept, 4u);
}

// Holes do not change the outer loop, as long as they fit.
TEST(Outline, HolesAreDrawnApart) {
  const Workload workload{.family = Family::Star};
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Outline plain = draw_outline(workload, kWorkloadSeed, i),
                  holed = draw_outline(with_holes(workload, 2), kWorkloadSeed, i);
    EXPECT_EQ(plain.outer, holed.outer);
    EXPECT_EQ(holed.holes.size(), 2u);
  }
}

TEST(Outline, BothOrientationsOccur) {
  const Workload workload{.family = Family::E, .holes = 1};
  int outer = 0, hole = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Outline outline = draw_outline(workload, kWorkloadSeed, i);
    outer += twice_area(outline.outer) > 0;
    hole += twice_area(outline.holes[0]) > 0;
  }
  EXPECT_NEAR(outer, 50, 25);
  EXPECT_NEAR(hole, 50, 25);
}

// --- Samples ---

TEST(Sample, IsAFunctionOfSeedAndIndexInAnyOrder) {
  for (const Workload& workload : all_workloads()) {
    const auto drawn = [&](std::uint64_t seed, std::uint64_t index) {
      const Sample s = sample(workload, seed, index);
      return std::pair(s.id, hash(s));
    };
    const auto first = drawn(kWorkloadSeed, 0), second = drawn(kWorkloadSeed, 1),
               other_seed = drawn(kWorkloadSeed + 1, 0);
    EXPECT_EQ(drawn(kWorkloadSeed, 1), second);
    EXPECT_EQ(drawn(kWorkloadSeed, 0), first);
    EXPECT_NE(first.second, second.second) << first.first;
    EXPECT_NE(first.second, other_seed.second) << first.first;
  }
}

// Every family, placement, number of holes: the loops are those of a region, exactly planar in a lattice frame.
TEST(Sample, IsAcceptedByValidate) {
  for (const Workload& plain : all_workloads())
    for (std::size_t holes = 0; holes <= 2; ++holes)
      for (std::uint64_t i = 0; i < 8; ++i) {
        const Workload workload = with_holes(plain, holes);
        const Sample s = sample(workload, kWorkloadSeed, i);
        const auto fault = exact::validate(s.polygon);
        EXPECT_FALSE(fault) << s.id << ": " << fault->message;
        EXPECT_FALSE(find_fault(s.ball)) << s.id;
        EXPECT_EQ(s.polygon.loop_count(), holes + 1) << s.id;
        const bool planar = exact::answer(s.ball, s.polygon).off_plane == 0;
        EXPECT_TRUE(planar || workload.placement == Placement::Rotated) << s.id;
      }
}

// The radius is exactly `doubles` doubles from the one nearest to the distance; the centre does not depend on them.
TEST(Sample, NearBallsHaveTheirFeatureAndTheirDistanceInDoubles) {
  const std::map<BallPlace, Feature::Kind> kinds{{BallPlace::NearFace, Feature::Kind::Face},
                                                 {BallPlace::NearEdge, Feature::Kind::Edge},
                                                 {BallPlace::NearVertex, Feature::Kind::Vertex}};
  for (Workload workload : all_workloads()) {
    const auto kind = kinds.find(workload.ball);
    if (kind == kinds.end()) continue;
    for (std::uint64_t i = 0; i < 8; ++i) {
      workload.holes = i % 2;
      workload.doubles = 0;
      const Ball at_distance = sample(workload, kWorkloadSeed, i).ball;
      for (const int doubles : {-1000, -1, 0, 1, 7}) {
        workload.doubles = doubles;
        const Sample s = sample(workload, kWorkloadSeed, i);
        const Answer answer = exact::answer(s.ball, s.polygon);
        EXPECT_EQ(answer.nearest.kind, kind->second) << s.id;
        EXPECT_EQ(s.ball.radius, move_by_doubles(answer.distance, doubles)) << s.id;
        EXPECT_EQ(s.ball.center, at_distance.center) << s.id;
        EXPECT_TRUE(doubles >= 0 || answer.relation == Relation::Separate) << s.id;
        EXPECT_TRUE(doubles <= 0 || answer.relation == Relation::Overlapping) << s.id;
      }
    }
  }
}

TEST(Sample, LatticeTangentBallsTouch) {
  std::map<std::pair<Feature::Kind, PointLocation>, int> seen;
  for (Workload workload : all_workloads()) {
    if (workload.ball != BallPlace::LatticeTangent) continue;
    for (std::uint64_t i = 0; i < 20; ++i) {
      workload.holes = i % 2;
      workload.doubles = 0;
      const Sample s = sample(workload, kWorkloadSeed, i);
      const Answer answer = exact::answer(s.ball, s.polygon);
      EXPECT_EQ(answer.relation, Relation::Touching) << s.id;
      EXPECT_EQ(answer.distance, s.ball.radius) << s.id;
      EXPECT_EQ(s.ball.radius, std::round(s.ball.radius)) << s.id;
      EXPECT_EQ(std::count(s.tags.begin(), s.tags.end(), "tangent"), 1) << s.id;
      ++seen[{answer.nearest.kind, answer.foot}];

      workload.doubles = -1;
      const Sample below = sample(workload, kWorkloadSeed, i);
      EXPECT_EQ(exact::relation(below.ball, below.polygon), Relation::Separate) << below.id;
      EXPECT_EQ(std::count(below.tags.begin(), below.tags.end(), "tangent"), 0) << below.id;
    }
  }
  using enum Feature::Kind;
  for (const auto& place : {std::pair(Face, PointLocation::Inside), std::pair(Edge, PointLocation::Boundary),
                            std::pair(Edge, PointLocation::Outside), std::pair(Vertex, PointLocation::Boundary),
                            std::pair(Vertex, PointLocation::Outside)})
    EXPECT_GT(seen[place], 0) << to_string(place.first) << " " << to_string(place.second);
}

// The foot lies inside, outside and, on exactly planar outlines, on the boundary; the ball reaches the polygon anyway.
TEST(Sample, FeetNearTheBoundaryFallOnEverySideOfIt) {
  std::map<PointLocation, int> feet;
  for (Workload workload : all_workloads()) {
    if (workload.ball != BallPlace::FootNearEdge && workload.ball != BallPlace::FootNearVertex) continue;
    for (std::uint64_t i = 0; i < 20; ++i) {
      const Sample s = sample(workload, kWorkloadSeed, i);
      const Answer answer = exact::answer(s.ball, s.polygon);
      ++feet[answer.foot];
      EXPECT_EQ(answer.relation, Relation::Overlapping) << s.id;
    }
  }
  EXPECT_GT(feet[PointLocation::Inside], 50);
  EXPECT_GT(feet[PointLocation::Outside], 50);
  EXPECT_GT(feet[PointLocation::Boundary], 50);
}

// Whole multiples of 2^-51, of up to 52 bits, so that a product of two of them is rounded.
TEST(Sample, OfAPlanarFrameHasCoordinatesOfManyBits) {
  double most = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Polygon polygon = draw_placed_outline({.placement = Placement::Planar}, kWorkloadSeed, i).polygon;
    double largest = 0;
    for (std::size_t v = 0; v < polygon.vertex_count(); ++v) {
      const Eigen::Vector3d whole = polygon.vertex(v) * 0x1p51;
      EXPECT_EQ(whole, whole.array().round().matrix());
      largest = std::max(largest, whole.cwiseAbs().maxCoeff());
    }
    EXPECT_GT(largest, 0x1p44);
    most = std::max(most, largest);
  }
  EXPECT_LT(most, 0x1p52);
}

TEST(Sample, LiesAsFarFromTheOriginAsAskedFor) {
  for (const Placement placement : all_placements()) {
    const Workload workload{.placement = placement, .origin_distance = 1e6};
    const PlacedOutline placed = draw_placed_outline(workload, kWorkloadSeed, 0);
    const double size = static_cast<double>(bounding_box(placed.outline.outer).size()) * placed.frame.unit;
    EXPECT_NEAR(placed.polygon.vertex(0).norm() / size, 1e6, 3);
  }
}

TEST(Sample, NamesItsSettings) {
  Workload workload{.ball = BallPlace::NearEdge, .holes = 1, .doubles = -2};
  EXPECT_EQ(sample(workload, 7, 153).id, "star-lattice-frame-near-edge-n24-h1-k-2-s7-i153");
  workload.family = Family::Koch;
  workload.placement = Placement::Rotated;
  workload.koch_dimension = 1.5;
  workload.origin_distance = 1e6;
  const Sample s = sample(workload, 7, 153);
  EXPECT_EQ(s.id, "koch-rotated-near-edge-n24-h1-k-2-d1.5-o1e+06-s7-i153");
  EXPECT_EQ(s.tags, (std::vector<std::string>{"koch", "rotated", "near-edge"}));
}

TEST(Sample, RefusesWhatTheFamilyCannotGive) {
  const auto refuses = [](auto change) {
    Workload workload;
    change(workload);
    EXPECT_THROW((void)sample(workload, kWorkloadSeed, 0), std::invalid_argument);
  };
  refuses([](Workload& w) { w.koch_dimension = 1; });
  refuses([](Workload& w) { w.koch_dimension = 2; });
  refuses([](Workload& w) { w.vertices = 1000000; });
  refuses([](Workload& w) { w.family = Family::RandomSimple, w.vertices = kMostRandomSimple + 1; });
  refuses([](Workload& w) { w.holes = kMostHoles + 1; });
  refuses([](Workload& w) { w.origin_distance = -1; });
  refuses([](Workload& w) { w.origin_distance = 1e12; });
  refuses([](Workload& w) { w.origin_distance = 1e15, w.placement = Placement::Rotated, w.vertices = 1000; });
  refuses([](Workload& w) { w.ball = BallPlace::LatticeTangent, w.placement = Placement::Rotated; });
  refuses([](Workload& w) { w.family = Family::Koch, w.koch_dimension = std::nextafter(2.0, 0); });
}

// --- The same bits on every compiler ---

// The first 100 samples of every workload of a family, one hole in every other sample. g++ and clang++, -O0 and -O3
// agree; a change of these numbers changes every experiment.
TEST(Sample, HasTheGoldenBits) {
  const std::map<Family, std::uint64_t> golden{
      {Family::Triangle, 0xb4bdf3686ff4399d}, {Family::Convex, 0x87031295f3b39f3a},
      {Family::Star, 0x682cabfe27760c85},     {Family::Comb, 0xe77980adfca975ea},
      {Family::Spiral, 0x96e6c18a60a14f58},   {Family::RandomSimple, 0x4e6f64007fa3996e},
      {Family::Koch, 0xd934d5249415a9},       {Family::U, 0x7033e7789d18de79},
      {Family::L, 0xc590672685b4354f},        {Family::E, 0x92cb3d86c69cbe23},
  };
  std::map<Family, Hash> hashes;
  for (const Workload& workload : all_workloads())
    for (std::uint64_t i = 0; i < 100; ++i)
      hashes[workload.family].add(sample(with_holes(workload, i % 2), kWorkloadSeed, i));
  for (const auto& [family, hash] : hashes)
    EXPECT_EQ(hash.value(), golden.at(family)) << to_string(family) << std::hex << " 0x" << hash.value();
}

}  // namespace
}  // namespace touchstone::workloads
