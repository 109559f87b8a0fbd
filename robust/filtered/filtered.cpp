// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/filtered.h"

#include "robust/exact/exact.h"
#include "robust/filtered/engine.h"

// TEMPORARY skeleton: everything is asked of exact.
namespace touchstone::filtered {

struct PreparedPolygon::Parts {
  exact::PreparedPolygon exact;
};
PreparedPolygon::PreparedPolygon(const Polygon& polygon)
    : parts_(std::make_unique<const Parts>(Parts{exact::PreparedPolygon(polygon)})) {}
PreparedPolygon::PreparedPolygon(PreparedPolygon&&) noexcept = default;
PreparedPolygon& PreparedPolygon::operator=(PreparedPolygon&&) noexcept = default;
PreparedPolygon::~PreparedPolygon() = default;

#define QUESTION(type, name)                                                              \
  type name(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts) {      \
    counts.count(Stage::Unlimited);                                                       \
    return exact::name(ball, polygon.parts().exact);                                      \
  }                                                                                       \
  type name(const Ball& ball, const PreparedPolygon& polygon) {                           \
    return exact::name(ball, polygon.parts().exact);                                      \
  }                                                                                       \
  type name(const Ball& ball, const Polygon& polygon) { return exact::name(ball, polygon); }
QUESTION(bool, contact)
QUESTION(Relation, relation)
QUESTION(PlaneSide, plane_side)
QUESTION(FootPlace, foot)
QUESTION(std::vector<std::size_t>, edges_hit)
QUESTION(Answer, answer)

namespace {
TriangleQuestion question(const Ball& ball, const Triangle& triangle) {
  TriangleQuestion q;
  const Eigen::Vector3d* const vertices[] = {&triangle.a, &triangle.b, &triangle.c};
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) q.vertex[i][axis] = (*vertices[i])[axis];
  for (int axis = 0; axis < 3; ++axis) q.center[axis] = ball.center[axis];
  q.radius = ball.radius;
  return q;
}
}  // namespace
bool contact(const Ball& ball, const Triangle& triangle) {
  return engine().triangle_contact(question(ball, triangle));
}
bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts) {
  return engine().counted_triangle_contact(question(ball, triangle), counts);
}
void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches) {
  for (std::size_t i = 0; i < balls.size(); ++i) touches[i] = contact(balls[i], polygon);
}
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  for (std::size_t i = 0; i < triangles.size(); ++i) touches[i] = contact(ball, triangles[i]);
}

}  // namespace touchstone::filtered
