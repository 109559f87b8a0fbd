// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/methods/engines/cgal_triangles.h"
#include "experiments/studies/bench/families.h"
#include "geometry/contact/fast_triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using TriangleQueries = std::vector<workloads::TriangleQuery>;

// k: the radius is (1 +- 2^-k) x the rounded exact distance.
constexpr int kExponents[] = {52, 50, 48, 46, 44, 40, 36, 30, 24, 16, 8, 1};

/// The shares of queries by the slowest stage that filtered needed.
std::vector<timing::Share> shares_by_stage(const TriangleQueries& queries) {
  std::vector<timing::Share> shares;
  for (std::size_t s = 0; s < filtered::kStages; ++s)
    shares.push_back({std::string(to_string(static_cast<filtered::Stage>(s))), 0});
  for (const auto& [ball, triangle] : queries) {
    filtered::StageCounts counts;
    (void)filtered::contact(ball, triangle, counts);
    shares[static_cast<std::size_t>(counts.last())].share += 1 / static_cast<double>(queries.size());
  }
  return shares;
}

timing::Benchmark draw(int exponent, const Settings& settings) {
  constexpr std::uint64_t kMostQueries = 20'000, kMostChecked = 2'000;  // each draw takes 30 us
  TriangleQueries drawn;
  for (std::uint64_t i = 0; i < std::min(settings.samples, kMostQueries); ++i) {
    drawn.push_back(workloads::draw_query_at_contact(settings.seed, i));
    drawn.back().ball.radius *= 1 + std::ldexp(i % 2 == 0 ? 1.0 : -1.0, -exponent);
  }
  const auto queries = std::make_shared<const TriangleQueries>(std::move(drawn));

  timing::Benchmark benchmark;
  benchmark.name = fmt::format("2^-{}", exponent);
  benchmark.shares = shares_by_stage(*queries);
  benchmark.checked = settings.checks ? std::min<std::size_t>(queries->size(), kMostChecked) : 0;
  std::vector<bool> touches;
  for (std::size_t i = 0; i < benchmark.checked; ++i) {
    const auto& [ball, t] = (*queries)[i];
    touches.push_back(exact::contact(ball, Polygon({t.a, t.b, t.c})));
  }
  const auto truth = std::make_shared<const std::vector<bool>>(std::move(touches));
  const auto add = [&](std::string name, auto ask, std::optional<timing::Comparison> comparison) {
    benchmark.candidates.push_back(candidate(
        std::move(name), queries, truth, [ask](const workloads::TriangleQuery& q) { return ask(q.ball, q.triangle); },
        comparison));
  };
  add(
      "fast", [](const Ball& b, const Triangle& t) { return fast::contact(b, t); }, std::nullopt);
  add(
      "filtered", [](const Ball& b, const Triangle& t) { return filtered::contact(b, t); },
      timing::Comparison{"fast", {}});
  add(
      "EPICK", [](const Ball& b, const Triangle& t) { return methods::cgal::epick_contact(b, t); },
      timing::Comparison{"filtered", {}});
  add(
      "EPECK", [](const Ball& b, const Triangle& t) { return methods::cgal::epeck_contact(b, t); },
      timing::Comparison{"filtered", {}});
  return benchmark;
}

}  // namespace

Family nearness_family() {
  Family family{"nearness", "the radius at (1 +- 2^-k) x the exact distance, for k from 52 to 1", {}};
  for (const int exponent : kExponents)
    family.benchmarks.emplace_back([exponent](const Settings& settings) { return draw(exponent, settings); });
  return family;
}

}  // namespace touchstone::bench
