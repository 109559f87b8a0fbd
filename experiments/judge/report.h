// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/judge/judge.h"
#include "experiments/judge/show/case_view.h"
#include "experiments/judge/tally.h"

namespace touchstone::judge {

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
    std::string id;
    std::vector<std::string> tags;
    cases::Shapes shapes;
    cases::StatedAnswer answer;
  };
  std::map<std::string, std::vector<Wrong>> worst_;  ///< by method, the worst first
};

}  // namespace touchstone::judge
