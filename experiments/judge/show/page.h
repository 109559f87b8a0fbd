// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/judge/show/case_view.h"

namespace touchstone::show {

/// Returns a case as a section of a page: its margin, its picture, and a table of what `exact` and the verdicts say,
/// key by key, with what differs marked.
[[nodiscard]] std::string section_of(const CaseView& view);

/// Returns a page of HTML that loads nothing: the title, then the body.
[[nodiscard]] std::string page_of(const std::string& title, const std::string& body);

}  // namespace touchstone::show
