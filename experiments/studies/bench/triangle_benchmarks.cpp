// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/methods/engines/cgal_triangles.h"
#include "experiments/methods/ericson.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/studies/bench/families.h"
#include "geometry/contact/fast_triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using TriangleQueries = std::vector<workloads::TriangleQuery>;

/// The goals for the cost of filtered relative to fast.
std::optional<timing::Goal> goal_of(workloads::TriangleFamily family) {
  switch (family) {
    case workloads::TriangleFamily::Random: return timing::Goal{1};
    case workloads::TriangleFamily::HalfNear: return timing::Goal{2.5};
    case workloads::TriangleFamily::Near: return timing::Goal{4};
    case workloads::TriangleFamily::Extreme:
    case workloads::TriangleFamily::LatticeTangent: return timing::Goal{10};
    default: return std::nullopt;
  }
}

/// The least cost of EPECK relative to filtered; checked if it takes part.
std::optional<timing::Goal> goal_of_epeck(workloads::TriangleFamily family) {
  if (family == workloads::TriangleFamily::Random) return timing::Goal{100, false};
  if (family == workloads::TriangleFamily::HalfNear) return timing::Goal{50, false};
  return std::nullopt;
}

std::vector<bool> truths(const TriangleQueries& queries, std::size_t count) {
  std::vector<bool> touches;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [ball, t] = queries[i];
    touches.push_back(exact::contact(ball, Polygon({t.a, t.b, t.c})));
  }
  return touches;
}

/// EPECK's objects are made before each repetition, so that none knows its exact value yet.
timing::Candidate prepared_epeck(const std::shared_ptr<const TriangleQueries>& queries,
                                 const std::shared_ptr<const std::vector<bool>>& truth) {
  const auto objects = std::make_shared<methods::cgal::EpeckQueries>();
  const auto make = [queries, objects](std::size_t count) {
    objects->clear();
    for (std::size_t i = 0; i < count; ++i) objects->add((*queries)[i].ball, (*queries)[i].triangle);
  };
  const auto ask = [objects](std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += objects->contact(i);
    return sum;
  };
  const auto count_wrong = [make, objects, truth](std::size_t count) {
    make(count);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (objects->contact(i) != (*truth)[i]) ++wrong;
    return wrong;
  };
  return {"EPECK, objects made", queries->size(), ask, count_wrong, make, timing::Comparison{"filtered", {}}};
}

timing::Benchmark draw(workloads::TriangleFamily family, const Settings& settings) {
  constexpr std::size_t kMostChecked = 20'000;  // a second
  TriangleQueries drawn;
  drawn.reserve(settings.samples);
  for (std::uint64_t i = 0; i < settings.samples; ++i)
    drawn.push_back(workloads::draw_triangle_query(family, settings.seed, i));
  const auto queries = std::make_shared<const TriangleQueries>(std::move(drawn));

  timing::Benchmark benchmark;
  benchmark.checked = settings.checks ? std::min<std::size_t>(settings.samples, kMostChecked) : 0;
  const auto truth = std::make_shared<const std::vector<bool>>(truths(*queries, benchmark.checked));
  if (benchmark.checked > 0)
    benchmark.note =
        statistics::percent_to_places(
            statistics::share_of(static_cast<std::uint64_t>(std::ranges::count(*truth, true)), benchmark.checked), 1) +
        " % touch";

  const auto add = [&](std::string name, auto ask, std::optional<timing::Comparison> comparison) {
    benchmark.candidates.push_back(candidate(
        std::move(name), queries, truth, [ask](const workloads::TriangleQuery& q) { return ask(q.ball, q.triangle); },
        comparison));
  };
  const auto fast = [](const Ball& b, const Triangle& t) { return fast::contact(b, t); };
  const auto filtered = [](const Ball& b, const Triangle& t) { return filtered::contact(b, t); };
  const auto ericson = [](const Ball& b, const Triangle& t) { return methods::ericson_contact(b, t); };
  add("fast", fast, std::nullopt);
  add("filtered", filtered, timing::Comparison{"fast", goal_of(family)});
  add("Ericson", ericson,
      timing::Comparison{
          "fast", family == workloads::TriangleFamily::Random ? std::optional(timing::Goal{1, false}) : std::nullopt});
  if (const auto goal = goal_of_epeck(family)) {
    const auto cartesian = [](const Ball& b, const Triangle& t) { return methods::cgal::cartesian_contact(b, t); };
    const auto epick = [](const Ball& b, const Triangle& t) { return methods::cgal::epick_contact(b, t); };
    const auto epeck = [](const Ball& b, const Triangle& t) { return methods::cgal::epeck_contact(b, t); };
    const auto epick_compare = [](const Ball& b, const Triangle& t) { return methods::cgal::epick_comparison(b, t); };
    const auto epeck_compare = [](const Ball& b, const Triangle& t) { return methods::cgal::epeck_comparison(b, t); };
    add("CGAL, doubles", cartesian, timing::Comparison{"filtered", {}});
    add("EPICK", epick, timing::Comparison{"filtered", {}});
    add("EPICK, compare", epick_compare, timing::Comparison{"filtered", {}});
    add("EPECK", epeck, timing::Comparison{"filtered", goal});
    add("EPECK, compare", epeck_compare, timing::Comparison{"filtered", {}});
    benchmark.candidates.push_back(prepared_epeck(queries, truth));
  }
  return benchmark;
}

}  // namespace

std::vector<Family> triangle_families() {
  std::vector<Family> families;
  for (const workloads::TriangleFamily family : workloads::all_triangle_families())
    families.push_back({std::string(to_string(family)),
                        std::string(summary(family)),
                        {[family](const Settings& settings) { return draw(family, settings); }}});
  return families;
}

}  // namespace touchstone::bench
