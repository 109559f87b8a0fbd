// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/judge/judge.h"

// What the judge makes of many cases: counts, a summary, JSON, JUnit and a page.
namespace touchstone::judge {

/// How often something was judged, and with which results.
struct Count {
  std::uint64_t cases = 0;
  std::uint64_t wrong = 0;      ///< another value than the expected one
  std::uint64_t not_given = 0;  ///< no value, and none that is wrong
  std::uint64_t known = 0;      ///< of these two: all failures are known
  std::uint64_t within = 0;     ///< neither, but only within the margin

  [[nodiscard]] std::uint64_t given() const { return cases - not_given; }
};

/// Counts by what cases have in common.
using Counts = std::map<std::string, Count>;

/// The results of one method. A case counts once as a whole, once for each of its keys that were compared, once for
/// its file and once for each of its tags.
struct MethodTally {
  std::string method;
  Count all;
  Counts by_key;
  Counts by_file;  ///< by the name of the file without folder and extension: the family of a corpus
  Counts by_tag;
};

/// The counts of all methods, in the order in which they first answer.
class Tally {
 public:
  void add(const Judged& judged);
  [[nodiscard]] const std::vector<MethodTally>& methods() const { return methods_; }

 private:
  std::vector<MethodTally> methods_;
};

/// Returns the name of a file without its folder and extension.
[[nodiscard]] std::string family_of_file(const std::string& file);

/// Returns a screen of text for each method: wrong cases of how many, as a whole, by key, by file and by tag, with
/// Clopper-Pearson limits of 95 % for the cases that were answered. Of the tags, only the `most_tags` with the highest
/// shares of wrong cases. `coloured`: wrong counts in red, others in green.
[[nodiscard]] std::string summary_text(const Tally& tally, bool coloured, std::size_t most_tags = 10);

/// Returns all counts as one JSON object, with a line end: `{"methods":[{"method":...,"all":{"cases":...,"wrong":...,
/// "not_given":...,"known":...,"within":...,"rate":...,"lower":...,"upper":...},"keys":{...},"families":{...},
/// "tags":{...}}]}`. `known` and `within` count whole cases, so `keys` do not have them.
[[nodiscard]] std::string summary_json(const Tally& tally);

/// A report in the XML of JUnit, which CI services show: a test suite for each method and file, a test case for each
/// case. An expectation that is not met is a failure; no answer is an error; a case whose failures are all known is
/// skipped.
class JunitReport {
 public:
  void add(const Judged& judged);
  /// Returns the file: UTF-8, without characters that XML 1.0 forbids.
  [[nodiscard]] std::string text() const;

 private:
  struct Suite {
    std::uint64_t tests = 0, failures = 0, errors = 0, skipped = 0;
    std::string cases;
  };
  std::map<std::pair<std::string, std::string>, Suite> suites_;  ///< by method and file
};

/// A page about what was judged: for each method the counts and rates by key, family and tag, and its worst cases as
/// pictures. The worst are those with a wrong contact (else any wrong key), the furthest from the threshold first.
class Report {
 public:
  static constexpr std::size_t kWorst = 8;  ///< of each method

  void add(const Judged& judged);
  /// Returns the page (HTML), which loads nothing. Cost: some hundred exact queries for each picture.
  [[nodiscard]] std::string text(const Tally& tally) const;

 private:
  struct Wrong {
    bool contact;          ///< whether its contact is wrong
    std::int64_t doubles;  ///< between radius and distance; 0 for a moving ball
    std::string line, verdict;
  };
  std::map<std::string, std::vector<Wrong>> worst_;  ///< by method, the worst first
};

}  // namespace touchstone::judge
