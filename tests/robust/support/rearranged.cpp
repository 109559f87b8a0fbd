// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/rearranged.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchstone::contact_tests {
namespace {

Polygon with_order(const Polygon& polygon, const Order& order) {
  std::vector<Loop> loops;
  for (const auto& numbers : order) {
    loops.emplace_back();
    for (const std::size_t i : numbers) loops.back().push_back(polygon.vertex(i));
  }
  return polygon_of(loops);
}

template <class T>
void turn(std::vector<T>& items, std::size_t begin, std::size_t steps) {
  const auto first = items.begin() + static_cast<std::ptrdiff_t>(begin);
  if (first == items.end()) return;
  std::rotate(first, first + static_cast<std::ptrdiff_t>(steps % (items.size() - begin)), items.end());
}

}  // namespace

std::vector<Loop> loops_of(const Polygon& polygon) {
  std::vector<Loop> loops(polygon.loop_count());
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) loops[polygon.loop_of(i)].push_back(polygon.vertex(i));
  return loops;
}

Polygon polygon_of(const std::vector<Loop>& loops) { return Polygon(loops[0], {loops.begin() + 1, loops.end()}); }

Polygon polygon_of(const Triangle& t) { return Polygon({t.a, t.b, t.c}); }
Triangle triangle_of(const Polygon& polygon) { return {polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)}; }

double extent(const Polygon& polygon) {
  double largest = 0;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i)
    largest = std::max(largest, (polygon.vertex(i) - polygon.vertex(0)).cwiseAbs().maxCoeff());
  return largest;
}

PointMap mirror_along(int axis) {
  return [axis](Eigen::Vector3d v) {
    v[axis] = -v[axis];
    return v;
  };
}

Polygon moved(const Polygon& polygon, const PointMap& map) {
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops) std::transform(loop.begin(), loop.end(), loop.begin(), map);
  return polygon_of(loops);
}

Case moved(const Case& original, const PointMap& map) {
  return {original.id, {map(original.ball.center), original.ball.radius}, moved(original.polygon, map)};
}

Case scaled(const Case& original, int exponent) {
  Case result = moved(original, [exponent](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent));
  });
  result.ball.radius = std::ldexp(original.ball.radius, exponent);
  return result;
}

bool scales_exactly(const Case& original, int exponent) {
  const auto exact = [exponent](double x) {
    const double there = std::ldexp(x, exponent);
    return std::isfinite(there) && std::ldexp(there, -exponent) == x;
  };
  const auto all_exact = [&](const Eigen::Vector3d& v) { return exact(v.x()) && exact(v.y()) && exact(v.z()); };
  bool result = exact(original.ball.radius) && all_exact(original.ball.center);
  for (std::size_t i = 0; i < original.polygon.vertex_count(); ++i)
    result = result && all_exact(original.polygon.vertex(i));
  return result;
}

Answer scaled(Answer answer, int exponent) {
  for (double& x : answer.point) x = std::ldexp(x, exponent);
  answer.distance = std::ldexp(answer.distance, exponent);
  answer.off_plane = std::ldexp(answer.off_plane, exponent);
  answer.depth = std::ldexp(answer.depth, exponent);
  return answer;
}

Order order_of(const Polygon& polygon) {
  Order order(polygon.loop_count());
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) order[polygon.loop_of(i)].push_back(i);
  return order;
}

Reordered::Reordered(const Polygon& original, const Order& order) : polygon(with_order(original, order)) {
  for (const auto& numbers : order) old_vertex.insert(old_vertex.end(), numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < old_vertex.size(); ++i) {
    const std::size_t from = old_vertex[i], to = old_vertex[polygon.next(i)];
    old_edge.push_back(original.next(from) == to ? from : to);
  }
}

Answer Reordered::in_old_numbers(Answer answer) const {
  for (std::size_t& i : answer.edges_hit) i = old_edge[i];
  std::sort(answer.edges_hit.begin(), answer.edges_hit.end());
  std::size_t& nearest = answer.nearest.index;
  if (answer.nearest.kind == Feature::Kind::Edge) nearest = old_edge[nearest];
  if (answer.nearest.kind == Feature::Kind::Vertex) nearest = old_vertex[nearest];
  return answer;
}

std::size_t Reordered::place(Feature original) const {
  if (original.kind == Feature::Kind::Face) return 0;
  const auto& old = original.kind == Feature::Kind::Edge ? old_edge : old_vertex;
  return static_cast<std::size_t>(std::find(old.begin(), old.end(), original.index) - old.begin());
}

std::vector<Reordered> all_starts(const Polygon& polygon, const std::function<bool(std::size_t)>& reverse) {
  std::vector<Reordered> result;
  for (std::size_t start = 0; start < polygon.loop_end(0); ++start) {
    Order order = order_of(polygon);
    for (std::size_t loop = 0; loop < order.size(); ++loop) {
      turn(order[loop], 0, start);
      if (reverse(loop)) std::reverse(order[loop].begin(), order[loop].end());
    }
    turn(order, 1, start);
    result.emplace_back(polygon, order);
  }
  return result;
}

}  // namespace touchstone::contact_tests
