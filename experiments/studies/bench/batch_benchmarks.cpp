// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "experiments/workloads/lattice/triangle_queries.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::bench {
namespace {

constexpr std::size_t kTriangles = 1024;  // that one ball is asked about

/// Fills the first so many answers.
using Fill = std::function<void(std::span<bool> touches)>;

timing::Candidate fills(std::string name, std::size_t queries, const std::shared_ptr<const std::vector<bool>>& truths,
                        const Fill& fill, std::optional<timing::Comparison> comparison = std::nullopt) {
  const std::shared_ptr<bool[]> touches(new bool[queries]());
  const auto ask = [touches, fill](std::size_t count) {
    const std::span<bool> first(touches.get(), count);
    fill(first);
    return static_cast<std::uint64_t>(std::ranges::count(first, true));
  };
  const auto count_wrong = [touches, truths, ask](std::size_t count) {
    ask(count);
    const std::span<const bool> first(touches.get(), count);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (first[i] != (*truths)[i]) ++wrong;
    return wrong;
  };
  return {std::move(name), queries, ask, count_wrong, {}, std::move(comparison)};
}

/// Returns the answers of `fill` to the first `count` queries.
std::shared_ptr<const std::vector<bool>> truths(std::size_t count, const Fill& fill) {
  const std::unique_ptr<bool[]> touches(new bool[count]());
  fill({touches.get(), count});
  return std::make_shared<const std::vector<bool>>(touches.get(), touches.get() + count);
}

std::vector<timing::Candidate> candidates(std::size_t queries, const std::shared_ptr<const std::vector<bool>>& truth,
                                          const Fill& fast, const Fill& single, const Fill& batch) {
  return {fills("fast", queries, truth, fast),
          fills("filtered", queries, truth, single, timing::Comparison{"fast", {}}),
          fills("filtered, batch", queries, truth, batch, timing::Comparison{"filtered", {}})};
}

timing::Benchmark balls_against_polygon(std::size_t vertices, const Settings& settings) {
  struct Data {
    std::vector<Ball> balls;
    fast::PreparedPolygon<> fast;
    filtered::PreparedPolygon filtered;
    exact::PreparedPolygon exact;
  };
  const Polygon polygon = draw_polygon(workloads::Family::Star, vertices, settings.seed, 0);
  std::vector<Ball> balls;
  for (const PolygonQuery& query : draw_balls({polygon}, settings.seed, settings.samples)) balls.push_back(query.ball);
  const auto data =
      std::make_shared<const Data>(Data{std::move(balls), fast::PreparedPolygon<>(polygon),
                                        filtered::PreparedPolygon(polygon), exact::PreparedPolygon(polygon)});
  const auto one_by_one = [data](const auto Data::*prepared) -> Fill {
    return [data, prepared](std::span<bool> touches) {
      for (std::size_t i = 0; i < touches.size(); ++i) touches[i] = contact(data->balls[i], (*data).*prepared);
    };
  };
  const Fill batch = [data](std::span<bool> touches) {
    filtered::contact(std::span(data->balls).first(touches.size()), data->filtered, touches);
  };
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("many balls, one star of {} vertices", vertices);
  benchmark.checked = settings.checks ? std::min<std::size_t>(settings.samples, 200'000 / vertices) : 0;
  benchmark.candidates = candidates(data->balls.size(), truths(benchmark.checked, one_by_one(&Data::exact)),
                                    one_by_one(&Data::fast), one_by_one(&Data::filtered), batch);
  return benchmark;
}

timing::Benchmark ball_against_triangles(const Settings& settings) {
  constexpr std::size_t kMostChecked = 20'000;
  struct Data {
    std::vector<Ball> balls;  ///< one for each kTriangles of the triangles
    std::vector<Triangle> triangles;
  };
  Data drawn;
  for (std::uint64_t i = 0; i < settings.samples; ++i) {
    const workloads::TriangleQuery query =
        workloads::draw_triangle_query(workloads::TriangleFamily::Random, settings.seed, i);
    if (i % kTriangles == 0) drawn.balls.push_back(query.ball);
    drawn.triangles.push_back(query.triangle);
  }
  const auto data = std::make_shared<const Data>(std::move(drawn));
  const auto one_by_one = [data](auto ask) -> Fill {
    return [data, ask](std::span<bool> touches) {
      for (std::size_t i = 0; i < touches.size(); ++i)
        touches[i] = ask(data->balls[i / kTriangles], data->triangles[i]);
    };
  };
  const Fill batch = [data](std::span<bool> touches) {
    for (std::size_t first = 0; first < touches.size(); first += kTriangles) {
      const std::size_t size = std::min(kTriangles, touches.size() - first);
      filtered::contact(data->balls[first / kTriangles], std::span(data->triangles).subspan(first, size),
                        touches.subspan(first, size));
    }
  };
  const auto fast = [](const Ball& ball, const Triangle& t) { return fast::contact(ball, t); };
  const auto filtered = [](const Ball& ball, const Triangle& t) { return filtered::contact(ball, t); };
  const auto exact = [](const Ball& ball, const Triangle& t) { return exact::contact(ball, Polygon({t.a, t.b, t.c})); };
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("one ball, {} triangles", kTriangles);
  benchmark.checked = settings.checks ? std::min<std::size_t>(settings.samples, kMostChecked) : 0;
  benchmark.candidates = candidates(data->triangles.size(), truths(benchmark.checked, one_by_one(exact)),
                                    one_by_one(fast), one_by_one(filtered), batch);
  return benchmark;
}

}  // namespace

Family batch_family() {
  Family family{"batches", "contact: filtered's functions of spans against single calls", {}};
  family.benchmarks.emplace_back(ball_against_triangles);
  for (const std::size_t vertices : {8U, 128U})
    family.benchmarks.emplace_back([=](const Settings& settings) { return balls_against_polygon(vertices, settings); });
  return family;
}

}  // namespace touchstone::bench
