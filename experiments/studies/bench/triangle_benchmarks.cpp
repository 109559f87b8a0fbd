// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/methods/triangle_contacts.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/bench/families.h"
#include "geometry/contact/fast_triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using TriangleQueries = std::vector<workloads::TriangleQuery>;
using DrawQuery = std::function<workloads::TriangleQuery(std::uint64_t seed, std::uint64_t index)>;

constexpr auto kFast = [](const Ball& ball, const Triangle& t) { return fast::contact(ball, t); };
constexpr auto kEricson = [](const Ball& ball, const Triangle& t) { return methods::ericson_contact(ball, t); };
constexpr auto kFiltered = [](const Ball& ball, const Triangle& t) { return filtered::contact(ball, t); };

// Where each draw takes 30 us.
constexpr std::uint64_t kMostCostly = 20'000, kMostCostlyChecked = 2'000;

/// A benchmark of the contact of balls and triangles, with the answers of `exact` to the first queries.
class TriangleBenchmark {
 public:
  TriangleBenchmark(std::string name, const DrawQuery& draw, const Settings& settings, std::uint64_t most_queries,
                    std::size_t most_checked) {
    TriangleQueries drawn;
    drawn.reserve(std::min(settings.samples, most_queries));
    for (std::uint64_t i = 0; i < std::min(settings.samples, most_queries); ++i)
      drawn.push_back(draw(settings.seed, i));
    benchmark.name = std::move(name);
    benchmark.checked = settings.checks ? std::min(drawn.size(), most_checked) : 0;
    std::vector<bool> touches;
    for (std::size_t i = 0; i < benchmark.checked; ++i) {
      const auto& [ball, t] = drawn[i];
      touches.push_back(exact::contact(ball, Polygon({t.a, t.b, t.c})));
    }
    queries = std::make_shared<const TriangleQueries>(std::move(drawn));
    truth_ = std::make_shared<const std::vector<bool>>(std::move(touches));
  }

  template <class Ask>
  void add(std::string name, const Ask& ask, std::optional<timing::Comparison> comparison = std::nullopt) {
    benchmark.candidates.push_back(candidate(
        std::move(name), queries, truth_, [ask](const workloads::TriangleQuery& q) { return ask(q.ball, q.triangle); },
        std::move(comparison)));
  }

  /// Returns which share of the checked queries touches, as a note.
  [[nodiscard]] std::string touching() const {
    if (truth_->empty()) return "";
    const auto count = static_cast<std::uint64_t>(std::ranges::count(*truth_, true));
    return statistics::percent_to_places(statistics::share_of(count, truth_->size()), 1) + " % touch";
  }

  timing::Benchmark benchmark;
  std::shared_ptr<const TriangleQueries> queries;

 private:
  std::shared_ptr<const std::vector<bool>> truth_;
};

DrawQuery of_family(workloads::TriangleFamily family) {
  return
      [family](std::uint64_t seed, std::uint64_t index) { return workloads::draw_triangle_query(family, seed, index); };
}

/// The radius at (1 +- 2^-k) x the rounded exact distance.
DrawQuery at_distance(int k) {
  return [k](std::uint64_t seed, std::uint64_t index) {
    workloads::TriangleQuery query = workloads::draw_query_at_contact(seed, index);
    query.ball.radius *= 1 + std::ldexp(index % 2 == 0 ? 1.0 : -1.0, -k);
    return query;
  };
}

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

timing::Benchmark triangles(workloads::TriangleFamily family, const Settings& settings) {
  constexpr std::size_t kMostChecked = 20'000;  // a second
  TriangleBenchmark asked("", of_family(family), settings, settings.samples, kMostChecked);
  asked.benchmark.note = asked.touching();
  asked.add("fast", kFast);
  asked.add("filtered", kFiltered, timing::Comparison{"fast", goal_of(family)});
  const bool is_random = family == workloads::TriangleFamily::Random;
  asked.add("Ericson", kEricson,
            timing::Comparison{"fast", is_random ? std::optional(timing::Goal{1, false}) : std::nullopt});
  if (const auto goal = goal_of_epeck(family)) {
    asked.add("EPICK", methods::cgal::epick_contact, timing::Comparison{"filtered", {}});
    asked.add("EPICK, compare", methods::cgal::epick_comparison, timing::Comparison{"filtered", {}});
    asked.add("EPECK", methods::cgal::epeck_contact, timing::Comparison{"filtered", goal});
    asked.add("EPECK, compare", methods::cgal::epeck_comparison, timing::Comparison{"filtered", {}});
  }
  return asked.benchmark;
}

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

timing::Benchmark nearness(int exponent, const Settings& settings) {
  TriangleBenchmark asked(fmt::format("2^-{}", exponent), at_distance(exponent), settings, kMostCostly,
                          kMostCostlyChecked);
  asked.benchmark.shares = shares_by_stage(*asked.queries);
  asked.add("fast", kFast);
  asked.add("filtered", kFiltered, timing::Comparison{"fast", {}});
  asked.add("EPICK", methods::cgal::epick_contact, timing::Comparison{"filtered", {}});
  asked.add("EPECK", methods::cgal::epeck_contact, timing::Comparison{"filtered", {}});
  return asked.benchmark;
}

}  // namespace

std::vector<Family> triangle_families() {
  std::vector<Family> families;
  for (const workloads::TriangleFamily family : workloads::all_triangle_families())
    families.push_back({std::string(to_string(family)),
                        std::string(summary(family)),
                        {[family](const Settings& settings) { return triangles(family, settings); }}});
  return families;
}

Family nearness_family() {
  Family family{"nearness", "the radius at (1 +- 2^-k) x the exact distance, for k from 52 to 1", {}};
  for (const int exponent : {52, 50, 48, 46, 44, 40, 36, 30, 24, 16, 8, 1})
    family.benchmarks.emplace_back([exponent](const Settings& settings) { return nearness(exponent, settings); });
  return family;
}

}  // namespace touchstone::bench
