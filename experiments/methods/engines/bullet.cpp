// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/engines/bullet_contact.h"
#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "this is about Bullet's double build");

std::optional<bool> contact(const Ball& ball, const Triangle& t) {
  const double sphere[]{ball.center.x(), ball.center.y(), ball.center.z(), ball.radius};
  const double triangle[]{t.a.x(), t.a.y(), t.a.z(), t.b.x(), t.b.y(), t.b.z(), t.c.x(), t.c.y(), t.c.z()};
  return bullet_contact(sphere, triangle);
}

}  // namespace

void add_bullet(MethodList& list) {
  list.push_back(triangle_method("bullet", "Bullet's sphere against triangle, its double build", contact));
}

}  // namespace touchstone::methods
