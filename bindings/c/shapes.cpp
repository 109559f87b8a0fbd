// SPDX-License-Identifier: Apache-2.0
#include "bindings/c/shapes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "bindings/c/calls.h"
#include "geometry/shapes/rejection.h"
#include "robust/scene/posing.h"

namespace touchstone::c {
namespace {

template <class Of, class In>
constexpr bool kSameLayout = sizeof(Of) == sizeof(In) && alignof(Of) == alignof(In) && std::is_standard_layout_v<Of>;
static_assert(kSameLayout<Ball, touchstone_ball> && offsetof(Ball, radius) == offsetof(touchstone_ball, radius));
static_assert(kSameLayout<Motion, touchstone_motion> && offsetof(Motion, to) == offsetof(touchstone_motion, to));
static_assert(kSameLayout<Triangle, touchstone_triangle> && offsetof(Triangle, c) == 6 * sizeof(double));
static_assert(kSameLayout<Eigen::Vector3d, double[3]>);

// The last enumerators, of enumerations without gaps.
static_assert(in_c(PlaneSide::Intersects) == TOUCHSTONE_INTERSECTS &&
              in_c(Relation::Overlapping) == TOUCHSTONE_OVERLAPPING &&
              in_c(PointLocation::Outside) == TOUCHSTONE_OUTSIDE && in_c(Feature::Kind::Vertex) == TOUCHSTONE_VERTEX &&
              in_c(FirstContactKind::None) == TOUCHSTONE_NEVER &&
              in_c(RejectionCode::HoleOutside) == TOUCHSTONE_HOLE_OUTSIDE);

/// Throws the rejection, whose message begins with the element if there are several.
[[noreturn]] void reject(const char* element, std::size_t i, std::size_t count, const Rejection& fault) {
  throw Rejected({fault.code, (count == 1 ? "" : element + std::to_string(i) + ": ") + fault.message});
}

/// Returns whether a number is finite, by its bits: in any state of the floating-point unit, and without a flag.
bool is_finite(double number) { return std::bit_cast<std::uint64_t>(number) << 1U < 0xFFE0000000000000U; }

/// Returns the balls or motions. Throws Rejected for the first one with a fault. Nearly all have none at first sight.
template <class Shape>
std::span<const Shape> without_fault(const char* element, std::span<const Shape> shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto* numbers = reinterpret_cast<const double*>(&shapes[i]);  // the fourth is the radius
    if (!std::signbit(numbers[3]) && std::all_of(numbers, numbers + sizeof(Shape) / sizeof(double), is_finite))
      continue;
    if (const auto fault = find_fault(shapes[i])) reject(element, i, shapes.size(), *fault);
  }
  return shapes;
}

/// Returns the array as one of C++.
template <class Of, class In>
std::span<const Of> as(std::span<const In> elements) {
  return {reinterpret_cast<const Of*>(elements.data()), elements.size()};
}

}  // namespace

std::span<const Ball> balls_of(const touchstone_ball* balls, std::size_t count) {
  return without_fault("ball ", as<Ball>(given(balls, count, "the array of balls")));
}

std::span<const Motion> motions_of(const touchstone_motion* motions, std::size_t count) {
  return without_fault("motion ", as<Motion>(given(motions, count, "the array of motions")));
}

std::span<const Eigen::Vector3d> points_of(const double* points, std::size_t count) {
  given(points, count, "the array of points");
  const std::span all(reinterpret_cast<const Eigen::Vector3d*>(points), count);
  for (std::size_t i = 0; i < count; ++i)
    if (!std::all_of(all[i].begin(), all[i].end(), is_finite))
      reject("point ", i, count, {RejectionCode::NotFinite, "a coordinate of the point is not finite"});
  return all;
}

std::span<const Triangle> triangles_of(const touchstone_triangle* triangles, std::size_t count) {
  const auto all = as<Triangle>(given(triangles, count, "the array of triangles"));
  expect_valid("triangle ", all, Degenerate::AsSegments);
  return all;
}

void expect_valid(const char* element, std::span<const Triangle> triangles, Degenerate degenerate) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    try {
      scene::expect_valid(triangles[i], degenerate);
    } catch (const Rejected& rejected) {
      reject(element, i, triangles.size(), rejected.rejection());
    }
  }
}

std::vector<Triangle> triangles_of(const touchstone_mesh& mesh) {
  // Through a quotient, as the product may not fit.
  if (mesh.corners == nullptr && (mesh.vertex_count % 3 != 0 || mesh.vertex_count / 3 != mesh.triangle_count))
    throw std::invalid_argument("without corners, " + std::to_string(mesh.triangle_count) +
                                " triangles have three vertices each, not " + std::to_string(mesh.vertex_count) +
                                " in all");
  given(mesh.vertices, mesh.vertex_count, "the array of vertices");
  const auto* vertices = reinterpret_cast<const Eigen::Vector3d*>(mesh.vertices);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangle_count);
  for (std::size_t face = 0; face < mesh.triangle_count; ++face) {
    Triangle triangle;
    Eigen::Vector3d* const corners[] = {&triangle.a, &triangle.b, &triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t vertex = mesh.corners == nullptr ? 3 * face + i : mesh.corners[3 * face + i];
      if (vertex >= mesh.vertex_count)
        throw std::invalid_argument("face " + std::to_string(face) + " has vertex " + std::to_string(vertex) +
                                    " of a mesh with " + std::to_string(mesh.vertex_count));
      *corners[i] = vertices[vertex];
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

touchstone_feature in_c(const Feature& feature) { return {feature.index, in_c(feature.kind), 0}; }

touchstone_answer in_c(const Answer& answer) {
  const auto &p = answer.point, &n = answer.contact_normal;
  return {in_c(answer.plane), answer.plane_tangent, in_c(answer.foot),  in_c(answer.relation), in_c(answer.nearest),
          {p[0], p[1], p[2]}, answer.distance,      {n[0], n[1], n[2]}, answer.depth,          answer.off_plane};
}

touchstone_closest_point in_c(const ClosestPoint& closest) {
  const auto &p = closest.point, &n = closest.contact_normal;
  return {in_c(closest.feature), {p[0], p[1], p[2]}, closest.distance, {n[0], n[1], n[2]}};
}

touchstone_first_contact in_c(const FirstContact& contact) {
  const auto &p = contact.point, &n = contact.contact_normal;
  return {in_c(contact.kind), contact.momentary,  contact.time, in_c(contact.feature),
          {p[0], p[1], p[2]}, {n[0], n[1], n[2]}, contact.depth};
}

}  // namespace touchstone::c
