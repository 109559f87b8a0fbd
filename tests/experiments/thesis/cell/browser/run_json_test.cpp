// SPDX-License-Identifier: GPL-3.0-or-later
// What the page learns about the cell and its runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "experiments/thesis/cell/browser/cell_json.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "robust/exact/exact.h"
#include "tests/experiments/thesis/cell/browser/aristo.h"

namespace touchstone::cell::browser {
namespace {

using Json = nlohmann::ordered_json;

TEST(CellJson, HoldsEveryPartWithIndicesInBounds) {
  const Json cell = Json::parse(cell_json(simulator()));
  ASSERT_EQ(cell["parts"].size(), simulator().parts().size());
  for (const Json& part : cell["parts"]) {
    const std::size_t points = part["points"].size() / 3;
    EXPECT_EQ(part["points"].size() % 3, 0U);
    for (const Json& corner : part["triangles"]) EXPECT_LT(corner.get<std::size_t>(), points);
    for (const Json& end : part["outline"]) EXPECT_LT(end.get<std::size_t>(), points);
    EXPECT_EQ(3 * part["face_ends"].back().get<std::size_t>(), part["triangles"].size());
  }
  // A cube: all its edges are outlines, and each of its faces is two triangles.
  const Json& material = cell["parts"].back();
  EXPECT_EQ(material["points"].size(), 24U);
  EXPECT_EQ(material["triangles"].size(), 36U);
  EXPECT_EQ(material["outline"].size(), 24U);
  EXPECT_EQ(material["face_ends"], Json({2, 4, 6, 8, 10, 12}));
}

// The sides of a cylinder of 24 meet in 15 degrees, those with its ends in 90.
TEST(CellJson, OutlinesWhereFacesBend) {
  const Json cell = Json::parse(cell_json(simulator()));
  for (const Json& part : cell["parts"])
    if (part["name"] == "Axis6/flange") {
      EXPECT_EQ(part["outline"].size(), 2 * 48U);
    }
}

TEST(CellJson, SaysWhichValuesAreChosen) {
  const Json labels = Json::parse(cell_json(simulator()))["labels"];
  EXPECT_EQ(labels["storage.angle"], "T");
  EXPECT_EQ(labels["storage.radius"], "C");
  EXPECT_EQ(labels["step"], "D");
}

TEST(RunJson, IsWhatTheProcessSays) {
  const Recording& run = recording();
  ASSERT_EQ(run.process.failure, "");
  const Json json = Json::parse(run_json(run));
  ASSERT_EQ(json["stops"].size(), run.process.stops.size());
  ASSERT_EQ(json["moves"].size(), run.process.moves.size());
  for (std::size_t i = 0; i < run.process.stops.size(); ++i) {
    const cell::Stop& stop = run.process.stops[i];
    EXPECT_EQ(json["stops"][i]["commanded"], Json(stop.commanded));
    EXPECT_EQ(json["stops"][i]["touched"].is_null(), !stop.touched.has_value());
    EXPECT_EQ(json["stops"][i]["target"].is_null(), !stop.target.has_value());
  }
  EXPECT_EQ(json["times"], Json(run.timing.arrivals()));
  EXPECT_EQ(json["waits"], Json(run.timing.waits()));
  EXPECT_EQ(json["methods"][0],
            Json({{"name", "filtered"}, {"asked", run.comparison.scores[0].asked}, {"wrong", 0}, {"unsure", 0}}));
}

// A face that is named by a wrong number would be coloured though the sphere is elsewhere. Scenes count triangles
// first, the model does not: a prism over a triangle has both.
void names_the_faces_that_are_touched(const Recording& run) {
  ASSERT_EQ(run.process.failure, "");
  const Json json = Json::parse(run_json(run));
  const auto& faces = run.parts.back().faces.faces;
  std::set<std::string> touched_for;
  for (std::size_t i = 0; i < run.process.stops.size(); ++i) {
    const cell::Stop& at = run.process.stops[i];
    if (!at.target) continue;
    Pose pose = run.places[static_cast<std::size_t>(*at.target)];
    if (run.process.holding(i).slot == at.target) pose = run.process.holding(i).lies->pose;  // no virtual copy
    const auto distance = [&](const char* key) {
      const Polygon& face = faces.at(json["stops"][i][key].get<std::size_t>()).polygon;
      Loop loop;
      for (std::size_t k = 0; k < face.vertex_count(); ++k) loop.push_back(pose * face.vertex(k));
      return exact::answer(at.sphere, Polygon(loop)).distance;
    };
    EXPECT_NEAR(distance("nearest"), json["stops"][i]["distance"].get<double>(), 1e-9);
    EXPECT_EQ(at.touched.has_value(), !json["stops"][i]["touched"].is_null());
    if (!at.touched) continue;
    EXPECT_LT(distance("touched"), at.sphere.radius + 1e-9);
    touched_for.insert(json["stops"][i]["target"]);
  }
  EXPECT_EQ(touched_for, (std::set<std::string>{"storage", "machine"}));
}

TEST(RunJson, NamesTheFacesThatAreTouched) { names_the_faces_that_are_touched(recording()); }

TEST(RunJson, NamesTheFacesOfAPrism) {
  const char* prism = R"(material.solid={"cylinder": {"from": [0, 0, 0], "to": [0, 0, 40], "radius": 30, "sides": 3}})";
  const Simulator simulator(
      cell::read_cell(aristo().file, std::nullopt,
                      {prism, "storage.slots[1].aim=[0, -21.8]", "machine.slots[0].aim=[0, -21.8]"}),
      {.methods = {}, .rule = {.sphere_alone = true}});
  const Recording run = simulator.run(setting_of(simulator.cell()));
  const auto numbers = cell::scene_faces(run.parts.back().faces).numbers;
  EXPECT_FALSE(std::is_sorted(numbers.begin(), numbers.end())) << "any order of counting would do";
  names_the_faces_that_are_touched(run);
}

TEST(RunJson, FollowsTheMaterial) {
  const Recording& run = recording();
  const Json json = Json::parse(run_json(run));
  std::string places;
  for (std::size_t i = 0; i < run.snapshots.size(); ++i) {
    const Json& place = json["stops"][i]["place"];
    const std::string word = place.is_null() ? "gripper" : place.get<std::string>();
    if (i == 0 || place != json["stops"][i - 1]["place"]) places += word + " ";
  }
  EXPECT_EQ(places, "storage gripper machine gripper storage ");
  // From the stop on at which it is gripped, where it lay, it is fixed to the flange.
  const auto in_flange = [&](std::size_t i) -> Eigen::Vector3d {
    const Pose& flange = run.snapshots[i].links.back();
    return flange.rotation.transpose() * (run.snapshots[i].material.translation - flange.translation);
  };
  Eigen::Vector3d held = Eigen::Vector3d::Zero();
  std::size_t last = 0;
  for (const cell::MaterialTransfer& transfer : run.process.transfers) {
    EXPECT_EQ(run.snapshots[transfer.stop].slot, transfer.slot);
    if (transfer.slot) {
      for (std::size_t i = last; i < transfer.stop; ++i) EXPECT_LT((in_flange(i) - held).norm(), 1e-9) << i;
      last = transfer.stop;
      continue;
    }
    const Pose& before = run.snapshots[transfer.stop - 1].material;
    EXPECT_LT((run.snapshots[transfer.stop].material.translation - before.translation).norm(), 1e-9);
    held = in_flange(last = transfer.stop);
  }
}

TEST(RunJson, TellsOfAFailureAndOfTheWayUntilThen) {
  Setting setting = setting_of(aristo());
  setting.angle = 67;  // where the machine is
  const Json json = Json::parse(run_json(simulator().run(setting)));
  EXPECT_NE(json["failure"], "");
  EXPECT_EQ(json["setting"]["storage"]["angle"], 67);
  EXPECT_EQ(json["labels"]["storage.angle"], "C");
}

// The stand grows with the height: what is drawn, and what is asked about, is the new one.
TEST(RunJson, BuildsTheStandAnew) {
  Setting setting = setting_of(aristo());
  setting.height = 300;
  const Recording run = simulator().run(setting);
  const Json json = Json::parse(run_json(run));
  double lowest = 0;
  for (const Json& coordinate : json["stand"]["points"]) lowest = std::min(lowest, coordinate.get<double>());
  EXPECT_EQ(lowest, -300);
}

}  // namespace
}  // namespace touchstone::cell::browser
