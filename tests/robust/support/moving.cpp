// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/moving.h"

#include <cmath>
#include <limits>
#include <ostream>
#include <sstream>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone {

void PrintTo(const FirstContact& first, std::ostream* out) { showValue(first, *out); }

void showValue(const FirstContact& first, std::ostream& out) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << to_string(first.kind) << " at " << first.time << (first.momentary ? ", momentary" : "") << "; "
      << to_string(first.feature.kind) << ' ' << first.feature.index << "; point (" << first.point.x() << ", "
      << first.point.y() << ", " << first.point.z() << ")";
}

namespace contact_tests {
namespace {

/// Half of a way through the centre.
Eigen::Vector3d draw_half_way(const Case& c) {
  using rc::gen::inRange;
  const Polygon& polygon = c.polygon;
  const std::size_t i = *inRange<std::size_t>(0, polygon.vertex_count());
  const Eigen::Vector3d from = c.ball.center - polygon.vertex(i);
  const double size = std::exp2(std::ilogb(extent(polygon)) - 2), sign = *rc::gen::element(-1, 1);
  const int axis = *inRange(0, 3), j = (axis + 1) % 3, k = (axis + 2) % 3;
  Eigen::Vector3d half = Eigen::Vector3d::Zero();
  switch (*inRange(0, 7)) {
    case 0: break;
    case 1: half = sign * (polygon.vertex(polygon.next(i)) - polygon.vertex(i)); break;
    case 2: half = sign * from; break;
    case 3:  // perpendicular to the way from the vertex
      half[j] = from[k];
      half[k] = -from[j];
      break;
    case 4: half[axis] = 8 * sign * size; break;
    case 5:
      half = sign * (polygon.vertex(polygon.next(i)) - polygon.vertex(i));
      half[axis] += size;
      break;
    default:
      for (double& x : half) x = *inRange(-4, 5) * size;
  }
  return half;
}

const Polygon& square() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  return polygon;
}
const Polygon& letter_u() {
  static const Polygon polygon(
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  return polygon;
}
const Polygon& letter_l() {
  static const Polygon polygon({{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}});
  return polygon;
}
/// Edges 4 to 7 bound the hole.
const Polygon& frame() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                               {{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}});
  return polygon;
}
/// Lifted onto the plane z = 1 - x/2 + y/2, at heights 1, -1, 1, 3.
const Polygon& warped() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 4}});
  return polygon;
}

constexpr bool kMomentary = true, kStays = false;
constexpr Feature kFace{Feature::Kind::Face, 0};
constexpr Feature edge(std::size_t i) { return {Feature::Kind::Edge, i}; }
constexpr Feature vertex(std::size_t i) { return {Feature::Kind::Vertex, i}; }

FirstContact start(Feature feature, const Eigen::Vector3d& point) {
  return {FirstContactKind::Start, 0, false, feature, point};
}
FirstContact way(double time, bool momentary, Feature feature, const Eigen::Vector3d& point) {
  return {FirstContactKind::Way, time, momentary, feature, point};
}

}  // namespace

void showValue(const MovingCase& drawn, std::ostream& out) {
  std::ostringstream line;
  showValue(Case{drawn.id, drawn.motion.ball, drawn.polygon}, line);
  const Eigen::Vector3d& to = drawn.motion.to;
  std::ostringstream motion;
  motion.precision(std::numeric_limits<double>::max_digits10);
  motion << R"("motion":{"to":[)" << to.x() << ',' << to.y() << ',' << to.z() << "]},";
  std::string text = line.str();
  out << text.insert(text.find(R"("polygon")"), motion.str());
}

rc::Gen<MovingCase> moving(rc::Gen<Case> gen) {
  return rc::gen::map(
      rc::gen::suchThat(
          rc::gen::resize(100, rc::gen::exec([gen = std::move(gen)] {
                            Case c = *gen;
                            const Eigen::Vector3d half = draw_half_way(c);
                            const int middle = *rc::gen::inRange(0, 4);
                            MovingCase drawn{c.id + "-moving", {c.ball, c.ball.center}, std::move(c.polygon)};
                            if (middle != 1) drawn.motion.ball.center -= half;
                            if (middle != 2) drawn.motion.to += half;
                            workloads::Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()), 0);
                            sign_zeros(drawn.motion.to, random);
                            return drawn;
                          })),
          [](const MovingCase& drawn) { return !find_fault(drawn.motion); }),
      [](MovingCase drawn) { return drawn; });
}

const std::vector<MovingHandCase>& moving_hand_cases() {
  constexpr double kLargest = std::numeric_limits<double>::max();
  static const std::vector<MovingHandCase> cases{
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
      {{"fits a hole just so", {{{2, 2, 4}, 1}, {2, 2, -4}}, frame()}, way(0.5, kMomentary, edge(4), {2, 1, 0})},
      {{"passes through a hole", {{{2, 2, 4}, 0.999}, {2, 2, -4}}, frame()}, {}},
      {{"fits between the fingers just so", {{{1.5, 5, 0}, 0.5}, {1.5, 1, 0}}, letter_u()},
       way(0.5, kStays, vertex(3), {2, 3, 0})},
      {{"passes between the fingers just so", {{{1.5, 2, 4}, 0.5}, {1.5, 2, -4}}, letter_u()},
       way(0.5, kMomentary, edge(3), {2, 2, 0})},
      {{"a point passes through a lifted face", {{{2, 2, 5}, 0}, {2, 2, -3}}, warped()},
       way(0.5, kMomentary, kFace, {2, 2, 1})},
      {{"grazes an edge and runs into the next", {{{7, 3, -4}, 1}, {-1, 3, 4}}, letter_l()},
       way(0.5, kStays, edge(2), {3, 2, 0})},
      {{"an irrational time", {{{-3, -1, 0}, 2}, {1, -1, 0}}, square()},
       way(0.3169872981077807, kStays, vertex(0), {0, 0, 0})},  // (3 - sqrt 3) / 4
      {{"a time that rounds to 0", {{{2, 2, 1 + 0x1p-52}, 1}, {2, 2, -kLargest}}, square()},
       way(0, kStays, kFace, {2, 2, 0})},
      {{"a time that rounds to 1", {{{2, 2, 0x1p60}, 1}, {2, 2, 0}}, square()}, way(1, kStays, kFace, {2, 2, 0})},
  };
  return cases;
}

std::optional<Eigen::Vector3d> center_at(const Motion& motion, const mpq_class& time) {
  Eigen::Vector3d center;
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class from(motion.ball.center[axis]), to(motion.to[axis]);
    const mpq_class exact = from + time * (to - from);
    center[axis] = exact.get_d();
    if (!std::isfinite(center[axis]) || mpq_class(center[axis]) != exact) return std::nullopt;
  }
  return center;
}

}  // namespace contact_tests
}  // namespace touchstone
