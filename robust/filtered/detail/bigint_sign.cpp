// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/bigint_sign.h"

#include <CGAL/Mpzf.h>

namespace touchstone::filtered {
namespace {

using Number = CGAL::Mpzf;  // integers times powers of two: a ring is all that the signs need

Vector3<Number> difference(const double* a, const double* b) {
  return {Number(a[0]) - Number(b[0]), Number(a[1]) - Number(b[1]), Number(a[2]) - Number(b[2])};
}

struct View {
  const TriangleQuestion& question;
  int i;

  [[nodiscard]] Vector3<Number> from() const { return difference(question.center, question.vertex[i]); }
  [[nodiscard]] Vector3<Number> edge() const { return difference(question.vertex[(i + 1) % 3], question.vertex[i]); }
  [[nodiscard]] Vector3<Number> normal() const {
    return signs::normal(difference(question.vertex[1], question.vertex[0]),
                         difference(question.vertex[2], question.vertex[1]));
  }
  [[nodiscard]] Number radius() const { return Number(question.radius()); }
  [[nodiscard]] static int axis() { return 0; }
};

}  // namespace

int unlimited_sign(SignKind kind, const TriangleQuestion& question, int edge) {
  return expression_sign(kind, View{question, edge});
}

}  // namespace touchstone::filtered
