// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/case.h"

#include <gtest/gtest.h>

#include "experiments/program/json.h"

namespace touchstone::cases {
namespace {

constexpr auto kTriangle = R"("polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]]})";
constexpr auto kBall = R"("ball":{"center":[0.5,0.25,1],"radius":1})";

std::string object(const std::string& members) { return "{" + members + "}"; }
/// A sound case with this text between its id and its ball.
std::string with_more(const std::string& members) { return object(R"("id":"a",)" + members + kBall + "," + kTriangle); }
std::string with_ball(const std::string& ball) { return object(R"("id":"a","ball":)" + ball + "," + kTriangle); }
std::string with_polygon(const std::string& polygon) {
  return object(R"("id":"a",)" + std::string(kBall) + R"(,"polygon":)" + polygon);
}

std::string code(const std::string& line) {
  const Case read = read_case(line);
  const auto* rejection = std::get_if<Rejection>(&read.content);
  return rejection ? std::string(to_string(rejection->code)) : "accepted";
}

std::string message(const std::string& line) { return std::get<Rejection>(read_case(line).content).message; }

TEST(ReadCase, TakesTheExampleOfTheContract) {
  const Case read = read_case(
      R"({"id":"tilted-L-17","ball":{"center":[0.5,0.25,1],"radius":1},"polygon":{"outer":[[0,0,0],[1,0,0],[1,1,0]],)"
      R"("holes":[]},"expected":{"relation":"touching"},"tags":["tangent","lattice"]})");
  EXPECT_EQ(read.id, "tilted-L-17");
  EXPECT_EQ(read.expected->values.relation, Relation::Touching);
  const auto& shapes = std::get<Shapes>(read.content);
  EXPECT_EQ(shapes.ball().center, Eigen::Vector3d(0.5, 0.25, 1));
  EXPECT_EQ(shapes.polygon.vertex_count(), 3u);
}

TEST(ReadCase, ReadsTheEndOfAMotion) {
  const auto with_motion = [](const std::string& motion, const std::string& ball = kBall) {
    return object(R"("id":"a",)" + ball + R"(,"motion":)" + motion + "," + kTriangle);
  };
  const Case read = read_case(with_motion(R"({"to":[0.5,0.25,-1]})"));
  EXPECT_EQ(std::get<Shapes>(read.content).motion()->to, Eigen::Vector3d(0.5, 0.25, -1));
  EXPECT_FALSE(std::get<Shapes>(read_case(with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,0]]})")).content).motion());
  for (const char* motion : {"null", "[1,2,3]", "{}", R"({"to":null})", R"({"to":[1,2]})", R"({"to":[1,2,"3"]})",
                             R"({"to":[1,2,3,4]})", R"({"to":[1,2,3],"to":[1,2,3]})"})
    EXPECT_EQ(code(with_motion(motion)), "malformed-case") << motion;
  EXPECT_EQ(message(with_motion("7")), "motion is not an object");
  EXPECT_EQ(message(with_motion("{}")), "motion has no key \"to\"");
  EXPECT_EQ(message(with_motion(R"({"to":[1,2]})")), "motion.to is not a point of three numbers");
  EXPECT_EQ(code(with_motion(R"({"to":[1,1e400,2]})")), "not-finite");
  EXPECT_EQ(message(with_motion(R"({"to":[1,1e400,2]})")), "motion.to is not finite");
  // In the order of the codes: numbers that are not finite come before a negative radius.
  const std::string negative = R"("ball":{"center":[0,0,0],"radius":-1})";
  EXPECT_EQ(code(with_motion(R"({"to":[1,1e400,2]})", negative)), "not-finite");
  EXPECT_EQ(code(with_motion(R"({"to":[1,2,2]})", negative)), "negative-radius");
}

TEST(ReadCase, OpensLoopsThatAreClosed) {
  const std::string open = R"("outer":[[0,0,0],[9,0,0],[0,9,0]],"holes":[[[1,1,0],[2,1,0],[1,2,0]]])";
  const std::string closed =
      R"("outer":[[0,0,0],[9,0,0],[0,9,0],[-0.0,0,0]],"holes":[[[1,1,0],[2,1,0],[1,2,0],[1,1,0]]])";
  const auto polygon = [](const std::string& text) {
    return std::get<Shapes>(read_case(with_polygon(text)).content).polygon;
  };
  EXPECT_EQ(polygon("{\"closed\":true," + closed + "}"), polygon("{" + open + "}"));
  EXPECT_EQ(polygon("{\"closed\":false," + open + "}"), polygon("{" + open + "}"));
  EXPECT_TRUE(read_case(with_polygon("{\"closed\":true," + closed + "}")).rewritten);
  EXPECT_FALSE(read_case(with_polygon("{\"closed\":false," + open + "}")).rewritten);
  EXPECT_EQ(code(with_polygon("{" + closed + "}")), "repeated-vertex");
  EXPECT_EQ(message(with_polygon("{\"closed\":true," + open + "}")),
            "polygon.outer is not closed: its last point is not its first");
  EXPECT_EQ(
      message(with_polygon(R"({"closed":true,"outer":[[0,0,0],[9,0,0],[0,9,0],[0,0,0]],"holes":[[[1,1,0],[2,1,0]]]})")),
      "polygon.holes[0] is not closed: its last point is not its first");
  EXPECT_EQ(code(with_polygon(R"({"closed":true,"outer":[[0,0,0]]})")), "malformed-case");
  EXPECT_EQ(code(with_polygon(R"({"closed":true,"outer":[[0,0,0],[1,0,0],[0,0,0]]})")), "too-few-vertices");
  for (const char* value : {"1", "null", "\"yes\"", "[]"})
    EXPECT_EQ(message(with_polygon("{\"closed\":" + std::string(value) + "," + open + "}")),
              "polygon.closed is neither true nor false");
}

TEST(ReadCase, ReadsNumbersAsTheNearestDoubles) {
  const Case read = read_case(with_ball(R"({"center":[0.1,9007199254740993,1e-400],"radius":-0})"));
  const auto& ball = std::get<Shapes>(read.content).ball();
  EXPECT_EQ(ball.center, Eigen::Vector3d(0.1, 9007199254740992.0, 0));
  EXPECT_EQ(ball.radius, 0);
}

TEST(ReadCase, SaysWhereALineIsNotJson) {
  for (const char* line : {"nonsense", "{\"id\":\"a\"", R"({"id":NaN})", R"({"id":Infinity})", "{'id':1}", "{} {}"})
    EXPECT_THROW((void)read_case(line), program::NotJson) << line;
}

// The text around numbers beyond the doubles must still be JSON.
TEST(ReadCase, HoldsNumbersBeyondTheFiniteDoublesToTheGrammar) {
  for (const char* line : {R"({"a":1e400,1e400:1})", "[1e400-5]", "[01e999]", "[-01e999]", "[--1e400]", "[+1e400]",
                           "[.1e400]", "[1.e400]", "[1e400e1]", "[1e400.5]", "[1e4001e400]", "[1e400 1e400]", "1e400x"})
    EXPECT_THROW((void)read_case(line), program::NotJson) << line;
  for (const char* line : {"[1e400]", "[-1.5E+400,1]", R"(["\\",1e400,"\"1e400-5"])"})
    EXPECT_EQ(code(line), "malformed-case") << line;
  EXPECT_EQ(code(with_more(R"("more":[1,-1e400],)")), "accepted");
}

TEST(ReadCase, TakesANulByteForNoEndOfTheLine) {
  const std::string good = with_more("");
  EXPECT_THROW((void)read_case(good + std::string("\0garbage", 8)), program::NotJson);
  EXPECT_THROW((void)read_case(good + std::string("\0", 1)), program::NotJson);
}

TEST(ReadCase, TakesNoByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF", good = with_more("");
  for (const std::string& line :
       {mark + good, mark, " " + mark + good, good + mark, good.substr(0, 1) + mark + good.substr(1)})
    EXPECT_THROW((void)read_case(line), program::NotJson) << line;
  EXPECT_EQ(read_case(object("\"id\":\"" + mark + "\"")).id, mark) << "within a text it is a letter";
}

TEST(ReadCase, LetsIdsAndTagsBeAnyString) {
  const std::string odd = R"("id":"\u0000beyond the finite doubles","tags":["\u0000beyond the finite doubles"],)";
  const std::string shape = std::string(kBall) + "," + kTriangle;
  EXPECT_EQ(code(object(odd + shape)), "accepted");
  const Case beside_an_overflow = read_case(object(odd + R"("more":1e400,)" + shape));
  EXPECT_TRUE(std::holds_alternative<Shapes>(beside_an_overflow.content));
  EXPECT_EQ(beside_an_overflow.id, std::string("\0beyond the finite doubles", 26));
}

TEST(ReadCase, RejectsWhatIsNestedTooDeep) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  const std::string shape = std::string(kBall) + "," + kTriangle;
  const auto more = [&](const std::string& value) { return with_more(R"("more":)" + value + ","); };
  EXPECT_EQ(code(more(nested(program::kMostLevels - 1))), "accepted");
  EXPECT_EQ(code(more(nested(program::kMostLevels))), "malformed-case");
  EXPECT_EQ(code(more(nested(1'000'000))), "malformed-case");
  EXPECT_EQ(read_case(more(nested(1'000'000))).id, "a");
  EXPECT_EQ(code(with_more(R"("expected":{"point":)" + nested(10'000) + "},")), "malformed-case");
  EXPECT_EQ(code(nested(1'000'000)), "malformed-case");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += R"({"x":)";
  EXPECT_EQ(code(more(objects + "1e400" + std::string(100'000, '}'))), "malformed-case");
  EXPECT_THROW((void)read_case(std::string(1'000'000, '[')), program::NotJson);
  EXPECT_EQ(code(object(R"("id":"[[[[)" + std::string(100, '[') + "\"," + shape)), "accepted");
}

TEST(ReadCase, RejectsAnExpectationBeyondTheFiniteDoubles) {
  const std::string expecting = R"("expected":{"point":[0,1e400,0]},)";
  EXPECT_EQ(code(with_more(expecting)), "not-finite");
  EXPECT_EQ(message(with_more(expecting)), "expected.point has a number beyond the finite doubles");
  EXPECT_EQ(code(object(R"("id":"a",)" + expecting + kBall + R"(,"polygon":[])")), "malformed-case");
}

TEST(ReadCase, RejectsMalformedCases) {
  const std::string id = R"("id":"a",)", ball = std::string(kBall) + ",", triangle = kTriangle;
  for (const std::string& line :
       {std::string("[1]"), std::string("{}"),
        object(ball + triangle),  // no id
        object(R"("id":7,)" + ball + triangle),
        object(id + triangle),  // no ball
        object(id + kBall),     // no polygon
        with_ball(R"({"center":[0,0],"radius":1})"), with_ball(R"({"center":[0,0,"0"],"radius":1})"),
        with_ball(R"({"center":[0,0,0]})"), with_ball(R"({"center":[0,0,0],"radius":true})"),
        with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,0,0]]})"),
        with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,0]],"holes":{}})"), with_polygon(R"({"holes":[]})"),
        with_more(R"("tags":"tangent",)"), with_more(R"("expected":[],)"),
        with_more(R"("expected":{"relatoin":"touching"},)"),
        with_more(R"("expected":{"error":"zero-normal","contact":true},)")})
    EXPECT_EQ(code(line), "malformed-case") << line;
}

TEST(ReadCase, RejectsADuplicateKeyAtAnyDepth) {
  for (const std::string& line : {with_more(R"("id":"b",)"), with_ball(R"({"center":[0,0,0],"radius":1,"radius":1})"),
                                  with_more(R"("more":[{"x":1,"\u0078":2}],)")})
    EXPECT_EQ(code(line), "malformed-case") << line;
}

TEST(ReadCase, AllowsKeysThatTheContractDoesNotKnow) { EXPECT_EQ(code(with_more(R"("origin":{"a":1},)")), "accepted"); }

TEST(ReadCase, RejectsNumbersBeyondTheFiniteDoublesAfterWrongForm) {
  EXPECT_EQ(code(object(R"("id":"a\"-1e400","ball":{"center":[0,-1e400,0],"radius":1},)" + std::string(kTriangle))),
            "not-finite");
  EXPECT_EQ(code(with_ball(R"({"center":[0,0,0],"radius":1e309})")), "not-finite");
  EXPECT_EQ(code(with_polygon(R"({"outer":[[0,0,0],[1,0,0],[1,1,2e308]]})")), "not-finite");
  EXPECT_EQ(code(with_ball(R"({"center":[0,1e400],"radius":1})")), "malformed-case");
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
  EXPECT_EQ(read.expected->texts.at("error"), "\"malformed-case\"");
  EXPECT_FALSE(read_case("{}").id.has_value());
}

TEST(ReadCase, TakesNothingFromAMalformedExpectation) {
  for (const char* expected : {R"({"error":false})", R"({"error":"zero-normal","foot":"inside"})",
                               R"({"error":true,"error":true})", R"({"error":true},"expected":{"error":true})"})
    EXPECT_FALSE(read_case(object(R"("id":"a","expected":)" + std::string(expected))).expected.has_value()) << expected;
  const Case sound = read_case(R"({"id":"a","id":"b","expected":{"error":"malformed-case"}})");
  EXPECT_TRUE(sound.expected.has_value()) << "the duplicate key lies elsewhere";
}

}  // namespace
}  // namespace touchstone::cases
