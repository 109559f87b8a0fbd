// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "experiments/methods/engines/bullet_sweep.h"
#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "this is about Bullet's double build");

std::array<double, 4> numbers_of(const Ball& ball) {
  return {ball.center.x(), ball.center.y(), ball.center.z(), ball.radius};
}

std::array<double, 9> numbers_of(const Triangle& t) {
  return {t.a.x(), t.a.y(), t.a.z(), t.b.x(), t.b.y(), t.b.z(), t.c.x(), t.c.y(), t.c.z()};
}

std::optional<bool> contact(const Ball& ball, const Triangle& triangle) {
  return bullet_contact(numbers_of(ball).data(), numbers_of(triangle).data());
}

std::optional<Sweep> sweep(const Motion& motion, const Triangle& triangle) {
  const double time = bullet_sweep(numbers_of(motion.ball).data(), motion.to.data(), numbers_of(triangle).data());
  return Sweep{std::isfinite(time), time};
}

}  // namespace

void add_bullet(MethodList& list) {
  list.push_back(triangle_method("bullet", "Bullet's sphere against triangle, its double build; its convex sweep",
                                 contact, sweep));
}

}  // namespace touchstone::methods
