// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone scenes`: answers are those of the scene, settings decide every byte, and what is wrong is named.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/output.h"
#include "experiments/run/stop_signal.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::scenes {
namespace {

using run_tests::Ran;
using run_tests::Scratch;
using run_tests::text_of;

Ran touchstone_scene(std::vector<std::string> arguments) {
  return run_tests::run_captured(commands::scenes_command, std::move(arguments));
}

std::vector<nlohmann::json> lines_of(const Ran& run) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(run.out);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

/// A unit cube of quads and, above it at height 3, a triangle.
constexpr const char* kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
constexpr const char* kRoof = "OFF 5 3 0\n0 0 3\n2 0 3\n0 2 3\n2 2 3\n5 5 5\n3 0 1 2\n4 0 1 3 2\n3 1 3 2\n";

class SceneCommand : public testing::Test {
 protected:
  SceneCommand() {
    write("cube.obj", kCube);
    write("roof.off", kRoof);
  }
  std::string write(const std::string& name, const std::string& text) const {
    run::write_file(scratch.path / name, text);
    return path(name);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  /// As objects of the scene are named.
  [[nodiscard]] std::string object(const std::string& stem) const {
    return scratch.path.filename().string() + "/" + stem;
  }

  Scratch scratch;
};

TEST_F(SceneCommand, NamesTheFacesThatAreTouchedByObjectAndByTheirNumbersInTheMesh) {
  const std::string balls = write("balls.txt", "# x y z r\n0.5 0.5 2 1   # touches both\n\n9 9 9 0.5\n");
  const Ran run = touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", balls});
  EXPECT_EQ(run.status, 0) << run.err;
  const auto lines = lines_of(run);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0]["id"], "2") << "the number of the line";
  const auto face = [&](const char* stem, int number) {
    return nlohmann::json{{"object", object(stem)}, {"face", number}};
  };
  // In the scene triangles come first; in the file the quad stands between them.
  EXPECT_EQ(lines[0]["touched"], nlohmann::json({face("cube", 1), face("roof", 0), face("roof", 1)}));
  EXPECT_EQ(lines[1]["touched"], nlohmann::json::array());
  EXPECT_NE(run.err.find("2 balls, 2 objects of 9 faces, 0 parts of files left out"), std::string::npos) << run.err;
}

TEST_F(SceneCommand, AnswersEachQuestionAboutChosenObjects) {
  const std::string balls =
      write("balls.jsonl", R"({"id":"above","ball":{"center":[0.5,0.5,2.25],"radius":1},"polygon":{}})");
  const auto ask = [&](const std::string& question, const std::string& name) {
    const Ran run =
        touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", balls, question, "--objects", object(name)});
    EXPECT_EQ(run.status, 0) << run.err;
    return lines_of(run).at(0);
  };
  EXPECT_EQ(ask("--any", "cube")["touches"], false);
  EXPECT_EQ(ask("--any", "roof")["touches"], true);
  EXPECT_EQ(ask("--all", "cube")["touched"].size(), 0U);
  EXPECT_EQ(ask("--nearest", "cube")["nearest"],
            nlohmann::json::parse(R"({"object":")" + object("cube") +
                                  R"(","face":1,"feature":{"kind":"face"},"point":[0.5,0.5,1.0],"distance":1.25,)"
                                  R"("contact_normal":[0,0,1],"depth":-0.25})"));
  EXPECT_EQ(ask("--nearest", "roof")["nearest"]["distance"], 0.75);
  const Ran unknown = touchstone_scene({path("cube.obj"), "--balls", balls, "--objects", "cone"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("no object \"cone\"; there are " + object("cube")), std::string::npos) << unknown.err;
}

// The lines of answers serve as balls again, and give the same answers.
TEST_F(SceneCommand, GivesTheSameBytesForAnyThreadsAndForItsOwnAnswersAsBalls) {
  for (const std::string question : {"--any", "--all", "--nearest"}) {
    const auto ask = [&](const std::vector<std::string>& more) {
      std::vector<std::string> arguments{path("cube.obj"), path("roof.off"), question};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Ran run = touchstone_scene(arguments);
      EXPECT_EQ(run.status, 0) << run.err;
      return run.out;
    };
    const std::string one = ask({"--samples", "100", "--threads", "1"});
    EXPECT_EQ(one, ask({"--samples", "100", "--threads", "3"}));
    EXPECT_NE(one, ask({"--samples", "100", "--seed", "2"}));
    EXPECT_EQ(one, ask({"--balls", write("again.jsonl", one)}));
    EXPECT_TRUE(one.starts_with(ask({"--samples", "40"}))) << "a ball depends on seed and index alone";
  }
}

TEST_F(SceneCommand, WritesAnswersAndARecordOfTheRunIntoAFolder) {
  const std::string folder = path("it's new/results");
  const Ran printed = touchstone_scene({path("cube.obj"), path("roof.off"), "--samples", "50"});
  const Ran run = touchstone_scene({path("cube.obj"), path("roof.off"), "--samples", "50", "--output", folder});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(text_of(folder + "/answers.jsonl"), printed.out);
  const auto record = nlohmann::json::parse(text_of(folder + "/run.json"));
  EXPECT_EQ(record["samples_done"], 50);
  EXPECT_NE(record["command"].get<std::string>().find("--samples 50 --seed 1 --method filtered"), std::string::npos);
}

// Any method: exact agrees on every ball; single floats do not where a radius is a double below the distance.
TEST_F(SceneCommand, HoldsAnotherMethodAgainstFiltered) {
  for (const std::string question : {"--any", "--all", "--nearest"}) {
    const Ran run =
        touchstone_scene({path("cube.obj"), path("roof.off"), "--samples", "60", question, "--method", "exact"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("exact answers otherwise than filtered to 0 of 60 balls"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, touchstone_scene({path("cube.obj"), path("roof.off"), "--samples", "60", question}).out);
  }
  const std::string balls = write("balls.txt", "0.5 0.5 2 0.99999999999\n0.5 0.5 2 0.5\n");
  const Ran run = touchstone_scene({path("cube.obj"), "--balls", balls, "--method", "fast-float"});
  EXPECT_NE(run.err.find("fast-float answers otherwise than filtered to 1 of 2 balls"), std::string::npos) << run.err;
  EXPECT_EQ(lines_of(run)[0]["touched"].size(), 1U) << "the answer of the method";
}

TEST_F(SceneCommand, ScalesMeshesToTheUnitOfTheScene) {
  const std::string balls = write("balls.txt", "12.7 12.7 50.8 25.4\n");
  const auto nearest = [&](const std::vector<std::string>& units) {
    std::vector<std::string> arguments{path("cube.obj"), "--balls", balls, "--nearest"};
    arguments.insert(arguments.end(), units.begin(), units.end());
    const Ran run = touchstone_scene(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return lines_of(run).at(0)["nearest"]["distance"].get<double>();
  };
  EXPECT_EQ(nearest({"--unit", "inch", "--scene-unit", "mm"}), 50.8 - 25.4);
  EXPECT_EQ(nearest({"--unit", "mm"}), nearest({})) << "in one unit nothing changes";
  const Ran two = touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", balls, "--unit", "mm,m,inch"});
  EXPECT_EQ(two.status, 2);
  EXPECT_NE(two.err.find("3 were given for 2 meshes"), std::string::npos) << two.err;
  EXPECT_NE(touchstone_scene({path("cube.obj"), "--samples", "1", "--unit", "ell"})
                .err.find("there is no unit \"ell\"; there are um, mm, cm, m, inch, foot"),
            std::string::npos);
}

TEST_F(SceneCommand, NamesTheFileAndVertexThatOverflowInTheUnitOfTheScene) {
  const std::string big = write("big.obj", "v 0 0 0\nv 1e308 0 0\nv 0 1e308 0\nf 1 2 3\n");
  const Ran run = touchstone_scene({big, "--samples", "1", "--unit", "m", "--scene-unit", "mm"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, big + ": vertex 1 leaves the finite doubles from m to mm");
  EXPECT_EQ(touchstone_scene({big, "--samples", "1", "--unit", "mm", "--scene-unit", "foot"}).status, 0);
}

// In the scene the triangles come first.
TEST_F(SceneCommand, ListsTouchedFacesByTheirNumbersInTheMesh) {
  const std::string mesh = write("mixed.off", "OFF 4 3 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 1 2 3\n3 0 1 2\n4 3 2 1 0\n");
  const Ran run = touchstone_scene({mesh, "--balls", write("balls.txt", "1.5 0.5 0 1\n")});
  std::vector<int> faces;
  const auto line = lines_of(run).at(0);
  for (const auto& face : line["touched"]) faces.push_back(face["face"].get<int>());
  EXPECT_EQ(faces, (std::vector<int>{0, 1, 2}));
}

TEST_F(SceneCommand, NumbersFilesOfOneNameSoThatNoTwoObjectsAreCalledAlike) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string off = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Ran run = touchstone_scene({write("b.obj", triangle), write("b.off", off), write("b#2.off", off), "--balls",
                                    write("balls.txt", "0 0 0 1\n")});
  EXPECT_EQ(run.status, 0) << run.err;
  std::vector<std::string> names;
  const auto line = lines_of(run).at(0);
  for (const auto& face : line["touched"]) names.push_back(face["object"].get<std::string>());
  EXPECT_EQ(names, (std::vector<std::string>{object("b"), object("b#3"), object("b#2")}));
}

TEST_F(SceneCommand, TakesNamesOfObjectsThatHoldCommas) {
  const std::string comma = write("co,mma.obj", kCube);
  const auto touched = [&](const std::vector<std::string>& names) {
    std::vector<std::string> arguments{comma, path("cube.obj"), path("roof.off"), "--balls",
                                       write("balls.txt", "0 0 3 9\n")};
    for (const std::string& name : names) arguments.insert(arguments.end(), {"--objects", name});
    const Ran run = touchstone_scene(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return lines_of(run).at(0)["touched"].size();
  };
  EXPECT_EQ(touched({object("co,mma")}), 6U);
  EXPECT_EQ(touched({object("co,mma"), object("roof")}), 9U);
  EXPECT_EQ(touched({object("cube") + "," + object("roof")}), 9U);
}

TEST_F(SceneCommand, RefusesAFileNameThatIsNotUtf8AndNamesIt) {
  const Ran run = touchstone_scene({write("bad\xff.obj", kCube), "--samples", "1"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("the name of a file is not UTF-8: " + path("bad\\xff.obj")), std::string::npos) << run.err;
}

TEST_F(SceneCommand, ReadsBallsFromAnArray) {
  std::string array =
      std::string("\x93NUMPY\1\0\x76\0", 10) + "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 4), }";
  array.resize(128, ' ');
  const double ball[] = {0.5, 0.5, 2, 1};
  array.append(reinterpret_cast<const char*>(ball), sizeof ball);
  const auto ask = [&](const std::string& balls) { return touchstone_scene({path("cube.obj"), "--balls", balls}).out; };
  EXPECT_EQ(ask(write("balls.npy", array)),
            ask(write("balls", R"({"id":"0","ball":{"center":[0.5,0.5,2],"radius":1}})")));
  EXPECT_NE(ask(path("balls.npy")), "");
}

TEST_F(SceneCommand, NamesTheFileAndLineOfABallThatIsNone) {
  const auto fault = [&](const std::string& text) {
    const Ran run = touchstone_scene({path("cube.obj"), "--balls", write("balls", "0 0 0 1\n" + text + "\n")});
    EXPECT_EQ(run.status, 2) << text;
    const std::string prefix = path("balls") + ": line 2: ";
    EXPECT_TRUE(run.err.starts_with(prefix)) << run.err;
    return run.err.substr(std::min(prefix.size(), run.err.size()));
  };
  EXPECT_EQ(fault("1 2 3"), "expected four numbers, x y z r, or seven, found 3");
  EXPECT_EQ(fault("1 2 3 4 5"), "expected four numbers, x y z r, or seven, found 5");
  EXPECT_EQ(fault("1 2 3 4 5 6 7 8"), "expected four numbers, x y z r, or seven, found 8");
  EXPECT_NE(fault("1 2 3 4 5 6 nan"), "");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,3],"radius":1},"motion":7})"), "motion is not an object");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,3],"radius":1},"motion":{}})"), "motion has no key \"to\"");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,3],"radius":1},"motion":{"to":[1]}})"),
            "motion.to is not a point of three numbers");
  EXPECT_NE(
      fault(R"({"ball":{"center":[1,2,3],"radius":1},"motion":{"to":[1,2,3],"to":[1,2,3]}})").find("duplicate key"),
      std::string::npos);
  EXPECT_EQ(fault("1 2 x 4"), "'x' is not a number");
  EXPECT_EQ(fault("1,2,3,4"), "'1,2,3,4' is not a number");
  EXPECT_NE(fault("1 2 nan 4"), "");
  EXPECT_NE(fault("1 2 3 1e400"), "");
  EXPECT_NE(fault("1 2 3 -1"), "");
  EXPECT_TRUE(fault("{\"ball\":").starts_with("not JSON: "));
  EXPECT_EQ(fault("{}"), "the line has no key \"ball\"");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2],"radius":1}})"), "ball.center is not a point of three numbers");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,"3"],"radius":1}})"), "a coordinate of ball.center is not a number");
  EXPECT_EQ(fault(R"({"ball":{"center":[1,2,3]}})"), "ball has no key \"radius\"");
  EXPECT_EQ(fault(R"({"id":7,"ball":{"center":[1,2,3],"radius":1}})"), "id is not a string");
  EXPECT_NE(fault(R"({"ball":{"center":[1,2,3],"radius":1,"radius":2}})").find("a duplicate key"), std::string::npos);
  const Ran absent = touchstone_scene({path("cube.obj"), "--balls", path("absent")});
  EXPECT_EQ(absent.status, 2);
  EXPECT_EQ(absent.err, path("absent") + ": cannot be read: No such file or directory");
}

TEST_F(SceneCommand, ListsTheFacesOnTheWayOfABallInTheOrderOfTime) {
  // Down past the roof at height 3, into the cube.
  const std::string balls = write("balls", "0.5 0.5 6 0.5 0.5 0.5 0.75\n9 9 9 1 9 9 8\n0.5 0.5 6 0.5\n");
  const Ran run = touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", balls});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto lines = lines_of(run);
  EXPECT_EQ(lines[0]["motion"], nlohmann::json::parse(R"({"to":[0.5,0.5,0.75]})"));
  const nlohmann::json& touched = lines[0]["touched"];
  std::vector<std::pair<std::string, int>> faces;
  for (const auto& face : touched) faces.emplace_back(face["object"], face["face"]);
  // Both faces of the roof at once, then the top and the four sides together with it, as it is a quarter away from
  // them.
  EXPECT_EQ(faces, (std::vector<std::pair<std::string, int>>{{object("roof"), 0},
                                                             {object("roof"), 1},
                                                             {object("cube"), 1},
                                                             {object("cube"), 2},
                                                             {object("cube"), 3},
                                                             {object("cube"), 4},
                                                             {object("cube"), 5}}));
  EXPECT_EQ(touched[0]["time"], touched[1]["time"]);
  EXPECT_NEAR(touched[0]["time"].get<double>(), 2.5 / 5.25, 1e-15);
  EXPECT_EQ(touched[0]["first"], "way");
  EXPECT_EQ(touched[2]["feature"], nlohmann::json({{"kind", "face"}}));
  EXPECT_EQ(touched[2]["point"], nlohmann::json({0.5, 0.5, 1.0}));
  EXPECT_EQ(lines[1]["touched"], nlohmann::json::array());
  EXPECT_FALSE(lines[2].contains("motion"));

  // A case may hold the motion; answers serve as balls again.
  const std::string again = write("again.jsonl", run.out);
  EXPECT_EQ(touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", again}).out, run.out);
  const auto any = lines_of(touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", again, "--any"}));
  EXPECT_EQ(any[0]["touches"], true);
  EXPECT_EQ(any[1]["touches"], false);
  EXPECT_EQ(any[2]["touches"], false) << "it does not move";
  const Ran nearest = touchstone_scene({path("cube.obj"), "--balls", again, "--nearest"});
  EXPECT_EQ(nearest.status, 2);
  EXPECT_NE(nearest.err.find("the ball \"1\" moves"), std::string::npos) << nearest.err;
}

TEST_F(SceneCommand, HoldsAnotherMethodAgainstFilteredForBallsThatMove) {
  const std::string balls = write("balls", "0.5 0.5 6 0.5 0.5 0.5 0.75\n9 9 9 1 9 9 8\n");
  const auto ask = [&](const std::string& method) {
    return touchstone_scene({path("cube.obj"), path("roof.off"), "--balls", balls, "--method", method});
  };
  const Ran exact = ask("exact");
  EXPECT_EQ(exact.out, ask("filtered").out);
  EXPECT_NE(exact.err.find("exact answers otherwise than filtered to 0 of 2 balls"), std::string::npos) << exact.err;
  const Ran thesis = ask("thesis");
  EXPECT_EQ(thesis.status, 2);
  EXPECT_NE(thesis.err.find("does not compute the contact of moving balls"), std::string::npos) << thesis.err;
}

TEST_F(SceneCommand, MergesFacesSoThatABallMeetsNoSeam) {
  const std::string floor = write(
      "floor.obj",
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 5 5 5\nv 6 6 6\nv 7 7 7\nf 1 2 5 4\nf 7 8 9\nf 2 3 6 5\n");
  const std::string balls = write("balls", "1 0.5 1 1\n");
  const auto nearest = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{floor, "--balls", balls, "--nearest", "--skip-bad"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran run = touchstone_scene(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("line 11: face 1: zero-normal"), std::string::npos) << run.err;
    return lines_of(run).at(0)["nearest"];
  };
  EXPECT_EQ(nearest({})["feature"]["kind"], "edge");
  EXPECT_EQ(nearest({})["face"], 0);
  EXPECT_EQ(nearest({"--merge"})["feature"]["kind"], "face");
  EXPECT_EQ(nearest({"--merge"})["faces"], nlohmann::json({0, 2}));
  EXPECT_FALSE(nearest({"--merge"}).contains("face"));
}

TEST_F(SceneCommand, SaysHowFarFacesThatAreNotPlanarAreDisplaced) {
  const std::string warped = write("warped.obj", "v 0 0 0\nv 4 0 1\nv 4 4 0\nv 0 4 1\nf 1 2 3 4\nf 1 2 3\n");
  const Ran run = touchstone_scene({warped, "--balls", write("balls", "2 2 0.5 2\n")});
  const auto touched = lines_of(run).at(0)["touched"];
  EXPECT_EQ(touched[0]["off_plane"], 0.5);
  EXPECT_FALSE(touched[1].contains("off_plane"));
  EXPECT_NE(run.err.find("1 face is not planar: vertices are displaced by up to 0.5 onto the plane."),
            std::string::npos)
      << run.err;
}

TEST_F(SceneCommand, RefusesWhatIsWrongInAMeshOrSaysWhatItLeavesOut) {
  // A face without area at line 15, an index out of range at line 16.
  const std::string bad = write("bad.obj", std::string(kCube) + "f 1 2 1\nf 1 2 99\nf 1 2 3\n");
  const Ran refused = touchstone_scene({bad, "--samples", "3"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find("bad.obj: line 16: vertex 99 is out of range"), std::string::npos) << refused.err;
  const Ran skipped = touchstone_scene({bad, "--samples", "3", "--skip-bad", "--output", path("results")});
  EXPECT_EQ(skipped.status, 0) << skipped.err;
  EXPECT_NE(skipped.err.find("left out: " + bad + ": line 16: "), std::string::npos) << skipped.err;
  EXPECT_NE(skipped.err.find("left out: " + bad + ": line 15: face 6: "), std::string::npos) << skipped.err;
  EXPECT_NE(skipped.out.find("1 object of 7 faces, 2 parts of files left out"), std::string::npos) << skipped.out;
  EXPECT_NE(text_of(path("results/left-out.txt")).find("line 15"), std::string::npos);

  const std::string flat = write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\n");
  const Ran degenerate = touchstone_scene({path("cube.obj"), flat, "--samples", "3"});
  EXPECT_EQ(degenerate.status, 2);
  EXPECT_NE(degenerate.err.find("flat.obj: line 5: face 0: zero-normal: "), std::string::npos) << degenerate.err;
  EXPECT_EQ(touchstone_scene({path("cube.obj"), path("absent.stl"), "--samples", "3", "--skip-bad"}).status, 2);
  const Ran nothing = touchstone_scene({flat, "--samples", "3", "--skip-bad"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.err.find("flat.obj: no face is left"), std::string::npos) << nothing.err;
}

TEST_F(SceneCommand, TakesFacesOfNoAreaAsSegmentsIfAsked) {
  const std::string mesh =
      write("mesh.obj", "v 0 0 0\nv 4 0 0\nv 2 0 0\nv 0 4 0\nv 4 4 4\nf 1 2 4\nf 1 3 2\nf 1 2 5 4\nf 5 5 5\n");
  const std::string balls = write("balls", "2 -1 0 1\n4 4 5 1\n");
  const Ran ran = touchstone_scene({mesh, "--balls", balls, "--as-segments"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto lines = lines_of(ran);
  const nlohmann::json on_edge = lines.at(0)["touched"], at_vertex = lines.at(1)["touched"], corners = {0, 1, 2};
  EXPECT_FALSE(on_edge.at(0).contains("corners"));
  EXPECT_EQ(on_edge.at(1)["face"], 1);
  EXPECT_EQ(on_edge.at(1)["corners"], corners);
  EXPECT_EQ(at_vertex.back()["face"], 3);
  EXPECT_EQ(at_vertex.back()["corners"], corners);
  EXPECT_NE(ran.err.find("2 faces are of no area: segments or points."), std::string::npos) << ran.err;
  EXPECT_EQ(touchstone_scene({mesh, "--balls", balls}).status, 2);
  EXPECT_EQ(touchstone_scene({mesh, "--balls", balls, "--as-segments", "--merge"}).status, 2);
  EXPECT_EQ(touchstone_scene({mesh, "--balls", balls, "--as-segments", "--method", "exact"}).status, 2);
}

TEST_F(SceneCommand, RefusesOtherBadFacesWhereItTakesSegments) {
  const std::string mesh = write("mesh.obj", "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 2\nf 1 2 3 4\n");
  const std::string balls = write("balls", "0 0 1 1\n");
  const Ran refused = touchstone_scene({mesh, "--balls", balls, "--as-segments"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("mesh.obj: line 6: face 1: "), std::string::npos) << refused.err;
  const Ran skipped = touchstone_scene({mesh, "--balls", balls, "--as-segments", "--skip-bad"});
  EXPECT_EQ(skipped.status, 0) << skipped.err;
  EXPECT_EQ(lines_of(skipped).at(0)["touched"].size(), 1U);
}

// "Nothing is touched" would be a wrong answer about what the file was meant to hold.
TEST_F(SceneCommand, RefusesAMeshWithoutAFaceWhateverIsAskedOfIt) {
  const std::string balls = write("balls.txt", "0 0 0 1\n");
  const std::string wide = write("wide.obj", std::string("\xFF\xFEv\0 \0", 6));
  const std::string capitals = write("capitals.obj", "V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n");
  for (const std::string skip : {"", "--skip-bad"})
    for (const std::string& bad : {wide, capitals, write("empty.obj", ""), write("empty.stl", std::string(84, '\0'))})
      for (const std::string question : {"--any", "--all", "--nearest"}) {
        std::vector<std::string> arguments{path("cube.obj"), bad, "--balls", balls, question};
        if (!skip.empty()) arguments.push_back(skip);
        const Ran ran = touchstone_scene(arguments);
        EXPECT_EQ(ran.status, 2) << bad;
        EXPECT_EQ(ran.out, "") << bad;
        EXPECT_TRUE(ran.err.starts_with("touchstone: " + bad + ": ")) << ran.err;
      }
}

TEST_F(SceneCommand, RefusesAMeshWhoseFacesAreAllLeftOut) {
  const std::string balls = write("balls.txt", "0 0 0 1\n");
  const std::string flat = write("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n");
  const Ran ran = touchstone_scene({path("cube.obj"), flat, "--balls", balls, "--skip-bad"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("touchstone: " + flat + ": no face is left"), std::string::npos) << ran.err;
}

TEST_F(SceneCommand, WantsOneSourceOfBallsAndOneQuestion) {
  EXPECT_EQ(touchstone_scene({path("cube.obj")}).status, 2);
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--samples", "1", "--balls", "x"}).status, 2);
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--samples", "1", "--any", "--nearest"}).status, 2);
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--samples", "-1"}).status, 2);
  EXPECT_NE(touchstone_scene({path("cube.obj"), "--samples", "1", "--method", "guess"}).err.find("guess"),
            std::string::npos);
}

/// While one lives, no file can grow: as where a disk is full.
class NoRoomForFiles {
 public:
  NoRoomForFiles() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit none{0, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  NoRoomForFiles(const NoRoomForFiles&) = delete;
  NoRoomForFiles& operator=(const NoRoomForFiles&) = delete;
  ~NoRoomForFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(SceneCommand, FailsWhereAnAnswerCannotBeWrittenAndWhateverCameAfterIt) {
  for (const char* count : {"1", "2000"}) {
    const NoRoomForFiles no_room;
    const Ran file = touchstone_scene({path("cube.obj"), "--samples", count, "--force", "--output", path("full")});
    EXPECT_EQ(file.status, 2);
    EXPECT_EQ(file.err, path("full/answers.jsonl") + ": cannot be written: File too large");
    EXPECT_FALSE(std::filesystem::exists(path("full/run.json")));
  }

  // Longer than any buffer, so that nothing is left to be written at the end.
  std::string many;
  for (int i = 0; i < 4000; ++i) many += "f 1 2 3\n";
  const std::string mesh = write("many.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + many);
  const std::string balls = write("ball.txt", "0 0 0 1\n");
  std::fflush(stdout);
  const int kept = ::dup(STDOUT_FILENO), full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  ::dup2(full, STDOUT_FILENO);
  const std::string said = run_tests::message_of<std::exception>([&] {
    run_tests::run_command(commands::scenes_command, {mesh, "--balls", balls});
  });
  ::dup2(kept, STDOUT_FILENO);
  std::clearerr(stdout);
  ::close(kept);
  ::close(full);
  EXPECT_EQ(said, "standard output: cannot be written: No space left on device");
}

TEST_F(SceneCommand, RefusesAFileOfAnswersThatCannotBeOpened) {
  std::filesystem::create_directories(path("results/answers.jsonl"));
  const Ran run = touchstone_scene({path("cube.obj"), "--samples", "1", "--force", "--output", path("results")});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, path("results/answers.jsonl") + ": cannot be written: Is a directory");
}

TEST_F(SceneCommand, ReplacesASymbolicLinkInPlaceOfFollowingIt) {
  const std::string victim = write("victim.txt", "precious\n");
  std::filesystem::create_directories(path("results"));
  std::filesystem::create_symlink(victim, path("results/answers.jsonl"));
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--samples", "1", "--force", "--output", path("results")}).status, 0);
  EXPECT_EQ(text_of(victim), "precious\n");
  EXPECT_FALSE(std::filesystem::is_symlink(path("results/answers.jsonl")));
}

TEST_F(SceneCommand, TakesItsOwnFileOfAnswersForBallsAndReplacesIt) {
  const std::string file = path("results/answers.jsonl");
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--samples", "30", "--output", path("results")}).status, 0);
  const std::string once = text_of(file);
  EXPECT_EQ(touchstone_scene({path("cube.obj"), "--balls", file, "--force", "--output", path("results")}).status, 0);
  EXPECT_EQ(text_of(file), once);
  EXPECT_EQ(touchstone_scene({path("absent.obj"), "--balls", file, "--force", "--output", path("results")}).status, 2);
  EXPECT_EQ(text_of(file), once) << "a run that is refused loses no results";
}

// Answers go to a pipe, which holds the command up until it has been interrupted.
TEST_F(SceneCommand, RecordsWhatIsMissingWhereItIsInterrupted) {
  std::signal(SIGINT, SIG_DFL);  // in the background of a shell it is ignored
  std::filesystem::create_directories(path("results"));
  ASSERT_EQ(::mkfifo(path("results/answers.jsonl").c_str(), 0600), 0);
  std::thread reader([file = path("results/answers.jsonl")] {
    const int pipe = ::open(file.c_str(), O_RDONLY);
    char bytes[4096];
    (void)!::read(pipe, bytes, sizeof bytes);
    ::kill(::getpid(), SIGINT);
    while (::read(pipe, bytes, sizeof bytes) > 0) {
    }
    ::close(pipe);
  });
  const Ran run = touchstone_scene({path("cube.obj"), "--samples", "1000000", "--force", "--output", path("results")});
  // Where the command wrote nothing, the reader still waits.
  const int writer = ::open(path("results/answers.jsonl").c_str(), O_RDWR | O_NONBLOCK);
  EXPECT_EQ(::write(writer, "x", 1), 1);
  ::close(writer);
  reader.join();
  EXPECT_EQ(run.status, run::kInterrupted) << run.err;
  const auto record = nlohmann::json::parse(text_of(path("results/run.json")));
  const auto asked = record["samples_asked"].get<int>(), done = record["samples_done"].get<int>();
  EXPECT_EQ(record["interrupted"], true);
  EXPECT_EQ(asked, 1'000'000);
  EXPECT_LT(done, asked);
  EXPECT_EQ(record["samples_missing"], asked - done);
}

}  // namespace
}  // namespace touchstone::scenes
