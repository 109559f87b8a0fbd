// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::judge {
namespace {

TEST(Verdict, CasesAreWrittenInTheFormOfTheContract) {
  const Polygon polygon({{0, 0, 0}, {4, 0, -0.0}, {0, 4, 0}}, {{{1, 1, 0}, {1.5, 1, 0}, {1, 1.25, 0}}});
  EXPECT_EQ(cases::to_line(cases::case_of("a-1", {{0.1, -0.0, 1e300}, 5e-324}, polygon, {"star", "tangent"})),
            R"({"id":"a-1","ball":{"center":[0.1,0,1e+300],"radius":5e-324},)"
            R"("polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]],"holes":[[[1,1,0],[1.5,1,0],[1,1.25,0]]]},)"
            R"("tags":["star","tangent"]})"
            "\n");
}

TEST(Verdict, NumbersAreShortestAndReadBackAsTheSameDouble) {
  for (const double value : {0.1, 1e23, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 1.0 / 3, -123456789.0}) {
    cases::PartialAnswer answer;
    answer.distance = value;
    const std::string line = cases::to_line(cases::object_of(answer));
    EXPECT_EQ(nlohmann::json::parse(line)["distance"].get<double>(), value) << line;
  }
}

TEST(Verdict, WhatIsNoFiniteNumberIsNull) {
  cases::PartialAnswer answer;
  answer.distance = std::numeric_limits<double>::infinity();
  answer.off_plane = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cases::to_line(cases::object_of(answer)), "{\"distance\":null,\"off_plane\":null}\n");
}

TEST(Verdict, KeysThatAMethodDoesNotComputeAreLeftOut) {
  EXPECT_EQ(cases::to_line(cases::verdict_of("a\"b", "m", cases::PartialAnswer{})), R"({"id":"a\"b","method":"m"})"
                                                                                    "\n");
}

/// Returns whether a reply meets the expectation.
bool meets(const std::string& expected, const std::string& reply) {
  return cases::differences(nlohmann::json::parse(expected), cases::answer_in(nlohmann::json::parse(reply))).empty();
}

TEST(Verdict, CoordinatesAndLengthsAreComparedAsTheDoublesThatTheyMean) {
  const std::string low = R"({"point":[-9223372036854775808,0,0]})", high = R"({"point":[9223372036854775808,0,0]})";
  EXPECT_FALSE(meets(low, high));
  EXPECT_FALSE(meets(high, low));
  EXPECT_TRUE(meets(low, low));
  for (const std::string key : {"distance", "off_plane"}) {
    const auto of = [&](const std::string& number) { return "{\"" + key + "\":" + number + "}"; };
    EXPECT_FALSE(meets(of("18446744073709551615"), of("-1")));
    EXPECT_FALSE(meets(of("-1"), of("18446744073709551615")));
    EXPECT_TRUE(meets(of("9007199254740993"), of("9007199254740992")));
    EXPECT_TRUE(meets(of("9007199254740993"), of("9007199254740992.0")));
    EXPECT_TRUE(meets(of("18446744073709551615"), of("18446744073709551616")));
    EXPECT_FALSE(meets(of("9007199254740994"), of("9007199254740992")));
    EXPECT_FALSE(meets(of("0"), of("null")));
  }
}

TEST(Verdict, IndicesAreComparedAsWholeNumbers) {
  EXPECT_FALSE(meets(R"({"edges_hit":[18446744073709551615]})", R"({"edges_hit":[-1]})"));
  EXPECT_FALSE(meets(R"({"edges_hit":[9007199254740993]})", R"({"edges_hit":[9007199254740992]})"));
  EXPECT_FALSE(meets(R"({"edges_hit":[1]})", R"({"edges_hit":[1,2]})"));
  EXPECT_FALSE(meets(R"({"nearest":{"kind":"edge","index":1}})", R"({"nearest":{"kind":"edge","index":2}})"));
  EXPECT_FALSE(meets(R"({"nearest":{"kind":"edge"}})", R"({"nearest":{"kind":"edge","index":2}})"));
  EXPECT_TRUE(meets(R"({"nearest":{"kind":"edge","index":1}})", R"({"nearest":{"kind":"edge","index":1.0}})"));
}

TEST(Verdict, LengthsOfAReplyAreWrittenAsTheDoublesThatTheyMean) {
  EXPECT_EQ(cases::to_line(cases::answer_in(
                nlohmann::json::parse(R"({"distance":9007199254740993,"edges_hit":[9007199254740993]})"))),
            "{\"edges_hit\":[9007199254740993],\"distance\":9007199254740992}\n");
}

}  // namespace
}  // namespace touchstone::judge
