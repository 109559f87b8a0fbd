// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/rational_answer.h"

#include <CGAL/Gmpq.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/methods/plain_formulas.h"

namespace touchstone::corpus {
namespace {

using cases::Key;
using cases::key_of;
using cases::PartialAnswer;

/// Numbers of the formulas, whose results are never rounded.
struct UnroundedRationals {
  using Number = CGAL::Gmpq;
};

using RationalPolygon = methods::PlainPolygon<UnroundedRationals>;

mpq_class rational(const CGAL::Gmpq& x) { return mpq_class(x.mpq()); }

/// The interval of the numbers that round to x > 0 or to 0; it includes its ends if the significand of x is even.
struct Rounded {
  mpq_class low, high;
  bool with_ends;
};

Rounded that_round_to(double x) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const mpq_class beyond = mpq_class(kMost) + mpq_class(kMost) - mpq_class(std::nextafter(kMost, 0.0));
  if (std::isinf(x)) return {(mpq_class(kMost) + beyond) / 2, 4 * beyond * beyond, true};
  const mpq_class here(x), below = x == 0 ? mpq_class(-std::nextafter(0.0, 1.0)) : mpq_class(std::nextafter(x, 0.0)),
                           above = x == kMost ? beyond : mpq_class(std::nextafter(x, kMost));
  return {(below + here) / 2, (here + above) / 2, (std::bit_cast<std::uint64_t>(x) & 1) == 0};
}

struct Point2 {
  mpq_class x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// Returns a number > 0 if c lies to the left of the line from a to b.
int side(const Point2& a, const Point2& b, const Point2& c) {
  return sgn(mpq_class((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}
/// Returns whether a point on the line lies between a and b, or equals one of them.
bool is_between(const Point2& a, const Point2& b, const Point2& c) {
  return sgn(mpq_class((a.x - c.x) * (b.x - c.x) + (a.y - c.y) * (b.y - c.y))) <= 0;
}
/// Returns whether the segments a b and c d cross between their ends, or share more than a point.
bool cross_or_overlap(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const int c_side = side(a, b, c), d_side = side(a, b, d);
  if (c_side != 0 || d_side != 0) return c_side * d_side < 0 && side(c, d, a) * side(c, d, b) < 0;
  const Point2* shared = nullptr;
  for (const Point2* p : {&a, &b, &c, &d}) {
    if (!is_between(a, b, *p) || !is_between(c, d, *p)) continue;
    if (shared != nullptr && !(*p == *shared)) return true;
    shared = p;
  }
  return false;
}

/// Returns the vertices without the coordinate of the largest component of the normal; nothing if the normal is zero.
std::optional<std::vector<Point2>> dropped(const Polygon& polygon) {
  const std::size_t count = polygon.vertex_count();
  std::vector<std::array<mpq_class, 3>> vertices(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) vertices[i][k] = mpq_class(polygon.vertex(i)[static_cast<Eigen::Index>(k)]);
  std::array<mpq_class, 3> normal;
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
    const auto &p = vertices[i], &q = vertices[polygon.next(i)];
    for (std::size_t k = 0; k < 3; ++k) normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  }
  std::size_t axis = 0;
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
    if (abs(normal[k]) > abs(normal[axis])) axis = k;
  if (normal[axis] == 0) return std::nullopt;
  std::vector<Point2> points;
  for (const auto& v : vertices) points.push_back({v[(axis + 1) % 3], v[(axis + 2) % 3]});
  return points;
}

/// A loop on its way through a point: the vertices before and after it, and the number of the vertex there, or of the
/// edge, beyond all vertices.
struct Run {
  std::size_t before, after, number;
};

/// Returns how edge i runs through one of its points.
Run run_of(const Polygon& polygon, const std::vector<Point2>& points, std::size_t i, const Point2& p) {
  const std::size_t next = polygon.next(i);
  if (p == points[i]) return {polygon.previous(i), next, i};
  if (p == points[next]) return {i, polygon.next(next), next};
  return {i, next, points.size() + i};
}

/// Returns whether edges i and j cross, overlap, or share a point in which their loops cross.
bool meet(const Polygon& polygon, const std::vector<Point2>& points, std::size_t i, std::size_t j) {
  const std::array ends{i, polygon.next(i), j, polygon.next(j)};
  const Point2 &a = points[i], &b = points[ends[1]], &c = points[j], &d = points[ends[3]];
  if (cross_or_overlap(a, b, c, d)) return true;
  for (const std::size_t end : ends) {
    const Point2& p = points[end];
    if (side(a, b, p) != 0 || side(c, d, p) != 0 || !is_between(a, b, p) || !is_between(c, d, p)) continue;
    const Run run = run_of(polygon, points, i, p), other = run_of(polygon, points, j, p);
    if (run.number == other.number) continue;
    const bool turns_left = side(points[run.before], p, points[run.after]) >= 0;
    const auto is_left = [&](const Point2& q) {
      const bool first = side(points[run.before], p, q) > 0, second = side(p, points[run.after], q) > 0;
      return turns_left ? first && second : first || second;
    };
    if (is_left(points[other.before]) != is_left(points[other.after])) return true;
  }
  return false;
}

/// Returns whether a hole is inside the outer loop, where it begins: on its first edge, before any edge of that loop.
bool begins_inside(const Polygon& polygon, const std::vector<Point2>& points, std::size_t hole) {
  const Point2 &start = points[hole], &end = points[polygon.next(hole)];
  mpq_class least = 1;  // the part of the edge up to where an edge of the outer loop meets its line
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
    const Point2 &a = points[i], &b = points[polygon.next(i)];
    const auto area = [&](const Point2& p) -> mpq_class {
      return (end.x - start.x) * (p.y - start.y) - (end.y - start.y) * (p.x - start.x);
    };
    const mpq_class from = area(a), to = area(b);
    if (sgn(from) * sgn(to) > 0 || from == to) continue;
    const mpq_class along = from / (from - to);
    const Point2 met{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
    const mpq_class part = start.x != end.x ? mpq_class((met.x - start.x) / (end.x - start.x))
                                            : mpq_class((met.y - start.y) / (end.y - start.y));
    if (part > 0 && part < least) least = part;
  }
  const Point2 p{start.x + least / 2 * (end.x - start.x), start.y + least / 2 * (end.y - start.y)};
  bool inside = false;
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
    const Point2 &a = points[i], &b = points[polygon.next(i)];
    if ((a.y > p.y) != (b.y > p.y) && (side(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace

bool is_nearest_double(double x, const mpq_class& exact) {
  const Rounded rounded = that_round_to(std::abs(x));
  const mpq_class value = x < 0 || (x == 0 && exact < 0) ? mpq_class(-exact) : exact;
  return rounded.with_ends ? rounded.low <= value && value <= rounded.high
                           : rounded.low < value && value < rounded.high;
}

namespace {

/// Returns the sign of sqrt(squared) - x.
int compare_root(const mpq_class& squared, const mpq_class& x) { return x < 0 ? 1 : sgn(mpq_class(squared - x * x)); }

/// Returns whether x is the double nearest to term + sign sqrt(squared), for a sign of -1 or +1.
bool is_nearest_sum(double x, const mpq_class& term, int sign, const mpq_class& squared) {
  const auto [low, high, with_ends] = that_round_to(std::abs(x));
  const auto compare = [&](const mpq_class& end) { return sign * compare_root(squared, sign * (end - term)); };
  const int from_low = compare(x < 0 ? mpq_class(-high) : low), from_high = compare(x < 0 ? mpq_class(-low) : high);
  return with_ends ? from_low >= 0 && from_high <= 0 : from_low > 0 && from_high < 0;
}

}  // namespace

bool is_nearest_root(double x, const mpq_class& squared) { return is_nearest_sum(x, 0, 1, squared); }

namespace {

/// `mesh`: the nearest face and the touched ones, if the polygon is the nearest face of a mesh.
std::vector<std::string> differences_about(const Ball& ball, const Polygon& polygon, const cases::StatedAnswer& answer,
                                           const PartialAnswer* mesh) {
  const RationalPolygon prepared(polygon);
  const RationalPolygon::Query query(ball, prepared);
  const auto nearest = query.nearest();
  PartialAnswer decisive;
  if (mesh != nullptr) {
    decisive = *mesh;
  } else {
    decisive.plane = query.plane_side();
    decisive.plane_tangent = query.plane_tangent();
    decisive.foot = query.foot();
    decisive.edges_hit = query.edges_hit();
  }
  decisive.relation = query.relation();
  decisive.contact = query.contact();
  decisive.nearest = nearest->feature;

  std::vector<std::string> differences;
  const auto& [stands, texts] = answer;
  const auto compare = [&differences, &texts = texts](const Key& key, bool is_right, const std::string& given) {
    const std::string name(key.name);
    const auto text = texts.find(name);
    if (text == texts.end())
      differences.push_back(name + ": is missing");
    else if (!is_right)
      differences.push_back(
          fmt::format("{}: the file says {}, rational arithmetic gives {}", name, text->second, given));
  };
  const cases::StatedAnswer found = cases::stated(decisive);
  for (const Key& key : cases::kKeys)
    if (has(decisive, key)) compare(key, same_value(key, stands, decisive), found.texts.at(std::string(key.name)));

  const auto about = [](const mpq_class& x) {
    return fmt::format("{}{}", std::isfinite(x.get_d()) && x == x.get_d() ? "" : "about ", x.get_d());
  };
  const mpq_class off_plane = rational(prepared.off_plane()), squared = rational(nearest->distance_squared);
  if (mesh == nullptr)
    compare(key_of(&PartialAnswer::off_plane), stands.off_plane && is_nearest_double(*stands.off_plane, off_plane),
            about(off_plane));
  compare(key_of(&PartialAnswer::distance),
          stands.distance && *stands.distance >= 0 && is_nearest_root(*stands.distance, squared),
          fmt::format("sqrt({})", about(squared)));
  const auto closest = query.closest_point(nearest->feature);
  const std::array point{rational(closest.x()), rational(closest.y()), rational(closest.z())};
  bool is_nearest_point = stands.point.has_value();
  for (std::size_t k = 0; k < 3 && is_nearest_point; ++k) {
    const double x = (*stands.point)[static_cast<Eigen::Index>(k)];  // an infinite one was stated without its sign
    is_nearest_point = is_nearest_double(std::isinf(x) ? std::copysign(x, sgn(point[k])) : x, point[k]);
  }
  compare(key_of(&PartialAnswer::point), is_nearest_point,
          fmt::format("about [{},{},{}]", point[0].get_d(), point[1].get_d(), point[2].get_d()));
  const auto away = query.away_from(nearest->feature);
  const std::array normal{rational(away.x()), rational(away.y()), rational(away.z())};
  const mpq_class length_squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  bool is_nearest_normal = stands.contact_normal.has_value();
  for (std::size_t k = 0; k < 3 && is_nearest_normal; ++k)
    is_nearest_normal = is_nearest_sum((*stands.contact_normal)[static_cast<Eigen::Index>(k)], 0,
                                       normal[k] < 0 ? -1 : 1, normal[k] * normal[k] / length_squared);
  compare(key_of(&PartialAnswer::contact_normal), is_nearest_normal,
          fmt::format("the direction of about [{},{},{}]", normal[0].get_d(), normal[1].get_d(), normal[2].get_d()));
  const mpq_class radius(ball.radius);
  const double depth = stands.depth.value_or(0);  // an infinite one was stated without its sign
  compare(key_of(&PartialAnswer::depth),
          stands.depth && is_nearest_sum(std::isinf(depth) ? -depth : depth, radius, -1, squared),
          fmt::format("{} - sqrt({})", about(radius), about(squared)));
  return differences;
}

}  // namespace

std::vector<std::string> rational_differences(const Ball& ball, const Polygon& polygon,
                                              const cases::StatedAnswer& answer) {
  return differences_about(ball, polygon, answer, nullptr);
}

std::vector<std::string> rational_differences(const Ball& ball, const cases::PosedMesh& mesh,
                                              const cases::StatedAnswer& answer) {
  PartialAnswer found;
  found.touched.emplace();
  std::vector<mpq_class> squared;
  for (std::size_t face = 0; face < mesh.faces().size(); ++face) {
    const RationalPolygon prepared(mesh.faces()[face]);
    const RationalPolygon::Query query(ball, prepared);
    squared.push_back(rational(query.nearest()->distance_squared));
    if (query.contact() == true) found.touched->push_back(face);
  }
  found.face = *std::ranges::min_element(mesh.order(), {}, [&](std::size_t face) { return squared[face]; });
  return differences_about(ball, mesh.faces()[*found.face], answer, &found);
}

std::optional<RejectionCode> find_rational_fault(const Polygon& polygon) {
  const auto points = dropped(polygon);
  if (!points) return RejectionCode::ZeroNormal;
  const std::size_t count = polygon.vertex_count();
  for (std::size_t i = 0; i < count; ++i) {
    if ((*points)[i] == (*points)[polygon.next(i)]) return RejectionCode::LoopMeetsItself;
    for (std::size_t j = i + 1; j < polygon.loop_end(polygon.loop_of(i)); ++j)
      if (meet(polygon, *points, i, j)) return RejectionCode::LoopMeetsItself;
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = polygon.loop_end(polygon.loop_of(i)); j < count; ++j)
      if (meet(polygon, *points, i, j)) return RejectionCode::LoopsMeet;
  for (std::size_t loop = 1; loop < polygon.loop_count(); ++loop)
    if (!begins_inside(polygon, *points, polygon.loop_begin(loop))) return RejectionCode::HoleOutside;
  return std::nullopt;
}

}  // namespace touchstone::corpus
