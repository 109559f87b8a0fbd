// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/verdict.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/cases/comparison.h"

namespace touchstone::cases {
namespace {

TEST(Verdict, CasesAreWrittenInTheFormOfTheContract) {
  const Polygon polygon({{0, 0, 0}, {4, 0, -0.0}, {0, 4, 0}}, {{{1, 1, 0}, {1.5, 1, 0}, {1, 1.25, 0}}});
  EXPECT_EQ(case_line("a-1", Shapes{Ball{{0.1, -0.0, 1e300}, 5e-324}, polygon}, {"star", "tangent"}),
            R"({"id":"a-1","ball":{"center":[0.1,0,1e+300],"radius":5e-324},)"
            R"("polygon":{"outer":[[0,0,0],[4,0,0],[0,4,0]],"holes":[[[1,1,0],[1.5,1,0],[1,1.25,0]]]},)"
            R"("tags":["star","tangent"]})"
            "\n");
}

TEST(Verdict, NumbersAreShortestAndReadBackAsTheSameDouble) {
  for (const double value : {0.1, 1e23, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 1.0 / 3, -123456789.0}) {
    PartialAnswer answer;
    answer.distance = value;
    const std::string line = to_line(object_of(answer));
    EXPECT_EQ(nlohmann::json::parse(line)["distance"].get<double>(), value) << line;
  }
}

TEST(Verdict, WhatIsNoFiniteNumberIsNull) {
  PartialAnswer answer;
  answer.distance = std::numeric_limits<double>::infinity();
  answer.off_plane = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_line(object_of(answer)), "{\"distance\":null,\"off_plane\":null}\n");
}

TEST(Verdict, KeysThatAMethodDoesNotComputeAreLeftOut) {
  EXPECT_EQ(verdict_line("a\"b", "m", stated(PartialAnswer{})), R"({"id":"a\"b","method":"m"})"
                                                                "\n");
}

/// Returns the differences between an expectation and a reply.
std::vector<std::string> differences(const std::string& expected, const std::string& reply) {
  std::vector<std::string> sentences;
  for (const auto& difference :
       cases::differences(stated_in(nlohmann::json::parse(expected)), stated_in(nlohmann::json::parse(reply))))
    sentences.push_back(to_string(difference));
  return sentences;
}

/// Returns whether a reply meets the expectation.
bool meets(const std::string& expected, const std::string& reply) { return differences(expected, reply).empty(); }

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
  EXPECT_EQ(
      verdict_line("a", "m",
                   stated_in(nlohmann::json::parse(R"({"distance":9007199254740993,"edges_hit":[9007199254740993]})"))),
      "{\"id\":\"a\",\"method\":\"m\",\"edges_hit\":[9007199254740993],\"distance\":9007199254740992}\n");
}

TEST(Verdict, ValuesThatDoNotHaveTheFormOfTheContractAreComparedAsWritten) {
  EXPECT_TRUE(meets(R"({"relation":"near"})", R"({"relation":"near"})"));
  EXPECT_TRUE(meets(R"({"nearest":{"kind":"face","index":0}})", R"({"nearest":{"index":0,"kind":"face"}})"));
  EXPECT_EQ(differences(R"({"relation":"touching","foot":7,"contact":true})", R"({"relation":"near","foot":[7]})"),
            (std::vector<std::string>{"contact: expected true, not given", "foot: expected 7, found [7]",
                                      "relation: expected \"touching\", found \"near\""}));
  EXPECT_FALSE(meets(R"({"edges_hit":[-1]})", R"({"edges_hit":[1]})"));
  EXPECT_FALSE(meets(R"({"point":[0,0]})", R"({"point":[0,0,0]})"));
}

// What is read back from a statement is the statement.
TEST(Verdict, StatementsAreReadAsTheAnswersThatTheyState) {
  PartialAnswer answer;
  answer.plane = PlaneSide::Behind;
  answer.plane_tangent = false;
  answer.foot = PointLocation::Boundary;
  answer.edges_hit = {0, 7};
  answer.relation = Relation::Overlapping;
  answer.contact = true;
  answer.nearest = {Feature::Kind::Vertex, 3};
  answer.point = {-0.0, std::numeric_limits<double>::infinity(), 0.1};
  answer.distance = 5e-324;
  answer.contact_normal = {-0.6, 0, 0.8};
  answer.depth = -1;
  answer.off_plane = std::numeric_limits<double>::quiet_NaN();
  const StatedAnswer read = stated_in(nlohmann::json(object_of(answer)));
  EXPECT_EQ(read.texts, stated(answer).texts);
  EXPECT_EQ(read.texts.size(), 12U);
  for (const Key& key : kKeys) {
    if (!has(answer, key)) continue;
    EXPECT_TRUE(has(read.values, key)) << key.name;
    EXPECT_TRUE(same_value(key, read.values, answer)) << key.name;
    EXPECT_FALSE(same_value(key, only(answer, {}), answer)) << key.name;
    EXPECT_EQ(find_key(key.name), key);
  }
}

TEST(Verdict, StatementsAboutMovingBallsAreReadAsTheAnswersThatTheyState) {
  const Feature vertex{Feature::Kind::Vertex, 3};
  for (const FirstContact& first :
       {FirstContact{FirstContactKind::Way, 0.25, true, vertex, {0.1, 0, 0}, {0, -0.6, 0.8}},
        FirstContact{FirstContactKind::Start, 0, false, {Feature::Kind::Face, 0}, {1, 2, 3}, {0, 0, 1}, 0.5},
        FirstContact{}}) {
    const auto answer = PartialAnswer::of(first, 0.5, "");
    const StatedAnswer read = stated_in(nlohmann::json(object_of(answer)));
    EXPECT_EQ(read.texts, stated(answer).texts);
    EXPECT_EQ(read.texts.size(), 9U);
    for (const Key& key : kKeys) {
      EXPECT_EQ(has(answer, key) || is_null(answer, key), read.texts.contains(std::string(key.name))) << key.name;
      EXPECT_TRUE(same_value(key, read.values, answer)) << key.name;
      EXPECT_EQ(find_key(key.name), key);
    }
    EXPECT_TRUE(differences(read, stated(answer)).empty());
  }
}

// The contract: null without a value; momentary is null except for `way`.
TEST(Verdict, KeysAboutMovingBallsAreNullAsTheContractHasIt) {
  const auto text = [](const FirstContact& first) { return to_line(object_of(PartialAnswer::of(first, 0, ""))); };
  EXPECT_EQ(text({}),
            "{\"contact\":false,\"first\":\"none\",\"time\":null,\"momentary\":null,\"feature\":null,"
            "\"point\":null,\"contact_normal\":null,\"depth\":null,\"off_plane\":0}\n");
  EXPECT_EQ(
      text({FirstContactKind::Start, 0, false, {Feature::Kind::Edge, 1}, {1, 0, 0}, {0, 0, 1}, 0.5}),
      "{\"contact\":true,\"first\":\"start\",\"time\":0,\"momentary\":null,"
      "\"feature\":{\"kind\":\"edge\",\"index\":1},\"point\":[1,0,0],\"contact_normal\":[0,0,1],\"depth\":0.5,\"off_plane\":0}\n");
  EXPECT_EQ(
      text({FirstContactKind::Way, 1, true, {Feature::Kind::Face, 0}, {1, 0, 0}, {0, 0, -1}}),
      "{\"contact\":true,\"first\":\"way\",\"time\":1,\"momentary\":true,"
      "\"feature\":{\"kind\":\"face\"},\"point\":[1,0,0],\"contact_normal\":[0,0,-1],\"depth\":0,\"off_plane\":0}\n");
}

TEST(Verdict, NullIsMetByNullAlone) {
  EXPECT_TRUE(meets(R"({"first":"none","point":null,"feature":null,"time":null})",
                    R"({"first":"none","point":null,"feature":null,"time":null})"));
  EXPECT_FALSE(meets(R"({"point":null})", R"({"point":[0,0,0]})"));
  EXPECT_FALSE(meets(R"({"feature":null})", R"({"feature":{"kind":"face"}})"));
  EXPECT_FALSE(meets(R"({"momentary":null})", R"({"momentary":false})"));
  EXPECT_FALSE(meets(R"({"momentary":null})", R"({})"));
}

TEST(Verdict, DifferingKeysAreThoseThatBothAnswersHave) {
  PartialAnswer truth, answer;
  truth.contact = true, truth.distance = 1.0, truth.foot = PointLocation::Inside;
  answer.contact = false, answer.distance = std::numeric_limits<double>::infinity();
  answer.nearest = {Feature::Kind::Face, 0};
  EXPECT_EQ(differing_keys(truth, answer),
            (std::vector{key_of(&PartialAnswer::contact), key_of(&PartialAnswer::distance)}));
  EXPECT_TRUE(differing_keys(truth, truth).empty());
  EXPECT_TRUE(differing_keys(truth, {}).empty());
}

}  // namespace
}  // namespace touchstone::cases
