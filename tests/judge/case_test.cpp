// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/case.h"

#include <gtest/gtest.h>

namespace touchstone::judge {
namespace {

constexpr auto kTriangle = R"("polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]})";
constexpr auto kBall = R"("ball":{"center":[0.5,0.25,1],"radius":1})";

std::string object(const std::string& members) { return "{" + members + "}"; }
std::string with_polygon(const std::string& polygon) {
  return object(R"("id":"a",)" + std::string(kBall) + R"(,"polygon":)" + polygon);
}

std::string code(const std::string& line) {
  const Case read = read_case(line);
  const auto* rejection = std::get_if<Rejection>(&read.content);
  return rejection ? std::string(word(rejection->code)) : "accepted";
}

std::string message(const std::string& line) { return std::get<Rejection>(read_case(line).content).message; }

TEST(ReadCase, TakesTheExampleOfTheContract) {
  const Case read = read_case(
      R"({"id":"tilted-L-17","ball":{"center":[0.5,0.25,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]],)"
      R"("holes":[]},"expected":{"relation":"touching"},"tags":["tangent","lattice"]})");
  EXPECT_EQ(read.id, "tilted-L-17");
  EXPECT_EQ(read.expected->at("relation"), "touching");
  const auto& shapes = std::get<Shapes>(read.content);
  EXPECT_EQ(shapes.ball.center, Eigen::Vector3d(0.5, 0.25, 1));
  EXPECT_EQ(shapes.polygon.vertex_count(), 3u);
}

TEST(ReadCase, ReadsNumbersAsTheNearestDoubles) {
  const Case read = read_case(object(R"("id":"a","ball":{"center":[0.1,9007199254740993,1e-400],"radius":-0},)" +
                                     std::string(kTriangle)));
  const auto& ball = std::get<Shapes>(read.content).ball;
  EXPECT_EQ(ball.center, Eigen::Vector3d(0.1, 9007199254740992.0, 0));
  EXPECT_EQ(ball.radius, 0);
}

TEST(ReadCase, SaysWhereALineIsNotJson) {
  for (const char* line : {"nonsense", "{\"id\":\"a\"", R"({"id":NaN})", R"({"id":Infinity})", "{'id':1}", "{} {}"})
    EXPECT_THROW((void)read_case(line), NotJson) << line;
}

TEST(ReadCase, RejectsMalformedCases) {
  const std::string id = R"("id":"a",)", ball = std::string(kBall) + ",", triangle = kTriangle;
  EXPECT_EQ(code("[1]"), "malformed-case");
  EXPECT_EQ(code("{}"), "malformed-case");
  EXPECT_EQ(code(object(ball + triangle)), "malformed-case") << "no id";
  EXPECT_EQ(code(object(R"("id":7,)" + ball + triangle)), "malformed-case");
  EXPECT_EQ(code(object(id + triangle)), "malformed-case") << "no ball";
  EXPECT_EQ(code(object(id + kBall)), "malformed-case") << "no polygon";
  EXPECT_EQ(code(object(id + R"("ball":{"center":[0,0],"radius":1},)" + triangle)), "malformed-case");
  EXPECT_EQ(code(object(id + R"("ball":{"center":[0,0,"0"],"radius":1},)" + triangle)), "malformed-case");
  EXPECT_EQ(code(object(id + R"("ball":{"center":[0,0,0]},)" + triangle)), "malformed-case");
  EXPECT_EQ(code(object(id + R"("ball":{"center":[0,0,0],"radius":true},)" + triangle)), "malformed-case");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,0,0]]})")), "malformed-case");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,0]],"holes":{}})")), "malformed-case");
  EXPECT_EQ(code(with_polygon(R"({"holes":[]})")), "malformed-case");
  EXPECT_EQ(code(object(id + ball + triangle + R"(,"tags":"tangent")")), "malformed-case");
  EXPECT_EQ(code(object(id + ball + triangle + R"(,"expected":[])")), "malformed-case");
  EXPECT_EQ(code(object(id + ball + triangle + R"(,"expected":{"relatoin":"touching"})")), "malformed-case");
  EXPECT_EQ(code(object(id + ball + triangle + R"(,"expected":{"error":"zero-normal","contact":true})")),
            "malformed-case");
}

TEST(ReadCase, RejectsADuplicateKeyAtAnyDepth) {
  EXPECT_EQ(code(object(R"("id":"a","id":"b",)" + std::string(kBall) + "," + kTriangle)), "malformed-case");
  EXPECT_EQ(code(object(R"("id":"a","ball":{"center":[0,0,0],"radius":1,"radius":1},)" + std::string(kTriangle))),
            "malformed-case");
  EXPECT_EQ(code(object(R"("id":"a",)" + std::string(kBall) + "," + kTriangle + R"(,"more":[{"x":1,"\u0078":2}])")),
            "malformed-case");
}

TEST(ReadCase, AllowsKeysThatTheContractDoesNotKnow) {
  EXPECT_EQ(code(object(R"("id":"a","origin":{"a":1},)" + std::string(kBall) + "," + kTriangle)), "accepted");
}

TEST(ReadCase, RejectsNumbersBeyondTheFiniteDoublesAfterWrongForm) {
  EXPECT_EQ(code(object(R"("id":"a\"-1e400","ball":{"center":[0,-1e400,0],"radius":1},)" + std::string(kTriangle))),
            "not-finite");
  EXPECT_EQ(code(object(R"("id":"a","ball":{"center":[0,0,0],"radius":1e309},)" + std::string(kTriangle))), "not-finite");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,2e308]]})")), "not-finite");
  EXPECT_EQ(code(object(R"("id":"a","ball":{"center":[0,1e400],"radius":1},)" + std::string(kTriangle))),
            "malformed-case");
  EXPECT_EQ(code(object(R"("id":1e400,)" + std::string(kBall) + "," + kTriangle)), "malformed-case");
}

TEST(ReadCase, LooksForReasonsInTheOrderOfTheContract) {
  const std::string negative = R"("id":"a","ball":{"center":[0,0,0],"radius":-1},"polygon":)";
  EXPECT_EQ(code(object(negative + R"({"outer":[[0,0,0],[1,0,0]]})")), "negative-radius");
  EXPECT_EQ(code(object(negative + R"({"outer":[[0,0,0],[1,0,1e999]]})")), "not-finite");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[0,0,0],[1,0,0]],"holes":[[[0,0,0],[1,0,0]]]})")),
            "too-few-vertices");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[0,0,-0.0],[1,0,0]]})")), "repeated-vertex");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[1,1,1],[2,2,2]]})")), "zero-normal");
}

TEST(ReadCase, NamesTheLoopAndTheVertex) {
  EXPECT_EQ(message(with_polygon(R"({"outer":[[0,0,0],[9,0,0],[0,9,0]],"holes":[[[1,1,0],[2,1,0],[2,1,0]]]})")),
            "hole 0: vertex 4 equals its neighbour, vertex 5");
  EXPECT_EQ(message(with_polygon(R"({"outer":[[0,0,0],[9,0,0],[0,9,0]],"holes":[[[1,1,0],[2,1]]]})")),
            "polygon.holes[0][1] is not a point of three numbers");
}

TEST(ReadCase, KeepsIdAndExpectationOfARejectedCase) {
  const Case read = read_case(R"({"id":"a","expected":{"error":"malformed-case"}})");
  EXPECT_EQ(read.id, "a");
  EXPECT_EQ(read.expected->at("error"), "malformed-case");
  EXPECT_FALSE(read_case("{}").id.has_value());
}

}  // namespace
}  // namespace touchstone::judge
