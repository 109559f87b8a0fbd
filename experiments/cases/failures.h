// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/crossings.h"
#include "experiments/program/state.h"
#include "experiments/program/table.h"

// The one count of studies: how many answers are wrong or undecided, of how many; and what their tables share.
namespace touchstone::cases {

/// Answers, or samples, and those that fail.
struct Failures {
  std::uint64_t trials = 0;
  std::uint64_t wrong = 0;
  std::uint64_t wrongly_in = 0, wrongly_out = 0;  ///< of the wrong answers, as Outcome
  std::uint64_t unsure = 0;                       ///< undecided answers, which are not wrong

  /// Counts an answer, of which `compare` says this; nothing: it is undecided.
  void add(std::optional<Outcome> outcome);
  /// Counts a sample.
  void add_sample(bool failed);

  [[nodiscard]] std::uint64_t not_right() const { return wrong + unsure; }
  [[nodiscard]] std::uint64_t boundary_missed() const { return wrong - wrongly_in - wrongly_out; }
  /// Returns the share of wrong ones; 0 of none.
  [[nodiscard]] double share() const {
    return trials == 0 ? 0 : static_cast<double>(wrong) / static_cast<double>(trials);
  }
  /// Returns it with its limits, as program::rate does. Requires independent trials.
  [[nodiscard]] program::Rate rate() const { return program::rate(wrong, trials); }

  auto members() { return std::tie(trials, wrong, wrongly_in, wrongly_out, unsure); }
  friend bool operator==(const Failures&, const Failures&) = default;
};

/// The answers of a method at thresholds. Failures are about the question that the method understands: the contract's if
/// it lifts vertices, otherwise the polygon as given. So a failure is due to the method's own arithmetic, such as
/// rounding.
struct CrossingFailures : Failures {
  std::uint64_t contract = 0;  ///< wrong or undecided by the contract
  std::uint64_t lift = 0;      ///< of these, right about the polygon as given: the contract lifts, the method does not

  void add(const Outcomes& outcomes, bool lifts);
  auto members() { return std::tuple_cat(Failures::members(), std::tie(contract, lift)); }
  friend bool operator==(const CrossingFailures&, const CrossingFailures&) = default;
};

/// The answers about some samples. Samples are independent; answers about one sample are not, so that limits of their
/// share would be too narrow.
struct SampledFailures {
  Failures samples, answers;

  auto members() { return std::tie(samples, answers); }
};

/// Returns the sum of a list of counts.
template <class List>
[[nodiscard]] auto total(const List& counts) {
  typename List::value_type sum;
  for (const auto& count : counts) program::add(sum, count);
  return sum;
}

/// The lowest and the highest offset with a failure; nothing if there is none.
struct Band {
  std::optional<double> lowest, highest;
};

/// Returns the band of counts by all_offsets(). `failures`: a member of a count that is the number of its failures.
template <class Count, class Number>
[[nodiscard]] Band band_of(const std::vector<Count>& counts, Number failures) {
  Band band;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (std::invoke(failures, counts[i]) == 0) continue;
    band.highest = all_offsets()[i];
    if (!band.lowest) band.lowest = band.highest;
  }
  return band;
}

/// Returns the band in words: `-2^3 to 2^-1`, `none seen`; at an end of the sweep, beyond which nothing was tested,
/// `-2^32 or beyond`.
[[nodiscard]] std::string to_string(const Band& band);

/// The strata behind a row of a table: one stratum, or those that differ in their family alone.
struct StratumGroup {
  std::string family;  ///< `all` for several
  workloads::Placement placement;
  Threshold threshold;
  std::vector<std::size_t> strata;
};

/// Returns each stratum of the settings, then the groups of all families.
[[nodiscard]] std::vector<StratumGroup> stratum_groups(const CrossingSettings& settings);

/// The subject of a row of a table about thresholds.
struct Subject {
  const StratumGroup* group;
  Test test;
  std::string_view method;
};

/// A row about the answers at one offset.
template <class Count>
struct OffsetRow : Subject {
  double offset;
  Count count;
  program::Rate rate;
};

/// Returns the columns of a Subject. `test`: the meaning of the column of that name.
template <class Row>
[[nodiscard]] std::vector<program::Column<Row>> subject_columns(const char* test) {
  return {{"family", "the family of polygons, or `all`", program::path(&Row::group, &StratumGroup::family)},
          {"placement", "exactly planar with few or all bits, or rotated and rounded",
           program::path(&Row::group, &StratumGroup::placement)},
          {"threshold", "the threshold that balls cross", program::path(&Row::group, &StratumGroup::threshold)},
          {"test", test, &Row::test},
          {"method", "the method", &Row::method}};
}

/// Returns the columns of a table of OffsetRows: `counts` are those of the study's own words, `rated` what the rate is
/// of.
template <class Row>
[[nodiscard]] std::vector<program::Column<Row>> offset_columns(const char* test,
                                                               std::vector<program::Column<Row>> counts,
                                                               const char* rated) {
  return program::all_columns<Row>(
      {subject_columns<Row>(test),
       {{"offset", "the distance of the ball from the threshold, in u x size", &Row::offset}},
       std::move(counts),
       program::rate_columns<Row>(rated, &Row::rate)});
}

/// Returns the columns of a member `band` of a row. `lowest`: the meaning of the first one.
template <class Row>
[[nodiscard]] std::vector<program::Column<Row>> band_columns(const char* lowest) {
  return {{"lowest_offset", lowest, program::path(&Row::band, &Band::lowest)},
          {"highest_offset", "the highest one", program::path(&Row::band, &Band::highest)}};
}

}  // namespace touchstone::cases
