// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/cases/method.h"
#include "experiments/judge/show/radii.h"

namespace touchstone::show {

/// The verdict of one method on a case.
struct Verdict {
  std::string method;
  cases::StatedAnswer answer;
  std::string fault;                         ///< why there is no answer; else empty
  std::vector<std::optional<bool>> contact;  ///< at each radius of the view; empty if it was asked about the case alone
};

/// A case with everything that its picture and its table show.
struct CaseView {
  std::string id;
  std::vector<std::string> tags;
  cases::Shapes shapes;
  cases::PartialAnswer truth;  ///< by `exact`
  Radii radii;
  std::vector<Verdict> verdicts;
};

/// Asks `exact`.
[[nodiscard]] CaseView view_of(const std::string& id, const std::vector<std::string>& tags,
                               const cases::Shapes& shapes);

/// Asks the method about the case, and about contact at each radius of the view. An exception of the method becomes its
/// fault.
[[nodiscard]] Verdict verdict_of(const CaseView& view, const cases::Method& method);

/// Returns the margin as a sentence: `The ball touches: its radius is 3 doubles above the least one that does.`
/// Margins of more than a million doubles are not counted.
[[nodiscard]] std::string margin_text(const CaseView& view);

}  // namespace touchstone::show
