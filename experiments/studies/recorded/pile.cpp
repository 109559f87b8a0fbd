// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/recorded/pile.h"

#include "experiments/cases/workloads/random.h"

namespace touchstone::recorded {
namespace {

constexpr std::uint64_t kStream = 0x70696c65;
constexpr std::size_t kSide = 12;   // cells
constexpr std::size_t kAcross = 3;  // balls, of a layer's side

double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

}  // namespace

Pile draw_pile(std::uint64_t seed, std::uint64_t index, std::size_t balls) {
  workloads::Random random(seed, index, kStream);
  Pile pile;
  const auto place = [&random](std::size_t i) {
    return static_cast<double>(i) - double{kSide} / 2 + (random.unit() - 0.5) / 2;
  };
  for (std::size_t i = 0; i <= kSide; ++i)
    for (std::size_t j = 0; j <= kSide; ++j) {
      const double x = place(i), y = place(j), bowl = (x * x + y * y) / 16;
      pile.vertices.emplace_back(rounded(x), rounded(y), rounded(bowl + random.unit() / 2));
    }
  for (std::size_t i = 0; i < kSide; ++i)
    for (std::size_t j = 0; j < kSide; ++j) {
      const std::size_t a = i * (kSide + 1) + j, b = a + kSide + 1;
      pile.triangles.push_back({a, b, b + 1});
      pile.triangles.push_back({a, b + 1, a + 1});
    }
  constexpr double kApart = 1.5;  // more than two radii
  for (std::size_t i = 0; i < balls; ++i) {
    const auto at = [&random](std::size_t n) {
      return rounded(kApart * (static_cast<double>(n) + (random.unit() - 0.5) / 8));
    };
    const double x = at(i % kAcross) - kApart, y = at(i / kAcross % kAcross) - kApart;
    const double z = at(1 + i / kAcross / kAcross);
    pile.balls.push_back({{rounded(x), rounded(y), z}, rounded(0.25 + 0.375 * random.unit())});
  }
  return pile;
}

}  // namespace touchstone::recorded
