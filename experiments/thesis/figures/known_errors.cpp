// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/known_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/degrees.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/thesis.h"
#include "robust/filtered/filtered.h"

namespace touchstone::figures {
namespace {

using workloads::Random;

/// Streams of random numbers, one a measurement.
enum Stream : std::uint64_t { kNotNumbers = 64, kTouching, kCollinear = kTouching + 3, kFarAway, kFeet, kEdges };

struct Edge {
  Eigen::Vector3d start, end;

  [[nodiscard]] Eigen::Vector3d along() const { return end - start; }
  /// Away from an outline that runs counter-clockwise.
  [[nodiscard]] Eigen::Vector3d outward() const { return Eigen::Vector3d(along().y(), -along().x(), 0).normalized(); }
};

Edge edge_of(const Outline& outline, std::size_t i) {
  const auto& [x0, y0] = outline.corners[i];
  const auto& [x1, y1] = outline.corners[(i + 1) % outline.corners.size()];
  return {{x0, y0, 0}, {x1, y1, 0}};
}

Edge random_edge(const Outline& outline, Random& random) {
  return edge_of(outline,
                 static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(outline.corners.size()) - 1)));
}

/// Draws a ball of a flowchart's workload.
Ball random_ball(const Box& bounds, double radius, Random& random) {
  Ball ball{bounds.enlarged(3 * radius, 3 * radius).point(random), radius};
  ball.center.z() = 1.5 * radius * (2 * random.unit() - 1);
  return ball;
}

double extent(const Box& box) { return std::max(box.width(), box.height()); }

/// u.v / |u||v| at a point of an edge, as the method computes it.
template <class Scalar>
bool is_not_number(const Edge& edge, const Eigen::Vector3d& point) {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Vector u = edge.start.cast<Scalar>() - point.cast<Scalar>(), v = edge.end.cast<Scalar>() - point.cast<Scalar>();
  return std::isnan(std::acos(static_cast<double>(u.dot(v) / (u.norm() * v.norm()))));
}

}  // namespace

std::vector<FactorReach> measure_factor_reach(const Outline& outline) {
  std::vector<FactorReach> all;
  const Polygon polygon = outline.polygon();
  for (const double factor : {0.99, 0.9999, 1.0}) {
    const thesis::PreparedPolygon<> method(polygon, {.match_factor = factor});
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
      const Edge edge = edge_of(outline, i);
      const double length = edge.along().norm();
      const Eigen::Vector3d middle = (edge.start + edge.end) / 2;
      const auto inside = [&](double away) {
        return thesis::foot(Ball{middle + away * edge.outward(), 1}, method) == PointLocation::Inside;
      };
      double low = 0, high = 0;
      for (high = length * 1e-6; high < length && inside(high); high *= 2) low = high;
      while (high < length && high - low > 1e-12 * length) {
        const double half = (low + high) / 2;
        (inside(half) ? low : high) = half;
      }
      all.push_back({i, length, factor, low});
    }
  }
  return all;
}

double derived_factor_reach(double length, double factor) {
  return length * workloads::cosine(90 * factor) / (2 * workloads::sine(90 * factor));
}

NotNumbers measure_not_numbers(const Outline& outline, std::uint64_t samples, std::uint64_t seed) {
  NotNumbers result;
  const double scale = 1000 / extent(bounds(outline));
  for (std::uint64_t i = 0; i < samples; ++i) {
    Random random(seed, i, kNotNumbers);
    // A turn by rational numbers: no function of the C library.
    const double t = 2 * random.unit() - 1, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    Outline turned{outline.name, {}};
    const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    for (const auto& [x, y] : outline.corners)
      turned.corners.emplace_back(rounded(scale * (c * x - s * y)), rounded(scale * (s * x + c * y)));
    const Edge edge = random_edge(turned, random);
    Eigen::Vector3d point = edge.start + random.unit() * edge.along();
    const bool in_doubles = is_not_number<double>(edge, point);
    point = {rounded(point.x()), rounded(point.y()), 0};
    ++result.samples;
    result.in_doubles += in_doubles;
    if (!is_not_number<float>(edge, point)) continue;
    ++result.in_floats;
    const thesis::PreparedPolygon<float> method(turned.polygon());
    result.called_outside += thesis::foot(Ball{point, 1}, method) == PointLocation::Outside;
    result.misses += !thesis::contact(Ball{point, 1}, method);
  }
  return result;
}

Touching measure_touching(const Outline& outline, Touched what, std::uint64_t samples, std::uint64_t seed) {
  const Polygon polygon = outline.polygon();
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<> strict(polygon), closed(polygon, {.comparison = thesis::Comparison::Closed}),
      signed_angles(polygon, {.angles = thesis::Angles::Signed});
  const Box box = bounds(outline);
  Touching result;
  for (std::uint64_t i = 0; i < samples; ++i) {
    Random random(seed, i, kTouching + static_cast<std::uint64_t>(what));
    // Multiples of 2^-10, so that all sums are exact; five parts of a radius, for 3, 4, 5.
    const double fifth = 0x1p-10 * static_cast<double>(random.integer(1, 1024)), r = 5 * fifth;
    Ball ball{{0, 0, 0}, r};
    const Edge edge = random_edge(outline, random);
    const Eigen::Vector3d out = edge.outward(), along = edge.along().normalized();
    if (what == Touched::Face) {
      ball.center = box.point(random);
      ball.center.z() = random.coin() ? r : -r;
    } else if (what == Touched::Edge) {
      ball.center = edge.start + std::round(random.unit() * edge.along().norm() * 1024) / 1024 * along +
                    3 * fifth * out + Eigen::Vector3d(0, 0, 4 * fifth);
    } else {
      ball.center = edge.start - 3 * fifth * along + 4 * fifth * out;
    }
    const Answer answer = filtered::answer(ball, truth);
    const bool other = (what == Touched::Face) != (answer.nearest.kind == Feature::Kind::Face) ||
                       (what == Touched::Vertex) != (answer.nearest.kind == Feature::Kind::Vertex);
    if (answer.relation != Relation::Touching || other) continue;  // elsewhere: not over the polygon, or nearer to more
    ++result.samples;
    result.missed += !thesis::contact(ball, strict);
    result.missed_signed += !thesis::contact(ball, signed_angles);
    result.missed_closed += !thesis::contact(ball, closed);
  }
  return result;
}

Collinear measure_collinear(const Outline& outline, std::uint64_t samples, std::uint64_t seed) {
  Outline begun = outline;
  const Edge first = edge_of(outline, 0);
  const Eigen::Vector3d middle = (first.start + first.end) / 2;
  begun.corners.insert(begun.corners.begin() + 1, {middle.x(), middle.y()});
  const Polygon polygon = begun.polygon();
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<> method(polygon), newell(polygon, {.normal = thesis::Normal::Newell});
  const Box box = bounds(outline);
  Collinear result;
  for (std::uint64_t i = 0; i < samples; ++i) {
    Random random(seed, i, kCollinear);
    const Ball ball = random_ball(box, 0.05 * extent(box), random);
    if (!filtered::contact(ball, truth)) continue;
    ++result.contacts;
    result.missed += !thesis::contact(ball, method);
    result.missed_newell += !thesis::contact(ball, newell);
  }
  return result;
}

FarAway measure_far_away(const Outline& outline, double offset, std::uint64_t samples, std::uint64_t seed) {
  Eigen::Matrix3d tilt;  // a rotation except for rounding: in the plane of axes, s would lose nothing
  tilt << 2, -2, 1, 1, 2, 2, -2, -1, 2;
  tilt /= 3;
  const auto moved = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return tilt * p + Eigen::Vector3d::Constant(offset);
  };
  Loop loop;
  for (const auto& [x, y] : outline.corners) loop.push_back(moved({x, y, 0}));
  const Polygon polygon(loop);
  const filtered::PreparedPolygon truth(polygon);
  const thesis::Options options{.angles = thesis::Angles::Signed};
  const thesis::PreparedPolygon<double> in_doubles(polygon, options);
  const thesis::PreparedPolygon<float> in_floats(polygon, options);
  const fast::PreparedPolygon<> fast(polygon);
  const Box box = bounds(outline);
  FarAway result{offset};
  for (std::uint64_t i = 0; i < samples; ++i) {
    Random random(seed, i, kFarAway);
    Ball ball = random_ball(box, 0.05 * extent(box), random);
    ball.center = moved(ball.center);
    const bool touches = filtered::contact(ball, truth);
    ++result.samples;
    result.wrong[0] += thesis::contact(ball, in_doubles) != touches;
    result.wrong[1] += thesis::contact(ball, in_floats) != touches;
    result.wrong[2] += fast::contact(ball, fast) != touches;
  }
  return result;
}

FootErrors measure_foot_errors(const Polygon& polygon, double radius, std::uint64_t samples, std::uint64_t seed) {
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<double> in_doubles(polygon);
  const thesis::PreparedPolygon<float> in_floats(polygon);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) box.extend(polygon.vertex(i));
  box.extend(box.min() - Eigen::Vector3d::Constant(radius));
  box.extend(box.max() + Eigen::Vector3d::Constant(radius));
  // Step (3): Q = C - (N.C + D) N.
  const auto foot = [](const auto& method, const Eigen::Vector3d& center) -> Eigen::Vector3d {
    using Vector = std::decay_t<decltype(method.normal())>;
    const auto& c = center.cast<typename Vector::Scalar>();
    const Vector q = c - (method.normal().dot(c) + method.offset()) * method.normal();
    return q.template cast<double>();
  };
  FootErrors errors;
  for (std::uint64_t i = 0; i < samples; ++i) {
    Random random(seed, i, kFeet);
    const Eigen::Vector3d shares{random.unit(), random.unit(), random.unit()};
    const Ball ball{box.min() + shares.cwiseProduct(box.sizes()), radius};
    if (filtered::foot(ball, truth) != PointLocation::Inside) continue;
    const Eigen::Vector3d exact = filtered::answer(ball, truth).point;
    ++errors.samples;
    errors.in_doubles = std::max(errors.in_doubles, (foot(in_doubles, ball.center) - exact).norm());
    errors.in_floats = std::max(errors.in_floats, (foot(in_floats, ball.center) - exact).norm());
  }
  return errors;
}

EdgePlaces measure_edge_places(const Outline& outline, double radius, std::uint64_t balls, std::uint64_t seed) {
  const Polygon polygon = outline.polygon();
  const filtered::PreparedPolygon truth(polygon);
  const thesis::PreparedPolygon<double> in_doubles(polygon);
  const thesis::PreparedPolygon<float> in_floats(polygon);
  const Box box = bounds(outline);
  EdgePlaces places;
  for (std::uint64_t i = 0; i < balls; ++i) {
    Random random(seed, i, kEdges);
    const Ball ball = random_ball(box, radius * extent(box), random);
    if (filtered::foot(ball, truth) != PointLocation::Outside) continue;
    const auto hit = filtered::edges_hit(ball, truth);
    const std::array hits{thesis::edges_hit(ball, in_doubles), thesis::edges_hit(ball, in_floats)};
    for (std::size_t edge = 0; edge < in_doubles.edges().size(); ++edge) {
      const auto& e = in_doubles.edges()[edge];
      const double t = (ball.center - e.start).dot(e.direction);
      ++places.pairs;
      ++(t <= 0 ? places.before : t >= e.length ? places.beyond : places.beside);
      for (std::size_t m = 0; m < hits.size(); ++m)
        places.wrong[m] += std::ranges::binary_search(hits[m], edge) != std::ranges::binary_search(hit, edge);
    }
  }
  return places;
}

}  // namespace touchstone::figures
