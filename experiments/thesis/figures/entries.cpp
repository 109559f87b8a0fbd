// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/entries.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace touchstone::figures {

void EntryList::add(std::string_view id, Status status, std::string text, std::vector<Number> numbers,
                    std::string shows) {
  const auto caption = std::ranges::find(captions(), id, &Caption::id);
  if (caption == captions().end()) throw std::logic_error("no caption is numbered " + std::string(id));
  const auto same = [&](const Entry& entry) { return entry.caption == &*caption; };
  if (std::ranges::any_of(entries_, same)) throw std::logic_error("two entries for " + std::string(id));
  entries_.push_back({&*caption, status, std::move(text), std::move(numbers), std::move(shows)});
}

std::vector<Entry> EntryList::all() && {
  std::ranges::sort(entries_, {}, &Entry::caption);
  for (std::size_t i = 0; i < captions().size(); ++i)
    if (i >= entries_.size() || entries_[i].caption != &captions()[i])
      throw std::logic_error("no entry for " + std::string(captions()[i].id));
  return std::move(entries_);
}

double moved(const CaseStudy& study, std::size_t move, kinematics::AristoJoint joint) {
  const auto& moves = study.process.moves;
  if (move >= study.moves_to_machine() || std::size_t{moves[move].joint} != joint)
    return std::numeric_limits<double>::quiet_NaN();
  return moves[move].degrees;
}

Number captioned(std::string what, double degrees, int stated) {
  Number number = beside(found(std::move(what), "°", degrees, true), Label::Text, stated);
  number.basis = Basis::Fitted;
  return number;
}

Number set_angle(std::string what, double degrees, int stated) {
  return beside(found(std::move(what), "°", degrees, true), Label::Text, stated);
}

std::vector<Entry> entries_of(const Study& study) {
  EntryList entries;
  add_diagrams_and_photographs(study, entries);
  add_algorithm(study, entries);
  add_environment(study, entries);
  add_case_studies(study, entries);
  add_known_errors(study, entries);
  return std::move(entries).all();
}

}  // namespace touchstone::figures
