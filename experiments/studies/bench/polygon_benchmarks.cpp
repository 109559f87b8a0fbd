// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "experiments/studies/bench/yardsticks.h"
#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

using Outline = workloads::Family;

Queries<PolygonQuery> ball_queries(const std::vector<Polygon>& polygons, const Settings& settings) {
  return std::make_shared<const std::vector<PolygonQuery>>(draw_balls(polygons, settings.seed, settings.samples));
}

struct Size {
  std::size_t vertices;
  std::optional<timing::Goal> goal;  ///< of filtered in times of fast
};

const std::vector<Size>& sizes() {
  static const std::vector<Size> list{{8, {}},
                                      {32, {}},
                                      {128, timing::Goal{0.25}},
                                      {1024, timing::Goal{0.08}},
                                      {10'000, {}},
                                      {100'000, timing::Goal{0.001}}};
  return list;
}

std::vector<Polygon> move_off_plane(const std::vector<Polygon>& planar, const OffPlane& off_plane, std::uint64_t seed) {
  std::vector<Polygon> moved;
  for (const Polygon& polygon : planar) moved.push_back(move_off_plane(polygon, off_plane, seed, moved.size()));
  return moved;
}

constexpr auto kContact = [](const Ball& ball, const auto& polygon) { return contact(ball, polygon); };

timing::Benchmark contacts(Outline outline, const Size& size, const Settings& settings) {
  const auto polygons = draw_polygons(outline, size.vertices, settings.seed);
  const auto queries = ball_queries(polygons, settings);
  timing::Benchmark benchmark =
      compare(std::string(to_string(outline)), polygons, size.vertices, queries, settings, kContact, size.goal);
  // The least share of the time of filtered that the same walk takes without bounds.
  benchmark.candidates.push_back(asks("fast, same tree", prepare<FastTree>(polygons), queries,
                                      truths(kContact, polygons, queries, benchmark.checked), kContact,
                                      timing::Comparison{"filtered", timing::Goal{1 / 1.3, false}}));
  benchmark.note = fmt::format("{} of {} vertices",
                               polygons.size() == 1 ? "one polygon" : fmt::format("{} polygons", polygons.size()),
                               polygons.front().vertex_count());
  benchmark.pool = "all outlines";
  return benchmark;
}

template <class Prepared>
timing::Candidate prepares(std::string name, const std::shared_ptr<const std::vector<Polygon>>& polygons,
                           std::size_t most, std::optional<timing::Comparison> comparison = std::nullopt) {
  const auto ask = [polygons](std::size_t count) {
    std::uint64_t made = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Prepared prepared((*polygons)[i % polygons->size()]);
      ++made;
    }
    return made;
  };
  return {std::move(name), most, ask, {}, {}, std::move(comparison)};
}

timing::Benchmark preparations(std::size_t vertices, const Settings& settings) {
  const auto polygons =
      std::make_shared<const std::vector<Polygon>>(draw_polygons_of_all_outlines(vertices, settings.seed));
  const std::size_t most = std::min<std::size_t>(settings.samples, 1000);
  timing::Benchmark benchmark;
  benchmark.name = "preparation";
  benchmark.note = "all outlines";
  benchmark.unit = "polygon";
  benchmark.candidates = {
      prepares<fast::PreparedPolygon<>>("fast", polygons, most),
      prepares<filtered::PreparedPolygon>("filtered", polygons, most, timing::Comparison{"fast", timing::Goal{10}})};
  return benchmark;
}

/// A polygon that is queried once, preparation included.
timing::Benchmark asked_once(std::size_t vertices, const Settings& settings) {
  const auto polygons =
      std::make_shared<const std::vector<Polygon>>(draw_polygons_of_all_outlines(vertices, settings.seed));
  const auto queries = ball_queries(*polygons, settings);
  timing::Benchmark benchmark;
  benchmark.name = "asked once";
  benchmark.note = "all outlines, preparation included";
  benchmark.checked = checked(settings, vertices);
  const auto truth = truths(kContact, *polygons, queries, benchmark.checked);
  const auto once = [&](const char* name, auto question, std::optional<timing::Comparison> comparison) {
    return candidate(
        name, queries, truth,
        [polygons, question](const PolygonQuery& query) { return question(query.ball, (*polygons)[query.polygon]); },
        std::move(comparison));
  };
  benchmark.candidates = {
      once("fast", [](const Ball& ball, const Polygon& p) { return contact(ball, fast::PreparedPolygon<>(p)); }, {}),
      once(
          "filtered", [](const Ball& ball, const Polygon& p) { return filtered::contact(ball, p); },
          timing::Comparison{"fast", timing::Goal{5}})};
  return benchmark;
}

/// Polygons that are each queried `questions` times, preparation included.
timing::Benchmark asked_often(std::size_t vertices, std::size_t questions, const Settings& settings) {
  const auto polygons =
      std::make_shared<const std::vector<Polygon>>(draw_polygons_of_all_outlines(vertices, settings.seed));
  std::vector<PolygonQuery> in_turn = draw_balls(*polygons, settings.seed, settings.samples), drawn;
  // All queries about the first polygon, then all about the next.
  for (std::size_t first = 0; first < polygons->size(); ++first)
    for (std::size_t i = first; i < in_turn.size(); i += polygons->size()) drawn.push_back(in_turn[i]);
  const auto queries = std::make_shared<const std::vector<PolygonQuery>>(std::move(drawn));
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("asked {} times", questions);
  benchmark.note = "all outlines, preparation included; a ratio of 1 breaks even";
  benchmark.checked = checked(settings, vertices);
  const auto truth = truths(kContact, *polygons, queries, benchmark.checked);
  const auto asks_prepared = [&]<class Prepared>(const char* name, std::optional<timing::Comparison> comparison) {
    const auto each_answer = [polygons, queries, questions](std::size_t count, const auto& visit) {
      std::optional<Prepared> prepared;
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [ball, polygon] = (*queries)[i];
        if (i % questions == 0 || polygon != (*queries)[i - 1].polygon) prepared.emplace((*polygons)[polygon]);
        visit(i, contact(ball, *prepared));
      }
    };
    const auto ask = [each_answer](std::size_t count) {
      std::uint64_t touching = 0;
      each_answer(count, [&](std::size_t, bool touches) { touching += touches ? 1 : 0; });
      return touching;
    };
    const auto count_wrong = [each_answer, truth](std::size_t count) {
      std::size_t wrong = 0;
      each_answer(count, [&](std::size_t i, bool touches) { wrong += touches != (*truth)[i] ? 1 : 0; });
      return wrong;
    };
    return timing::Candidate{name, queries->size(), ask, count_wrong, {}, std::move(comparison)};
  };
  benchmark.candidates = {
      asks_prepared.operator()<fast::PreparedPolygon<>>("fast", std::nullopt),
      asks_prepared.operator()<filtered::PreparedPolygon>("filtered", timing::Comparison{"fast", {}})};
  return benchmark;
}

/// Beyond this, a turn of distinct polygons that are each prepared takes minutes.
constexpr std::size_t kMostAskedOnce = 128;

Family contact_family(const Size& size) {
  Family family{
      fmt::format("polygons-{}", size.vertices), "contact of small balls near the plane with prepared polygons", {}};
  for (const Outline outline : outlines_of(size.vertices))
    family.benchmarks.emplace_back([=](const Settings& settings) { return contacts(outline, size, settings); });
  family.benchmarks.emplace_back([=](const Settings& settings) { return preparations(size.vertices, settings); });
  if (size.vertices <= kMostAskedOnce)
    family.benchmarks.emplace_back([=](const Settings& settings) { return asked_once(size.vertices, settings); });
  if (size.vertices == 8 || size.vertices == 32 || size.vertices == 1024)
    for (const std::size_t questions : {2U, 8U, 32U, 128U})
      family.benchmarks.emplace_back(
          [=](const Settings& settings) { return asked_often(size.vertices, questions, settings); });
  return family;
}

timing::Benchmark off_plane(std::size_t vertices, const Settings& settings) {
  constexpr timing::Goal kGoal{1.5};
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("{} vertices", vertices);
  benchmark.note = "filtered, all outlines";
  benchmark.checked = checked(settings, vertices);
  const auto planar = draw_polygons_of_all_outlines(vertices, settings.seed);
  for (const OffPlane& moved : all_off_plane()) {
    const auto polygons = move_off_plane(planar, moved, settings.seed);
    const auto queries = ball_queries(polygons, settings);
    const auto truth = truths(kContact, polygons, queries, benchmark.checked);
    const bool base = moved.share == 0;
    benchmark.candidates.push_back(asks(moved.name, prepare<filtered::PreparedPolygon>(polygons), queries, truth,
                                        kContact,
                                        base ? std::nullopt : std::optional(timing::Comparison{"planar", kGoal})));
  }
  return benchmark;
}

/// The part of an answer on which fast and exact agree up to rounding, in a form that can be compared and summed.
struct Decisions {
  Answer answer;

  explicit operator std::uint64_t() const { return static_cast<std::uint64_t>(answer.relation); }
  friend bool operator==(const Decisions& x, const Decisions& y) {
    const Answer &a = x.answer, &b = y.answer;
    return a.plane == b.plane && a.plane_tangent == b.plane_tangent && a.foot == b.foot && a.edges_hit == b.edges_hit &&
           a.relation == b.relation && a.nearest == b.nearest;
  }
};

struct Edges {
  std::vector<std::size_t> hit;

  explicit operator std::uint64_t() const { return hit.size(); }
  friend bool operator==(const Edges&, const Edges&) = default;
};

Family question_family() {
  Family family{"questions", "the other questions about prepared polygons, all outlines", {}};
  struct Goals {
    std::size_t vertices;
    double answer;
  };
  for (const Goals goals : {Goals{8, 1.5}, Goals{128, 0.3}}) {
    const auto add = [&family, vertices = goals.vertices](const char* name, auto question,
                                                          std::optional<timing::Goal> goal = std::nullopt) {
      family.benchmarks.emplace_back([=](const Settings& settings) {
        const auto polygons = draw_polygons_of_all_outlines(vertices, settings.seed);
        return compare(fmt::format("{}, {} vertices", name, vertices), polygons, vertices,
                       ball_queries(polygons, settings), settings, question, goal);
      });
    };
    add("relation", [](const Ball& ball, const auto& polygon) { return relation(ball, polygon); });
    add(
        "plane_side", [](const Ball& ball, const auto& polygon) { return plane_side(ball, polygon); },
        timing::Goal{1.5});
    add("foot", [](const Ball& ball, const auto& polygon) { return foot(ball, polygon); });
    add("edges_hit", [](const Ball& ball, const auto& polygon) { return Edges{edges_hit(ball, polygon)}; });
    add(
        "answer", [](const Ball& ball, const auto& polygon) { return Decisions{answer(ball, polygon)}; },
        timing::Goal{goals.answer});
  }
  return family;
}

}  // namespace

std::vector<Family> polygon_families() {
  std::vector<Family> families;
  for (const Size& size : sizes()) families.push_back(contact_family(size));
  Family moved{"off-plane", "filtered's contact with polygons whose vertices are off the plane", {}};
  for (const std::size_t vertices : {8U, 128U, 1024U})
    moved.benchmarks.emplace_back([=](const Settings& settings) { return off_plane(vertices, settings); });
  families.push_back(std::move(moved));
  families.push_back(question_family());
  return families;
}

}  // namespace touchstone::bench
