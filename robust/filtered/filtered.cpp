// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/filtered.h"

#include "geometry/detail/required.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/prepared.h"

namespace touchstone::filtered {
namespace {

NoCounts uncounted;

}  // namespace

bool contact(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.contact(required(ball), parts_of(polygon), uncounted);
}
Relation relation(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.relation(required(ball), parts_of(polygon), uncounted);
}
PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.plane_side(required(ball), parts_of(polygon), uncounted);
}
FootPlace foot(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.foot(required(ball), parts_of(polygon), uncounted);
}
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.edges_hit(required(ball), parts_of(polygon), uncounted);
}
Answer answer(const Ball& ball, const PreparedPolygon& polygon) {
  return engine().plain.answer(required(ball), parts_of(polygon), uncounted);
}

bool contact(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.contact(required(ball), parts_of(polygon), counts);
}
Relation relation(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.relation(required(ball), parts_of(polygon), counts);
}
PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.plane_side(required(ball), parts_of(polygon), counts);
}
FootPlace foot(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.foot(required(ball), parts_of(polygon), counts);
}
std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.edges_hit(required(ball), parts_of(polygon), counts);
}
Answer answer(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {
  return engine().counted.answer(required(ball), parts_of(polygon), counts);
}

bool contact(const Ball& ball, const Polygon& polygon) { return contact(ball, PreparedPolygon(polygon)); }
Relation relation(const Ball& ball, const Polygon& polygon) { return relation(ball, PreparedPolygon(polygon)); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return plane_side(ball, PreparedPolygon(polygon)); }
FootPlace foot(const Ball& ball, const Polygon& polygon) { return foot(ball, PreparedPolygon(polygon)); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return edges_hit(ball, PreparedPolygon(polygon));
}
Answer answer(const Ball& ball, const Polygon& polygon) { return answer(ball, PreparedPolygon(polygon)); }

bool contact(const Ball& ball, const Triangle& triangle) {
  return engine().plain.triangle_contact(question(required(ball), required(triangle)), uncounted);
}
bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts) {
  return engine().counted.triangle_contact(question(required(ball), required(triangle)), counts);
}

ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle) {
  return closest(engine().plain, required(center), required(triangle), uncounted);
}
ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle, StageCounts& counts) {
  return closest(engine().counted, required(center), required(triangle), counts);
}

void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches) {
  expect_equal_lengths("balls", balls.size(), "answers", touches.size());
  engine().balls_contact(balls, parts_of(polygon), touches);
}
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  expect_equal_lengths("triangles", triangles.size(), "answers", touches.size());
  engine().triangles_contact(ball, triangles, touches);
}

}  // namespace touchstone::filtered
