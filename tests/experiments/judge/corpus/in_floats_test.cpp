// SPDX-License-Identifier: GPL-3.0-or-later
// Cases in floats: nothing is left to round, and a radius that was at the threshold still is.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiments/cases/workloads/workload.h"
#include "experiments/judge/corpus/corpus.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::corpus {
namespace {

CorpusCase case_of(const workloads::Workload& workload, std::uint64_t index) {
  workloads::Sample sample = workloads::sample(workload, 7, index);
  return {sample.id, cases::Shapes{sample.question(), std::move(sample.polygon)}, {}, "drawn"};
}

/// The radius some floats away.
float off(float radius, int floats) {
  for (; floats > 0; --floats) radius = std::nextafter(radius, std::numeric_limits<float>::max());
  for (; floats < 0; ++floats) radius = std::nextafter(radius, 0.0F);
  return radius;
}

const cases::Shapes& polygon_case(const CorpusCase& given) { return std::get<cases::Shapes>(given.shapes); }

bool touches_with(const cases::AnyShapes& any_shapes, double radius) {
  const auto& shapes = std::get<cases::Shapes>(any_shapes);
  return std::visit([&](const auto& question) { return exact::contact(question, shapes.polygon); },
                    cases::with_radius(shapes.question, radius));
}
bool touches(const cases::AnyShapes& shapes, float radius) { return touches_with(shapes, static_cast<double>(radius)); }

TEST(InFloats, MakesACaseWhoseRadiusIsWithinAFloatOfTheThreshold) {
  using workloads::BallPlace;
  int made = 0, without = 0, least = 0, above = 0;
  for (const auto way : {workloads::Way::Static, workloads::Way::Across})
    for (const BallPlace place : {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex})
      for (std::uint64_t i = 0; i < 100; ++i) {
        const CorpusCase drawn = case_of({.ball = place, .vertices = 3, .way = way}, i);
        const auto found = in_floats(drawn);
        const double radius_drawn = polygon_case(drawn).ball().radius;
        const bool at_threshold = !touches_with(drawn.shapes, radius_drawn * (1 - 0x1p-40)) &&
                                  touches_with(drawn.shapes, radius_drawn * (1 + 0x1p-40));
        if (!found || !at_threshold || touches(found->shapes, 0)) continue;
        ++made;
        EXPECT_TRUE(is_in_floats(found->shapes)) << found->id;
        EXPECT_TRUE(found->id.ends_with("-float"));
        EXPECT_EQ(found->origin, "the nearest floats of: drawn");
        const auto radius = static_cast<float>(polygon_case(*found).ball().radius);
        if (!touches(found->shapes, radius)) {
          EXPECT_TRUE(touches(found->shapes, off(radius, 1))) << found->id;
          ++without;
        } else if (!touches(found->shapes, off(radius, -1))) {
          ++least;
        } else {
          EXPECT_FALSE(touches(found->shapes, off(radius, -2))) << found->id;
          ++above;
        }
      }
  EXPECT_GT(made, 400);
  for (const int some : {without, least, above}) EXPECT_GT(some, made / 5);
}

TEST(InFloats, KeepsWhatIsInFloatsAlready) {
  const cases::Shapes shapes{Ball{{0.5, 0.25, 1}, 1}, Polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})};
  const auto found = in_floats({"it", shapes, {"tag"}, "by hand"});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, "it-float");
  EXPECT_EQ(found->origin, "by hand");
  EXPECT_EQ(polygon_case(*found).ball().radius, 1);
}

TEST(InFloats, RoundsOtherRadii) {
  const cases::Shapes shapes{Ball{{0.5, 0.25, 1}, 0.1}, Polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})};
  EXPECT_EQ(polygon_case(*in_floats({"it", shapes, {}, ""})).ball().radius, static_cast<double>(0.1F));
}

TEST(InFloats, LeavesOutWhatFloatsCannotHold) {
  const auto has = [](const Ball& ball, const Polygon& polygon) {
    return in_floats({"it", cases::Shapes{ball, polygon}, {}, ""}).has_value();
  };
  const Polygon triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_TRUE(has(Ball{{0, 0, 1e30}, 0.1}, triangle));
  EXPECT_FALSE(has(Ball{{0, 0, 1e300}, 0.1}, triangle));
  EXPECT_FALSE(has(Ball{{0, 0, 0}, 1e300}, triangle));
  EXPECT_FALSE(has(Ball{{0, 0, 1}, 0.1}, Polygon({{0, 0, 0}, {1e-60, 0, 0}, {0, 1e-60, 0}}))) << "a point";
  EXPECT_FALSE(has(Ball{{0, 0, 1}, 0.1}, Polygon({{0, 0, 0.1}, {1, 0, 0.3}, {1, 1, 0.5}, {0, 1, 0.3}}))) << "off plane";
}

}  // namespace
}  // namespace touchstone::corpus
