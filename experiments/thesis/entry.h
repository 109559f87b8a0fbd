// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cell/model/cell.h"
#include "experiments/statistics/clopper_pearson.h"
#include "experiments/thesis/captions.h"

namespace touchstone::thesis_figures {

using cell::Label;

/// A number that an entry reproduces.
struct Number {
  std::string what, unit;
  double ours;
  bool chosen = false;                         ///< ours rests on chosen values
  std::optional<statistics::Limits> limits{};  ///< 95 %, where ours is a share of random samples
  std::uint64_t samples = 0;                   ///< of these
  std::optional<double> stated{};              ///< in the thesis, elsewhere or derived
  double tolerance = 0;                        ///< by which ours may differ from it and agree
  std::optional<Label> label{};                ///< where the stated one comes from

  /// Nothing where no number is stated.
  [[nodiscard]] std::optional<bool> agrees() const;
};

/// That nothing is stated about.
[[nodiscard]] Number found(std::string what, std::string unit, double ours, bool chosen);
/// A share in percent of random samples, with its limits.
[[nodiscard]] Number share(std::string what, std::uint64_t count, std::uint64_t samples, bool chosen);
/// Beside one that is stated.
[[nodiscard]] Number beside(Number ours, Label label, double stated, double tolerance = 0);

enum class Status {
  Reproduced,     ///< from the thesis's text, public sources and arithmetic alone
  WithChosen,     ///< with values that no public source gives
  Photograph,     ///< of real machines
  NotComputable,  ///< no number, or none that is public
};

/// What came of a figure or table.
struct Entry {
  const Caption* caption;
  Status status;
  std::string text;             ///< what was done, or why nothing can be
  std::vector<Number> numbers;  ///< of photographs, too, where captions name some
  std::string shows;            ///< what our picture shows; empty where there is none

  /// All that are stated agree.
  [[nodiscard]] bool agrees() const;
  /// For people: `reproduced`, `reproduced with chosen values`, `photograph: not computable`, `not computable`; or
  /// `differs`, where a number of the first two kinds does.
  [[nodiscard]] std::string_view status_words() const;
  /// Of its files, without extension: `4-3`, `table-6-1`, `E-2`.
  [[nodiscard]] std::string file_stem() const;
};

}  // namespace touchstone::thesis_figures
