// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "experiments/bench/cgal.h"

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
  using Kernel = CGAL::Simple_cartesian<double>;
  return CGAL::squared_distance(point<Kernel>(ball.center), triangle_of<Kernel>(triangle)) <= ball.radius * ball.radius;
}

bool epick_contact(const Ball& ball, const Triangle& triangle) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const Kernel::Sphere_3 sphere(point<Kernel>(ball.center), ball.radius * ball.radius);
  return sphere.has_on_bounded_side(point<Kernel>(triangle.a)) ||
         CGAL::do_intersect(sphere, triangle_of<Kernel>(triangle));
}

}  // namespace touchstone::bench::cgal
