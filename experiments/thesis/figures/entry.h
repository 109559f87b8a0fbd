// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/figures/computed.h"

namespace touchstone::figures {

using cell::Label;

/// Why a stated number agrees with ours.
enum class Basis {
  Fitted,       ///< a caption states it, and the layout was solved for it
  Input,        ///< a caption states it, and the cell was built with it
  Predicted,    ///< captions imply it where the layout was not fitted
  OwnCheck,     ///< arithmetic or the exact answer says it: a test of this project
  OtherSource,  ///< another source says it
};
/// `fitted`, `input`, `predicted`, `own check`, `other source`.
[[nodiscard]] std::string_view to_string(Basis basis);
/// Returns the source of a number that is stated with this basis.
[[nodiscard]] Label label_of(Basis basis);

/// A number that an entry reproduces.
struct Number {
  std::string what, unit;
  Value ours;
  bool chosen = false;             ///< whether our number depends on chosen values
  std::optional<double> stated{};  ///< as stated in the thesis or elsewhere, or as derived
  double tolerance = 0;            ///< the largest difference that counts as agreement
  std::optional<Basis> basis{};    ///< set with the stated number

  /// Returns whether ours agrees with the stated number; nothing if none is stated.
  [[nodiscard]] std::optional<bool> agrees() const;
};

enum class Status {
  WithChosen,     ///< with values that no public source gives
  Derived,        ///< compared with what this project derived or another source states: no number is the thesis's
  SelfCheck,      ///< compared with what holds by construction, such as a file that is written and read again
  Photograph,     ///< of real machines
  NotComputable,  ///< has no number, or no public one
};

/// The result for a figure or table, as the thesis's own lists name it, or for one of ours on the errors of its method.
struct Entry {
  std::string id;       ///< `4.3`, `table 6.1`, `E.2`
  std::string caption;  ///< as cited; for our own figures, their subject
  int page;             ///< of the thesis; 0 for our own
  Status status;
  std::string text;             ///< what was done, or why nothing can be done
  std::vector<Number> numbers;  ///< also for photographs, if captions name some
  std::string shows;            ///< what our picture shows; empty without a picture

  /// Returns whether all stated numbers agree.
  [[nodiscard]] bool agrees() const;
  /// Returns the status in words: `reproduced with chosen values`, `derived`, `self-check`, `photograph: not
  /// computable`, `not computable`; or `differs`, if a number of the first three kinds does.
  [[nodiscard]] std::string_view status_words() const;
  /// Returns the name of its files, without extension: `4-3`, `table-6-1`, `E-2`.
  [[nodiscard]] std::string file_stem() const;
};

/// A stated share w / r of w wrong and r right positive answers, from `samples` random samples, rounded to `unit`.
struct StatedShare {
  double share, unit;
  std::uint64_t samples;
};

/// Returns by how much our share, w' / r' of n' samples, may differ from a stated one, of n samples, if both estimate
/// the same p:
///
///     4 sqrt(v + v') + u / 2,   v = (p / r) (1 + p)   (delta method, w and r being two counts of one multinomial),
///
/// where u is the unit, r = r' n / n', and p is estimated from both sides together, so that a small sample of ours with
/// few wrong answers by chance does not narrow the result. Four standard deviations are a confidence of 99.994 % for
/// large counts. A count of 0 wrong answers on either side is taken as 1. Requires right > 0.
[[nodiscard]] double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples,
                               const StatedShare& stated);

/// Returns the entries of figures.json with what was computed: figures 2.1 to 6.31 and tables 5.1 to 6.2 in the
/// thesis's order, each chapter's tables after its figures, then ours. [arshad2008, lists of figures and of tables]
///
/// Each entry of the file has an id, a caption, a page unless it is ours, a status, a text, what its picture shows, if
/// there is one, and numbers. `{name}` in a text or in what a number is stands for a computed text or number. A number
/// has the name of what is computed; what it is; a unit; whether it rests on chosen values; and, if one is stated, the
/// stated number with its basis and a tolerance: each a number, or the name of one. For a ratio that was stated of
/// random samples, `stated samples` and what it is `rounded to` give the tolerance. Numbers that were
/// not measured are left out.
///
/// Throws cell::BadCell, which names the file, the entry and the key, if the file is malformed, or if nothing computes
/// what it names.
[[nodiscard]] std::vector<Entry> read_entries(const std::filesystem::path& file, const Computed& computed);
/// The same for a study and the file that comes with the program.
[[nodiscard]] std::vector<Entry> entries_of(const Study& study);

}  // namespace touchstone::figures
