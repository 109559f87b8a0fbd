// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>
#include <rapidcheck.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "geometry/contact/first_contact.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "tests/robust/support/generators.h"

namespace touchstone {

/// How GoogleTest and RapidCheck show a first contact: in the words of the contract, numbers to the last bit.
void PrintTo(const FirstContact& first, std::ostream* out);
void showValue(const FirstContact& first, std::ostream& out);

namespace contact_tests {

/// A motion that `find_fault` and a polygon that `exact::validate` accepts.
struct MovingCase {
  std::string id;  ///< the id of the static case, and how the ball moves through it
  Motion motion;
  Polygon polygon;
};

/// One line in the contract's form.
void showValue(const MovingCase& drawn, std::ostream& out);

/// Motions through the centres of static cases, mostly in the middle of the way: along edges, towards and past
/// vertices, perpendicular to the way to a vertex, along axes, in any direction, or at rest. Small integers remain
/// small integers, so that balls graze and touch exactly, at simple times.
[[nodiscard]] rc::Gen<MovingCase> moving(rc::Gen<Case> gen);
[[nodiscard]] inline rc::Gen<MovingCase> any_moving_case() { return moving(any_case()); }

/// Returns the first contact of a ball that touches at its start, where it has this answer.
[[nodiscard]] inline FirstContact at_start(const Answer& answer) {
  return {FirstContactKind::Start, 0, false, answer.nearest, answer.point, answer.contact_normal, answer.depth};
}

/// Returns c(t) if its coordinates are doubles.
[[nodiscard]] std::optional<Eigen::Vector3d> center_at(const Motion& motion, const mpq_class& time);

}  // namespace contact_tests
}  // namespace touchstone
