// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "geometry/contact/fast_motion.h"
#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::bench {
namespace {

struct MotionOfTriangle {
  Motion motion;
  Triangle triangle;
};
using MotionQueries = std::vector<MotionOfTriangle>;

/// The part of a first contact on which fast and exact agree up to rounding, in a form that can be compared and summed.
struct FirstDecisions {
  FirstContact first;

  explicit operator std::uint64_t() const { return static_cast<std::uint64_t>(first.kind); }
  friend bool operator==(const FirstDecisions& a, const FirstDecisions& b) {
    return a.first.kind == b.first.kind && a.first.feature == b.first.feature;
  }
};

constexpr auto kContactInMotion = [](const Motion& motion, const auto& polygon) { return contact(motion, polygon); };
constexpr auto kFirst = [](const Motion& motion, const auto& polygon) {
  return FirstDecisions{first_contact(motion, polygon)};
};

enum class Ways { Random, NearGrazing };

/// Draws motion number `index`: vertices and both ends uniform in the unit cube, radius uniform in [0, 0.25); or
/// (1 + 2^-50) or (1 - 2^-50) times the radius that grazes.
MotionOfTriangle draw(Ways ways, std::uint64_t seed, std::uint64_t index) {
  const auto [ball, triangle] = workloads::draw_triangle_query(workloads::TriangleFamily::Random, seed, index);
  const auto other = workloads::draw_triangle_query(workloads::TriangleFamily::Random, ~seed, index);
  const Motion motion{{ball.center, ball.radius / 2}, other.ball.center};
  if (ways == Ways::Random) return {motion, triangle};
  const double grazing = workloads::grazing_radius(
      motion, [&triangle = triangle](const Motion& asked) { return filtered::contact(asked, triangle); });
  return {workloads::with_radius(motion, grazing * (1 + (index % 2 == 0 ? 0x1p-50 : -0x1p-50))), triangle};
}

/// One question about triangles to fast, filtered and exact.
template <class Question>
timing::Benchmark about_triangles(const char* name, Ways ways, const Settings& settings, const Question& question,
                                  double goal) {
  constexpr std::size_t kMostChecked = 2000;  // a second
  MotionQueries drawn;
  for (std::uint64_t i = 0; i < settings.samples; ++i) drawn.push_back(draw(ways, settings.seed, i));
  const auto queries = std::make_shared<const MotionQueries>(std::move(drawn));

  timing::Benchmark benchmark;
  benchmark.name = name;
  benchmark.checked = settings.checks ? std::min<std::size_t>(settings.samples, kMostChecked) : 0;
  const auto exactly = [question](const MotionOfTriangle& q) {
    return question(q.motion, exact::PreparedPolygon(Polygon({q.triangle.a, q.triangle.b, q.triangle.c})));
  };
  std::vector<decltype(exactly(queries->front()))> list;
  for (std::size_t i = 0; i < benchmark.checked; ++i) list.push_back(exactly((*queries)[i]));
  const auto truth = std::make_shared<const decltype(list)>(std::move(list));

  const auto add = [&](std::string who, auto ask, std::optional<timing::Comparison> comparison) {
    benchmark.candidates.push_back(candidate(std::move(who), queries, truth, ask, std::move(comparison)));
  };
  if constexpr (std::is_same_v<decltype(exactly(queries->front())), bool>) {
    if (benchmark.checked > 0)
      benchmark.note =
          statistics::percent_to_places(
              statistics::share_of(static_cast<std::uint64_t>(std::ranges::count(*truth, true)), benchmark.checked),
              1) +
          " % touch";
    add(
        "fast", [](const MotionOfTriangle& q) { return fast::contact(q.motion, q.triangle); }, std::nullopt);
    add(
        "filtered", [](const MotionOfTriangle& q) { return filtered::contact(q.motion, q.triangle); },
        timing::Comparison{"fast", timing::Goal{goal}});
  } else {
    add(
        "fast", [](const MotionOfTriangle& q) { return FirstDecisions{fast::first_contact(q.motion, q.triangle)}; },
        std::nullopt);
    add(
        "filtered",
        [](const MotionOfTriangle& q) { return FirstDecisions{filtered::first_contact(q.motion, q.triangle)}; },
        timing::Comparison{"fast", timing::Goal{goal}});
  }
  add("exact", exactly, timing::Comparison{"filtered", timing::Goal{50, false}});
  return benchmark;
}

/// One question about prepared polygons of all outlines.
template <class Question>
timing::Benchmark about_polygons(const char* name, std::size_t vertices, const Settings& settings,
                                 const Question& question, std::optional<timing::Goal> goal) {
  const auto polygons = draw_polygons_of_all_outlines(vertices, settings.seed);
  const auto queries =
      std::make_shared<const std::vector<PolygonMotion>>(draw_motions(polygons, settings.seed, settings.samples));
  return compare(fmt::format("{}, {} vertices", name, vertices), polygons, vertices, Queries<PolygonMotion>(queries),
                 settings, question, goal, timing::Goal{50, false});
}

}  // namespace

Family motion_family() {
  Family family{"motions", "contact and first contact of moving balls", {}};
  const auto triangles = [&family](const char* name, Ways ways, auto question, double goal) {
    family.benchmarks.emplace_back(
        [=](const Settings& settings) { return about_triangles(name, ways, settings, question, goal); });
  };
  triangles("contact, random triangles", Ways::Random, kContactInMotion, 1.3);
  triangles("first contact, random triangles", Ways::Random, kFirst, 3);
  triangles("contact, 2^-50 from grazing", Ways::NearGrazing, kContactInMotion, 6);
  triangles("first contact, 2^-50 from grazing", Ways::NearGrazing, kFirst, 6);
  const auto polygons = [&family](const char* name, std::size_t vertices, auto question,
                                  std::optional<timing::Goal> goal) {
    family.benchmarks.emplace_back(
        [=](const Settings& settings) { return about_polygons(name, vertices, settings, question, goal); });
  };
  polygons("contact", 8, kContactInMotion, std::nullopt);
  polygons("first contact", 8, kFirst, std::nullopt);
  polygons("contact", 1024, kContactInMotion, timing::Goal{0.1});
  polygons("first contact", 1024, kFirst, timing::Goal{0.1});
  return family;
}

}  // namespace touchstone::bench
