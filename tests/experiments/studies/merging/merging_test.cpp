// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>

#include "experiments/commands.h"
#include "experiments/run/output.h"
#include "experiments/run/stop_signal.h"
#include "experiments/studies/merging/measure.h"
#include "geometry/io/read_mesh.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"
#include "tests/experiments/support/address_sanitizer.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"
#include "tests/robust/support/random_meshes.h"

namespace touchstone::merging {
namespace {

using mesh_tests::cube;
using mesh_tests::grid;

const Settings kQuick{.balls = 60, .least = 3, .repetitions = 1};

Mesh plate_and_cube() {
  Mesh mesh = grid(4, 4, [](int i, int j) { return i != 1 || j != 1; });
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Mesh box = cube();
  for (const auto& vertex : box.vertices) mesh.vertices.emplace_back(vertex + Eigen::Vector3d(9, 9, 9));
  for (auto face : box.faces) {
    for (std::uint32_t& vertex : face) vertex += first;
    mesh.faces.push_back(face);
  }
  return mesh;
}

MeshResult studied(const Settings& settings, const char* name, const Mesh& mesh) {
  return study(settings, name, mesh, run_tests::kNeverStop).value();
}

TEST(MergeStudy, AsksScenesThatAnswerAlike) {
  const MeshResult result = studied(kQuick, "plate and cube", plate_and_cube());
  EXPECT_EQ(result.counts.faces, 42U);
  EXPECT_EQ(result.counts.polygons, 7U);
  EXPECT_EQ(result.counts.holes, 1U);
  EXPECT_EQ(result.counts.largest, 20U);
  const auto kind = [&](Kind k) { return result.measured[static_cast<std::size_t>(k)]; };
  EXPECT_EQ(kind(Kind::Faces).triangles, 42U);
  EXPECT_EQ(kind(Kind::Merged).polygons, 7U);
  EXPECT_EQ(kind(Kind::Mixed).polygons, 1U);  // the plate
  EXPECT_EQ(kind(Kind::Mixed).triangles, 12U);
  if (!run_tests::kAddressSanitizer) {
    EXPECT_GT(kind(Kind::Faces).memory, kind(Kind::Mixed).memory);
    EXPECT_NE(kind(Kind::Merged).memory, kind(Kind::Mixed).memory);
  }
  EXPECT_EQ(result.differences.asked, (std::array<std::uint64_t, 3>{120, 120, 12}));
  EXPECT_EQ(result.differences.differ, (std::array<std::uint64_t, 3>{}));
}

// A merge that covers more than the faces must be seen.
TEST(MergeStudy, SeesAnswersThatDiffer) {
  Settings rough = kQuick;
  rough.tolerance = 0.2;
  const MeshResult result =
      studied(rough, "dented", mesh_tests::shaken(grid(6, 6, [](int, int) { return true; }), 0.1, 1));
  EXPECT_LT(result.counts.polygons, 36U);
  EXPECT_GT(result.differences.differ[2], 0U);
  EXPECT_GT(result.differences.distance, 0);
  EXPECT_LE(result.differences.distance, result.counts.off_plane);
}

TEST(MergeStudy, ComparesAnswersByAsManyThreadsAsItIsGiven) {
  const auto running = [] {
    const std::filesystem::directory_iterator threads("/proc/self/task");
    return std::distance(begin(threads), end(threads));
  };
  merging::Settings settings{.tolerance = 0.2, .balls = 2000, .least = 3, .repetitions = 1};
  const Mesh mesh = mesh_tests::shaken(grid(6, 6, [](int, int) { return true; }), 0.1, 1);
  const merging::Differences alone = studied(settings, "dented", mesh).differences;
  const auto before = running();
  settings.threads = 3;
  const merging::Differences together = studied(settings, "dented", mesh).differences;
  EXPECT_GT(running(), before);
  EXPECT_EQ(run::archived(together), run::archived(alone));
}

TEST(MergeStudy, DrawsBallsOfWhichSomeTouchAndSomeDoNot) {
  const Mesh mesh = plate_and_cube();
  const mesh::MergedMesh merged = mesh::merge_faces(mesh);
  scene::Scene scene;
  scene.add("mesh", mesh::scene_faces(mesh, merged).faces);
  int touching = 0;
  for (std::uint64_t i = 0; i < 100; ++i) touching += scene.touches(draw_ball(mesh, merged, 1, i)) ? 1 : 0;
  EXPECT_GT(touching, 20);
  EXPECT_LT(touching, 95);
}

// Spans of coordinates overflow.
TEST(MergeStudy, DrawsFiniteBallsWhereTheMeshsExtentIsNotFinite) {
  const double far = 1.7e308;
  const Mesh mesh{{{-far, -far, 0}, {far, -far, 0}, {far, far, 1}}, {{0, 1, 2}}};
  const mesh::MergedMesh merged = mesh::merge_faces(mesh);
  for (std::uint64_t i = 0; i < 1000; ++i) EXPECT_FALSE(find_fault(draw_ball(mesh, merged, 1, i))) << i;
}

TEST(MergeStudy, WritesTheSameCountsAgainAndAsManyFieldsAsNames) {
  const run_tests::Scratch scratch;
  const std::vector<MeshResult> once{studied(kQuick, "a, b", plate_and_cube())};
  const std::vector<MeshResult> again{studied(kQuick, "a, b", plate_and_cube())};
  write_counts(scratch.path, once);
  const std::string text = run_tests::text_of(scratch.path / "merge.csv");
  write_counts(scratch.path, again);
  EXPECT_EQ(run_tests::text_of(scratch.path / "merge.csv"), text);
  write_times(scratch.path, once);
  for (const char* name : {"merge.csv", "merge-times.csv"}) {
    std::istringstream lines(run_tests::text_of(scratch.path / name));
    std::string header, line;
    std::getline(lines, header);
    const auto names = std::ranges::count(header, ',');
    while (std::getline(lines, line)) EXPECT_EQ(std::ranges::count(line, ','), names + 1) << line;  // one in "a, b"
  }
}

TEST(MergeStudy, GivesNothingOnceItIsStopped) {
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(study(kQuick, "plate and cube", plate_and_cube(), stop));
  EXPECT_FALSE(mesh::merge_faces(plate_and_cube(), 0, stop));
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class MergeCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    run::write_file(scratch.path / name, text);
    return scratch.path / name;
  }
  /// Runs the command into the folder `output`.
  [[nodiscard]] run_tests::Ran run(std::vector<std::string> arguments, const std::string& output = "out") const {
    arguments.insert(arguments.end(), {"--output", scratch.path / output});
    return run_tests::run_captured(commands::merging_command, arguments);
  }
  [[nodiscard]] std::string text(const std::string& file) const { return run_tests::text_of(scratch.path / file); }
  /// Two meshes and a bad file.
  [[nodiscard]] std::vector<std::string> three_files() const {
    return {write("a.obj", kTriangle), write("none.obj", "v 0 0 0\n"),
            write("b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"), "--compare", "9"};
  }

  const run_tests::Scratch scratch;
};

// This number of balls takes far longer than the thread needs to see that interrupts are heeded.
TEST_F(MergeCommand, StopsWithinAMeshWhereItIsInterruptedAndSaysHowFarItCame) {
  std::signal(SIGINT, SIG_DFL);  // in the background of a shell it is ignored
  std::atomic<bool> ended = false;
  std::thread interrupting([&ended] {
    struct sigaction now {};
    while (!ended && ::sigaction(SIGINT, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::this_thread::yield();
    if (!ended) ::kill(::getpid(), SIGINT);
  });
  const auto ran = run({write("mesh.obj", kTriangle), "--compare", "10000000"});
  ended = true;
  interrupting.join();
  EXPECT_EQ(ran.status, run::kInterrupted) << ran.err;
  EXPECT_NE(ran.err.find("interrupted: " + (scratch.path / "out").string() + " covers 0 of 1 item; --resume"),
            std::string::npos)
      << ran.err;
  const auto record = nlohmann::json::parse(text("out/run.json"));
  EXPECT_EQ(record["interrupted"], true);
  EXPECT_EQ(record["samples_asked"], 1);
  EXPECT_EQ(record["samples_done"], 0);
  EXPECT_EQ(record["samples_missing"], 0);
}

TEST_F(MergeCommand, PartsAddUpToTheCountsOfOneRun) {
  auto part = three_files(), other = three_files(), all = three_files();
  part.insert(part.end(), {"--part", "1/2"});
  other.insert(other.end(), {"--part", "2/2"});
  EXPECT_EQ(run(all, "whole").status, 2) << "for the bad file";
  EXPECT_EQ(run(part, "one").status, 0) << "merge reports the bad file";
  EXPECT_EQ(run(other, "two").status, 0);
  all.insert(all.end(), {"--quiet", "--output", scratch.path / "merged"});
  EXPECT_EQ(commands::merging_command().merge({scratch.path / "one", scratch.path / "two"}, all), 2);
  for (const std::string file : {"/merge.csv", "/polygons.csv"}) EXPECT_EQ(text("merged" + file), text("whole" + file));
}

// What is done is not done again: the times are those of the first run.
TEST_F(MergeCommand, ResumesBehindTheFilesThatAreDone) {
  auto arguments = three_files();
  EXPECT_EQ(run(arguments).status, 2);
  const std::string times = text("out/merge-times.csv");
  arguments.emplace_back("--resume");
  const auto again = run(arguments);
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("1 of 3 files cannot be read"), std::string::npos) << again.err;
  EXPECT_EQ(text("out/merge-times.csv"), times);
}

TEST_F(MergeCommand, RefusesACheckpointOfFilesThatThereAreNot) {
  auto arguments = three_files();
  (void)run(arguments);
  arguments.emplace_back("--resume");
  const std::filesystem::path file = scratch.path / "out/checkpoint.json";
  auto checkpoint = nlohmann::json::parse(text("out/checkpoint.json"));
  merging::Results sound;
  run::restore(checkpoint["state"].get<std::string>(), sound);
  ASSERT_EQ(sound.read.size(), 2U);
  const auto expect_refused = [&](const char* what, const auto& damage) {
    merging::Results results = sound;
    damage(results);
    checkpoint["state"] = run::archived(results);
    run::write_file(file, checkpoint.dump());
    const auto refused = run(arguments);
    EXPECT_EQ(refused.err,
              file.string() + ": is not a checkpoint of this program: it holds results of files that there are not")
        << what;
  };
  expect_refused("a file behind the last", [](auto& results) {
    auto last = results.read.extract(2);
    last.key() = 3;
    results.read.insert(std::move(last));
  });
  expect_refused("another file", [](auto& results) { results.read.begin()->second.name = "c"; });
  expect_refused("more results than files", [](auto& results) { results.files = 1; });
  expect_refused("more bad files than files", [](auto& results) { results.bad = 4; });
}

TEST_F(MergeCommand, DoesNotResumeOverMeshesThatHaveChanged) {
  auto arguments = three_files();
  (void)run(arguments);
  (void)write("a.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
  arguments.emplace_back("--resume");
  const auto again = run(arguments);
  EXPECT_NE(again.status, 0);
  EXPECT_NE(again.err.find("checkpoint.json: is of MESH "), std::string::npos) << again.err;
}

TEST_F(MergeCommand, KeepsTheFormerCheckpointIfNoFileCanBeRead) {
  (void)run(three_files());
  const std::string former = text("out/checkpoint.json");
  EXPECT_EQ(run({scratch.path / "nowhere.obj", "--force"}).status, 2);
  EXPECT_EQ(text("out/checkpoint.json.previous"), former);
}

TEST_F(MergeCommand, SaysHowManyPartsAreLeftOutBeyondThoseThatItNames) {
  std::string bad;
  for (std::size_t i = 0; i < kMostSentences + 500; ++i) bad += "v 0 0 zero\n";
  const std::string mesh = write("mesh.obj", kTriangle + bad);
  const auto ran = run({mesh, "--compare", "0", "--skip-bad"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.err.find("left out: " + mesh + ": 500 more parts\n"), std::string::npos);
}

TEST_F(MergeCommand, SaysOfEachPolygonHowFarItsFacesAreOffItsPlane) {
  const std::string mesh =
      write("mesh.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0.25\nv 0 4 0\nv 9 9 9\nf 1 2 4\nf 2 3 4\nf 3 5 4\n");
  const auto polygons = [&](const char* tolerance) {
    const auto ran = run({mesh, "--compare", "0", "--tolerance", tolerance, "--force"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    std::string table = text("out/polygons.csv");
    const std::string name = scratch.path.filename().string() + "/mesh";
    for (std::size_t at = 0; (at = table.find(name, at)) != std::string::npos;) table.replace(at, name.size(), "m");
    return table;
  };
  const std::string heading = "mesh,polygon,faces,edges,holes,off_plane\n";
  EXPECT_EQ(polygons("0"), heading + "m,0,1,3,0,0\nm,1,1,3,0,0\nm,2,1,3,0,0\n");
  const std::string merged = polygons("0.5");
  EXPECT_TRUE(merged.starts_with(heading + "m,0,2,4,0,0.")) << merged;
  EXPECT_TRUE(merged.ends_with("m,1,1,3,0,0\n")) << merged;
}

TEST_F(MergeCommand, SaysNothingOfRatiosAndDifferencesWhereNoFaceIsAPolygon) {
  const auto ran = run({write("mesh.obj", "v 0 0 0\nf 1 1 1\n"), "--skip-bad"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("nan"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("0 of 0,"), std::string::npos) << ran.out;
}

TEST_F(MergeCommand, NamesAFileWithoutAFaceAndGoesOnWithTheOthers) {
  const std::string none = write("none.obj", "V 0 0 0\n");
  const auto ran = run({none, write("mesh.obj", kTriangle), "--compare", "0", "--skip-bad"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err, "touchstone: " + none + ": line 1: 'V' is not an OBJ keyword; the file has no face\n");
  EXPECT_NE(ran.out.find("1 of 2 meshes"), std::string::npos) << ran.out;
}

TEST_F(MergeCommand, RefusesAToleranceThatIsNotTheNumberWritten) {
  for (const std::string tolerance : {"1e-400", "1e400", "nan", "-1", "0x1p-2000", "0x1p1024", "0.1mm"}) {
    const auto ran = run({"absent.obj", "--tolerance", tolerance});
    EXPECT_TRUE(ran.err.starts_with("--tolerance: \"" + tolerance + "\" is no")) << ran.err;
  }
}

TEST_F(MergeCommand, NamesFacesThatAreNoPolygonsAndFailsUnlessTheyMayBeSkipped) {
  std::vector<std::string> arguments{write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n"),
                                     "--compare", "0", "--force"};
  for (const int status : {2, 0}) {
    const auto ran = run(arguments);
    EXPECT_EQ(ran.status, status) << ran.err;
    EXPECT_NE(ran.err.find("mesh.obj: line 6: face 1: zero-normal"), std::string::npos) << ran.err;
    arguments.emplace_back("--skip-bad");
  }
}

}  // namespace
}  // namespace touchstone::merging
