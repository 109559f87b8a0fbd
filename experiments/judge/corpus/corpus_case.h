// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/program/sweep.h"

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

/// Returns whether every coordinate and the radius is a float, and a mesh has no pose.
[[nodiscard]] bool is_in_floats(const cases::AnyShapes& shapes);

/// Returns a case like this one whose coordinates and radius are floats.
///
/// Every coordinate becomes the nearest float, of a mesh that of its posed vertices. If the radius is within 2^-40 of
/// the one at which the ball begins to touch, relatively, it becomes the least float with which the ball touches, or a
/// neighbour of that: the last float without contact, or the next one with it, by the case's id, unless a point touches
/// already. Any other radius becomes the nearest float. `origin` says how the case was made. A case that is in floats
/// stays as it is. The id ends with `-float` in either case.
///
/// Returns nothing if a number is beyond the floats, if the contract rejects the rounded polygon or mesh, if the ball
/// then touches with no float as its radius, or if rounding moves vertices off a plane from which they were off by
/// 2^-30 sizes of the polygon at most: an engine that does not lift vertices would be asked about another polygon.
[[nodiscard]] std::optional<CorpusCase> in_floats(CorpusCase given);

/// The result of a check: the number of cases, and the faults as sentences that name file, line, case and key. A check
/// that was stopped has those of the first cases.
struct Findings {
  std::size_t cases = 0;
  std::vector<std::string> faults;
};

/// Derives the whole answer of every case by `exact` and by `filtered`, and every rejection of loops; all must agree with
/// the expectation of the case. A missing key, an id that is not unique among all
/// files, and a line that is not a case are faults; the check continues with the other cases.
///
/// A part checks its share of the lines. It reads the ids of the lines before, so that the findings of all parts add up
/// to those of one check.
[[nodiscard]] Findings check_files(const std::vector<std::string>& files, program::Part part,
                                   const std::atomic<bool>& stop, const program::Progress& progress);

}  // namespace touchstone::corpus
