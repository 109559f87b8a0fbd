// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// A report in the XML of JUnit, which CI services show: a test suite for each method and file, a test case for each
/// case. An expectation that is not met is a failure; no answer is an error.
class JunitReport {
 public:
  void add(const Judged& judged);
  /// Returns the file: UTF-8, without characters that XML 1.0 forbids.
  [[nodiscard]] std::string text() const;

 private:
  struct Suite {
    std::uint64_t tests = 0, failures = 0, errors = 0;
    std::string cases;
  };
  std::map<std::pair<std::string, std::string>, Suite> suites_;  ///< by method and file
};

}  // namespace touchstone::judge
