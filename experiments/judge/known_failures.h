// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::judge {

/// A failure of a method: a key of a case for which it gives another value than the expected one or none, or an answer
/// that it does not give at all. To give a wrong value is not the same failure as to give none.
struct Failure {
  static constexpr std::string_view kNoAnswer = "no answer";  ///< in place of the key

  std::string method, id, key;
  bool omits = false;  ///< whether the answer lacks the key

  friend auto operator<=>(const Failure&, const Failure&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The failures that a user knows of, and those that occur. A failure that is not judged neither occurs nor is mended.
class KnownFailures {
 public:
  KnownFailures() = default;
  /// Reads a file that `text` wrote. Throws std::runtime_error, which names the file and the line, if it cannot be read
  /// or a line does not have the form.
  explicit KnownFailures(const std::string& file);

  [[nodiscard]] bool has(const Failure& failure) const { return known_.contains(failure); }
  /// Notes what was judged, and whether it failed.
  void judged(const Failure& possible, bool failed);
  /// Returns the known failures that were judged and did not occur, ascending.
  [[nodiscard]] std::vector<Failure> mended() const;
  /// Returns how many failures that are not known occurred.
  [[nodiscard]] std::size_t new_ones() const;
  /// Returns the failures that occurred and the known ones that were not judged, one a line of JSON, by method, case
  /// and key: `{"method":"fast","case":"t","key":"contact"}`, with `"given":false` if the answer lacks the key.
  [[nodiscard]] std::string text() const;

 private:
  std::set<Failure> known_, judged_, occurred_;
};

}  // namespace touchstone::judge
