// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/contact/first_contact.h"
#include "robust/filtered/detail/motion/motion_view.h"

namespace touchstone::filtered {

/// @{
/// Returns the contact, or the first contact, of a moving ball with a triangle, computed by `exact`.
[[nodiscard]] bool exact_motion_contact(const MotionTriangleView& view);
[[nodiscard]] FirstContact exact_first_contact(const MotionTriangleView& view);
/// @}

}  // namespace touchstone::filtered
