// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <stdexcept>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/studies/tradeoff/front.h"

namespace touchstone::tradeoff {
namespace {

using cases::QueryKind;
using workloads::BallPlace;
using workloads::PlacedOutline;
using workloads::Random;

constexpr std::size_t kPolygons = 16;                      // of each group
constexpr std::uint64_t kStream = std::uint64_t{1} << 41;  // beyond those that the workloads draw from

BallPlace draw_near_place(Random& random) {
  constexpr std::array kPlaces{BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex};
  return kPlaces[static_cast<std::size_t>(random.integer(0, kPlaces.size() - 1))];
}

std::optional<Query> draw_query(const std::vector<PlacedOutline>& outlines, workloads::Workload workload, Balls balls,
                                std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, kStream + static_cast<std::uint64_t>(balls));
  const auto polygon = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(outlines.size()) - 1));
  workload.ball = balls == Balls::Near ? draw_near_place(random) : BallPlace::Anywhere;
  workload.doubles = static_cast<int>(random.integer(-kNearDoubles, kNearDoubles));
  try {
    return Query{polygon, workloads::draw_ball(outlines[polygon], workload, seed, index)};
  } catch (const std::invalid_argument&) {  // this polygon has no such ball
    return std::nullopt;
  }
}

using Prepared = std::vector<std::unique_ptr<cases::PreparedMethod>>;  // of one method, by polygon

timing::Candidate candidate(const cases::Method& method, const Prepared& prepared, const std::vector<Query>& queries,
                            QueryKind kind) {
  const auto ask = [&prepared, &queries, kind](std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto answer = prepared[queries[i].polygon]->ask(queries[i].ball, kind);
      sum += answer.contact.value_or(false) ? 1 : 0;
    }
    return sum;
  };
  return {std::string(method.name()), queries.size(), ask, {}, {}, {}};
}

}  // namespace

std::string_view to_string(Balls balls) { return balls == Balls::Near ? "near" : "anywhere"; }

std::string_view to_string(QueryKind kind) { return kind == QueryKind::Contact ? "contact" : "answer"; }

Queries draw_queries(const PolygonGroup& group, std::uint64_t seed, std::size_t count) {
  workloads::Workload workload;
  workload.family = group.family;
  workload.placement = group.placement;
  std::vector<PlacedOutline> outlines;
  Queries queries;
  for (std::uint64_t i = 0; i < kPolygons; ++i) {
    outlines.push_back(workloads::draw_placed_outline(workload, seed, i));
    queries.polygons.push_back(outlines.back().polygon);
  }
  for (const Balls balls : kBalls) {
    auto& list = balls == Balls::Near ? queries.near : queries.anywhere;
    for (std::uint64_t index = 0; list.size() < count && index < 2 * count; ++index)
      if (const auto query = draw_query(outlines, workload, balls, seed, index)) list.push_back(*query);
  }
  return queries;
}

std::uint64_t list_count(const TimingSettings& settings) {
  return settings.groups.size() * kBalls.size() * kTimedKinds.size();
}

std::vector<Timing> measure_timings(const TimingSettings& settings, const std::atomic<bool>& stop,
                                    const program::Progress& progress) {
  std::vector<Timing> timings;
  std::uint64_t done = 0;
  for (const PolygonGroup& group : settings.groups) {
    if (stop) break;
    const Queries queries = draw_queries(group, settings.seed, settings.queries);
    std::vector<Prepared> prepared(settings.methods.size());
    for (std::size_t m = 0; m < prepared.size(); ++m)
      for (const Polygon& polygon : queries.polygons) prepared[m].push_back(settings.methods[m]->prepare(polygon));
    for (const Balls balls : kBalls) {
      for (const QueryKind kind : kTimedKinds) {
        if (queries.of(balls).empty()) continue;
        timing::Benchmark benchmark;
        for (std::size_t m = 0; m < prepared.size(); ++m)
          benchmark.candidates.push_back(candidate(*settings.methods[m], prepared[m], queries.of(balls), kind));
        timing::Result result = timing::measure(
            std::string(to_string(group.family)), benchmark, settings.repetitions, stop, [](std::uint64_t) {},
            kSecondsOfList);
        if (stop) return timings;
        timings.push_back({group, balls, kind, std::move(result.candidates)});
        progress(++done);
      }
    }
  }
  return timings;
}

}  // namespace touchstone::tradeoff
