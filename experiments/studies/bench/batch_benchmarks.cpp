// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/studies/bench/families.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "experiments/studies/bench/variants.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_triangle.h"
#include "geometry/shapes/triangle.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/triangle_set.h"

namespace touchstone::bench {
namespace {

/// Truth values as wide as the numbers, so that loops of both are vectorised.
template <class Real>
using Truth = std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>;

template <class Real>
struct Vector {
  Real x, y, z;
};
template <class Real>
__attribute__((always_inline)) inline Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
__attribute__((always_inline)) inline Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
__attribute__((always_inline)) inline Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
struct Query {
  const Real* coordinates[9];
  Vector<Real> center;
  Real radius_squared;
};

constexpr std::size_t kBlock = 256;

/// Answers at most kBlock of them.
template <class Real>
__attribute__((always_inline)) inline void ask(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  const Real *ax = query.coordinates[0], *ay = query.coordinates[1], *az = query.coordinates[2];
  const Real *bx = query.coordinates[3], *by = query.coordinates[4], *bz = query.coordinates[5];
  const Real *cx = query.coordinates[6], *cy = query.coordinates[7], *cz = query.coordinates[8];
  const Vector<Real> center = query.center;
  const Real radius_squared = query.radius_squared;
  for (std::size_t i = 0; i < count; ++i) {
    using T = Truth<Real>;
    const Vector<Real> a{ax[i], ay[i], az[i]}, b{bx[i], by[i], bz[i]}, c{cx[i], cy[i], cz[i]};
    const Vector<Real> normal = cross(b - a, a - c);
    T inside = 1, touched = 0;
    const auto edge = [&](const Vector<Real>& start, const Vector<Real>& end) __attribute__((always_inline)) {
      const Vector<Real> from_start = center - start, direction = end - start, moment = cross(from_start, direction);
      const Real along = dot(from_start, direction), length_squared = dot(direction, direction);
      const T line =
          T{dot(moment, moment) <= radius_squared * length_squared} & T{along >= 0} & T{along <= length_squared};
      touched |= line | T{dot(from_start, from_start) <= radius_squared};
      inside &= T{dot(normal, moment) >= 0};
    };
    edge(a, b);
    edge(b, c);
    edge(c, a);
    const Real height = dot(normal, center - c);
    truths[i] = touched | (inside & T{height * height <= radius_squared * dot(normal, normal)});
  }
}

#if defined(__x86_64__)
template <class Real>
__attribute__((target("avx2"))) void ask_with_avx2(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  ask(query, count, truths);
}
#endif
template <class Real>
void ask_with_any(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  ask(query, count, truths);
}

/// The formulas of `fast::contact` over triangles as structure of arrays, in loops that compilers vectorise: the
/// yardstick for a prepared set. Uses AVX2 where the machine has it.
template <class Real>
class FastBatch {
 public:
  explicit FastBatch(std::span<const Triangle> triangles);
  /// Writes to touches[i] whether the ball touches triangle i; wrong if the input is within rounding error of contact.
  void contact(const Ball& ball, std::span<bool> touches) const;

 private:
  std::array<std::vector<Real>, 9> coordinates_;  ///< x, y, z of the first vertices, then of the others
};

template <class Real>
FastBatch<Real>::FastBatch(std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    std::size_t next = 0;
    for (const Eigen::Vector3d* vertex : {&t.a, &t.b, &t.c})
      for (const double x : *vertex) coordinates_[next++].push_back(static_cast<Real>(x));
  }
}

template <class Real>
void FastBatch<Real>::contact(const Ball& ball, std::span<bool> touches) const {
  auto asked = &ask_with_any<Real>;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) asked = &ask_with_avx2<Real>;
#endif
  const auto radius = static_cast<Real>(ball.radius);
  Truth<Real> truths[kBlock];
  for (std::size_t first = 0; first < touches.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, touches.size() - first);
    Query<Real> query{
        {},
        {static_cast<Real>(ball.center.x()), static_cast<Real>(ball.center.y()), static_cast<Real>(ball.center.z())},
        radius * radius};
    for (std::size_t i = 0; i < coordinates_.size(); ++i) query.coordinates[i] = coordinates_[i].data() + first;
    asked(query, count, truths);
    for (std::size_t i = 0; i < count; ++i) touches[first + i] = truths[i] != 0;
  }
}

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
