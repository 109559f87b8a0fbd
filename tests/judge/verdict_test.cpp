// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::judge {
namespace {

TEST(Verdict, CasesAreWrittenInTheFormOfTheContract) {
  const Polygon polygon({{0, 0, 0}, {4, 0, -0.0}, {0, 4, 0}}, {{{1, 1, 0}, {1.5, 1, 0}, {1, 1.25, 0}}});
  EXPECT_EQ(to_line(case_of("a-1", {{0.1, -0.0, 1e300}, 5e-324}, polygon, {"star", "tangent"})),
            R"({"id":"a-1","ball":{"center":[0.1,0,1e+300],"radius":5e-324},)"
            R"("polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]],"holes":[[[1,1,0],[1.5,1,0],[1,1.25,0]]]},)"
            R"("tags":["star","tangent"]})"
            "\n");
}

TEST(Verdict, NumbersAreShortestAndReadBackAsTheSameDouble) {
  for (const double value : {0.1, 1e23, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 1.0 / 3, -123456789.0}) {
    methods::PartialAnswer answer;
    answer.distance = value;
    const std::string line = to_line(object_of(answer));
    EXPECT_EQ(nlohmann::json::parse(line)["distance"].get<double>(), value) << line;
  }
}

TEST(Verdict, WhatIsNoFiniteNumberIsNull) {
  methods::PartialAnswer answer;
  answer.distance = std::numeric_limits<double>::infinity();
  answer.off_plane = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_line(object_of(answer)), "{\"distance\":null,\"off_plane\":null}\n");
}

TEST(Verdict, KeysThatAMethodDoesNotComputeAreLeftOut) {
  EXPECT_EQ(to_line(verdict_of("a\"b", "m", methods::PartialAnswer{})), R"({"id":"a\"b","method":"m"})" "\n");
}

}  // namespace
}  // namespace touchstone::judge
