// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/comparison.h"

// What the judge finds out, as data: told at once, or of a part, and told where parts are merged.
namespace touchstone::judge {

/// Exit status of the judge: the worst one that occurred.
enum Status { AllMet = 0, ExpectationNotMet = 1, InputRejected = 2 };

/// A valid case, and how a method met its expectation.
struct Judged {
  static constexpr const char* kNoMotions = "cannot answer about moving balls";

  std::string method, id;
  std::string file;  ///< of the case
  std::vector<std::string> tags;
  bool has_expectation = false;
  std::vector<std::string> compared;           ///< keys of the expectation
  std::vector<cases::Difference> differences;  ///< the expectations that are not met
  std::string fault;                           ///< why there is no answer; else empty
  bool within = false;  ///< whether an answer is wrong, but not by more than the margin of the order
  bool known = false;   ///< whether there is a failure, and every one is known; set when it is told

  // Of a case with a value that is wrong, if the order keeps them; else empty.
  std::string line, verdict;  ///< as lines of JSON
  std::int64_t doubles = 0;   ///< between radius and distance; 0 for a moving ball

  auto members() {
    return std::tie(method, id, file, tags, has_expectation, compared, differences, fault, within, known, line, verdict,
                    doubles);
  }
};

/// One finding. What is empty is not told.
struct Entry {
  std::string place{}, id{};  ///< of a case with an id, which must be unique if failures are known
  std::string complaint{};    ///< a sentence
  Status status = AllMet;     ///< what the complaint makes of the exit status
  /// How an engine ended. Told last, and once if repeated; but not if there is a complaint about it, also a later one.
  std::string ending{};
  std::string verdict{};  ///< a line of JSON
  std::optional<Judged> judged{};

  auto members() { return std::tie(place, id, complaint, status, ending, verdict, judged); }
};

/// The findings about some lines of cases.
struct Judgement {
  std::uint64_t lines = 0;
  std::vector<Entry> entries;  ///< in the order of the lines

  Judgement& operator+=(const Judgement& next) {
    lines += next.lines;
    entries.insert(entries.end(), next.entries.begin(), next.entries.end());
    return *this;
  }
  auto members() { return std::tie(lines, entries); }
};

[[nodiscard]] inline std::uint64_t items_done(const Judgement& judgement) { return judgement.lines; }

}  // namespace touchstone::judge
