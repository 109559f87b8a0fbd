// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/convex/convex.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ch_graham_andrew.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/triangulate.h"
#include "geometry/contact/fast.h"
#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/mesh/detail/face_plane.h"

namespace touchstone::convex {
namespace {

using cases::PartialAnswer;
using cases::QueryKind;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbers = std::vector<std::uint32_t>;  // of vertices

/// A polygon's vertices without the dropped axis.
class Shadow {
 public:
  explicit Shadow(const Polygon& polygon) : axis_(exact::detail::dropped_axis(polygon).value()) {
    const auto u = polygon.coordinates((axis_ + 1) % 3), v = polygon.coordinates((axis_ + 2) % 3);
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) points_.emplace_back(u[i], v[i]);
    turned_ = mesh::detail::turn(polygon, 0, axis_) < 0;
  }
  [[nodiscard]] const std::vector<Kernel::Point_2>& points() const { return points_; }
  /// Whether the outer loop runs clockwise.
  [[nodiscard]] bool turned() const { return turned_; }
  /// Whether three corners of a loop with the outer loop's orientation turn inwards, or run straight.
  [[nodiscard]] bool convex(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return CGAL::orientation(points_[a], points_[b], points_[c]) != (turned_ ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN);
  }

 private:
  int axis_;
  bool turned_ = false;
  std::vector<Kernel::Point_2> points_;
};

Polygon polygon_of(const Polygon& polygon, const Numbers& numbers) {
  Loop loop;
  for (const std::uint32_t i : numbers) loop.push_back(polygon.vertex(i));
  return Polygon(loop);
}

/// The loop of both along their common edge, which goes from the first's vertex `i` to the next one.
Numbers joined(const Numbers& first, std::size_t i, const Numbers& second, std::size_t k) {
  Numbers loop;
  for (std::size_t n = 1; n <= first.size(); ++n) loop.push_back(first[(i + n) % first.size()]);
  for (std::size_t n = 2; n < second.size(); ++n) loop.push_back(second[(k + n) % second.size()]);
  return loop;
}

bool all_convex(const Numbers& loop, const Shadow& shadow) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!shadow.convex(loop[i], loop[(i + 1) % loop.size()], loop[(i + 2) % loop.size()])) return false;
  return true;
}

/// Joins two of the parts, if that may be.
bool join_two(std::vector<Numbers>& parts, const Shadow& shadow) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t i = 0; i < parts[p].size(); ++i) {
      const std::uint32_t a = parts[p][i], b = parts[p][(i + 1) % parts[p].size()];
      if (const auto other = edges.find({b, a}); other != edges.end()) {
        const auto [q, k] = other->second;
        Numbers both = joined(parts[p], i, parts[q], k);
        if (all_convex(both, shadow)) {
          parts[q] = std::move(both);
          parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(p));
          return true;
        }
      }
      edges[{a, b}] = {p, i};
    }
  return false;
}

/// Whether a ball touches one of some convex polygons, by `fast`.
class PreparedConvex final : public cases::PreparedMethod {
 public:
  explicit PreparedConvex(const std::vector<Polygon>& parts) {
    for (const Polygon& part : parts) parts_.emplace_back(part);
  }

  PartialAnswer ask(const Ball& ball, QueryKind /*kind*/) const override {
    PartialAnswer answer;
    answer.contact = std::ranges::any_of(parts_, [&](const auto& part) { return fast::contact(ball, part); });
    answer.stage = "double";
    return answer;
  }

 private:
  std::vector<fast::PreparedPolygon<double>> parts_;
};

}  // namespace

Polygon convex_hull(const Polygon& polygon) {
  const FloatingPointState state;
  const Shadow shadow(polygon);
  std::map<Kernel::Point_2, std::uint32_t> numbers;
  std::vector<Kernel::Point_2> outer, hull;
  for (std::uint32_t i = 0; i < polygon.loop_end(0); ++i) {
    outer.push_back(shadow.points()[i]);
    numbers.emplace(outer.back(), i);
  }
  CGAL::ch_graham_andrew(outer.begin(), outer.end(), std::back_inserter(hull));
  if (shadow.turned()) std::ranges::reverse(hull);
  Numbers loop;
  for (const Kernel::Point_2& point : hull) loop.push_back(numbers.at(point));
  return polygon_of(polygon, loop);
}

std::vector<Polygon> convex_parts(const Polygon& polygon) {
  const FloatingPointState state;
  const Shadow shadow(polygon);
  std::vector<Numbers> parts;
  if (polygon.vertex_count() == 3)
    parts.push_back({0, 1, 2});
  else
    for (const auto& triangle : methods::triangulate(polygon)) parts.emplace_back(triangle.begin(), triangle.end());
  while (join_two(parts, shadow)) continue;
  std::vector<Polygon> polygons;
  for (const Numbers& part : parts) polygons.push_back(polygon_of(polygon, part));
  return polygons;
}

void add_methods() {
  methods::add_methods([](methods::MethodList& list) {
    list.push_back(std::make_unique<cases::Method>(
        "hull", "fast on the polygon's convex hull, which fills notches and holes",
        [](const Polygon& polygon) { return std::make_unique<PreparedConvex>(std::vector{convex_hull(polygon)}); }));
    list.push_back(std::make_unique<cases::Method>(
        "convex-parts", "fast on convex parts of the polygon, joined from triangles",
        [](const Polygon& polygon) { return std::make_unique<PreparedConvex>(convex_parts(polygon)); }));
  });
}

}  // namespace touchstone::convex
