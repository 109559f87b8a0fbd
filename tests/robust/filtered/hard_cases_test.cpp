// SPDX-License-Identifier: GPL-3.0-or-later
// What the generators of cases must not miss.
#include "tests/robust/support/hard_cases.h"

#include <gtest/gtest.h>
#include <rapidcheck/Random.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/robust/support/signed_zeros.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;

TEST(HardCases, HaveNegativeZeros) {
  // Coordinates of samples of workloads are hardly ever zero, nor are radii at a threshold.
  const std::vector<std::pair<std::string, rc::Gen<Case>>> all{{"grid_cases", grid_cases()},
                                                               {"soak_cases", soak_cases()},
                                                               {"threshold_cases", threshold_cases()},
                                                               {"degenerate_balls", degenerate_balls()},
                                                               {"off_plane_cases", off_plane_cases()},
                                                               {"scaled_cases", scaled_cases()},
                                                               {"islands", islands()},
                                                               {"hard_triangles", hard_triangles()}};
  for (const auto& [name, gen] : all) {
    NegativeZeros seen;
    rc::Random random(2026);
    for (int i = 0; i < 400; ++i) {
      const Case drawn = gen(random.split(), 100).value();
      seen.look_at(drawn.ball);
      seen.look_at(drawn.polygon);
    }
    EXPECT_TRUE(seen.center) << name;
    EXPECT_TRUE(seen.vertex) << name;
    EXPECT_TRUE(seen.radius || name == "threshold_cases") << name;
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests
