// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/filtered.h"

#include "robust/exact/exact.h"

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

bool contact(const Ball& ball, const Triangle& triangle) {
  return exact::contact(ball, Polygon({triangle.a, triangle.b, triangle.c}));
}
bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts) {
  counts.count(Stage::Unlimited);
  return contact(ball, triangle);
}
void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches) {
  for (std::size_t i = 0; i < balls.size(); ++i) touches[i] = contact(balls[i], polygon);
}
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  for (std::size_t i = 0; i < triangles.size(); ++i) touches[i] = contact(ball, triangles[i]);
}

}  // namespace touchstone::filtered
