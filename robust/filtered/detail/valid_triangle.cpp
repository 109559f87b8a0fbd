// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/valid_triangle.h"

#include <utility>

#include "geometry/shapes/polygon.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/numbers/permanent.h"

namespace touchstone::filtered {
namespace {

/// Returns whether some component of the normal is certainly not zero. A finite triangle is then valid.
bool has_surely_normal(const Triangle& t) {
  const Eigen::Vector3d u = t.b - t.a, v = t.c - t.a;
  const auto known = [](double difference) { return rounded_double(difference); };
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (certain_sign(known(u[i]) * known(v[j]) - known(u[j]) * known(v[i]), bounds::kTiny) != 0) return true;
  }
  return false;
}

}  // namespace

void expect_valid(const Triangle& t) {
  if (t.a.allFinite() && t.b.allFinite() && t.c.allFinite() && has_surely_normal(t)) return;
  if (auto rejection = exact::validate(Polygon({t.a, t.b, t.c}))) throw Rejected(std::move(*rejection));
}

}  // namespace touchstone::filtered
