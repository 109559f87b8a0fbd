// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/run/timing.h"
#include "experiments/studies/bench/families.h"
#include "geometry/contact/fast.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

// Benchmarks of questions about prepared polygons. A query has two members: a ball or a motion, and the number of its
// polygon.
namespace touchstone::bench {

template <class Prepared>
using Polygons = std::shared_ptr<const std::vector<Prepared>>;
template <class Query>
using Queries = std::shared_ptr<const std::vector<Query>>;

template <class Prepared>
Polygons<Prepared> prepare(const std::vector<Polygon>& polygons) {
  std::vector<Prepared> list;
  for (const Polygon& polygon : polygons) list.emplace_back(polygon);
  return std::make_shared<const std::vector<Prepared>>(std::move(list));
}

/// Returns the number of queries for which exact takes about a second.
inline std::size_t checked(const Settings& settings, std::size_t vertices) {
  if (!settings.checks) return 0;
  return std::min<std::size_t>(settings.samples, std::clamp<std::size_t>(200'000 / vertices, 8, 5000));
}

/// Asks question(ball or motion, prepared polygon).
template <class Question, class Query, class Prepared>
auto answer_to(const Question& question, const Query& query, const std::vector<Prepared>& polygons) {
  const auto& [asked, polygon] = query;
  return question(asked, polygons[polygon]);
}

/// Returns the answers of `exact` to the first `count` queries.
template <class Question, class Query>
auto truths(const Question& question, const std::vector<Polygon>& polygons, const Queries<Query>& queries,
            std::size_t count) {
  using Truth = decltype(answer_to(question, queries->front(), std::vector<exact::PreparedPolygon>()));
  std::vector<Truth> list;
  if (count > 0) {
    const auto prepared = prepare<exact::PreparedPolygon>(polygons);
    for (std::size_t i = 0; i < count; ++i) list.push_back(answer_to(question, (*queries)[i], *prepared));
  }
  return std::make_shared<const std::vector<Truth>>(std::move(list));
}

template <class Prepared, class Query, class Question, class Truths>
timing::Candidate asks(std::string name, const Polygons<Prepared>& polygons, const Queries<Query>& queries,
                       const Truths& truths, const Question& question,
                       std::optional<timing::Comparison> comparison = std::nullopt) {
  return candidate(
      std::move(name), queries, truths,
      [polygons, question](const Query& query) { return answer_to(question, query, *polygons); },
      std::move(comparison));
}

/// One question about the same polygons, to fast and to filtered; with `least` also to exact, whose goal is that many
/// times the cost of filtered.
template <class Query, class Question>
timing::Benchmark compare(std::string name, const std::vector<Polygon>& polygons, std::size_t vertices,
                          const Queries<Query>& queries, const Settings& settings, const Question& question,
                          std::optional<timing::Goal> goal, std::optional<timing::Goal> least = std::nullopt) {
  timing::Benchmark benchmark;
  benchmark.name = std::move(name);
  benchmark.checked = checked(settings, vertices);
  const auto truth = truths(question, polygons, queries, benchmark.checked);
  benchmark.candidates = {asks("fast", prepare<fast::PreparedPolygon<>>(polygons), queries, truth, question),
                          asks("filtered", prepare<filtered::PreparedPolygon>(polygons), queries, truth, question,
                               timing::Comparison{"fast", goal})};
  if (least)
    benchmark.candidates.push_back(asks("exact", prepare<exact::PreparedPolygon>(polygons), queries, truth, question,
                                        timing::Comparison{"filtered", least}));
  return benchmark;
}

}  // namespace touchstone::bench
