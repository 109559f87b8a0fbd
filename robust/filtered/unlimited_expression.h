// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Mpzf.h>

#include "robust/filtered/sign_kind.h"

namespace touchstone::filtered {

/// The sign of the expression over a view in integers of any size.
template <class View>
int unlimited_expression_sign(SignKind kind, const View& view) {
  switch (kind) {
    case SignKind::Vertex: return CGAL::sign(expression<SignKind::Vertex>(view));
    case SignKind::Along: return CGAL::sign(expression<SignKind::Along>(view));
    case SignKind::Beyond: return CGAL::sign(expression<SignKind::Beyond>(view));
    case SignKind::Line: return CGAL::sign(expression<SignKind::Line>(view));
    case SignKind::Front: return CGAL::sign(expression<SignKind::Front>(view));
    case SignKind::Plane: return CGAL::sign(expression<SignKind::Plane>(view));
    case SignKind::Side: return CGAL::sign(expression<SignKind::Side>(view));
    case SignKind::Above: break;
  }
  return CGAL::sign(expression<SignKind::Above>(view));
}

}  // namespace touchstone::filtered
