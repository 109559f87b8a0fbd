// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of meshes: what is drawn near them, what is counted and kept, and what the command says of faulty files.
#include "experiments/studies/near_edge/faces.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "geometry/io/read_mesh.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/mesh/scene_faces.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::near_edge::faces {
namespace {

namespace fs = std::filesystem;
using run_tests::Ran;
using run_tests::text_of;

// A cube of quads, then a quad that is off its plane, a face without area and a bow tie.
constexpr const char* kCube = R"(v 0.1 0.1 0.1
v 1.3 0.1 0.1
v 1.3 1.3 0.1
v 0.1 1.3 0.1
v 0.1 0.1 1.3
v 1.3 0.1 1.3
v 1.3 1.3 1.3
v 0.1 1.3 1.3
v 1.3 1.3 1.4
v 2.5 0.1 0.1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
f 5 6 9 8
f 1 2 10
f 1 10 4 3
)";
constexpr std::uint64_t kFaces = 9, kAccepted = 7;

/// A folder of its own for each test, with the cube in it.
class MeshContact : public testing::Test {
 protected:
  MeshContact() {
    fs::create_directories(folder / "model");
    cube = write("model/cube.obj", kCube);
  }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }

  /// Runs the program in the folder.
  Ran touchstone(const std::string& arguments) const {
    const std::string command = "cd '" + folder.string() + "' && '" TOUCHSTONE_PROGRAM "' " + arguments + " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder / "out"), text_of(folder / "err")};
  }

  const run_tests::Scratch scratch;
  const fs::path folder = scratch.path;
  fs::path cube;
};

Result measured(const Settings& settings, const std::vector<NamedMesh>& meshes,
                const std::atomic<bool>& stop = run_tests::kNeverStop) {
  Result result = no_result(settings, meshes);
  measure(settings, meshes, {stop, run_tests::kSilent}, result);
  return result;
}

Result study(const fs::path& mesh, const std::vector<std::string>& methods) {
  return measured({.methods = methods::find_methods(methods)}, {{"model/cube", read_mesh(mesh).mesh}});
}

std::vector<nlohmann::json> lines_of(const fs::path& file) {
  std::vector<nlohmann::json> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST_F(MeshContact, ComesToEveryFaceAndNamesThoseRejected) {
  const Result result = study(cube, {"all"});
  ASSERT_EQ(result.meshes.size(), 1U);
  const MeshCounts& counts = result.meshes[0];
  EXPECT_EQ(counts.faces, kFaces);
  EXPECT_EQ(counts.queries, kAccepted * kPlaces.size() * kSteps.size());
  ASSERT_EQ(counts.rejected, 2U);
  EXPECT_EQ(result.rejected[0].face, 7U);
  EXPECT_EQ(result.rejected[0].rejection.code, RejectionCode::ZeroNormal);
  EXPECT_EQ(result.rejected[1].face, 8U);
  EXPECT_EQ(result.rejected[1].rejection.code, RejectionCode::LoopMeetsItself);
}

TEST_F(MeshContact, ExactIsNeverWrongAndTheThesisIs) {
  const Result result = study(cube, {"exact", "thesis-float"});
  for (const cases::Test test : kTests) {
    const Failures exact = result.meshes[0].methods[0].total(test);
    EXPECT_EQ(exact.trials, result.meshes[0].queries);
    EXPECT_EQ(exact.wrong, 0U) << to_string(test);
  }
  EXPECT_EQ(result.meshes[0].methods[0].faces_wrong, 0U);
  EXPECT_GT(result.meshes[0].methods[1].total(cases::Test::Contact).wrong, 0U);
  EXPECT_EQ(result.meshes[0].methods[1].faces_wrong, kAccepted);  // radii in floats do not resolve doubles
}

// Each ball is what it is said to be: the nearest feature, and the radius the double nearest to the distance, moved.
TEST_F(MeshContact, BallsAreNearTheirFeature) {
  const Mesh mesh = read_mesh(cube).mesh;
  for (std::uint64_t face = 0; face < kAccepted; ++face) {
    const Polygon polygon = mesh::face_polygon(mesh, face);
    const FaceCrossing crossing = draw_face_crossing(polygon, 7, "model/cube", face);
    EXPECT_TRUE(crossing.missing.empty());
    ASSERT_EQ(crossing.balls.size(), kPlaces.size() * kSteps.size());
    for (std::size_t i = 0; i < crossing.balls.size(); ++i) {
      const Ball& ball = crossing.balls[i];
      const Answer answer = exact::answer(ball, polygon);
      EXPECT_EQ(crossing.truths[i].contact, answer.contact());
      if (kPlaces[crossing.place(i)] == Threshold::FootEdge) {
        EXPECT_TRUE(answer.contact());
        EXPECT_FALSE(answer.edges_hit.empty());
        continue;
      }
      const int steps = FaceCrossing::steps(i);
      EXPECT_EQ(to_string(answer.nearest.kind), place_name(kPlaces[crossing.place(i)]));
      EXPECT_EQ(ball.radius, workloads::move_by_doubles(answer.distance, steps));
      if (steps != 0) {
        EXPECT_EQ(answer.contact(), steps > 0);
      }
    }
  }
}

TEST_F(MeshContact, ThreadsChangeNothingAndTheSeedDoes) {
  const auto counts = [&](unsigned threads, std::uint64_t seed) {
    const Settings settings{.methods = methods::find_methods({"all"}), .seed = seed, .threads = threads};
    const std::vector<NamedMesh> meshes{{"model/cube", read_mesh(cube).mesh}, {"again", read_mesh(cube).mesh}};
    const Result result = measured(settings, meshes);
    faces::write(folder, settings, meshes, result);
    return table(settings, meshes, result) + text_of(folder / "meshes.csv") + text_of(folder / "failures.jsonl");
  };
  EXPECT_EQ(counts(1, 3), counts(4, 3));
  EXPECT_NE(counts(1, 3), counts(1, 4));
}

// A face's balls depend on seed, name and number alone: not on the meshes beside it.
TEST_F(MeshContact, OtherMeshesChangeNothing) {
  const Mesh mesh = read_mesh(cube).mesh;
  const auto counts = [&](const std::vector<NamedMesh>& meshes) {
    const Settings settings{.methods = methods::find_methods({"fast", "thesis"}), .seed = 5};
    const Result result = measured(settings, meshes);
    return result.meshes.back().methods[1].total(cases::Test::Contact).wrong;
  };
  EXPECT_EQ(counts({{"cube", mesh}}), counts({{"other", mesh}, {"cube", mesh}}));
}

TEST_F(MeshContact, WhatIsStoppedHasComeToNothingMore) {
  const std::atomic<bool> stop = true;
  const Settings settings{.methods = methods::find_methods({"fast"})};
  const std::vector<NamedMesh> meshes{{"cube", read_mesh(cube).mesh}};
  EXPECT_EQ(items_done(measured(settings, meshes, stop)), 0U);
  EXPECT_EQ(face_count(settings, meshes), kFaces);
}

// The faces of a part lie in several meshes.
TEST_F(MeshContact, PartsAddUpToTheBytesOfOneRun) {
  write("again.obj", kCube);
  const std::string run = "near-edge model/cube.obj again.obj --skip-bad --methods exact,thesis,fast --output ";
  ASSERT_EQ(touchstone(run + "whole").status, 0);
  for (const char* part : {"1", "2", "3"})
    ASSERT_EQ(touchstone(run + "part" + part + " --part " + part + "/3").status, 0) << part;
  const Ran merged = touchstone("merge part1 part2 part3 --output merged");
  ASSERT_EQ(merged.status, 0) << merged.err;
  for (const char* file : {"meshes.csv", "rejected.csv", "failures.jsonl", "left-out.txt"}) {
    EXPECT_EQ(text_of(folder / "merged" / file), text_of(folder / "whole" / file)) << file;
    EXPECT_TRUE(file == std::string("left-out.txt") || !text_of(folder / "whole" / file).empty()) << file;
  }
}

TEST_F(MeshContact, PartsAreOfTheSameMeshes) {
  const std::string run = "near-edge one.obj --methods fast --output ";
  write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_EQ(touchstone(run + "part1 --part 1/2").status, 0);
  write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
  ASSERT_EQ(touchstone(run + "part2 --part 2/2").status, 0);
  const Ran refused = touchstone("merge part1 part2 --output merged");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("part1/part.json: is of MESH one.obj (hash "), std::string::npos) << refused.err;
}

TEST_F(MeshContact, FailuresAreJudgedWrongByTheMethodThatTheyName) {
  ASSERT_EQ(touchstone("near-edge model/cube.obj --skip-bad --output o").status, 0);
  const auto cases = lines_of(folder / "o/failures.jsonl");
  ASSERT_FALSE(cases.empty());
  std::set<std::string> ids;
  std::map<std::string, std::vector<nlohmann::json>> by_method;
  for (const auto& failure : cases) {
    EXPECT_TRUE(ids.insert(failure["id"]).second) << failure["id"];
    for (const std::string tag : failure["tags"])
      if (tag.starts_with("fails-")) by_method[tag.substr(6)].push_back(failure);
  }
  EXPECT_TRUE(by_method.count("thesis"));
  EXPECT_FALSE(by_method.count("exact"));
  for (const auto& [method, failures] : by_method) {
    std::string text;
    for (const auto& failure : failures) text += failure.dump() + "\n";
    write("named.jsonl", text);
    const Ran run = touchstone("judge --methods " + method + " named.jsonl");
    EXPECT_EQ(run.status, 1) << method;
    for (const auto& failure : failures)
      EXPECT_NE(run.err.find(failure["id"].get<std::string>() + ": "), std::string::npos) << method << failure["id"];
  }
  EXPECT_EQ(touchstone("judge --methods exact o/failures.jsonl").status, 0);
}

TEST_F(MeshContact, AMissingMeshIsAnErrorAndTheOthersGoOn) {
  const Ran run = touchstone("near-edge absent.obj model/cube.obj --skip-bad --methods exact,thesis --output o");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("absent.obj"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("model/cube"), std::string::npos) << run.out;
  EXPECT_NE(text_of(folder / "o/meshes.csv").find("model/cube,9,2,exact,face,contact,35,0,"), std::string::npos);
}

TEST_F(MeshContact, AMeshWithoutAFaceIsAnErrorAndTheOthersGoOn) {
  write("points.obj", "v 0 0 0\nv 1 0 0\n");
  const Ran run = touchstone("near-edge points.obj model/cube.obj --skip-bad --methods exact --output o");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "touchstone: points.obj: the file has no face\n");
  EXPECT_NE(text_of(folder / "o/meshes.csv").find("model/cube,9,"), std::string::npos);
}

TEST_F(MeshContact, NoMeshAtAllIsAnErrorWithoutATable) {
  const Ran run = touchstone("near-edge absent.obj --output o");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
}

TEST_F(MeshContact, RejectedFacesAreAnErrorUnlessSkipped) {
  const Ran refused = touchstone("near-edge model/cube.obj --methods exact --output o");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("2 rejected faces"), std::string::npos) << refused.err;
  const Ran skipped = touchstone("near-edge model/cube.obj --methods exact --output o --skip-bad --force");
  EXPECT_EQ(skipped.status, 0) << skipped.err;
  for (const Ran& run : {refused, skipped}) EXPECT_NE(run.out.find("zero-normal"), std::string::npos) << run.out;
  EXPECT_NE(text_of(folder / "o/rejected.csv").find("model/cube,7,zero-normal,"), std::string::npos);
}

TEST_F(MeshContact, WarnsOfWhatIsOdd) {
  write("open.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n");
  const Ran run = touchstone("near-edge open.stl --methods exact --output o");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "touchstone: warning: open.stl: line 8: the last 'endsolid' is missing\n");
}

TEST_F(MeshContact, SkipBadSaysWhatItLeavesOut) {
  write("bad.obj", std::string(kCube) + "f 1 2 99\nf 3 4\n");
  EXPECT_EQ(touchstone("near-edge bad.obj --methods exact --output o").status, 2);
  const Ran run = touchstone("near-edge bad.obj --methods exact --output o --skip-bad --force");
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("left out: bad.obj: line 20"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("left out: bad.obj: line 21"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("2 parts of files left out"), std::string::npos) << run.out;
  EXPECT_NE(text_of(folder / "o/left-out.txt").find("line 21"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::near_edge::faces
