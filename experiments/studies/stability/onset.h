// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"

namespace touchstone::stability {

/// Distances from the origin, in multiples of the longest side of a triangle's box. Triangles lie around zero, and are
/// moved away in a random direction.
inline constexpr double kOnsetDistances[] = {0, 1e6};
/// The radius differs from the exact distance by 2^-k of it, for each k from kCoarsest to kFinest.
inline constexpr int kCoarsest = 16, kFinest = 52;

/// The relative offset of the radius from the distance to a triangle's face at which signs computed in doubles start to
/// be wrong: failures by distance from the origin, method and offset. Each offset has two answers, above and below; a
/// triangle fails if one of them is wrong. Known: naive doubles are wrong from 2^-51 on at the origin, and at 2^-36 in
/// 38 % of the answers a million sizes away, where they lose as much as the coordinates.
class Onset {
 public:
  explicit Onset(const std::vector<const cases::Method*>& methods);

  /// First `ericson-absolute`, the closest point of [ericson2005, 5.1.5] as coordinates, then its distance; `ericson`,
  /// the same in differences (methods/triangle_contacts.h); then the methods of the study.
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }
  [[nodiscard]] std::uint64_t failures(std::size_t distance, std::size_t method, int k) const {
    return failures_[place(distance, method, k)];
  }
  /// Returns the number of wrong answers, among twice as many answers as triangles.
  [[nodiscard]] std::uint64_t wrong(std::size_t distance, std::size_t method, int k) const {
    return wrong_[place(distance, method, k)];
  }
  /// Returns the coarsest offset at which a triangle failed.
  [[nodiscard]] std::optional<int> first(std::size_t distance, std::size_t method) const;

  /// Adds the number of wrong answers for one triangle.
  void add_wrong(std::size_t distance, std::size_t method, int k, unsigned answers) {
    failures_[place(distance, method, k)] += answers > 0 ? 1 : 0;
    wrong_[place(distance, method, k)] += answers;
  }
  void add_triangle() { ++triangles_; }
  auto members() { return std::tie(failures_, wrong_, triangles_); }

 private:
  [[nodiscard]] std::size_t place(std::size_t distance, std::size_t method, int k) const {
    return (distance * methods_.size() + method) * static_cast<std::size_t>(kFinest - kCoarsest + 1) +
           static_cast<std::size_t>(k - kCoarsest);
  }

  std::vector<std::string> methods_;
  std::vector<std::uint64_t> failures_, wrong_;
  std::uint64_t triangles_ = 0;
};

[[nodiscard]] inline std::uint64_t items_done(const Onset& onset) { return onset.triangles(); }

/// Measures random triangles. The result is a function of (methods, triangles done, seed), independent of threads and
/// stops.
void find_onset(const std::vector<const cases::Method*>& methods, std::uint64_t triangles, std::uint64_t seed,
                unsigned threads, const program::RunControl& control, Onset& onset);

/// Writes onset.csv. Throws std::runtime_error, which names the file, if it cannot be written.
void write_onset(const std::filesystem::path& folder, const Onset& onset);

[[nodiscard]] program::TableDescription onset_description();

/// Returns the first failures of each method for the terminal.
[[nodiscard]] std::string text(const Onset& onset);

}  // namespace touchstone::stability
