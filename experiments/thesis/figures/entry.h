// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/run/statistics/clopper_pearson.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/figures/captions.h"

namespace touchstone::figures {

using cell::Label;

/// Why a stated number agrees with ours.
enum class Basis {
  Fitted,       ///< a caption states it, and the layout was solved for it
  Input,        ///< a caption states it, and the cell was built with it
  OwnCheck,     ///< arithmetic or the exact answer says it: a test of this project
  OtherSource,  ///< another source says it
};
/// `fitted`, `input`, `own check`, `other source`.
[[nodiscard]] std::string_view to_string(Basis basis);

/// A number that an entry reproduces.
struct Number {
  std::string what, unit;
  double ours;
  bool chosen = false;                         ///< whether our number depends on chosen values
  std::optional<statistics::Limits> limits{};  ///< 95 %, if ours is a share of random samples
  std::uint64_t samples = 0;                   ///< the number of these samples
  std::optional<double> stated{};              ///< as stated in the thesis or elsewhere, or as derived
  double tolerance = 0;                        ///< the largest difference that counts as agreement
  std::optional<Label> label{};                ///< the source of the stated number
  std::optional<Basis> basis{};                ///< set with the stated number

  /// Returns whether ours agrees with the stated number; nothing if none is stated.
  [[nodiscard]] std::optional<bool> agrees() const;
};

/// Returns a number without a stated counterpart.
[[nodiscard]] Number found(std::string what, std::string unit, double ours, bool chosen);
/// Returns a share in percent of random samples, with its limits.
[[nodiscard]] Number share(std::string what, std::uint64_t count, std::uint64_t samples, bool chosen);
/// Returns the number with a stated counterpart, whose basis is by its label Input, OtherSource or OwnCheck.
[[nodiscard]] Number beside(Number ours, Label label, double stated, double tolerance = 0);

enum class Status {
  Reproduced,     ///< from the thesis's text, public sources and arithmetic alone
  WithChosen,     ///< with values that no public source gives
  Photograph,     ///< of real machines
  NotComputable,  ///< has no number, or no public one
};

/// The result for a figure or table.
struct Entry {
  const Caption* caption;
  Status status;
  std::string text;             ///< what was done, or why nothing can be done
  std::vector<Number> numbers;  ///< also for photographs, if captions name some
  std::string shows;            ///< what our picture shows; empty without a picture

  /// Returns whether all stated numbers agree.
  [[nodiscard]] bool agrees() const;
  /// Returns the status in words: `reproduced`, `reproduced with chosen values`, `photograph: not computable`, `not
  /// computable`; or `differs`, if a number of the first two kinds does.
  [[nodiscard]] std::string_view status_words() const;
  /// Returns the name of its files, without extension: `4-3`, `table-6-1`, `E-2`.
  [[nodiscard]] std::string file_stem() const;
};

}  // namespace touchstone::figures
