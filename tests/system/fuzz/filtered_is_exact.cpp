// SPDX-License-Identifier: GPL-3.0-or-later
// About a ball and a polygon that the bytes describe, `filtered` answers what `exact` answers, in a rounding mode and
// under a flush-to-zero that they choose.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/support/environment.h"

using namespace touchstone;
using contact_tests::Environment;

namespace {

/// Numbers that small changes of the bytes change in ways that matter: steps of a lattice, some doubles beside them,
/// another exponent; and any double at all. Zeros after the last byte.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  std::uint8_t byte() { return next_ == end_ ? 0 : *next_++; }
  double number() {
    const std::uint8_t kind = byte();
    if (kind % 8 == 7) return any_double();
    const double lattice = std::ldexp(static_cast<std::int8_t>(byte()), exponent_);
    const int other_exponent = kind % 8 == 6 ? 4 * static_cast<std::int8_t>(byte()) : 0;
    const std::int64_t doubles = kind % 8 >= 4 ? static_cast<std::int8_t>(byte()) : 0;
    const double moved = workloads::move_by_doubles(std::ldexp(lattice, other_exponent), doubles);
    return std::isfinite(moved) ? moved : 0;
  }
  void choose_exponent() { exponent_ = 8 * static_cast<std::int8_t>(byte()); }

 private:
  double any_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    return std::bit_cast<double>(bits);
  }

  const std::uint8_t *next_, *end_;
  int exponent_ = 0;
};

Loop loop_of(Bytes& bytes, std::size_t vertices, unsigned flat_axis) {
  Loop loop(vertices);
  for (Eigen::Vector3d& vertex : loop)
    for (unsigned axis = 0; axis < 3; ++axis) vertex[axis] = axis == flat_axis ? 0 : bytes.number();
  return loop;
}

void expect(bool same, const char* question, const Ball& ball, const Polygon& polygon) {
  if (!same)
    throw std::logic_error(std::string("another answer to ") + question + ": " +
                           cases::case_line("found", cases::Shapes{ball, polygon}, {}));
}

/// What f gives in an environment; outside it, numbers are compared as they are.
template <class F>
auto in(int mode, unsigned flush, const F& f) {
  const Environment chosen(mode, flush);
  return f();
}

void compare(const Ball& ball, const Polygon& polygon, int mode, unsigned flush) {
  const Answer truth = exact::answer(ball, polygon);
  const auto ask = [&](const char* question, const auto& f, const auto& expected) {
    expect(in(mode, flush, f) == expected, question, ball, polygon);
  };
  const auto prepared = in(mode, flush, [&] { return filtered::PreparedPolygon(polygon); });
  ask(
      "answer", [&] { return filtered::answer(ball, prepared); }, truth);
  ask(
      "contact", [&] { return filtered::contact(ball, prepared); }, truth.contact());
  ask(
      "relation", [&] { return filtered::relation(ball, prepared); }, truth.relation);
  ask(
      "plane_side", [&] { return filtered::plane_side(ball, prepared); }, truth.plane);
  ask(
      "foot", [&] { return filtered::foot(ball, prepared); }, truth.foot);
  ask(
      "edges_hit", [&] { return filtered::edges_hit(ball, prepared); }, truth.edges_hit);
  if (polygon.vertex_count() != 3) return;
  const Triangle triangle{polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)};
  ask(
      "contact of a triangle", [&] { return filtered::contact(ball, triangle); }, truth.contact());
  ask(
      "closest of a triangle", [&] { return filtered::closest(ball.center, triangle); },
      filtered::ClosestPoint{truth.nearest, truth.point, truth.distance, truth.contact_normal});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const std::uint8_t environment = bytes.byte(), shape = bytes.byte();
  bytes.choose_exponent();
  const unsigned flat_axis = shape >> 6;  // 3: none
  const std::size_t vertices = 3 + (shape & 7), holes = (shape >> 3 & 7) == 7 ? 1 : 0;
  try {
    const Loop outer = loop_of(bytes, vertices, flat_axis);
    std::vector<Loop> loops;
    if (holes == 1) loops.push_back(loop_of(bytes, 3, flat_axis));
    const Polygon polygon(outer, loops);
    Ball ball{{bytes.number(), bytes.number(), bytes.number()}, std::abs(bytes.number())};
    if (find_fault(ball) || exact::validate(polygon)) return 0;
    const int mode = contact_tests::kModes[environment & 3];
    const unsigned flush = contact_tests::kFlushes[environment >> 2 & 3];
    compare(ball, polygon, mode, flush);
    // At the boundary itself, and beside it.
    const double distance = exact::answer(ball, polygon).distance;
    for (const double r :
         {std::nextafter(distance, 0.0), distance, std::nextafter(distance, std::numeric_limits<double>::infinity())})
      if (std::isfinite(r)) compare({ball.center, r}, polygon, mode, flush);
  } catch (const Rejected&) {
  }
  return 0;
}
