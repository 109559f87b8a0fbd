// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/detail/fast_definitions.h"

namespace touchstone::fast {

#define TOUCHSTONE_INSTANTIATE(Scalar)                                                      \
  template class PreparedPolygon<Scalar>;                                                   \
  template bool contact(const Ball&, const PreparedPolygon<Scalar>&);                       \
  template Relation relation(const Ball&, const PreparedPolygon<Scalar>&);                  \
  template PlaneSide plane_side(const Ball&, const PreparedPolygon<Scalar>&);               \
  template PointLocation foot(const Ball&, const PreparedPolygon<Scalar>&);                 \
  template std::vector<std::size_t> edges_hit(const Ball&, const PreparedPolygon<Scalar>&); \
  template Answer answer(const Ball&, const PreparedPolygon<Scalar>&);

TOUCHSTONE_INSTANTIATE(float)
TOUCHSTONE_INSTANTIATE(double)
TOUCHSTONE_INSTANTIATE(long double)

bool contact(const Ball& ball, const Polygon& polygon) { return contact(ball, PreparedPolygon<>(polygon)); }
Relation relation(const Ball& ball, const Polygon& polygon) { return relation(ball, PreparedPolygon<>(polygon)); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return plane_side(ball, PreparedPolygon<>(polygon)); }
PointLocation foot(const Ball& ball, const Polygon& polygon) { return foot(ball, PreparedPolygon<>(polygon)); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return edges_hit(ball, PreparedPolygon<>(polygon));
}
Answer answer(const Ball& ball, const Polygon& polygon) { return answer(ball, PreparedPolygon<>(polygon)); }

}  // namespace touchstone::fast
