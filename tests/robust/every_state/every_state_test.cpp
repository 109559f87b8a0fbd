// SPDX-License-Identifier: GPL-3.0-or-later
// Every public function gives the same bits in every state of the floating-point unit, and leaves that state as found.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/robust/every_state/public_function.h"

namespace touchstone::every_state_tests {
namespace {

constexpr State kDefault{FE_TONEAREST, Environment::kKeep};
constexpr std::uint64_t kInputs = 3 * TOUCHSTONE_SAMPLES;

const std::vector<PublicFunction>& all_functions() {
  static const std::vector<PublicFunction> all = [] {
    std::vector<PublicFunction> result;
    for (const auto& some : {shape_functions(), contact_functions(), scene_functions()})
      result.insert(result.end(), some.begin(), some.end());
    return result;
  }();
  return all;
}

class EveryState : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const PublicFunction& function() const { return all_functions()[GetParam()]; }
};

TEST_P(EveryState, GivesTheSameBitsAndIsLeftAsFound) {
  std::uint64_t different = 0, disturbed = 0;
  for (std::uint64_t index = 0; index < kInputs; ++index) {
    const Input in = draw_input(index);
    const std::string expected = function().call(in, kDefault).text;
    for (const State& state : contact_tests::kStates) {
      const Outcome outcome = function().call(in, state);
      const auto where = [&] { return testing::Message() << function().name << ", input " << index << ", " << state; };
      if (outcome.text != expected && ++different == 1)
        ADD_FAILURE() << where() << "\n" << outcome.text << "\n" << expected;
      if (!outcome.left_as_found && ++disturbed == 1) ADD_FAILURE() << where() << ": the state is not left as found";
    }
  }
  EXPECT_EQ(different, 0U) << "of " << 16 * kInputs;
  EXPECT_EQ(disturbed, 0U) << "of " << 16 * kInputs;
}

TEST_P(EveryState, GivesNoNegativeZero) {
  if (!function().rounds) return;
  for (std::uint64_t index = 0; index < kInputs; ++index)
    ASSERT_FALSE(function().call(draw_input(index), kDefault).negative_zero) << function().name << ", input " << index;
}

INSTANTIATE_TEST_SUITE_P(PublicFunction, EveryState, testing::Range(std::size_t{0}, all_functions().size()),
                         [](const auto& one) {
                           std::string name = all_functions()[one.param].name;
                           for (char& c : name)
                             if (c == ':')
                               c = '_';
                             else if (c == '=')
                               c = 'E';
                           return name + "_" + std::to_string(one.param);
                         });

}  // namespace
}  // namespace touchstone::every_state_tests
