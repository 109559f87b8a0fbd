// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "robust/scene/scene.h"

namespace touchstone::kinematics {

/// The first of the stops 0, 1, 2, ... of a move at which the ball touches a face.
struct SteppedContact {
  std::uint64_t stop;
  double degrees;    ///< stop times step
  std::size_t face;  ///< the lowest, numbered as in FirstContact
};

/// Finds contact as the thesis does: tests the ball after every `step` degrees, not between. At each stop the centre is
/// rounded as by point_at; the contact test of that ball is exact (`filtered`). There are no stops beyond the end of
/// the move. Throws as first_contact does, and std::invalid_argument for a step that is not finite and positive.
[[nodiscard]] std::optional<SteppedContact> stepped_contact(const Arc& arc, double radius, double step,
                                                            const scene::Faces& faces);

}  // namespace touchstone::kinematics
