// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robust/filtered/detail/numbers/permanent.h"
#include "robust/proofs/expressions.h"

namespace touchstone::proofs {

template <class Number>
inline constexpr int roundings_of = -1;
template <int Roundings>
inline constexpr int roundings_of<Permanent<Roundings>> = Roundings;

/// The inputs of expressions.h as the filters have them: rounded, except the radius.
struct PermanentInputs {
  Vector3<Permanent<1>> to_center, ahead, edge, velocity;
  Permanent<0> radius;
  Vector3<Permanent<1>> first_edge, second_edge, normal, axis, from_origin;
  Permanent<1> foot_x, foot_y, start_x, start_y, direction_x, direction_y;
  Vector3<Permanent<0>> first_exact, second_exact;
  Vector3<Permanent<1>> lane_vertex;
  Vector3<Permanent<0>> lane_edge;
  Permanent<0> first_weight, second_weight;
};

}  // namespace touchstone::proofs
