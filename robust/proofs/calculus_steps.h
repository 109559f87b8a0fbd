// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace touchstone::proofs {

/// The steps that the error calculus carries out in this process, each kind of numbers once. At the end they are
/// written to the file that the environment variable TOUCHSTONE_CALCULUS_STEPS names, for Coq (coq/calculus.v): a line
/// a step, its rule and its numbers in base 16. Without the variable, nothing is kept.
class CalculusSteps {
 public:
  static CalculusSteps& of_process() {
    static CalculusSteps steps;
    return steps;
  }
  CalculusSteps(const CalculusSteps&) = delete;
  CalculusSteps& operator=(const CalculusSteps&) = delete;
  ~CalculusSteps() {
    if (file_ == nullptr) return;
    std::ofstream out(file_);
    for (const std::string& step : steps_) out << step << '\n';
  }

  using Numbers = std::initializer_list<std::reference_wrapper<const mpq_class>>;
  /// Adds a step: its rule, the numbers that this is given besides bounds, and those of the bounds.
  void add(std::string_view rule, Numbers besides, Numbers bounds) {
    if (file_ == nullptr) return;
    std::string step(rule);
    for (const Numbers numbers : {besides, bounds})
      for (const mpq_class& number : numbers) step += ' ' + number.get_str(16);
    steps_.insert(std::move(step));
  }

 private:
  CalculusSteps() = default;

  const char* file_ = std::getenv("TOUCHSTONE_CALCULUS_STEPS");
  std::set<std::string> steps_;
};

}  // namespace touchstone::proofs
