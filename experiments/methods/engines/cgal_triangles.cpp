// SPDX-License-Identifier: GPL-3.0-or-later
// All that asks CGAL's kernels about triangles, because each file that includes them takes 6 s longer to compile.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/triangle_contacts.h"

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
bool is_within(const typename Kernel::Point_3& center, const typename Kernel::Triangle_3& triangle,
               const typename Kernel::FT& radius) {
  return CGAL::squared_distance(center, triangle) <= radius * radius;
}

template <class Kernel>
std::optional<bool> by_distance(const Ball& ball, const Triangle& t) {
  return is_within<Kernel>(point<Kernel>(ball.center), triangle<Kernel>(t), ball.radius);
}

/// CGAL has no distance of a segment from a triangle: takes it from those of its ends and of the edges. CGAL has no
/// time.
template <class Kernel>
std::optional<bool> by_distance_of_way(const Motion& motion, const Triangle& t) {
  const auto from = point<Kernel>(motion.ball.center), to = point<Kernel>(motion.to);
  const auto face = triangle<Kernel>(t);
  const typename Kernel::FT radius = motion.ball.radius;
  if (is_within<Kernel>(from, face, radius) || is_within<Kernel>(to, face, radius)) return true;
  if (from == to) return false;
  const typename Kernel::Segment_3 way(from, to);
  if (CGAL::do_intersect(way, face)) return true;
  for (int i = 0; i < 3; ++i)
    if (CGAL::squared_distance(way, typename Kernel::Segment_3(face.vertex(i), face.vertex(i + 1))) <= radius * radius)
      return true;
  return false;
}

template <class Kernel>
bool compares_within(const Ball& ball, const Triangle& t) {
  const typename Kernel::FT radius = ball.radius;
  return Kernel().compare_squared_distance_3_object()(point<Kernel>(ball.center), triangle<Kernel>(t),
                                                      typename Kernel::FT(radius * radius)) != CGAL::LARGER;
}

/// CGAL's sphere is a surface: it does not intersect a triangle in its interior. (From CGAL 6.2 on it is one beside boxes
/// too, where it was a ball.) The second test is right with either meaning.
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

/// The contract asks about lifted vertices, which are those of the triangles only if all lie in one plane. An exact
/// answer about other triangles would be one to another question.
bool lie_in_one_plane(const std::vector<Triangle>& triangles) {
  const auto corners = [](const Triangle& t) {
    return std::array{point<Epick>(t.a), point<Epick>(t.b), point<Epick>(t.c)};
  };
  const auto plane = std::ranges::find_if(triangles, [&](const Triangle& t) {
    const auto [a, b, c] = corners(t);
    return !CGAL::collinear(a, b, c);
  });
  return plane != triangles.end() && std::ranges::all_of(triangles, [&, of = corners(*plane)](const Triangle& t) {
           return std::ranges::all_of(corners(t),
                                      [&](const Epick::Point_3& p) { return CGAL::coplanar(of[0], of[1], of[2], p); });
         });
}

}  // namespace

void add_cgal_triangles(MethodList& list) {
  list.push_back(triangle_method("cgal-double-distance", "CGAL's squared_distance of a triangle over plain doubles",
                                 by_distance<Double>, by_distance_of_way<Double>));
  list.push_back(triangle_method("cgal-double-intersect",
                                 "CGAL's do_intersect of sphere and triangle over plain doubles",
                                 by_intersection<Double>));
  list.push_back(triangle_method("cgal-epick-distance", "CGAL's squared_distance over EPICK", by_distance<Epick>,
                                 by_distance_of_way<Epick>));
  list.push_back(triangle_method("cgal-epick-intersect", "CGAL's do_intersect over EPICK; r^2 is rounded",
                                 by_intersection<Epick>));
  list.push_back(triangle_method("cgal-epeck-distance",
                                 "CGAL's squared_distance over EPECK; unsure of loops that lifting moves",
                                 by_distance<Epeck>, by_distance_of_way<Epeck>, lie_in_one_plane));
  list.push_back(triangle_method("cgal-epeck-intersect",
                                 "CGAL's do_intersect over EPECK; unsure of loops that lifting moves",
                                 by_intersection<Epeck>, nullptr, lie_in_one_plane));
}

namespace cgal {

bool epick_comparison(const Ball& ball, const Triangle& t) { return compares_within<Epick>(ball, t); }
bool epeck_comparison(const Ball& ball, const Triangle& t) { return compares_within<Epeck>(ball, t); }

bool epick_contact(const Ball& ball, const Triangle& t) {
  const Epick::Sphere_3 sphere(point<Epick>(ball.center), ball.radius * ball.radius);
  return sphere.has_on_bounded_side(point<Epick>(t.a)) || CGAL::do_intersect(sphere, triangle<Epick>(t));
}

bool epeck_contact(const Ball& ball, const Triangle& t) {
  return is_within<Epeck>(point<Epeck>(ball.center), triangle<Epeck>(t), ball.radius);
}

}  // namespace cgal

}  // namespace touchstone::methods
