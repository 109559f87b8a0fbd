// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/run/sweep.h"
#include "experiments/run/table.h"

namespace touchstone::stability {

/// Distances from the origin, in multiples of the longest side of a triangle's box. Triangles lie around zero, and are
/// moved away in a random direction.
inline constexpr double kOnsetDistances[] = {0, 1e6};
/// The radius differs from the exact distance by 2^-k of it, for each k from kCoarsest to kFinest.
inline constexpr int kCoarsest = 16, kFinest = 52;

/// The relative offset of the radius from the distance to a triangle's face at which signs computed in doubles start to
/// be wrong: failures by distance from the origin, method and offset. Each offset has two answers, above and below; a
/// triangle fails if one of them is wrong.
class Onset {
 public:
  Onset() = default;
  explicit Onset(std::vector<std::string> methods);

  /// First `ericson-absolute`, the closest point of [ericson2005, 5.1.5] as coordinates, then its distance; `ericson`,
  /// the same in differences (methods/ericson.h); then the methods of the settings.
  [[nodiscard]] const std::vector<std::string>& methods() const { return methods_; }
  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }
  [[nodiscard]] std::uint64_t failures(std::size_t distance, std::size_t method, int k) const {
    return failures_[place(distance, method, k)];
  }
  /// Returns the number of wrong answers, among twice as many answers as triangles.
  [[nodiscard]] std::uint64_t wrong(std::size_t distance, std::size_t method, int k) const {
    return wrong_[place(distance, method, k)];
  }
  /// Returns the coarsest offset at which at least this share failed, and at least one triangle; 0 without such an
  /// offset.
  [[nodiscard]] int first(std::size_t distance, std::size_t method, double share) const;

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

/// Returns an empty onset.
[[nodiscard]] Onset no_onset(const std::vector<const cases::Method*>& methods);

/// Measures the random triangles that the onset does not contain yet. The result is a function of
/// (methods, triangles done, seed), independent of threads and stops.
void find_onset(const std::vector<const cases::Method*>& methods, std::uint64_t triangles, std::uint64_t seed,
                unsigned threads, const run::RunControl& control, Onset& onset);

/// The effect of contracting products and sums to fused multiply-adds on the sign of an expression in doubles: the same
/// expressions of signs.h, with and without std::fma, independently of the compiler's flags.
struct ContractionCount {
  std::string_view sign;    ///< orientation (of three points in the plane), side, line, plane
  std::string_view family;  ///< the exact sign is zero, or one double beside zero
  std::uint64_t trials = 0, plain_wrong = 0, fused_wrong = 0, differ = 0;
};

/// Runs `trials` of each sign and family; a function of (trials, seed). Orientation and side use vectors with all bits
/// set, one of them a power of two times the other; line and plane use balls that touch a lattice triangle exactly
/// (bench). For signs beside zero, one coordinate or the radius is moved by one double. Cost: about 30 us per trial of
/// all signs.
[[nodiscard]] std::vector<ContractionCount> count_contractions(std::uint64_t trials, std::uint64_t seed);

/// Results that reproduce experience known from the literature.
struct Known {
  Onset onset;
  std::vector<ContractionCount> contractions;
};

/// Writes onset.csv and contraction.csv: known_tables() says what they hold. The same bytes for the same settings,
/// whatever the threads. Throws std::runtime_error, which names the file, if it cannot be written.
void write_known(const std::filesystem::path& folder, const Known& known);

[[nodiscard]] std::vector<run::TableDescription> known_tables();

}  // namespace touchstone::stability
