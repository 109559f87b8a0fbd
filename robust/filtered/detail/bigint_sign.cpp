// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/bigint_sign.h"

#include "robust/detail/exact_kernel.h"

namespace touchstone::filtered {
namespace {

using Number = kernel::Mpzf;  // integers times powers of two: the signs need no division

Vector3<Number> difference(const double* a, const double* b) {
  return {Number(a[0]) - Number(b[0]), Number(a[1]) - Number(b[1]), Number(a[2]) - Number(b[2])};
}

struct View {
  const BallTriangleView& view;
  int i;

  [[nodiscard]] Vector3<Number> to_center() const { return difference(view.center, view.vertex[i]); }
  [[nodiscard]] Vector3<Number> edge() const { return difference(view.vertex[(i + 1) % 3], view.vertex[i]); }
  [[nodiscard]] Vector3<Number> normal() const {
    return signs::normal(difference(view.vertex[1], view.vertex[0]), difference(view.vertex[2], view.vertex[1]));
  }
  [[nodiscard]] Number radius() const { return Number(view.radius()); }
  [[nodiscard]] static int axis() { return 0; }
};

}  // namespace

int bigint_sign(SignKind kind, const BallTriangleView& view, int edge) {
  return expression_sign(kind, View{view, edge});
}

}  // namespace touchstone::filtered
