// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiments/judge/judge.h"

namespace touchstone::judge {

/// How often something was judged, and with which results.
struct Count {
  std::uint64_t cases = 0;
  std::uint64_t wrong = 0;      ///< another value than the expected one
  std::uint64_t not_given = 0;  ///< no value, and none that is wrong

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

}  // namespace touchstone::judge
