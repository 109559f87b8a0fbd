// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes Nef polyhedra: they take 20 s and over 1 GB to compile. CGAL's corefinement of meshes refuses
// boxes that share an edge.
#include "experiments/thesis/cell/model/exact_boolean.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::cell {

std::vector<CirclePoint> circle_points(int sides) {
  constexpr std::int64_t kOne = 1 << 20;  // tangents are whole multiples of its inverse
  std::vector<CirclePoint> points;
  for (int k = 0; k < sides; ++k) {
    const int quarters = 4 * k / sides, rest = 4 * k % sides;  // and rest / sides of a quarter
    const double half_angle = std::numbers::pi / 4 * rest / sides;
    const auto tangent = static_cast<std::int64_t>(std::round(std::tan(half_angle) * static_cast<double>(kOne)));
    CirclePoint point{kOne * kOne - tangent * tangent, 2 * tangent * kOne, kOne * kOne + tangent * tangent};
    for (int i = 0; i < quarters; ++i) point = {-point.sine, point.cosine, point.denominator};
    points.push_back(point);
  }
  return points;
}

namespace {

/// As exact as EPECK, whose lazy geometric objects take 12 s longer to compile.
using Kernel = CGAL::Simple_cartesian<CGAL::Lazy_exact_nt<CGAL::Gmpq>>;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Transformation = CGAL::Aff_transformation_3<Kernel>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

Transformation transformation(const Pose& pose) {
  const Eigen::Matrix3d& r = pose.rotation;
  const Eigen::Vector3d& t = pose.translation;
  Transformation map(r(0, 0), r(0, 1), r(0, 2), t.x(), r(1, 0), r(1, 1), r(1, 2), t.y(), r(2, 0), r(2, 1), r(2, 2),
                     t.z());
  if (!map.is_even()) throw std::invalid_argument("the pose of a solid must keep its orientation");
  return map;
}

/// A polyhedron of points and facets, each counter-clockwise seen from outside.
struct Facets : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> facets;

  void operator()(Polyhedron::HalfedgeDS& structure) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(structure, true);
    builder.begin_surface(points.size(), facets.size());
    for (const Point& p : points) builder.add_vertex(p);
    for (const auto& facet : facets) builder.add_facet(facet.begin(), facet.end());
    builder.end_surface();
  }

  Nef nef() {
    Polyhedron polyhedron;
    polyhedron.delegate(*this);
    return Nef(polyhedron);
  }
};

/// A prism: `top` is `bottom` moved, both counter-clockwise seen from above.
Nef prism(const std::vector<Point>& bottom, const std::vector<Point>& top) {
  const std::size_t n = bottom.size();
  Facets body;
  body.points = bottom;
  body.points.insert(body.points.end(), top.begin(), top.end());
  body.facets.resize(2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    body.facets[0].push_back(n - 1 - i), body.facets[1].push_back(n + i);
    body.facets.push_back({i, next, n + next, n + i});
  }
  return body.nef();
}

/// A ball of rings of n points, each counter-clockwise seen from above, the lowest first, between two poles.
Nef ball(std::vector<Point> points, std::size_t n) {
  const std::size_t last = points.size() - 1, top = last - n;
  Facets body;
  body.points = std::move(points);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    body.facets.push_back({0, 1 + next, 1 + i});
    for (std::size_t r = 1; r < top; r += n) body.facets.push_back({r + i, r + next, r + n + next, r + n + i});
    body.facets.push_back({top + i, top + next, last});
  }
  return body.nef();
}

Nef evaluate(const Solid& solid, const Transformation& outer);

struct Evaluate {
  const Transformation& map;

  Nef operator()(const Box& box) const {
    const Eigen::Vector3d &a = box.lower, &b = box.upper;
    std::vector<Point> bottom, top;
    for (const auto& [x, y] : {std::pair{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}}) {
      bottom.push_back(map(Point(x, y, a.z())));
      top.push_back(map(Point(x, y, b.z())));
    }
    return prism(bottom, top);
  }

  Nef operator()(const Cylinder& cylinder) const {
    const int u = (cylinder.axis + 1) % 3, v = (cylinder.axis + 2) % 3;
    const double from = cylinder.from[cylinder.axis], to = cylinder.to[cylinder.axis];
    std::vector<Point> bottom, top;
    for (const CirclePoint& p : circle_points(cylinder.sides)) {
      const auto scaled = [&](std::int64_t part) {
        return Number(cylinder.radius) * Number(static_cast<double>(part)) / Number(static_cast<double>(p.denominator));
      };
      std::array<Number, 3> at;
      at[static_cast<std::size_t>(u)] = Number(cylinder.from[u]) + scaled(p.cosine);
      at[static_cast<std::size_t>(v)] = Number(cylinder.from[v]) + scaled(p.sine);
      at[static_cast<std::size_t>(cylinder.axis)] = std::min(from, to);
      bottom.push_back(map(Point(at[0], at[1], at[2])));
      at[static_cast<std::size_t>(cylinder.axis)] = std::max(from, to);
      top.push_back(map(Point(at[0], at[1], at[2])));
    }
    return prism(bottom, top);
  }

  Nef operator()(const Sphere& sphere) const {
    const auto share = [](std::int64_t part, std::int64_t whole) {
      return Number(static_cast<double>(part)) / Number(static_cast<double>(whole));
    };
    const Number x = sphere.at.x(), y = sphere.at.y(), z = sphere.at.z(), radius = sphere.radius;
    const auto meridian = circle_points((sphere.sides + 3) / 4 * 4);
    const std::size_t quarter = meridian.size() / 4;
    std::vector<Point> points{map(Point(x, y, z - radius))};
    for (std::size_t k = 1; k < 2 * quarter; ++k) {  // from the south pole at three quarters of a turn
      const CirclePoint& latitude = meridian[(3 * quarter + k) % meridian.size()];
      const Number across = radius * share(latitude.cosine, latitude.denominator);
      const Number height = z + radius * share(latitude.sine, latitude.denominator);
      for (const CirclePoint& p : circle_points(sphere.sides))
        points.push_back(
            map(Point(x + across * share(p.cosine, p.denominator), y + across * share(p.sine, p.denominator), height)));
    }
    points.push_back(map(Point(x, y, z + radius)));
    return ball(std::move(points), static_cast<std::size_t>(sphere.sides));
  }

  Nef operator()(const MeshFile& mesh) const {
    throw std::invalid_argument(mesh.file.string() + ": a mesh cannot be part of a Boolean operation");
  }

  Nef operator()(const Boolean& boolean) const {
    Nef result = evaluate(boolean.parts.at(0), map);
    for (std::size_t i = 1; i < boolean.parts.size(); ++i) {
      const Nef part = evaluate(boolean.parts[i], map);
      switch (boolean.operation) {
        case Boolean::Operation::Union: result += part; break;
        case Boolean::Operation::Difference: result -= part; break;
        case Boolean::Operation::Intersection: result *= part; break;
      }
      result = result.regularization();
    }
    return result;
  }
};

Nef evaluate(const Solid& solid, const Transformation& outer) {
  const Transformation map = outer * transformation(solid.pose);
  return std::visit(Evaluate{map}, solid.shape);
}

mpq_class rational(const Number& number) { return mpq_class(number.exact().mpq()); }

Eigen::Vector3d rounded(const Point& point) {
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class value = rational(point[axis]);
    result[axis] = exact::detail::nearest_double(value.get_num(), value.get_den());
  }
  return result;
}

/// Twice the area of a loop, as a vector that points where it is counter-clockwise from.
Vector doubled_area(const std::vector<Point>& loop) {
  Vector sum(0, 0, 0);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum = sum + CGAL::cross_product(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return sum;
}

bool before(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

bool loop_before(const Loop& a, const Loop& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), before);
}

/// From its first vertex in order on, so that it does not matter where the data structure began.
Loop rounded_loop(const std::vector<Point>& loop) {
  Loop result;
  for (const Point& p : loop) result.push_back(rounded(p));
  std::rotate(result.begin(), std::min_element(result.begin(), result.end(), before), result.end());
  return result;
}

}  // namespace

Boundary boundary_of(const Solid& solid) {
  const FloatingPointState state;
  const Nef nef = evaluate(solid, Transformation(CGAL::IDENTITY));
  Boundary result;
  Number six_volumes = 0;
  for (auto facet = nef.halffacets_begin(); facet != nef.halffacets_end(); ++facet) {
    // Of the two sides of a facet, the one seen from the inside has loops that are clockwise from the outside.
    if (facet->incident_volume()->mark()) continue;
    std::vector<std::vector<Point>> loops;
    for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) {
      Nef::SHalfedge_around_facet_const_circulator edge(Nef::SHalfedge_const_handle{cycle}), begin = edge;
      std::vector<Point> loop;
      CGAL_For_all(edge, begin) loop.push_back(edge->source()->source()->point());
      loops.push_back(std::move(loop));
    }
    // The outer loop has the largest area. It comes first already, but that is not documented.
    const auto outer = std::max_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
      return doubled_area(a).squared_length() < doubled_area(b).squared_length();
    });
    std::iter_swap(loops.begin(), outer);
    for (const std::vector<Point>& loop : loops) six_volumes += (loops[0][0] - CGAL::ORIGIN) * doubled_area(loop);

    Boundary::Loops face;
    for (const std::vector<Point>& loop : loops) face.push_back(rounded_loop(loop));
    std::sort(face.begin() + 1, face.end(), loop_before);
    result.faces.push_back(std::move(face));
  }
  result.volume = rational(six_volumes) / 6;
  std::sort(result.faces.begin(), result.faces.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), loop_before);
  });
  return result;
}

}  // namespace touchstone::cell
