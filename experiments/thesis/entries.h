// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/entry.h"
#include "experiments/thesis/study.h"

namespace touchstone::thesis_figures {

/// One entry for every caption, in their order.
///
/// The numbers that captions state are written here as the captions have them; ours come out of the study. Of a study
/// that was only begun, entries of what was not measured have numbers of nothing.
[[nodiscard]] std::vector<Entry> entries_of(const Study& study);

/// What the chapters' files add entries to.
class EntryList {
 public:
  /// `shows` is empty where there is no picture. Throws std::logic_error for an id that no caption has or that has
  /// been added before.
  void add(std::string_view id, Status status, std::string text, std::vector<Number> numbers, std::string shows = "");

  /// In the captions' order. Throws std::logic_error where one is missing.
  [[nodiscard]] std::vector<Entry> all() &&;

 private:
  std::vector<Entry> entries_;
};

void add_diagrams_and_photographs(const Study& study, EntryList& entries);
void add_algorithm(const Study& study, EntryList& entries);
void add_environment(const Study& study, EntryList& entries);
void add_case_studies(const Study& study, EntryList& entries);
void add_known_errors(const Study& study, EntryList& entries);

/// What a move of a case study came out with, in degrees; NaN where it is no move of that joint.
[[nodiscard]] double moved(const CaseStudy& study, std::size_t move, kinematics::AristoJoint joint);
/// A move's angle as a caption has it: without a sign, in the direction that `what` tells.
[[nodiscard]] Number captioned(std::string what, double degrees, int stated);

}  // namespace touchstone::thesis_figures
