// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tunnelling/cost.h"

#include <memory>
#include <utility>
#include <vector>

#include "robust/filtered/motion.h"

namespace touchstone::tunnelling {
namespace {

struct Query {
  Motion motion;
  std::size_t polygon;
};

/// The passes and their prepared polygons.
struct Queries {
  std::vector<Query> list;
  std::vector<filtered::PreparedPolygon> polygons;
};

std::shared_ptr<const Queries> draw_queries(const CostSettings& settings) {
  Queries queries;
  for (std::uint64_t n = 0; queries.list.size() < settings.passes; ++n) {
    const auto pass = draw_pass(settings.vertices, settings.seed, n);
    if (!pass) continue;
    queries.list.push_back({pass->of(kRadii[queries.list.size() % kRadii.size()]), queries.polygons.size()});
    queries.polygons.emplace_back(pass->polygon);
  }
  return std::make_shared<const Queries>(std::move(queries));
}

/// `ask(motion, polygon)` returns whether the ball touches.
template <class Ask>
timing::Candidate candidate(std::string name, const std::shared_ptr<const Queries>& queries, Ask ask,
                            std::optional<timing::Comparison> comparison) {
  const auto count_contacts = [queries, ask](std::size_t count) {
    std::uint64_t contacts = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [motion, polygon] = queries->list[i];
      contacts += ask(motion, queries->polygons[polygon]) ? 1 : 0;
    }
    return contacts;
  };
  return {std::move(name), queries->list.size(), count_contacts, {}, {}, std::move(comparison)};
}

}  // namespace

std::string steps_name(std::size_t level) {
  return std::to_string(std::size_t{1} << level) + (level == 0 ? " step" : " steps");
}

timing::Result measure_cost(const CostSettings& settings, const std::atomic<bool>& stop,
                            const run::Progress& progress) {
  const auto queries = draw_queries(settings);
  const timing::Comparison to_contact{kContact, {}};
  timing::Benchmark benchmark;
  benchmark.unit = "motion";
  benchmark.candidates = {
      candidate(
          kContact, queries,
          [](const Motion& motion, const filtered::PreparedPolygon& p) { return filtered::contact(motion, p); },
          std::nullopt),
      candidate(
          kFirstContact, queries,
          [](const Motion& motion, const filtered::PreparedPolygon& p) {
            return filtered::first_contact(motion, p).contact();
          },
          to_contact)};
  for (std::size_t level = 0; level <= kMostLevel; ++level)
    benchmark.candidates.push_back(candidate(
        steps_name(level), queries,
        [level](const Motion& motion, const filtered::PreparedPolygon& p) {
          return touches_at_steps(motion, level, p);
        },
        to_contact));
  return timing::measure("tunnelling", benchmark, settings.repetitions, stop, progress);
}

}  // namespace touchstone::tunnelling
