// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/failures.h"

#include <gtest/gtest.h>

#include <vector>

namespace touchstone::cases {
namespace {

TEST(Failures, OfEachOutcomeAreCountedApart) {
  Failures failures;
  for (const std::optional<Outcome> outcome :
       {std::optional<Outcome>(), std::optional(Outcome::Right), std::optional(Outcome::WronglyIn),
        std::optional(Outcome::WronglyOut), std::optional(Outcome::WronglyOut), std::optional(Outcome::BoundaryMissed)})
    failures.add(outcome);
  EXPECT_EQ(failures, (Failures{.trials = 6, .wrong = 4, .wrongly_in = 1, .wrongly_out = 2, .unsure = 1}));
  EXPECT_EQ(failures.boundary_missed(), 1U);
  EXPECT_EQ(failures.not_right(), 5U);
  failures.add_sample(true);
  failures.add_sample(false);
  EXPECT_EQ(failures.share(), 5.0 / 8);
}

// Of a method that does not lift, those about the polygon as given are its own.
TEST(CrossingFailures, AreAboutTheQuestionThatTheMethodUnderstands) {
  CrossingFailures given, lifted;
  for (const Outcomes outcomes :
       {Outcomes{Outcome::Right, Outcome::Right}, Outcomes{Outcome::WronglyIn, Outcome::Right},
        Outcomes{Outcome::WronglyOut, Outcome::WronglyOut}, Outcomes{Outcome::Right, Outcome::WronglyIn}, Outcomes{}}) {
    given.add(outcomes, false);
    lifted.add(outcomes, true);
  }
  EXPECT_EQ(given, (CrossingFailures{{.trials = 5, .wrong = 2, .wrongly_in = 1, .wrongly_out = 1, .unsure = 1}, 3, 1}));
  EXPECT_EQ(lifted,
            (CrossingFailures{{.trials = 5, .wrong = 2, .wrongly_in = 1, .wrongly_out = 1, .unsure = 1}, 3, 1}));
}

TEST(Failures, OfABandLieBetweenItsEnds) {
  std::vector<Failures> counts(all_offsets().size());
  const auto band = [&] { return to_string(band_of(counts, &Failures::not_right)); };
  EXPECT_EQ(band(), "none seen");
  counts[counts.size() / 2].unsure = 1;
  EXPECT_EQ(band(), "0");
  EXPECT_EQ(to_string(band_of(counts, &Failures::wrong)), "none seen");
  counts[counts.size() / 2 + 2].wrong = 1;
  EXPECT_EQ(band(), "0 to 2^-6");
  counts[1].wrong = 1;
  EXPECT_EQ(band(), "-2^28 to 2^-6");
  counts.back().wrong = counts.front().wrong = 1;
  EXPECT_EQ(band(), "-2^32 or beyond to 2^32 or beyond");
  EXPECT_EQ(total(counts).not_right(), 5U);
}

}  // namespace
}  // namespace touchstone::cases
