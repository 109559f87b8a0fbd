// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/variants.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using TriangleQueries = std::vector<workloads::TriangleQuery>;

using Draw = std::function<workloads::TriangleQuery(std::uint64_t seed, std::uint64_t index)>;

/// The radius at (1 +- 2^-44) x the exact distance: where doubles for one sign decide.
workloads::TriangleQuery draw_close(std::uint64_t seed, std::uint64_t index) {
  workloads::TriangleQuery query = workloads::draw_query_at_contact(seed, index);
  query.ball.radius *= index % 2 == 0 ? 1 + 0x1p-44 : 1 - 0x1p-44;
  return query;
}

timing::Benchmark draw(const std::string& name, const Draw& draw_query, const Settings& settings) {
  constexpr std::uint64_t kMostQueries = 20'000, kMostChecked = 2'000;
  TriangleQueries drawn;
  for (std::uint64_t i = 0; i < std::min(settings.samples, kMostQueries); ++i)
    drawn.push_back(draw_query(settings.seed, i));
  const auto queries = std::make_shared<const TriangleQueries>(std::move(drawn));

  timing::Benchmark benchmark;
  benchmark.name = name;
  benchmark.checked = settings.checks ? std::min<std::size_t>(queries->size(), kMostChecked) : 0;
  std::vector<bool> touches;
  for (std::size_t i = 0; i < benchmark.checked; ++i) {
    const auto& [ball, t] = (*queries)[i];
    touches.push_back(exact::contact(ball, Polygon({t.a, t.b, t.c})));
  }
  const auto truth = std::make_shared<const std::vector<bool>>(std::move(touches));
  const auto add = [&](std::string of, auto ask, std::optional<timing::Comparison> comparison) {
    benchmark.candidates.push_back(candidate(
        std::move(of), queries, truth, [ask](const workloads::TriangleQuery& q) { return ask(q.ball, q.triangle); },
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
  const auto add = [&family](const std::string& name, const Draw& draw_query) {
    family.benchmarks.emplace_back(
        [name, draw_query](const Settings& settings) { return draw(name, draw_query, settings); });
  };
  const auto of = [](TriangleFamily each) {
    return
        [each](std::uint64_t seed, std::uint64_t index) { return workloads::draw_triangle_query(each, seed, index); };
  };
  add("random-triangles", of(TriangleFamily::Random));
  add("2^-44", draw_close);
  add("near", of(TriangleFamily::Near));
  add("lattice-tangent", of(TriangleFamily::LatticeTangent));
  return family;
}

}  // namespace touchstone::bench
