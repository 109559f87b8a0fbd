// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/judge/show/case_view.h"
#include "experiments/judge/show/svg.h"

namespace touchstone::show {

/// Draws a case: the polygon from above with the ball, the foot of its centre and the nearest point; a section through
/// them; and the radii around that of the ball, double by double, with what `exact` and each method say of contact. Of
/// a moving ball: its way, and the ball at its first contact.
[[nodiscard]] Svg picture(const CaseView& view);

/// Returns a case as a section of a page: its margin, its picture, and a table of what `exact` and the verdicts say,
/// key by key, with what differs marked.
[[nodiscard]] std::string section_of(const CaseView& view);

/// Returns a page of HTML that loads nothing: the title, then the body.
[[nodiscard]] std::string page_of(const std::string& title, const std::string& body);

}  // namespace touchstone::show
