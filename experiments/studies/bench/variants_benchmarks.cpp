// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <string>

#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/variants.h"
#include "experiments/workloads/lattice/triangle_queries.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using TriangleQueries = std::vector<workloads::TriangleQuery>;

timing::Benchmark draw(workloads::TriangleFamily family, const Settings& settings) {
  constexpr std::uint64_t kMostQueries = 20'000, kMostChecked = 2'000;
  TriangleQueries drawn;
  for (std::uint64_t i = 0; i < std::min(settings.samples, kMostQueries); ++i)
    drawn.push_back(workloads::draw_triangle_query(family, settings.seed, i));
  const auto queries = std::make_shared<const TriangleQueries>(std::move(drawn));

  timing::Benchmark benchmark;
  benchmark.name = to_string(family);
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
      "filtered", [](const Ball& b, const Triangle& t) { return filtered::contact(b, t); }, std::nullopt);
  for (const Variant& variant : variants())
    add(std::string(variant.name), variant.contact, timing::Comparison{"filtered", {}});
  return benchmark;
}

}  // namespace

Family variants_family() {
  Family family{"variants", "filtered without one of its stages, or with other exact arithmetic behind the first", {}};
  using workloads::TriangleFamily;
  for (const auto of : {TriangleFamily::Random, TriangleFamily::Near, TriangleFamily::LatticeTangent})
    family.benchmarks.emplace_back([of](const Settings& settings) { return draw(of, settings); });
  return family;
}

}  // namespace touchstone::bench
