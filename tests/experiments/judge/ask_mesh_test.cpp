// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone ask --mesh`: answers are those of the scene, and what is wrong in a mesh or a list of balls is named.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/commands.h"
#include "experiments/judge/ask.h"
#include "experiments/program/output.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::judge {
namespace {

using nlohmann::json;
using run_tests::Ran;
using run_tests::text_of;

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
  return lines;
}

/// A unit cube of quads, below two triangles at height 3, one before and one after it.
constexpr const char* kCubeAndRoof =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0 0 3\nv 2 0 3\nv 0 2 3\nv 2 2 3\n"
    "f 9 10 11\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 9 12 11\n";

class AskMesh : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    program::write_file(scratch.path / name, text);
    return path(name);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  static Ran ask(std::vector<std::string> arguments) {
    return run_tests::run_captured(commands::ask_command, std::move(arguments));
  }
  [[nodiscard]] Ran ask_about(const std::string& file, const std::string& balls,
                              const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--mesh", file, "--balls", write("balls.txt", balls)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return ask(arguments);
  }
  [[nodiscard]] std::vector<json> answers(const std::string& file, const std::string& balls,
                                          const std::vector<std::string>& more = {}) const {
    const Ran ran = ask_about(file, balls, more);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return lines_of(ran.out);
  }

  run_tests::Scratch scratch;
  std::string mesh = write("mesh.obj", kCubeAndRoof);
  std::string object = scratch.path.filename().string() + "/mesh";
};

std::vector<std::uint32_t> faces_of(const json& line) {
  std::vector<std::uint32_t> faces;
  for (const json& face : line["touched"]) faces.push_back(face["face"].get<std::uint32_t>());
  return faces;
}

// In the scene triangles come first; in the file the quads stand between them.
TEST_F(AskMesh, NamesTheTouchedFacesByTheirNumbersInTheMesh) {
  const auto lines = answers(mesh, "# x y z r\n0.5 0.5 2 1   # touches both\n\n 9\t9 9 0.5 \r\n");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], (json{{"id", "2"},
                            {"ball", {{"center", {0.5, 0.5, 2.0}}, {"radius", 1.0}}},
                            {"touched",
                             {{{"object", object}, {"face", 0}},
                              {{"object", object}, {"face", 2}},
                              {{"object", object}, {"face", 7}}}}}));
  EXPECT_EQ(lines[1]["id"], "4") << "the number of the line";
  EXPECT_EQ(lines[1]["touched"], json::array());
}

TEST_F(AskMesh, FindsTheNearestFace) {
  const auto lines = answers(mesh, "0.5 0.5 1.75 1\n", {"--nearest"});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0]["nearest"],
            json::parse(R"({"object":")" + object +
                        R"(","face":2,"feature":{"kind":"face"},"point":[0.5,0.5,1.0],"distance":0.75,)"
                        R"("contact_normal":[0,0,1],"depth":0.25})"));
}

/// Balls about the mesh, one a line; every third one moves if they may.
std::string many_balls(std::size_t count, bool move) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    workloads::Random random(1, i, 7);
    const double x = 3 * random.unit() - 0.5, y = 3 * random.unit() - 0.5, z = 4 * random.unit() - 0.5;
    text += fmt::format("{} {} {} {}", x, y, z, random.unit());
    text += move && i % 3 == 0 ? fmt::format(" {} {} {}\n", y, z, x) : "\n";
  }
  return text;
}

// More balls than are asked together, at places and on ways, each against the scene's answer about it alone.
TEST_F(AskMesh, AnswersAboutEachOfManyBalls) {
  constexpr std::size_t kBalls = 33'000;
  const std::string text = many_balls(kBalls, true);
  const AskedMesh asked = read_asked_mesh(mesh);
  const auto balls = read_balls(write("many.txt", text));
  const auto lines = answers(mesh, text);
  ASSERT_EQ(balls.size(), kBalls);
  ASSERT_EQ(lines.size(), kBalls);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < kBalls; ++i) {
    std::vector<std::uint32_t> faces;
    const auto* motion = std::get_if<Motion>(&balls[i].question);
    if (motion != nullptr) {
      for (const auto& [id, first] : asked.scene.touched_in_order(*motion)) faces.push_back(asked.numbers[id.face]);
    } else {
      for (const auto id : asked.scene.touched(std::get<Ball>(balls[i].question)))
        faces.push_back(asked.numbers[id.face]);
      std::ranges::sort(faces);
    }
    touching += faces.empty() ? 0 : 1;
    ASSERT_EQ(lines[i]["id"], std::to_string(i + 1));
    ASSERT_EQ(lines[i].contains("motion"), motion != nullptr) << i;
    ASSERT_EQ(faces_of(lines[i]), faces) << i;
  }
  EXPECT_GT(touching, kBalls / 10);
  EXPECT_LT(touching, kBalls - kBalls / 10);
}

TEST_F(AskMesh, FindsTheNearestFaceOfEachOfManyBalls) {
  const std::string text = many_balls(20'000, false);
  const AskedMesh asked = read_asked_mesh(mesh);
  const auto balls = read_balls(write("many.txt", text));
  const auto lines = answers(mesh, text, {"--nearest"});
  ASSERT_EQ(lines.size(), balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto nearest = asked.scene.nearest(std::get<Ball>(balls[i].question));
    ASSERT_EQ(lines[i]["nearest"]["face"], asked.numbers[nearest->face.face]) << i;
    ASSERT_EQ(lines[i]["nearest"]["distance"], nearest->distance) << i;
  }
}

TEST_F(AskMesh, ListsTheFacesOnTheWayOfABallInTheOrderOfTime) {
  // Down past the roof at height 3, into the cube.
  const auto lines = answers(mesh, "0.5 0.5 6 0.5 0.5 0.5 0.75\n9 9 9 1 9 9 8\n0.5 0.5 6 0.5\n");
  EXPECT_EQ(lines[0]["motion"], json::parse(R"({"to":[0.5,0.5,0.75]})"));
  const json& touched = lines[0]["touched"];
  // The two faces of the roof at once, then the top, and the four sides together with it, as it is a half away from
  // them.
  EXPECT_EQ(faces_of(lines[0]), (std::vector<std::uint32_t>{0, 7, 2, 3, 4, 5, 6}));
  EXPECT_EQ(touched[0]["time"], touched[1]["time"]);
  EXPECT_NEAR(touched[0]["time"].get<double>(), 2.5 / 5.25, 1e-15);
  EXPECT_EQ(touched[0]["first"], "way");
  EXPECT_EQ(touched[2]["feature"], json({{"kind", "face"}}));
  EXPECT_EQ(touched[2]["point"], json({0.5, 0.5, 1.0}));
  EXPECT_FALSE(touched[0].contains("contact"));
  EXPECT_EQ(lines[1]["touched"], json::array());
  EXPECT_FALSE(lines[2].contains("motion"));
  const Ran nearest = ask_about(mesh, "0 0 0 1\n0.5 0.5 6 0.5 0.5 0.5 0.75\n", {"--nearest"});
  EXPECT_EQ(nearest.status, 2);
  EXPECT_NE(nearest.err.find("that of line 2 moves"), std::string::npos) << nearest.err;
}

TEST_F(AskMesh, TellsHowFarFacesThatAreNotPlanarAreDisplaced) {
  const std::string warped = write("warped.obj", "v 0 0 0\nv 4 0 1\nv 4 4 0\nv 0 4 1\nf 1 2 3 4\nf 1 2 3\n");
  const json touched = answers(warped, "2 2 0.5 2\n").at(0)["touched"];
  EXPECT_EQ(touched[0]["off_plane"], 0.5);
  EXPECT_FALSE(touched[1].contains("off_plane"));
}

TEST_F(AskMesh, NamesTheFileAndLineOfABallThatIsNone) {
  const auto fault = [&](const std::string& text) {
    const Ran ran = ask_about(mesh, "0 0 0 1\n" + text + "\n");
    EXPECT_EQ(ran.status, 2) << text;
    EXPECT_EQ(ran.out, "");
    const std::string prefix = "--balls: " + path("balls.txt") + ": line 2: ";
    EXPECT_TRUE(ran.err.starts_with(prefix)) << ran.err;
    return ran.err.substr(std::min(prefix.size(), ran.err.size()));
  };
  EXPECT_EQ(fault("1 2 3"), "expected four numbers, x y z r, or seven, found 3");
  EXPECT_EQ(fault("1 2 3 4 5"), "expected four numbers, x y z r, or seven, found 5");
  EXPECT_EQ(fault("1 2 3 4 5 6 7 8"), "expected four numbers, x y z r, or seven, found 8");
  EXPECT_EQ(fault("1 2 x 4"), "'x' is not a number");
  EXPECT_EQ(fault("1,2,3,4"), "'1,2,3,4' is not a number");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,3],"radius":1}})"),
            R"('{"ball":{"center":[1,2,3],"radius":1}}' is not a number)");
  for (const char* text : {"1 2 nan 4", "1 2 3 1e400", "1 2 3 -1", "1 2 3 4 5 6 nan"}) EXPECT_NE(fault(text), "");
  const Ran absent = ask({"--mesh", mesh, "--balls", path("absent")});
  EXPECT_EQ(absent.status, 2);
  EXPECT_EQ(absent.err, "--balls: " + path("absent") + ": cannot be read: No such file or directory");
}

// One ball and many balls meet the same mesh, and the same fault of it.
TEST_F(AskMesh, RefusesABadMeshAndNamesThePlaceWhateverIsAskedOfIt) {
  const auto fault = [&](const std::string& bad) {
    const Ran one = ask({"--mesh", bad, "--ball", "0,0,0,1"}), many = ask_about(bad, "0 0 0 1\n");
    for (const Ran& ran : {one, many}) {
      EXPECT_EQ(ran.status, 2) << bad;
      EXPECT_EQ(ran.out, "") << bad;
    }
    EXPECT_EQ(one.err, many.err);
    const std::string prefix = "--mesh: " + bad + ": ";
    EXPECT_TRUE(one.err.starts_with(prefix)) << one.err;
    return one.err.substr(std::min(prefix.size(), one.err.size()));
  };
  EXPECT_EQ(fault(write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 99\n")),
            "line 5: vertex 99 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(fault(write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")),
            "line 4: face 0: zero-normal: the outer loop: its Newell normal is zero");
  // "Nothing is touched" would be a wrong answer about what the file was meant to hold.
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"wide.obj", {"\xFF\xFEv\0 \0", 6}},
                                   {"capitals.obj", "V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n"},
                                   {"empty.obj", ""},
                                   {"empty.stl", std::string(84, '\0')}})
    EXPECT_NE(fault(write(name, text)), "");
  EXPECT_NE(fault(path("absent.obj")), "");
}

TEST_F(AskMesh, EscapesAFileNameThatIsNotUtf8) {
  EXPECT_EQ(answers(write("bad\xff.obj", kCubeAndRoof), "0 0 3 0\n").at(0)["touched"][0]["object"],
            scratch.path.filename().string() + "/bad\\xff");
}

TEST_F(AskMesh, WritesTheLinesToAFile) {
  const std::string balls = "0.5 0.5 2 1\n9 9 9 1\n", file = path("answers.jsonl");
  const std::string printed = ask_about(mesh, balls).out;
  const Ran ran = ask_about(mesh, balls, {"--output", file});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(text_of(file), printed);
  const Ran again = ask_about(mesh, "9 9 9 1\n", {"--output", file});
  EXPECT_EQ(again.status, 2);
  EXPECT_EQ(again.err, file + ": exists already; --force overwrites it");
  EXPECT_EQ(text_of(file), printed);
  EXPECT_EQ(ask_about(mesh, "9 9 9 1\n", {"--output", file, "--force"}).status, 0);
  EXPECT_EQ(lines_of(text_of(file)).size(), 1U);
}

TEST_F(AskMesh, TakesOneBallOrAFileOfThem) {
  const std::string balls = write("balls.txt", "0 0 0 1\n");
  EXPECT_EQ(ask({"--mesh", mesh}).status, 2);
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--ball", "0,0,0,1"},
                                               {"--to", "0,0,0"},
                                               {"--print"},
                                               {"--methods", "exact"},
                                               {"--show", "x.html"}}) {
    std::vector<std::string> arguments{"--mesh", mesh, "--balls", balls};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(ask(arguments).status, 2) << more.front();
  }
  EXPECT_EQ(ask({"--polygon", "0 0, 1 0, 0 1", "--balls", balls}).status, 2);
  EXPECT_EQ(ask({"--mesh", mesh, "--ball", "0,0,0,1", "--nearest"}).status, 2);
  EXPECT_EQ(ask({"--mesh", mesh, "--ball", "0,0,0,1", "--output", path("x")}).status, 2);
}

}  // namespace
}  // namespace touchstone::judge
