// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

/// Returns one entry for every caption, in their order.
///
/// The numbers that captions state are written as the captions have them; our numbers are results of the study. If a
/// study was only begun, entries for anything not measured have numbers based on no samples.
[[nodiscard]] std::vector<Entry> entries_of(const Study& study);

/// The list to which the chapters' files add entries.
class EntryList {
 public:
  /// Adds an entry. `shows` is empty if there is no picture. Throws std::logic_error for an id without a caption, or
  /// one that was added before.
  void add(std::string_view id, Status status, std::string text, std::vector<Number> numbers, std::string shows = "");

  /// Returns the entries in the captions' order. Throws std::logic_error if one is missing.
  [[nodiscard]] std::vector<Entry> all() &&;

 private:
  std::vector<Entry> entries_;
};

void add_diagrams_and_photographs(const Study& study, EntryList& entries);
void add_algorithm(const Study& study, EntryList& entries);
void add_environment(const Study& study, EntryList& entries);
void add_case_studies(const Study& study, EntryList& entries);
void add_known_errors(const Study& study, EntryList& entries);

/// Returns the angle of a move of a case study, in degrees; NaN if it moves another joint.
[[nodiscard]] double moved(const CaseStudy& study, std::size_t move, kinematics::AristoJoint joint);
/// Returns a move's angle as a caption has it: without a sign, in the direction that `what` names.
[[nodiscard]] Number captioned(std::string what, double degrees, int stated);
/// The same for the storage's angle, which is not a result but set.
[[nodiscard]] Number set_angle(std::string what, double degrees, int stated);

}  // namespace touchstone::figures
