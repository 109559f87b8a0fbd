// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "experiments/studies/bench/cgal.h"

namespace touchstone::bench::cgal {
namespace {

template <class Kernel>
typename Kernel::Point_3 point(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

template <class Kernel>
typename Kernel::Triangle_3 triangle_of(const Triangle& t) {
  return {point<Kernel>(t.a), point<Kernel>(t.b), point<Kernel>(t.c)};
}

}  // namespace

bool cartesian_contact(const Ball& ball, const Triangle& triangle) {
  using Cartesian = CGAL::Simple_cartesian<double>;
  return CGAL::squared_distance(point<Cartesian>(ball.center), triangle_of<Cartesian>(triangle)) <=
         ball.radius * ball.radius;
}

bool epick_contact(const Ball& ball, const Triangle& triangle) {
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Epick::Sphere_3 sphere(point<Epick>(ball.center), ball.radius * ball.radius);
  return sphere.has_on_bounded_side(point<Epick>(triangle.a)) ||
         CGAL::do_intersect(sphere, triangle_of<Epick>(triangle));
}

}  // namespace touchstone::bench::cgal
