// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/verdict.h"

namespace touchstone::corpus {

/// A ball and a polygon that every method may be asked about, and where they come from.
struct CorpusCase {
  std::string id;
  Ball ball;
  Polygon polygon;
  std::vector<std::string> tags;
  std::string origin;  ///< the command that draws it again, or why someone made it
};

/// The exact answer with all its keys, as `expected` has it.
[[nodiscard]] cases::Verdict exact_answer(const Ball& ball, const Polygon& polygon);

/// The keys that say yes or no, which or how many. Of `point` and `distance`, methods that are not exact miss the last
/// bit nearly always.
[[nodiscard]] bool is_decisive(std::string_view key);

/// The keys to which the method gives another value than the truth, with what it gives. What it leaves out, and what it
/// is unsure of, is not wrong; where it ends with an exception, all keys are, and null is given.
[[nodiscard]] cases::Verdict wrong_values(const cases::Method& method, const Ball& ball, const Polygon& polygon,
                                          const cases::Verdict& truth);

/// Is one of these keys decisive?
[[nodiscard]] bool any_decisive(const cases::Verdict& wrong);

/// The methods that the corpus was chosen to fail: plain numbers of several kinds, the thesis's, and others' kernels.
/// All of them are in every build.
[[nodiscard]] const std::vector<const cases::Method*>& witnesses();
/// Those that are wrong about a decisive key.
[[nodiscard]] std::vector<const cases::Method*> failing_witnesses(const Ball& ball, const Polygon& polygon,
                                                                  const cases::Verdict& truth);

/// The case in the contract's form with its whole answer, the tag `fails:NAME` for each failing witness, and `origin`:
/// one line.
[[nodiscard]] std::string line_of(const CorpusCase& given, const cases::Verdict& truth);

/// `origin` and `tags` of a line that cases::read_case accepts; empty where they are missing.
struct Labels {
  std::vector<std::string> tags;
  std::string origin;
};
[[nodiscard]] Labels labels_of(std::string_view line);

}  // namespace touchstone::corpus
