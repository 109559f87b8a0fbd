// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "geometry/contact/answer.h"
#include "robust/filtered/detail/numbers/bounded.h"

namespace touchstone::filtered::detail {
inline namespace TOUCHSTONE_TARGET {

/// Finds the first of several events, if it is certain which one that is. Times are doubles or double-doubles.
template <class Time>
class FirstCandidate {
 public:
  /// Adds an event that certainly happens, at this time up to this error.
  TOUCHSTONE_INLINE void add(const Feature& feature, const Time& time, double error) {
    // Covers the rounding of the error and of the two sums.
    const double wide = bounds::kWideError * error + kRounding * leading_part(time);
    const Time earliest = time - Time(wide), latest = time + Time(wide);
    if (before(latest, latest_)) {
      if (before(earliest_, earliest_of_others_)) earliest_of_others_ = earliest_;
      feature_ = feature, time_ = time, error_ = error, earliest_ = earliest, latest_ = latest;
    } else if (before(earliest, earliest_of_others_)) {
      earliest_of_others_ = earliest;
    }
  }
  /// Returns whether an event was added.
  [[nodiscard]] TOUCHSTONE_INLINE bool any() const { return before(latest_, Time(kNever)); }
  /// Returns whether one event is certainly before all others.
  [[nodiscard]] TOUCHSTONE_INLINE bool certain() const { return any() && before(latest_, earliest_of_others_); }
  [[nodiscard]] const Feature& feature() const { return feature_; }
  /// Returns the time of the first event, and its error.
  [[nodiscard]] const Time& time() const { return time_; }
  [[nodiscard]] double error() const { return error_; }
  /// Returns a time before which no added event happens.
  [[nodiscard]] TOUCHSTONE_INLINE double earliest() const {
    return leading_part(before(earliest_, earliest_of_others_) ? earliest_ : earliest_of_others_);
  }
  /// Returns a time until which the first event has certainly happened; at least 1 if none was added.
  [[nodiscard]] TOUCHSTONE_INLINE double latest() const { return leading_part(latest_); }

 private:
  static constexpr double kNever = 4;
  static constexpr double kRounding = std::is_same_v<Time, double> ? 0x1p-50 : 0x1p-100;
  static TOUCHSTONE_INLINE double leading_part(double time) { return time; }
  static TOUCHSTONE_INLINE double leading_part(const DoubleDouble& time) { return time.high; }
  static TOUCHSTONE_INLINE bool before(const Time& a, const Time& b) { return leading_part(a - b) < 0; }

  Feature feature_{Feature::Kind::Face, 0};
  Time time_ = kNever;
  double error_ = 0;
  Time earliest_ = kNever, latest_ = kNever, earliest_of_others_ = kNever;
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered::detail
