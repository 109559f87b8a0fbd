// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bindings/c/calls.h"
#include "bindings/c/shapes.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/validate.h"
#include "robust/filtered/motion.h"

using namespace touchstone;
using namespace touchstone::c;

namespace {

Polygon valid_polygon(const double* vertices, const size_t* loop_sizes, size_t loop_count) {
  const auto sizes = given(loop_sizes, loop_count, "the array of loop sizes");
  if (sizes.empty()) throw std::invalid_argument("a polygon has an outer loop, but the count of loops is 0");
  size_t vertex_count = 0;
  for (const size_t size : sizes)
    if (__builtin_add_overflow(vertex_count, size, &vertex_count))
      throw std::invalid_argument("the loops have more vertices than memory can hold");
  const double* next = given(vertices, vertex_count, "the array of vertices").data();
  std::vector<Loop> loops;
  for (const size_t size : sizes) {
    Loop& loop = loops.emplace_back();
    loop.reserve(size);
    for (size_t i = 0; i < size; ++i, next += 3) loop.emplace_back(next[0], next[1], next[2]);
  }
  Polygon polygon(loops.front(), {loops.begin() + 1, loops.end()});
  if (const auto fault = exact::validate(polygon)) throw Rejected(*fault);
  return polygon;
}

}  // namespace

touchstone_status touchstone_polygon_create(const double* vertices, const size_t* loop_sizes, size_t loop_count,
                                            touchstone_polygon** polygon, touchstone_error* error) {
  return created(polygon, error,
                 [&] { return std::make_unique<touchstone_polygon>(valid_polygon(vertices, loop_sizes, loop_count)); });
}

void touchstone_polygon_free(touchstone_polygon* polygon) { delete polygon; }

touchstone_status touchstone_polygon_complete(const touchstone_polygon* polygon, touchstone_error* error) {
  return guarded(error, [&] { given(polygon, "the polygon").prepared.complete(); });
}

touchstone_status touchstone_polygon_contact(const touchstone_polygon* polygon, const touchstone_ball* balls,
                                             size_t count, bool* touches, touchstone_error* error) {
  return guarded(error, [&] {
    const auto& asked = given(polygon, "the polygon").prepared;
    filtered::contact(balls_of(balls, count), asked, given(touches, count, "the array of answers"));
  });
}

touchstone_status touchstone_polygon_answer(const touchstone_polygon* polygon, const touchstone_ball* balls,
                                            size_t count, touchstone_answer* answers, touchstone_error* error) {
  return guarded(error, [&] {
    const auto& asked = given(polygon, "the polygon").prepared;
    answer_each(balls_of(balls, count), answers, [&](const Ball& ball) { return in_c(filtered::answer(ball, asked)); });
  });
}

touchstone_status touchstone_polygon_edges_hit(const touchstone_polygon* polygon, const touchstone_ball* ball,
                                               uint64_t* edges, size_t capacity, size_t* count,
                                               touchstone_error* error) {
  return guarded(error, [&] {
    const auto& asked = given(polygon, "the polygon").prepared;
    const auto out = given(edges, capacity, "the array of edges");
    size_t& found = given(count, "the pointer to the count");
    const auto hit = filtered::edges_hit(balls_of(ball, 1)[0], asked);
    std::copy_n(hit.begin(), std::min(hit.size(), capacity), out.begin());
    found = hit.size();
  });
}

touchstone_status touchstone_polygon_first_contact(const touchstone_polygon* polygon, const touchstone_motion* motions,
                                                   size_t count, touchstone_first_contact* contacts,
                                                   touchstone_error* error) {
  return guarded(error, [&] {
    const auto& asked = given(polygon, "the polygon").prepared;
    answer_each(motions_of(motions, count), contacts,
                [&](const Motion& motion) { return in_c(filtered::first_contact(motion, asked)); });
  });
}

touchstone_status touchstone_triangles_contact(const touchstone_ball* ball, const touchstone_triangle* triangles,
                                               size_t count, bool* touches, touchstone_error* error) {
  return guarded(error, [&] {
    filtered::contact(balls_of(ball, 1)[0], triangles_of(triangles, count),
                      given(touches, count, "the array of answers"));
  });
}

touchstone_status touchstone_triangles_closest(const double* center, const touchstone_triangle* triangles, size_t count,
                                               touchstone_closest_point* points, touchstone_error* error) {
  return guarded(error, [&] {
    const Eigen::Vector3d& asking = points_of(center, 1)[0];
    answer_each(triangles_of(triangles, count), points,
                [&](const Triangle& triangle) { return in_c(filtered::closest(asking, triangle)); });
  });
}

touchstone_status touchstone_triangles_first_contact(const touchstone_motion* motion,
                                                     const touchstone_triangle* triangles, size_t count,
                                                     touchstone_first_contact* contacts, touchstone_error* error) {
  return guarded(error, [&] {
    const Motion& asking = motions_of(motion, 1)[0];
    answer_each(triangles_of(triangles, count), contacts,
                [&](const Triangle& triangle) { return in_c(filtered::first_contact(asking, triangle)); });
  });
}
