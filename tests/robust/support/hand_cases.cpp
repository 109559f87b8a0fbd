// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/hand_cases.h"

#include <Eigen/Geometry>
#include <cmath>

#include "tests/robust/support/limits.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

constexpr auto InFront = PlaneSide::InFront, Behind = PlaneSide::Behind, Intersects = PlaneSide::Intersects;
constexpr auto Inside = PointLocation::Inside, Boundary = PointLocation::Boundary, Outside = PointLocation::Outside;
constexpr auto Separate = Relation::Separate, Touching = Relation::Touching, Overlapping = Relation::Overlapping;
constexpr bool kTangent = true, kNotTangent = false;

constexpr Feature kFace{Feature::Kind::Face, 0};
constexpr Feature edge(std::size_t i) { return {Feature::Kind::Edge, i}; }
constexpr Feature vertex(std::size_t i) { return {Feature::Kind::Vertex, i}; }

Loop square(double low, double high) { return {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}; }

const Polygon& triangle() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  return polygon;
}
const Polygon& letter_l() {
  static const Polygon polygon({{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}});
  return polygon;
}
const Polygon& letter_u() {
  static const Polygon polygon(
      {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {4, 6, 0}, {4, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}});
  return polygon;
}
/// Edges 0 to 3, 4 to 7 and 8 to 11: a square, its hole, an island in the hole.
const Polygon& island() {
  static const Polygon polygon(square(0, 12), {square(2, 10), square(4, 8)});
  return polygon;
}
/// Vertex 4 of the hole points into it.
const Polygon& notched_hole() {
  static const Polygon polygon(square(-2, 10), {{{4, 5, 0}, {1, 7, 0}, {1, 1, 0}, {7, 1, 0}, {7, 7, 0}}});
  return polygon;
}

std::vector<HandCase> triangle_cases() {
  const Polygon& t = triangle();
  return {
      {{"touches the face", {{1, 1, 2}, 2}, t}, {Intersects, kTangent, Inside, {}, Touching, kFace, {1, 1, 0}, 2, 0}},
      {{"in front", {{1, 1, 2}, 1}, t}, {InFront, kNotTangent, Inside, {}, Separate, kFace, {1, 1, 0}, 2, 0}},
      {{"behind", {{1, 1, -2}, 1}, t}, {Behind, kNotTangent, Inside, {}, Separate, kFace, {1, 1, 0}, 2, 0}},
      {{"overlaps face and edges", {{1, 1, -2}, 3}, t},
       {Intersects, kNotTangent, Inside, {0, 1, 2}, Overlapping, kFace, {1, 1, 0}, 2, 0}},
      {{"touches an edge (3-4-5)", {{2, -3, 4}, 5}, t},
       {Intersects, kNotTangent, Outside, {0}, Touching, edge(0), {2, 0, 0}, 5, 0}},
      {{"touches a vertex (1-2-2-3)", {{-2, -1, 2}, 3}, t},
       {Intersects, kNotTangent, Outside, {0, 2}, Touching, vertex(0), {0, 0, 0}, 3, 0}},
      {{"touches the plane, far from the triangle", {{8, 8, 3}, 3}, t},
       {Intersects, kTangent, Outside, {}, Separate, edge(1), {2, 2, 0}, 9, 0}},
      {{"straight above an edge", {{2, 0, 3}, 3}, t},
       {Intersects, kTangent, Boundary, {0}, Touching, edge(0), {2, 0, 0}, 3, 0}},
      {{"straight above the first end of an edge", {{0, -3, 0}, 3}, t},
       {Intersects, kNotTangent, Outside, {0, 2}, Touching, vertex(0), {0, 0, 0}, 3, 0}},
      {{"straight above the last end of an edge", {{4, -3, 0}, 3}, t},
       {Intersects, kNotTangent, Outside, {0, 1}, Touching, vertex(1), {4, 0, 0}, 3, 0}},
      {{"a point on a vertex", {{4, 0, 0}, 0}, t},
       {Intersects, kTangent, Boundary, {0, 1}, Touching, vertex(1), {4, 0, 0}, 0, 0}},
      {{"a point at minus zero", {{-0.0, -0.0, -0.0}, -0.0}, t},
       {Intersects, kTangent, Boundary, {0, 2}, Touching, vertex(0), {0, 0, 0}, 0, 0}},
      {{"a point on an edge", {{2, 2, 0}, 0}, t},
       {Intersects, kTangent, Boundary, {1}, Touching, edge(1), {2, 2, 0}, 0, 0}},
      {{"a point on the face", {{1, 1, 0}, 0}, t},
       {Intersects, kTangent, Inside, {}, Touching, kFace, {1, 1, 0}, 0, 0}},
      {{"a point beside it", {{5, 5, 0}, 0}, t},
       {Intersects, kTangent, Outside, {}, Separate, edge(1), {2, 2, 0}, std::sqrt(18.0), 0}},
      {{"a point on the line of an edge, beyond it", {{-3, 0, 0}, 1}, t},
       {Intersects, kNotTangent, Outside, {}, Separate, vertex(0), {0, 0, 0}, 3, 0}},
      {{"an irrational distance to an edge, in contact", {{3, 3, 0}, 2}, t},
       {Intersects, kNotTangent, Outside, {1}, Overlapping, edge(1), {2, 2, 0}, std::sqrt(2.0), 0}},
  };
}

std::vector<HandCase> letter_cases() {
  const Polygon &l = letter_l(), &u = letter_u();
  return {
      {{"a tie of edges in the notch of an L, missed", {{4, 4, 1}, 2}, l},
       {Intersects, kNotTangent, Outside, {}, Separate, edge(2), {4, 2, 0}, std::sqrt(5.0), 0}},
      {{"hits edges in the notch of an L, two of them at their ends", {{4, 4, 1}, 3}, l},
       {Intersects, kNotTangent, Outside, {1, 2, 3, 4}, Overlapping, edge(2), {4, 2, 0}, std::sqrt(5.0), 0}},
      {{"level with the vertices of an L", {{1, 2, 0}, 1}, l},
       {Intersects, kNotTangent, Inside, {2, 3, 5}, Overlapping, kFace, {1, 2, 0}, 0, 0}},
      {{"level with an edge of an L, beside it", {{-2, 2, 0}, 1}, l},
       {Intersects, kNotTangent, Outside, {}, Separate, edge(5), {0, 2, 0}, 2, 0}},
      {{"reflex vertex straight below", {{2, 2, 1}, 1}, l},
       {Intersects, kTangent, Boundary, {2, 3}, Touching, vertex(3), {2, 2, 0}, 1, 0}},
      {{"a tie of edges in a U: the lowest", {{3, 4, 0}, 1}, u},
       {Intersects, kNotTangent, Outside, {3, 5}, Touching, edge(3), {4, 4, 0}, 1, 0}},
      {{"a tie of vertices of a U: the lowest", {{3, 9, 0}, 1}, u},
       {Intersects, kNotTangent, Outside, {}, Separate, vertex(3), {4, 6, 0}, std::sqrt(10.0), 0}},
      {{"inside a leg of a U", {{5, 4, 2}, 2}, u},
       {Intersects, kTangent, Inside, {}, Touching, kFace, {5, 4, 0}, 2, 0}},
  };
}

std::vector<HandCase> hole_cases() {
  const Polygon &p = island(), &n = notched_hole();
  return {
      {{"foot in a hole, a tie of hole and island", {{3, 6, 0}, 1}, p},
       {Intersects, kNotTangent, Outside, {7, 11}, Touching, edge(7), {2, 6, 0}, 1, 0}},
      {{"foot on an island", {{6, 6, 3}, 3}, p}, {Intersects, kTangent, Inside, {}, Touching, kFace, {6, 6, 0}, 3, 0}},
      {{"foot on the rim, edges of two loops touched", {{1, 6, 0}, 1}, p},
       {Intersects, kNotTangent, Inside, {3, 7}, Overlapping, kFace, {1, 6, 0}, 0, 0}},
      {{"foot on the edge of a hole", {{2, 6, 2}, 1}, p},
       {InFront, kNotTangent, Boundary, {}, Separate, edge(7), {2, 6, 0}, 2, 0}},
      {{"foot on a vertex of an island", {{8, 8, -2}, 2}, p},
       {Intersects, kTangent, Boundary, {9, 10}, Touching, vertex(10), {8, 8, 0}, 2, 0}},
      {{"a ball that falls through a hole", {{3, 3, 1}, 1}, p},
       {Intersects, kTangent, Outside, {}, Separate, edge(4), {3, 2, 0}, std::sqrt(2.0), 0}},
      {{"a tie of a vertex and a later edge: the edge", {{4, 3, 0}, 2}, n},
       {Intersects, kNotTangent, Outside, {4, 6, 8}, Touching, edge(6), {4, 1, 0}, 2, 0}},
  };
}

const Polygon& square() {
  static const Polygon polygon(square(0, 4));
  return polygon;
}
const Polygon& narrow_u() {
  static const Polygon polygon(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  return polygon;
}
/// Edges 4 to 7 bound the hole.
const Polygon& frame() {
  static const Polygon polygon(square(0, 4), {square(1, 3)});
  return polygon;
}
/// Lifted onto the plane z = 1 - x/2 + y/2, at heights 1, -1, 1, 3.
const Polygon& warped() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 4}});
  return polygon;
}

/// Two triangles that share the point (3, 3): vertices 2 and 5.
const Polygon& pinched() {
  static const Polygon polygon({{0, 0, 0}, {6, 0, 0}, {3, 3, 0}, {6, 6, 0}, {0, 6, 0}, {3, 3, 0}});
  return polygon;
}
/// A hole that touches edge 3 in its vertex 4.
const Polygon& touching_hole() {
  static const Polygon polygon(square(0, 8), {{{0, 4, 0}, {4, 1, 0}, {4, 7, 0}}});
  return polygon;
}

std::vector<HandCase> touching_cases() {
  const double root_of_2 = std::sqrt(2.0);
  return {
      {{"above the point in which a loop touches itself", {{3, 3, 2}, 2}, pinched()},
       {Intersects, kTangent, Boundary, {1, 2, 4, 5}, Touching, vertex(2), {3, 3, 0}, 2, 0}},
      {{"beside the point in which a loop touches itself", {{5, 3, 0}, 1}, pinched()},
       {Intersects, kNotTangent, Outside, {}, Separate, edge(1), {4, 2, 0}, root_of_2, 0}},
      {{"beyond the point in which a loop touches itself", {{1, 3, 0}, 2}, pinched()},
       {Intersects, kNotTangent, Outside, {1, 2, 4, 5}, Overlapping, edge(4), {2, 4, 0}, root_of_2, 0}},
      {{"above the triangle behind the point in which a loop touches itself", {{3, 4, 2}, 1}, pinched()},
       {InFront, kNotTangent, Inside, {}, Separate, kFace, {3, 4, 0}, 2, 0}},
      {{"above the point in which a hole touches the outline", {{0, 4, 1}, 1}, touching_hole()},
       {Intersects, kTangent, Boundary, {3, 4, 6}, Touching, edge(3), {0, 4, 0}, 1, 0}},
      {{"in a hole that touches the outline", {{3, 4, 0}, 1}, touching_hole()},
       {Intersects, kNotTangent, Outside, {5}, Touching, edge(5), {4, 4, 0}, 1, 0}},
  };
}

constexpr bool kMomentary = true, kStays = false;

/// Returns the doubles nearest to the direction from the point to the centre, or to the front if they coincide:
/// coordinates in small integers, of which a long double rounds no midpoint.
Eigen::Vector3d direction(const Eigen::Vector3d& center, const Eigen::Vector3d& point, const Polygon& polygon) {
  Eigen::Matrix<long double, 3, 1> away = (center - point).cast<long double>();
  if (away.isZero(0))
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
      away += polygon.vertex(i).cross(polygon.vertex(polygon.next(i))).cast<long double>();
  return (away / std::sqrt(away.squaredNorm())).cast<double>();
}

double depth(const Ball& ball, const Eigen::Vector3d& point) {
  return static_cast<double>(ball.radius - std::sqrt((ball.center - point).cast<long double>().squaredNorm()));
}

void add_normal(HandCase& c) {
  c.expected.contact_normal = direction(c.given.ball.center, c.expected.point, c.given.polygon);
  c.expected.depth = depth(c.given.ball, c.expected.point);
}

/// A centre at time t in small integers, or one that is on the point, and came from the front or along the plane.
void add_normal(MovingHandCase& c) {
  const Eigen::Vector3d& center = c.given.motion.ball.center;
  FirstContact& first = c.expected;
  if (!first.contact()) return;
  const Eigen::Vector3d at_time = center + first.time * (c.given.motion.to - center);
  if (first.contact_normal.isZero(0)) first.contact_normal = direction(at_time, first.point, c.given.polygon);
  if (first.kind == FirstContactKind::Start) first.depth = depth(c.given.motion.ball, first.point);
}

FirstContact start(Feature feature, const Eigen::Vector3d& point) {
  return {FirstContactKind::Start, 0, false, feature, point};
}
FirstContact way(double time, bool momentary, Feature feature, const Eigen::Vector3d& point) {
  return {FirstContactKind::Way, time, momentary, feature, point};
}

}  // namespace

const std::vector<HandCase>& hand_cases() {
  static const std::vector<HandCase> all = [] {
    std::vector<HandCase> cases = triangle_cases();
    for (const auto& more : {letter_cases(), hole_cases(), touching_cases()})
      cases.insert(cases.end(), more.begin(), more.end());
    for (HandCase& c : cases) add_normal(c);
    return cases;
  }();
  return all;
}

const std::vector<HandCase>& lifted_cases() {
  // N = (32, 0, 32), plane x + z = 0: along x vertex 0 comes to (0, 0, 0), along z it would come to (1, 0, -1).
  static const Polygon tie({{1, 0, 0}, {3, 0, -4}, {5, 4, -4}, {-1, 4, 0}});
  static const Polygon with_hole(square(0, 8), {{{2, 2, 5}, {4, 2, 5}, {4, 4, -3}}});
  static const std::vector<HandCase> all = [] {
    std::vector<HandCase> cases{
        {{"a hole is lifted onto the plane of the outer loop, whose mean alone counts", {{3, 2, 1}, 1}, with_hole},
         {Intersects, kTangent, Boundary, {4}, Touching, edge(4), {3, 2, 0}, 1, 5}},
        {{"the lowest axis is dropped on a tie", {{0, -3, 0}, 3}, tie},
         {Intersects, kNotTangent, Outside, {0, 3}, Touching, vertex(0), {0, 0, 0}, 3, 1}},
    };
    for (HandCase& c : cases) add_normal(c);
    return cases;
  }();
  return all;
}

HandCase turned(HandCase original, int times) {
  const PointMap turn = [times](const Eigen::Vector3d& v) {
    Eigen::Vector3d image;
    for (int k = 0; k < 3; ++k) image[(k + times) % 3] = v[k];
    return image;
  };
  original.given = moved(original.given, turn);
  original.expected.point = turn(original.expected.point);
  original.expected.contact_normal = turn(original.expected.contact_normal);
  return original;
}

const std::vector<MovingHandCase>& moving_hand_cases() {
  static const std::vector<MovingHandCase> all = [] {
    std::vector<MovingHandCase> cases{
        {{"falls on the face", {{{2, 2, 5}, 1}, {2, 2, -5}}, square()}, way(0.4, kStays, kFace, {2, 2, 0})},
        {{"falls on the back", {{{2, 1, -5}, 1}, {2, 1, 5}}, square()}, way(0.4, kStays, kFace, {2, 1, 0})},
        {{"stops short of the face", {{{2, 2, 5}, 1}, {2, 2, 1.5}}, square()}, {}},
        {{"moves away", {{{2, 2, 2}, 1}, {2, 2, 5}}, square()}, {}},
        {{"falls beside the square", {{{6, 2, 5}, 1}, {6, 2, -5}}, square()}, {}},
        {{"ends in contact", {{{2, 2, 3}, 1}, {2, 2, 1}}, square()}, way(1, kStays, kFace, {2, 2, 0})},
        {{"starts in contact and leaves", {{{2, 2, 1}, 1}, {2, 2, 9}}, square()}, start(kFace, {2, 2, 0})},
        {{"starts inside", {{{2, 2, 0}, 1}, {2, 2, 0}}, square()}, start(kFace, {2, 2, 0})},
        {{"starts at a vertex", {{{-3, 0, 4}, 5}, {9, 9, 9}}, square()}, start(vertex(0), {0, 0, 0})},
        {{"rests in contact", {{{2, -1, 0}, 1}, {2, -1, 0}}, square()}, start(edge(0), {2, 0, 0})},
        {{"rests apart", {{{2, -2, 0}, 1}, {2, -2, 0}}, square()}, {}},
        {{"a point passes through the face", {{{2, 2, 4}, 0}, {2, 2, -4}}, square()},
         way(0.5, kMomentary, kFace, {2, 2, 0})},
        {{"a point passes through an edge", {{{4, 2, 4}, 0}, {4, 2, -4}}, square()},
         way(0.5, kMomentary, edge(1), {4, 2, 0})},
        {{"a point passes through a vertex", {{{4, 4, 4}, 0}, {4, 4, -4}}, square()},
         way(0.5, kMomentary, vertex(2), {4, 4, 0})},
        {{"a point enters the face in its plane", {{{-4, 2, 0}, 0}, {4, 2, 0}}, square()},
         way(0.5, kStays, edge(3), {0, 2, 0})},
        {{"a point enters along an edge", {{{-4, 0, 0}, 0}, {4, 0, 0}}, square()},
         way(0.5, kStays, vertex(0), {0, 0, 0})},
        {{"a point passes a corner in its plane", {{{-4, 4, 0}, 0}, {4, -4, 0}}, square()},
         way(0.5, kMomentary, vertex(0), {0, 0, 0})},
        {{"a point passes through a reflex vertex", {{{2, 2, 1}, 0}, {2, 2, -3}}, letter_l()},
         way(0.25, kMomentary, vertex(3), {2, 2, 0})},
        {{"grazes an edge", {{{-1, 2, -4}, 1}, {-1, 2, 4}}, square()}, way(0.5, kMomentary, edge(3), {0, 2, 0})},
        {{"grazes an edge at a slant", {{{-1, 1, -4}, 1}, {-1, 3, 4}}, square()},
         way(0.5, kMomentary, edge(3), {0, 2, 0})},
        {{"grazes a vertex", {{{-3, -4, -8}, 5}, {-3, -4, 8}}, square()}, way(0.5, kMomentary, vertex(0), {0, 0, 0})},
        {{"grazes a vertex at the end", {{{-3, -4, -8}, 5}, {-3, -4, 0}}, square()},
         way(1, kMomentary, vertex(0), {0, 0, 0})},
        {{"misses a vertex", {{{-3, -4, -8}, 4.999}, {-3, -4, 8}}, square()}, {}},
        {{"slides over an edge onto the face", {{{-4, 2, 1}, 1}, {4, 2, 1}}, square()},
         way(0.5, kStays, edge(3), {0, 2, 0})},
        {{"slides over a vertex onto the face", {{{-4, -4, 1}, 1}, {4, 4, 1}}, square()},
         way(0.5, kStays, vertex(0), {0, 0, 0})},
        {{"slides over a reflex vertex onto the face", {{{6, 6, 1}, 1}, {-2, -2, 1}}, letter_l()},
         way(0.5, kStays, vertex(3), {2, 2, 0})},
        {{"grazes a corner above it", {{{-4, 4, 1}, 1}, {4, -4, 1}}, square()},
         way(0.5, kMomentary, vertex(0), {0, 0, 0})},
        {{"slides along an edge above it", {{{-4, 0, 1}, 1}, {4, 0, 1}}, square()},
         way(0.5, kStays, vertex(0), {0, 0, 0})},
        {{"slides along an edge beside it", {{{-4, -1, 0}, 1}, {4, -1, 0}}, square()},
         way(0.5, kStays, vertex(0), {0, 0, 0})},
        {{"slides along an edge backwards", {{{8, -1, 0}, 1}, {0, -1, 0}}, square()},
         way(0.5, kStays, vertex(1), {4, 0, 0})},
        {{"slides above the face across a hole", {{{2, -2, 1}, 1}, {2, 6, 1}}, frame()},
         way(0.25, kStays, edge(0), {2, 0, 0})},
        {{"slides over the point in which a loop touches itself", {{{-1, 3, 1}, 1}, {7, 3, 1}}, pinched()},
         way(0.5, kMomentary, vertex(2), {3, 3, 0})},
        {{"slides through that point from face to face", {{{3, -3, 1}, 1}, {3, 9, 1}}, pinched()},
         way(0.25, kStays, edge(0), {3, 0, 0})},
        {{"slides over an edge into a hole that touches it", {{{-4, 4, 1}, 1}, {4, 4, 1}}, touching_hole()},
         way(0.5, kMomentary, edge(3), {0, 4, 0})},
        {{"slides over that point past the hole", {{{-2, 0, 1}, 1}, {2, 8, 1}}, touching_hole()},
         way(0.5, kStays, edge(3), {0, 4, 0})},
        {{"fits a hole just so", {{{2, 2, 4}, 1}, {2, 2, -4}}, frame()}, way(0.5, kMomentary, edge(4), {2, 1, 0})},
        {{"passes through a hole", {{{2, 2, 4}, 0.999}, {2, 2, -4}}, frame()}, {}},
        {{"fits between the fingers just so", {{{1.5, 5, 0}, 0.5}, {1.5, 1, 0}}, narrow_u()},
         way(0.5, kStays, vertex(3), {2, 3, 0})},
        {{"passes between the fingers just so", {{{1.5, 2, 4}, 0.5}, {1.5, 2, -4}}, narrow_u()},
         way(0.5, kMomentary, edge(3), {2, 2, 0})},
        {{"a point passes through a lifted face", {{{2, 2, 5}, 0}, {2, 2, -3}}, warped()},
         way(0.5, kMomentary, kFace, {2, 2, 1})},
        {{"grazes an edge and runs into the next", {{{7, 3, -4}, 1}, {-1, 3, 4}}, letter_l()},
         way(0.5, kStays, edge(2), {3, 2, 0})},
        {{"an irrational time", {{{-3, -1, 0}, 2}, {1, -1, 0}}, square()},
         {FirstContactKind::Way,
          0.3169872981077807,
          kStays,
          vertex(0),
          {0, 0, 0},                           // (3 - sqrt 3) / 4
          {-0x1.bb67ae8584caap-1, -0.5, 0}}},  // sqrt 3 / 2
        {{"a time that rounds to 0", {{{2, 2, 1 + 0x1p-52}, 1}, {2, 2, -kMax}}, square()},
         way(0, kStays, kFace, {2, 2, 0})},
        {{"a time that rounds to 1", {{{2, 2, 0x1p60}, 1}, {2, 2, 0}}, square()}, way(1, kStays, kFace, {2, 2, 0})},
    };
    for (MovingHandCase& c : cases) add_normal(c);
    return cases;
  }();
  return all;
}

}  // namespace touchstone::contact_tests
