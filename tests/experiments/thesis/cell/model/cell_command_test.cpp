// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell show` and `convert`: tables, files and exit statuses.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/run/write_file.h"
#include "experiments/thesis/cell/model/link_model.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cell_model_tests {
namespace {

using run_tests::Ran;

Ran touchstone_cell(std::vector<std::string> arguments) {
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

class CellCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  const run_tests::Scratch scratch;
  const std::string aristo = std::string(TOUCHSTONE_SOURCE_DIR) + "/experiments/thesis/cell/cells/aristo.json";
};

// As the captions of the thesis have it: one file a link, three parts in Axis1, one in Gripper1.
TEST_F(CellCommand, ShowWritesAModelFileForEveryLink) {
  const Ran ran = touchstone_cell({"show", aristo, "--output", path("out")});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("faces.csv and 18 model files: "), std::string::npos) << ran.out;
  const std::string faces = run_tests::text_of(path("out/faces.csv"));
  EXPECT_EQ(std::count(faces.begin(), faces.end(), '\n'), 1 + 576);
  EXPECT_NE(faces.find("\nstorage/deck,storage,20,"), std::string::npos);
  EXPECT_NE(run_tests::text_of(path("out/run.json")).find("touchstone cell show "), std::string::npos);
  const cell::LinkModel axis1 = cell::read_link_model(path("out/models/Axis1.txt"));
  EXPECT_EQ(axis1.name, "Axis1");
  EXPECT_EQ(axis1.parts.size(), 3U);
  const cell::LinkModel gripper = cell::read_link_model(path("out/models/Gripper1.txt"));
  ASSERT_EQ(gripper.parts.size(), 1U);
  EXPECT_EQ(gripper.parts[0].vertices.size(), 16U);
  EXPECT_EQ(gripper.parts[0].polygons.size(), 10U);
  EXPECT_EQ(cell::read_link_model(path("out/models/machine-bottom.txt")).parts[0].polygons.size(), 11U);
}

// The files are those of the page of formats.
TEST_F(CellCommand, NewWritesTheLeastCell) {
  const Ran made = touchstone_cell({"new", path("mine")});
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string page = run_tests::text_of(std::string(TOUCHSTONE_SOURCE_DIR) + "/docs/formats.md");
  for (const char* name : {"mine/cell.json", "mine/arm.urdf"})
    EXPECT_NE(page.find("\n" + run_tests::text_of(path(name)) + "```"), std::string::npos) << name;
  const Ran shown = touchstone_cell({"show", path("mine/cell.json")});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_EQ(touchstone_cell({"new", path("mine")}).status, 2);
  EXPECT_EQ(touchstone_cell({"new", path("mine"), "--force"}).status, 0);
}

TEST_F(CellCommand, ShowIsTheSameEveryTime) {
  const Ran first = touchstone_cell({"show", aristo}), second = touchstone_cell({"show", aristo});
  EXPECT_EQ(first.out, second.out);
  EXPECT_NE(first.out.find("chosen: clearance, gripper, machine, material, robot, storage"), std::string::npos)
      << first.out;
}

TEST_F(CellCommand, ShowRefusesABadCellByItsKey) {
  run::write_file(path("bad.json"), R"({"nam":"x"})");
  const Ran ran = touchstone_cell({"show", path("bad.json")});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err,
            path("bad.json") +
                ": nam: is an unknown key; there are name, unit, step, clearance, meshes, robot, robots, gripper, "
                "storage, storages, machine, machines, material, materials, obstacles, zones, labels, presets");
}

TEST_F(CellCommand, ConvertSaysWhatItReadWroteAndReadAgain) {
  run::write_file(path("square.obj"), "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n");
  const Ran ran = touchstone_cell({"convert", path("square.obj"), path("square.txt"), "--merge", "--name", "Plate"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(run_tests::text_of(path("square.txt")),
            "Link Plate\nParts 1\nPart Plate\nVertices 4\n0 0 0\n2 0 0\n2 2 0\n0 2 0\nPolygons 1\n4 0 1 2 3\n");
  EXPECT_NE(ran.out.find("read again      1         4         1          0      0        4  [0, 2] x [0, 2] x [0, 0]"),
            std::string::npos)
      << ran.out;
}

TEST_F(CellCommand, ConvertNamesWhatIsWrong) {
  run::write_file(path("two words.obj"), "v 0 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3\n");
  const auto err = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "convert");
    const Ran ran = touchstone_cell(std::move(arguments));
    EXPECT_EQ(ran.status, 2);
    return ran.err;
  };
  EXPECT_EQ(
      err({path("two words.obj"), path("a.txt")}),
      path("two words.obj") + ": the name \"two words\" is not one word of UTF-8 without '#'; --name gives another");
  EXPECT_EQ(err({path("two words.obj"), path("a.step")}),
            path("a.step") + ": the extension '.step' must be .txt, .obj, .off, .stl or .ply");
  EXPECT_EQ(err({path("two words.obj"), path("two words.obj")}),
            path("two words.obj") + ": exists already; --force overwrites it");
  run::write_file(path("bad.txt"), "Link A\nParts x\n");
  EXPECT_EQ(err({path("bad.txt"), path("a.obj")}), path("bad.txt") + ": line 2: 'x' is not a count");
}

}  // namespace
}  // namespace touchstone::cell_model_tests
