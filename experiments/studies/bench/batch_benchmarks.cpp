// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <vector>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "experiments/studies/bench/yardsticks.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_triangle.h"
#include "geometry/shapes/triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::bench {
namespace {

constexpr std::size_t kTriangles = 1024;  // that one ball is asked about

/// Fills all of `touches`.
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
    return timing::counting([&](std::size_t i) { return touches.get()[i] != (*truths)[i]; })(count);
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
                                          const Fill& fast, const Fill& single, const Fill& batch,
                                          std::optional<timing::Goal> goal = std::nullopt) {
  return {fills("fast", queries, truth, fast),
          fills("filtered", queries, truth, single, timing::Comparison{"fast", {}}),
          fills("filtered, batch", queries, truth, batch, timing::Comparison{"filtered", goal})};
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
  benchmark.candidates =
      candidates(data->balls.size(), truths(benchmark.checked, one_by_one(&Data::exact)), one_by_one(&Data::fast),
                 one_by_one(&Data::filtered), batch, timing::Goal{vertices == 8 ? 0.5 : 0.7});
  return benchmark;
}

/// Draws a triangle at a distance of the ball's surface of at most a tenth of the radius: the triangle of a query,
/// moved along the line from its closest point to the centre.
Triangle near_triangle(const Ball& ball, std::uint64_t seed, std::uint64_t index) {
  const workloads::TriangleQuery query = workloads::draw_triangle_query(workloads::TriangleFamily::Random, seed, index);
  Triangle triangle = query.triangle;
  const filtered::ClosestPoint closest = filtered::closest(ball.center, triangle);
  const double wanted = ball.radius * (0.9 + 0.4 * query.ball.radius);  // the query's radius is uniform in [0, 0.5)
  if (!(closest.distance > 0)) return triangle;
  const Eigen::Vector3d shift = (ball.center - closest.point) * (1 - wanted / closest.distance);
  for (Eigen::Vector3d* vertex : {&triangle.a, &triangle.b, &triangle.c}) *vertex += shift;
  return triangle;
}

timing::Benchmark ball_against_triangles(bool near, const Settings& settings) {
  constexpr std::size_t kMostChecked = 20'000;
  /// One ball, and the triangles that it is asked about.
  struct Group {
    Ball ball;
    filtered::TriangleSet set;
    FastBatch<double> doubles;
    FastBatch<float> floats;
  };
  struct Data {
    std::vector<Group> groups;  ///< one for each kTriangles of the triangles
    std::vector<Triangle> triangles;
  };
  Data drawn;
  std::vector<Ball> balls;
  for (std::uint64_t i = 0; i < settings.samples; ++i) {
    const workloads::TriangleQuery query =
        workloads::draw_triangle_query(workloads::TriangleFamily::Random, settings.seed, i);
    if (i % kTriangles == 0) balls.push_back(query.ball);
    drawn.triangles.push_back(near ? near_triangle(balls.back(), settings.seed, i) : query.triangle);
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::span<const Triangle> rest = std::span<const Triangle>(drawn.triangles).subspan(i * kTriangles);
    const auto group = rest.first(std::min(kTriangles, rest.size()));
    drawn.groups.push_back({balls[i], filtered::TriangleSet(group), FastBatch<double>(group), FastBatch<float>(group)});
  }
  const auto data = std::make_shared<const Data>(std::move(drawn));
  const auto one_by_one = [data](auto ask) -> Fill {
    return [data, ask](std::span<bool> touches) {
      for (std::size_t i = 0; i < touches.size(); ++i)
        touches[i] = ask(data->groups[i / kTriangles].ball, data->triangles[i]);
    };
  };
  // A prepared group answers for all its triangles; the last group asked about may be cut short.
  const auto by_group = [data](auto ask) -> Fill {
    return [data, ask](std::span<bool> touches) {
      bool all[kTriangles];
      for (std::size_t first = 0; first < touches.size(); first += kTriangles) {
        const Group& group = data->groups[first / kTriangles];
        const std::size_t size = std::min(kTriangles, touches.size() - first);
        if (size == group.set.size()) {
          ask(group, touches.subspan(first, size));
        } else {
          ask(group, std::span<bool>(all, group.set.size()));
          std::copy(all, all + size, touches.begin() + static_cast<std::ptrdiff_t>(first));
        }
      }
    };
  };
  const Fill batch = [data](std::span<bool> touches) {
    for (std::size_t first = 0; first < touches.size(); first += kTriangles) {
      const std::size_t size = std::min(kTriangles, touches.size() - first);
      filtered::contact(data->groups[first / kTriangles].ball, std::span(data->triangles).subspan(first, size),
                        touches.subspan(first, size));
    }
  };
  const auto fast = [](const Ball& ball, const Triangle& t) { return fast::contact(ball, t); };
  const auto filtered = [](const Ball& ball, const Triangle& t) { return filtered::contact(ball, t); };
  const auto exact = [](const Ball& ball, const Triangle& t) { return exact::contact(ball, Polygon({t.a, t.b, t.c})); };
  const auto set = [](const Group& group, std::span<bool> touches) { contact(group.ball, group.set, touches); };
  const auto without_floats = [](const Group& g, std::span<bool> touches) {
    set_contact_without_floats(g.ball, g.set, touches);
  };
  const auto doubles = [](const Group& g, std::span<bool> touches) { g.doubles.contact(g.ball, touches); };
  const auto floats = [](const Group& g, std::span<bool> touches) { g.floats.contact(g.ball, touches); };
  timing::Benchmark benchmark;
  benchmark.name = fmt::format("one ball, {} triangles{}", kTriangles, near ? ", all near its surface" : "");
  benchmark.checked = settings.checks ? std::min<std::size_t>(settings.samples, kMostChecked) : 0;
  const std::size_t queries = data->triangles.size();
  const auto truth = truths(benchmark.checked, one_by_one(exact));
  benchmark.candidates = candidates(queries, truth, one_by_one(fast), one_by_one(filtered), batch);
  const std::optional<timing::Goal> goal = timing::Goal{0.25};
  benchmark.candidates.push_back(
      fills("filtered, set", queries, truth, by_group(set), timing::Comparison{"fast", goal}));
  benchmark.candidates.push_back(
      fills("filtered, no floats", queries, truth, by_group(without_floats), timing::Comparison{"filtered, set", {}}));
  benchmark.candidates.push_back(
      fills("fast, double lanes", queries, truth, by_group(doubles), timing::Comparison{"fast", {}}));
  benchmark.candidates.push_back(
      fills("fast, float lanes", queries, truth, by_group(floats), timing::Comparison{"fast", {}}));
  return benchmark;
}

}  // namespace

Family batch_family() {
  Family family{"batches", "contact: filtered's functions of spans and sets against single calls", {}};
  for (const bool near : {false, true})
    family.benchmarks.emplace_back([=](const Settings& settings) { return ball_against_triangles(near, settings); });
  for (const std::size_t vertices : {8U, 128U})
    family.benchmarks.emplace_back([=](const Settings& settings) { return balls_against_polygon(vertices, settings); });
  return family;
}

}  // namespace touchstone::bench
