// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/harness/course.h"

namespace touchstone::stability {

/// Triangles about zero, and moved away from there in a random direction by so many times the longest side of their
/// box.
inline constexpr double kOnsetDistances[] = {0, 1e6};
/// The radius is off the exact distance by 2^-k of it, for each k from kCoarsest to kFinest.
inline constexpr int kCoarsest = 16, kFinest = 52;

/// At which relative offset of the radius from the distance to a triangle's face the signs of doubles begin to be
/// wrong: failures by distance from the origin, method and offset. At each offset there are two answers, above and
/// below; a triangle fails if one of them is wrong.
class Onset {
 public:
  Onset() = default;
  explicit Onset(std::vector<std::string> methods);

  /// First `ericson-absolute`, the closest point of [ericson2005, 5.1.5] as coordinates, then its distance; `ericson`,
  /// the same in differences (methods/ericson.h); then those of the settings.
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }
  [[nodiscard]] std::uint64_t failures(std::size_t distance, std::size_t method, int k) const {
    return failures_[place(distance, method, k)];
  }
  /// Of twice as many answers as triangles.
  [[nodiscard]] std::uint64_t wrong(std::size_t distance, std::size_t method, int k) const {
    return wrong_[place(distance, method, k)];
  }
  /// The coarsest offset at which at least this share failed, and more than none; 0 if there is none.
  [[nodiscard]] int first(std::size_t distance, std::size_t method, double share) const;

  /// Of one triangle.
  void add_wrong(std::size_t distance, std::size_t method, int k, unsigned answers) {
    failures_[place(distance, method, k)] += answers > 0 ? 1 : 0;
    wrong_[place(distance, method, k)] += answers;
  }
  void add_triangle() { ++triangles_; }
  Onset& operator+=(const Onset& other);

  // Throws nlohmann::json::exception where something is missing.
  friend void to_json(nlohmann::ordered_json& json, const Onset& onset);
  friend void from_json(const nlohmann::json& json, Onset& onset);

 private:
  [[nodiscard]] std::size_t place(std::size_t distance, std::size_t method, int k) const {
    return (distance * methods_.size() + method) * static_cast<std::size_t>(kFinest - kCoarsest + 1) +
           static_cast<std::size_t>(k - kCoarsest);
  }

  std::vector<std::string> methods_;
  std::vector<std::uint64_t> failures_, wrong_;
  std::uint64_t triangles_ = 0;
};

/// What no triangle has been added to yet.
[[nodiscard]] Onset no_onset(const std::vector<const cases::Method*>& methods);

/// Asks about those of the random triangles that the onset does not hold yet. At the first process: a function of
/// (methods, triangles done, seed), whatever threads, processes and stops.
void find_onset(const std::vector<const cases::Method*>& methods, std::uint64_t triangles, std::uint64_t seed,
                unsigned threads, const harness::Course<Onset>& course, Onset& onset);

}  // namespace touchstone::stability
