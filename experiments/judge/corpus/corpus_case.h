// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"

namespace touchstone::corpus {

/// A valid ball, at a place or moving, a valid polygon or mesh, and their origin.
struct CorpusCase {
  std::string id;
  cases::AnyShapes shapes;
  std::vector<std::string> tags;
  std::string origin;  ///< the command that draws it again, or the reason why it was made
};

/// Returns whether the value of the key is yes or no, a choice or a count. Inexact methods nearly always miss the last
/// bit of `point`, `distance` and `time`.
[[nodiscard]] bool is_decisive(const cases::Key& key);

/// The keys that a method gets wrong, in the order of the contract, and its answer.
struct WrongAnswer {
  std::vector<cases::Key> keys;
  cases::PartialAnswer answer;
};

/// Compares the answer of the method with the truth. Keys that it omits or is unsure about are not wrong, nor is a
/// method that cannot answer about moving balls. If it throws, all keys are wrong, and the answer has none.
[[nodiscard]] WrongAnswer wrong_answer(const cases::Method& method, const cases::AnyShapes& shapes,
                                       const cases::PartialAnswer& truth);

/// Returns whether one of these keys is decisive.
[[nodiscard]] bool any_decisive(const std::vector<cases::Key>& keys);

/// Returns the methods that the corpus was chosen to fail: floating-point numbers of several kinds, the thesis, and
/// third-party kernels. Every build has all of them.
[[nodiscard]] const std::vector<const cases::Method*>& witnesses();
/// Returns the witnesses that get a decisive key wrong.
[[nodiscard]] std::vector<const cases::Method*> failing_witnesses(const cases::AnyShapes& shapes,
                                                                  const cases::PartialAnswer& truth);

/// Returns the case in the form of the contract with its whole answer, the tag `fails:NAME` for each failing witness,
/// and `origin`, as one line.
[[nodiscard]] std::string line_of(const CorpusCase& given, const cases::PartialAnswer& truth);

/// `origin` and `tags` of a line that cases::read_case accepts; empty where they are missing.
struct Labels {
  std::vector<std::string> tags;
  std::string origin;
};
[[nodiscard]] Labels labels_of(std::string_view line);

}  // namespace touchstone::corpus
