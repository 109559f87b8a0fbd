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
      << first.point.y() << ", " << first.point.z() << "); contact_normal (" << first.contact_normal.x() << ", "
      << first.contact_normal.y() << ", " << first.contact_normal.z() << "); depth " << first.depth;
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
