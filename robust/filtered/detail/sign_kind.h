// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/signs.h"

namespace touchstone::filtered {

/// The signs of signs.h by name, so that every stage can compute the same one.
enum class SignKind { Vertex, Along, Beyond, Line, Front, Plane, Side, Above };

inline namespace TOUCHSTONE_TARGET {

/// The largest magnitudes of the components of `to_center` (and of r), `edge` and `normal`.
struct Maxima {
  double to_center, edge, normal;
};

/// Returns the sign's expression over the numbers of an edge relative to a ball: `to_center`, `edge`, `normal`,
/// `radius` and, for Above, the coordinate.
template <SignKind kind, class View>
constexpr auto expression(const View& view) {
  if constexpr (kind == SignKind::Vertex) return signs::vertex(view.to_center(), view.radius());
  if constexpr (kind == SignKind::Along) return signs::along(view.to_center(), view.edge());
  if constexpr (kind == SignKind::Beyond) return signs::beyond(view.to_center(), view.edge());
  if constexpr (kind == SignKind::Line) return signs::line(view.to_center(), view.edge(), view.radius());
  if constexpr (kind == SignKind::Front) return signs::front(view.normal(), view.to_center());
  if constexpr (kind == SignKind::Plane) return signs::plane(view.normal(), view.to_center(), view.radius());
  if constexpr (kind == SignKind::Side) return signs::side(view.normal(), view.edge(), view.to_center());
  if constexpr (kind == SignKind::Above) {
    const auto& to_center = view.to_center();
    const auto& normal = view.normal();
    return signs::above(normal, to_center, normal[view.axis()], to_center[view.axis()]);
  }
}

/// Returns the sign of the expression over numbers that have an exact `sign`.
template <class View>
int expression_sign(SignKind kind, const View& view) {
  switch (kind) {
    case SignKind::Vertex: return sign(expression<SignKind::Vertex>(view));
    case SignKind::Along: return sign(expression<SignKind::Along>(view));
    case SignKind::Beyond: return sign(expression<SignKind::Beyond>(view));
    case SignKind::Line: return sign(expression<SignKind::Line>(view));
    case SignKind::Front: return sign(expression<SignKind::Front>(view));
    case SignKind::Plane: return sign(expression<SignKind::Plane>(view));
    case SignKind::Side: return sign(expression<SignKind::Side>(view));
    case SignKind::Above: break;
  }
  return sign(expression<SignKind::Above>(view));
}

/// Returns the error bound of the expression in units of relative rounding, without kTiny.
template <SignKind kind>
constexpr double bound(const Maxima& m) {
  switch (kind) {
    case SignKind::Vertex: return bounds::kVertex * (m.to_center * m.to_center);
    case SignKind::Along: return bounds::kAlong * (m.to_center * m.edge);
    case SignKind::Beyond: return bounds::kBeyond * (m.edge * (m.to_center > m.edge ? m.to_center : m.edge));
    case SignKind::Line: return bounds::kLine * (m.to_center * m.edge) * (m.to_center * m.edge);
    case SignKind::Front: return bounds::kFront * (m.normal * m.to_center);
    case SignKind::Plane: return bounds::kPlane * (m.normal * m.to_center) * (m.normal * m.to_center);
    case SignKind::Side: return bounds::kSide * (m.normal * m.edge * m.to_center);
    case SignKind::Above: return bounds::kAbove * (m.normal * m.normal * m.to_center);
  }
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
