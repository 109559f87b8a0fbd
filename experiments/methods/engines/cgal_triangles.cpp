// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <type_traits>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

template <class Kernel>
typename Kernel::Point_3 point(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

template <class Kernel>
typename Kernel::Triangle_3 triangle(const Triangle& t) {
  return {point<Kernel>(t.a), point<Kernel>(t.b), point<Kernel>(t.c)};
}

template <class Kernel>
std::optional<bool> by_distance(const Ball& ball, const Triangle& t) {
  const typename Kernel::FT radius = ball.radius;
  return CGAL::squared_distance(point<Kernel>(ball.center), triangle<Kernel>(t)) <= radius * radius;
}

/// CGAL's sphere is a surface: it does not intersect a triangle in its interior.
template <class Kernel>
std::optional<bool> by_intersection(const Ball& ball, const Triangle& t) {
  using Number = typename Kernel::FT;
  const Number radius = ball.radius, square = radius * radius;
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite(square)) return std::nullopt;  // EPICK's rationals would end the program
  const typename Kernel::Sphere_3 sphere(point<Kernel>(ball.center), square);
  return CGAL::do_intersect(sphere, triangle<Kernel>(t)) || sphere.has_on_bounded_side(point<Kernel>(t.a));
}

using Double = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

}  // namespace

void add_cgal_triangles(MethodList& list) {
  list.push_back(triangle_method("cgal-double-distance", "CGAL's squared_distance of a triangle over plain doubles",
                                 by_distance<Double>));
  list.push_back(triangle_method("cgal-double-intersect",
                                 "CGAL's do_intersect of sphere and triangle over plain doubles",
                                 by_intersection<Double>));
  list.push_back(triangle_method("cgal-epick-distance", "CGAL's squared_distance over EPICK", by_distance<Epick>));
  list.push_back(triangle_method("cgal-epick-intersect", "CGAL's do_intersect over EPICK; r^2 is rounded",
                                 by_intersection<Epick>));
  list.push_back(triangle_method("cgal-epeck-distance", "CGAL's squared_distance over EPECK; loops are not lifted",
                                 by_distance<Epeck>));
  list.push_back(triangle_method("cgal-epeck-intersect", "CGAL's do_intersect over EPECK; loops are not lifted",
                                 by_intersection<Epeck>));
}

}  // namespace touchstone::methods
