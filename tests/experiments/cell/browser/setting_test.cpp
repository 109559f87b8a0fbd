// SPDX-License-Identifier: GPL-3.0-or-later
// What a request may set, and what is said of the others.
#include "experiments/cell/browser/setting.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/cell/model/cell_entry.h"
#include "tests/experiments/cell/browser/aristo.h"

namespace touchstone::cell_browser_tests {
namespace {

using namespace cell::browser;

std::string refusal(const std::string& text) {
  try {
    (void)read_setting(text, aristo());
  } catch (const BadSetting& error) {
    return error.what();
  }
  return "accepted";
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
  try {
    (void)changed(cell, setting);
    FAIL() << "accepted";
  } catch (const cell::BadCell& error) {
    EXPECT_NE(std::string(error.what()).find(": step: at 0.05 degrees a stop, joint \"shoulder\" would take "),
              std::string::npos)
        << error.what();
  }
}

TEST(Setting, RefusesWhatTheArmCannotReach) {
  const auto reason = [](double radius, double height) -> std::string {
    Setting setting = setting_of(aristo());
    setting.radius = radius, setting.height = height;
    try {
      (void)changed(aristo(), setting);
    } catch (const cell::BadCell& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(reason(609, 242), "");
  EXPECT_NE(reason(1500, 242).find("storage.radius: "), std::string::npos) << reason(1500, 242);
  EXPECT_NE(reason(480.2, 20).find("storage.height: the stand's top, -20 from there, lies at or below the floor"),
            std::string::npos)
      << reason(480.2, 20);
}

TEST(Variation, NamesChangesAndThePieceButNoFiles) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      (void)read_variation(text);
    } catch (const BadSetting& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(read_variation("{}"), Variation{});
  const Variation variation =
      read_variation(R"({"changes": ["zones[0]={}", "storages[0]=@storage"], "piece": "second"})");
  EXPECT_EQ(variation.piece, "second");
  EXPECT_EQ(variation.changes, (std::vector<std::string>{"zones[0]={}", "storages[0]=@storage"}));
  for (const char* file : {"robot.urdf=x", "obstacles[0].mesh.file=x", "meshes=/", "robot.packages=[]"})
    EXPECT_NE(refused(nlohmann::json{{"changes", {file}}}.dump()).find("the page changes no files"), std::string::npos);
  EXPECT_EQ(refused(R"({"changes": [1]})"), "request: changes[0]: must be a text that is not empty");
  EXPECT_EQ(refused(nlohmann::json{{"changes", std::vector<std::string>(201, "step=1")}}.dump()),
            "request: changes: are more than 200");
}

}  // namespace
}  // namespace touchstone::cell_browser_tests
