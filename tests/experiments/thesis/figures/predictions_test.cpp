// SPDX-License-Identifier: GPL-3.0-or-later
// What the captions imply where the layout was not fitted: every row of predictions.csv and of sensitivity.csv.
#include "experiments/thesis/figures/predictions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/thesis/figures/entry.h"
#include "tests/experiments/thesis/figures/begun_study.h"

namespace touchstone::figures {
namespace {

using kinematics::chosen_layout;
using kinematics::kCases;
using kinematics::Layout;

const std::vector<Prediction>& places() {
  static const std::vector<Prediction> all = predict(chosen_layout());
  return all;
}

const Prediction& at(std::string_view line, double angle) {
  return *std::ranges::find_if(places(),
                               [&](const Prediction& place) { return place.line == line && place.angle == angle; });
}

TEST(Predictions, AreOfEveryWholeAngleAtBothRadiiAndBetweenThem) {
  std::set<std::pair<std::string_view, double>> seen;
  for (const Prediction& place : places()) {
    EXPECT_TRUE(seen.emplace(place.line, place.angle).second) << place.line << ' ' << place.angle;
    EXPECT_EQ(place.failure, "");
  }
  EXPECT_EQ(seen.size(), 2U * 121 + 33);
  for (int angle = -60; angle <= 60; ++angle)
    for (const char* line : {"case 1", "case 2"}) EXPECT_TRUE(seen.contains({line, angle})) << angle;
  for (int angle = -32; angle <= 0; ++angle) EXPECT_TRUE(seen.contains({"between", angle})) << angle;
  EXPECT_EQ(at("case 1", -16).radius, chosen_layout().storage_radius[0]);
  EXPECT_EQ(at("case 2", -16).radius, chosen_layout().storage_radius[1]);
  EXPECT_DOUBLE_EQ(at("between", -16).radius, (480.2 + 609) / 2);
}

// Fitted are the two cases alone, and their angles are those of the captions.
TEST(Predictions, HoldBothCasesAsFitted) {
  EXPECT_EQ(std::ranges::count_if(places(), &Prediction::fitted), 2);
  EXPECT_TRUE(at("case 1", 1).fitted);
  EXPECT_TRUE(at("case 2", -33).fitted);
  EXPECT_EQ(at("case 1", 1).found, (Implied{-149, 66, 35, 28}));
  EXPECT_EQ(at("case 2", -33).found, (Implied{-183, 100, 35, 28}));
  EXPECT_EQ(at("case 2", -33).elbow_at_storage, kCases[1].elbow);
  EXPECT_EQ(at("case 2", -33).shoulder_at_storage, kCases[1].shoulder);
}

// Halfway the arm comes another way, and every implied angle is found all the same.
TEST(Predictions, HoldBetweenTheCases) {
  const Prediction& middle = at("between", -16);
  EXPECT_FALSE(middle.fitted);
  EXPECT_EQ(middle.found, (Implied{-166, 83, 35, 28}));
  EXPECT_EQ(middle.elbow_at_storage, 4);
  EXPECT_EQ(middle.shoulder_at_storage, 12);
  for (const Prediction& place : places())
    for (std::size_t i = 0; i < kImplied.size(); ++i)
      EXPECT_TRUE(place.agrees(i)) << place.line << ' ' << place.angle << ": " << kImplied[i];
}

// The certified contact is the one that trigonometry gives; the thesis's method stops in the step after it, where the
// exact answer does.
TEST(Predictions, StopInTheStepAfterTheContactByTrigonometry) {
  std::set<std::string_view> joints;
  for (const Prediction& place : places()) {
    ASSERT_TRUE(place.contact && place.derived);
    joints.insert(place.contact_joint);
    EXPECT_NEAR(*place.contact, *place.derived, 1e-9) << place.line << ' ' << place.angle;
    const double stop = place.contact_joint == "base" ? (*place.found)[0] : *place.shoulder_at_storage;
    EXPECT_GT(std::abs(stop), std::abs(*place.contact)) << place.line << ' ' << place.angle;
    EXPECT_LT(std::abs(stop), std::abs(*place.contact) + 1) << place.line << ' ' << place.angle;
    EXPECT_EQ(place.wrong_stops, 0U);
  }
  EXPECT_EQ(joints, (std::set<std::string_view>{"base", "shoulder"}));
}

// Each count of Figs 4.11 and 4.12 is of the places that were not fitted, and one place with a wrong sign is found.
TEST(Predictions, AreCountedInTheirFiguresAndDifferWithAWrongSign) {
  Study study = begun();
  study.predictions = places();
  const auto entry_of = [&](std::string_view id) {
    const std::vector<Entry> entries = entries_of(study);
    return *std::ranges::find(entries, id, &Entry::id);
  };
  std::size_t counts = 0;
  for (const char* id : {"4.11", "4.12"})
    for (const Number& number : entry_of(id).numbers) {
      if (number.basis != Basis::Predicted) continue;
      ++counts;
      EXPECT_EQ(number.ours.value, 273) << number.what;
      EXPECT_EQ(number.agrees(), true) << number.what;
    }
  EXPECT_EQ(counts, 6U);
  EXPECT_NE(entry_of("4.11").text.find("the 33 angles between"), std::string::npos);
  auto& found = std::ranges::find(study.predictions, "between", &Prediction::line)->found.value();
  for (std::size_t i = 0; i < kImplied.size(); ++i) {
    found[i] = -found[i];
    EXPECT_EQ(entry_of(i == 0 ? "4.11" : "4.12").status_words(), "differs") << kImplied[i];
    found[i] = -found[i];
  }
  EXPECT_EQ(entry_of("4.12").status_words(), "reproduced with chosen values");
}

// The angles follow from nothing else than what they were derived of: where the layout is off, they are not found.
TEST(Predictions, FailInALayoutThatIsOff) {
  Layout layout = chosen_layout();
  layout.machine_radius += 5;
  const std::vector<Prediction> all = predict(layout);
  EXPECT_EQ(std::ranges::count_if(all, [](const Prediction& place) { return place.agrees(1); }), 275);
  EXPECT_EQ(std::ranges::count_if(all, [](const Prediction& place) { return place.agrees(2); }), 0);
}

const kinematics::Parameter& parameter(std::string_view name) {
  return *std::ranges::find_if(kinematics::parameters(),
                               [&](const kinematics::Parameter& each) { return name == each.name; });
}

// The range ends where the angles change at every place between the cases, not only at those that were tried.
TEST(Sensitivity, EndsWhereAnAngleChangesByAStep) {
  const kinematics::Parameter& radius = parameter("machine radius");
  const Sensitivity row = sensitivity(chosen_layout(), radius);
  EXPECT_EQ(row.value, chosen_layout().machine_radius);
  EXPECT_EQ(row.below, "elbow_at_machine, shoulder_at_machine");
  EXPECT_EQ(row.above, row.below);
  ASSERT_TRUE(row.lowest && row.highest);
  EXPECT_LT(*row.lowest, row.value - 1);
  EXPECT_GT(*row.highest, row.value + 1);
  for (const bool beyond : {false, true}) {
    const Layout moved = radius.moved(chosen_layout(), *row.highest - row.value + (beyond ? 0.02 : 0));
    std::size_t kept = 0;
    for (const Prediction& place : predict(moved)) kept += place.line == "between" && place.agrees(2);
    EXPECT_EQ(kept, beyond ? 0U : 33U);
  }
}

TEST(Sensitivity, NamesNothingWhereNothingChanges) {
  const Sensitivity row = sensitivity(chosen_layout(), parameter("storage radius in case 2"));
  EXPECT_FALSE(row.lowest || row.highest);
  EXPECT_EQ(row.below + row.above, "");
}

TEST(PredictionTables, WriteWhatWasFoundBesideWhatIsImplied) {
  Prediction failed{"between", -5, 500, false, "out of reach", {}, {}, {}, {}, {}, {}, 0};
  const std::string text = predictions_csv().csv({at("between", 0), at("case 2", -33), failed});
  for (const char* row :
       {"between,0,483.988,predicted,-3,1,base,-149.503535700,-149.503535700,0,,-150,-150,67,67,35,35,28,28",
        "case 2,-33,609.000,fitted,12,25,shoulder,24.495786123,24.495786123,0,,-183,-183,100,100,35,35,28,28",
        "between,-5,500.000,predicted,,,,,,0,out of reach,,-155,,72,,35,,28"})
    EXPECT_NE(text.find("\n" + std::string(row) + "\n"), std::string::npos) << text;
  EXPECT_NE(sensitivity_csv()
                .csv({{"gap", "mm", 1.8, {}, 3.25, "", "the process fails"}})
                .find("\ngap,mm,1.8,,3.25,,the process fails\n"),
            std::string::npos);
}

}  // namespace
}  // namespace touchstone::figures
