// SPDX-License-Identifier: GPL-3.0-or-later
// What a request may set, and what is said of the others.
#include "experiments/thesis/cell/browser/setting.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/model/cell_entry.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"

namespace touchstone::cell::browser {
namespace {

using run_tests::message_of;

std::string refusal(const std::string& text) {
  return message_of<BadSetting>([&] { return read_setting(text, aristo()); });
}

TEST(Setting, LeavesOutWhatIsAsInTheCell) {
  EXPECT_EQ(read_setting("{}", aristo()), setting_of(aristo()));
  const Setting set = read_setting(R"({"storage": {"angle": -33, "radius": 609}, "slot": "C"})", aristo());
  EXPECT_EQ(set, (Setting{-33, 609, 242, 2, 1}));
  EXPECT_EQ(read_setting(R"({"storage": {"height": 0}, "step": 0.5})", aristo()), (Setting{1, 480.2, 0, 1, 0.5}));
}

TEST(Setting, NamesTheKeyThatIsWrong) {
  EXPECT_EQ(refusal("storage"),
            "request: is not JSON: column 1: syntax error while parsing value - invalid literal; last read: 's'");
  EXPECT_EQ(refusal("[]"), "request: the whole: must be an object");
  EXPECT_EQ(refusal(R"({"storage": 3})"), "request: storage: must be an object");
  EXPECT_EQ(refusal(R"({"angle": 3})"),
            "request: angle: is an unknown key; there are storage, slot, step, drive, changes, piece");
  EXPECT_EQ(refusal(R"({"storage": {"angel": 3}})"),
            "request: storage.angel: is an unknown key; there are angle, radius, height");
  EXPECT_EQ(refusal(R"({"step": 1, "step": 2})"), "request: the whole: the key \"step\" is given twice");
  EXPECT_EQ(refusal(R"({"storage": {"angle": "left"}})"), "request: storage.angle: must be a number");
  EXPECT_EQ(refusal(R"({"storage": {"angle": null}})"), "request: storage.angle: must be a number");
  EXPECT_EQ(refusal(R"({"storage": {"angle": 1e999}})"), "request: storage.angle: is beyond the finite doubles");
  EXPECT_EQ(refusal(R"({"storage": {"angle": 361}})"), "request: storage.angle: must be from -360 to 360, is 361");
  EXPECT_EQ(refusal(R"({"storage": {"radius": 0}})"), "request: storage.radius: must be positive, is 0");
  EXPECT_EQ(refusal(R"({"storage": {"radius": 4000}})"), "request: storage.radius: must be from 0 to 2700, is 4000");
  EXPECT_EQ(refusal(R"({"storage": {"height": -1}})"), "request: storage.height: must be from 0 to 2700, is -1");
  EXPECT_EQ(refusal(R"({"step": 0})"), "request: step: must be from 0.05 to 90, is 0");
  EXPECT_EQ(refusal(R"({"slot": "D"})"), "request: slot: there is no slot \"D\"");
  EXPECT_EQ(refusal(R"({"slot": 1})"), "request: slot: must be a text that is not empty");
  EXPECT_EQ(refusal(std::string(60000, '[')).rfind("request: ", 0), 0U);
}

TEST(Setting, MarksWhatItChangesAsChosen) {
  Setting setting = setting_of(aristo());
  EXPECT_EQ(changed(aristo(), setting).labels, aristo().labels);
  setting.angle = -33;
  const cell::Cell cell = changed(aristo(), setting);
  EXPECT_EQ(cell.storage.angle, -33);
  EXPECT_EQ(aristo().label("storage.angle"), cell::Label::Text);
  EXPECT_EQ(cell.label("storage.angle"), cell::Label::Chosen);
}

TEST(Setting, RefusesAStepThatWouldTakeTooManyStops) {
  cell::Cell cell = aristo();
  cell.step = 90;
  cell.robot.joints[1].upper = 1e5;
  Setting setting = setting_of(cell);
  (void)changed(cell, setting);
  setting.step = kLeastStep;
  const std::string message = message_of<cell::BadCell>([&] { return changed(cell, setting); });
  EXPECT_NE(message.find(": step: at 0.05 degrees a stop, joint \"shoulder\" would take "), std::string::npos)
      << message;
}

TEST(Setting, RefusesWhatTheArmCannotReach) {
  const auto reason = [](double radius, double height) {
    Setting setting = setting_of(aristo());
    setting.radius = radius, setting.height = height;
    return message_of<cell::BadCell>([&] { return changed(aristo(), setting); });
  };
  EXPECT_EQ(reason(609, 242), "");
  EXPECT_NE(reason(1500, 242).find("storage.radius: "), std::string::npos) << reason(1500, 242);
  EXPECT_NE(reason(480.2, 20).find("storage.height: the stand's top, -20 from there, lies at or below the floor"),
            std::string::npos)
      << reason(480.2, 20);
}

std::string refused(const std::string& text) {
  return message_of<BadSetting>([&] { return read_variation(text); });
}

/// Of a request with this one change.
std::string refused_change(const std::string& change) { return refused(nlohmann::json{{"changes", {change}}}.dump()); }

TEST(Variation, NamesChangesAndThePiece) {
  EXPECT_EQ(read_variation("{}"), Variation{});
  const Variation variation =
      read_variation(R"({"changes": ["zones[0]={}", "storages[0]=@storage"], "piece": "second"})");
  EXPECT_EQ(variation.piece, "second");
  EXPECT_EQ(variation.changes, (std::vector<std::string>{"zones[0]={}", "storages[0]=@storage"}));
  EXPECT_EQ(refused(R"({"changes": [1]})"), "request: changes[0]: must be a text that is not empty");
  EXPECT_EQ(refused(nlohmann::json{{"changes", std::vector<std::string>(201, "step=1")}}.dump()),
            "request: changes: are more than 200");
  EXPECT_EQ(refused_change("step"), "request: changes[0]: step: has no \"=\"");
  EXPECT_EQ(refused_change("zones[0]=@"), "request: changes[0]: : is not a path of keys");
}

// The cell would be built before a setting is read.
TEST(Variation, RefusesAStepOutOfBounds) {
  EXPECT_EQ(refused_change("step=0.004"), "request: changes[0]: step: must be from 0.05 to 90, is 0.004");
  EXPECT_EQ(refused_change("step=91"), "request: changes[0]: step: must be from 0.05 to 90, is 91");
  for (const char* change : {"step=0.05", "step=90", "step=@clearance", "step=small", "zones[0].turn=0.004"})
    EXPECT_EQ(refused_change(change), "") << change;
}

// Files are for who starts the program: in a path, in a value at any depth, however JSON spells them, or copied.
TEST(Variation, SetsNothingThatNamesAFile) {
  for (const auto& [change, key] : std::initializer_list<std::pair<const char*, const char*>>{
           {"robot.urdf=x", "urdf"},
           {"meshes=/", "meshes"},
           {"meshes=null", "meshes"},
           {"robot.packages=[]", "packages"},
           {"obstacles[0].mesh.file=x", "file"},
           {R"(obstacles[0]={"name":"o","mesh":{"file":"/any/path.obj","unit":"mm"}})", "file"},
           {R"(obstacles[0]={"name":"o","m\u0065sh":3})", "mesh"},
           {R"(obstacles[0]={"name":"o","m\u0065sh":{"f\u0069le":"/any/path.obj"}})", "file"},
           {R"(robot={"\u0075\u0072\u0064\u0066":"/etc/passwd"})", "urdf"},
           {R"(obstacles[0].parts=[[{"box":[{"u\u0072df":"x"}]}]])", "urdf"},
           {R"(material.solid={"union":[{"mesh":{}},{}]})", "mesh"},
           {"robot.name=@robot.urdf", "urdf"},
           {"labels.step=T", "labels"},
           {"presets={}", "presets"},
           {"robot.links={}", "links"}})
    EXPECT_EQ(
        refused_change(change).rfind(
            std::string("request: changes[0]: the page does not set \"") + key + "\"; it sets about, aim, angle, ", 0),
        0U)
        << change << ": " << refused_change(change);
}

// The text of a value, or a part of it, is not a key.
TEST(Variation, SetsNamesThatLookLikeFiles) {
  for (const char* change : {R"(obstacles[0]={"name":"profile","box":{"from":[0,0,0],"to":[1,1,1]},"move":[400,0,0]})",
                             R"(zones[0]={"name":"mesh-urdf-file","sphere":{"at":[0,0,0],"radius":1}})",
                             "materials[0].name=packages", R"(storages[0].slots[0].name="\u0066ile")",
                             "obstacles[2]=null", "zones[0].stops=true", "robots[0].gripper=@gripper"})
    EXPECT_EQ(refused_change(change), "") << change;
}

// A change of the cell, or its file, may have set what the request leaves out.
TEST(Setting, IsWithinItsBoundsWhereverItsNumbersComeFrom) {
  const auto refusal_of = [](const auto& change) {
    cell::Cell cell = aristo();
    change(cell);
    return message_of<BadSetting>([&] { return read_setting("{}", cell); });
  };
  EXPECT_EQ(refusal_of([](cell::Cell& cell) { cell.step = 0.004; }),
            "request: step: must be from 0.05 to 90, is 0.004");
  EXPECT_EQ(refusal_of([](cell::Cell& cell) { cell.step = kLeastStep; }), "");
  EXPECT_EQ(refusal_of([](cell::Cell& cell) { cell.storage.angle = 400; }),
            "request: storage.angle: must be from -360 to 360, is 400");
  EXPECT_EQ(refusal_of([](cell::Cell& cell) { cell.storage.radius = 2701; }),
            "request: storage.radius: must be from 0 to 2700, is 2701");
  EXPECT_EQ(refusal_of([](cell::Cell& cell) { cell.storage.height = -1; }),
            "request: storage.height: must be from 0 to 2700, is -1");
}

}  // namespace
}  // namespace touchstone::cell::browser
