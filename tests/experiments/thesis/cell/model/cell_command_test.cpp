// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell show` and `new`: tables, files and exit statuses.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/link_model.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cell {
namespace {

using run_tests::Ran;

Ran touchstone_cell(std::vector<std::string> arguments) {
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

class CellCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (scratch.path / name).string(); }
  const run_tests::Scratch scratch;
  const std::string aristo = run_tests::kAristo.string();
};

// As the captions of the thesis have it: one file a link, three parts in Axis1, one in Gripper1.
TEST_F(CellCommand, ShowWritesAModelFileForEveryLink) {
  const Ran ran = touchstone_cell({"show", aristo, "--output", path("out")});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("faces.csv and 20 model files: "), std::string::npos) << ran.out;
  const std::string faces = run_tests::text_of(path("out/faces.csv"));
  EXPECT_EQ(std::count(faces.begin(), faces.end(), '\n'), 1 + 598);
  EXPECT_NE(faces.find("\nstorage/deck,storage,20,"), std::string::npos);
  EXPECT_NE(run_tests::text_of(path("out/run.json")).find("touchstone cell show "), std::string::npos);
  const LinkModel axis1 = read_link_model(path("out/models/Axis1.txt"));
  EXPECT_EQ(axis1.name, "Axis1");
  EXPECT_EQ(axis1.parts.size(), 3U);
  const LinkModel gripper = read_link_model(path("out/models/Gripper1.txt"));
  ASSERT_EQ(gripper.parts.size(), 1U);
  EXPECT_EQ(gripper.parts[0].vertices.size(), 16U);
  EXPECT_EQ(gripper.parts[0].polygons.size(), 10U);
  EXPECT_EQ(read_link_model(path("out/models/machine-bottom.txt")).parts[0].polygons.size(), 11U);
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

TEST_F(CellCommand, ShowNamesWhatRunWouldRefuse) {
  ASSERT_EQ(touchstone_cell({"new", path("mine")}).status, 0);
  const auto change = [&](const std::string& from, const std::string& to) {
    std::string text = run_tests::text_of(path("mine/cell.json"));
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    program::write_file(path("mine/cell.json"), text.replace(at, from.size(), to));
  };
  change("\"factor\": -1", "\"factor\": 0.5");
  const Ran warned = touchstone_cell({"show", path("mine/cell.json")});
  EXPECT_EQ(warned.status, 0);
  EXPECT_NE(warned.err.find("robot.coupling[0]: "), std::string::npos) << warned.err;
  EXPECT_NE(warned.err.find("; cell run refuses it"), std::string::npos) << warned.err;
  change("{", R"({"presets": {"turned": ["storage.angle=1", "storage.angel=1"]},)");
  const Ran refused = touchstone_cell({"show", path("mine/cell.json")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("mine/cell.json: presets.turned: "), std::string::npos) << refused.err;
}

TEST_F(CellCommand, ASolidWithoutInsideIsNamedWithItsFile) {
  ASSERT_EQ(touchstone_cell({"new", path("mine")}).status, 0);
  const Ran ran = touchstone_cell({"run", path("mine/cell.json"), "--set",
                                   R"(material.solid={"difference": [{"box": {"from": [0, 0, 0], "to": [1, 1, 1]}},
                                      {"box": {"from": [-1, -1, -1], "to": [2, 2, 2]}}]})"});
  EXPECT_EQ(ran.status, 2);
  EXPECT_NE(ran.err.find("mine/cell.json: material: the solid has no inside"), std::string::npos) << ran.err;
}

TEST_F(CellCommand, ShowIsTheSameEveryTime) {
  const Ran first = touchstone_cell({"show", aristo}), second = touchstone_cell({"show", aristo});
  EXPECT_EQ(first.out, second.out);
  EXPECT_NE(first.out.find("chosen: clearance, gripper, machine, material, robot, storage"), std::string::npos)
      << first.out;
}

TEST_F(CellCommand, ShowRefusesABadCellByItsKey) {
  program::write_file(path("bad.json"), R"({"nam":"x"})");
  const Ran ran = touchstone_cell({"show", path("bad.json")});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err,
            path("bad.json") +
                ": nam: is an unknown key; there are name, unit, step, clearance, meshes, robot, robots, gripper, "
                "storage, storages, machine, machines, material, materials, obstacles, zones, labels, presets");
}

}  // namespace
}  // namespace touchstone::cell
