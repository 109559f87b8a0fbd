// SPDX-License-Identifier: GPL-3.0-or-later
// The cell as the entries of chapters 5 and 6 have it, and the files of `touchstone thesis`.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/figures/drawn_cell.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/output.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/figures/begun_study.h"

namespace touchstone::figures {
namespace {

using kinematics::kCases;

const std::atomic<bool> kGoOn{false}, kStop{true};

// The scans meet places at which the thesis's order of moves does not complete: 410 mm, and in case 2 a height of 245
// mm.
constexpr Settings kSmall{.samples = 100,
                          .seed = 3,
                          .angle_step = 60,
                          .radius_step = 200,
                          .radius_scan = 52,
                          .height_scan = 44,
                          .home_step = 40};

const Study& small() {
  static const Study study = run_study(kSmall, 1, kGoOn, [](std::uint64_t, std::uint64_t) {}).value();
  return study;
}

/// By name, what a study writes.
std::map<std::string, std::string> files_of(const Study& study) {
  const run_tests::Scratch scratch;
  write_entries(scratch.path, entries_of(study));
  write_data(scratch.path, study);
  std::map<std::string, std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(scratch.path))
    if (file.is_regular_file())
      files[std::filesystem::relative(file.path(), scratch.path).string()] = run_tests::text_of(file.path());
  return files;
}

TEST(ThesisStudy, WritesTheSameBytesForAnyNumberOfThreads) {
  const auto three = run_study(kSmall, 3, kGoOn, [](std::uint64_t, std::uint64_t) {});
  ASSERT_TRUE(three);
  const auto files = files_of(small());
  EXPECT_EQ(files.size(), 20U);
  EXPECT_EQ(files, files_of(*three));
  for (const auto& [name, text] : files) EXPECT_FALSE(text.empty()) << name;
  // With so few samples, too, every stated number is found again, except for a reach that other sources' lengths do
  // not give.
  for (const Entry& entry : entries_of(small())) {
    if (entry.id != "table 5.1") {
      EXPECT_TRUE(entry.agrees()) << entry.id;
    }
  }
  EXPECT_NE(table(entries_of(small())).find("otherwise:\n  table 5.1: reach of the flange"), std::string::npos);
}

// Two machines' results are the same: what a message says of a cell that comes with the program names no file.
TEST(ThesisStudy, WritesNoPathOfTheMachine) {
  std::size_t out_of_reach = 0;
  for (const auto& [name, text] : files_of(small())) {
    EXPECT_EQ(text.find(TOUCHSTONE_SOURCE_DIR), std::string::npos) << name;
    EXPECT_EQ(text.find("aristo.json"), std::string::npos) << name;
    if (name == "places.csv") out_of_reach += text.find("out-of-reach") != std::string::npos;
  }
  EXPECT_EQ(out_of_reach, 1U);
}

TEST(ThesisStudy, StopsWhenItIsAskedTo) {
  EXPECT_FALSE(run_study(kSmall, 2, kStop, [](std::uint64_t, std::uint64_t) {}).has_value());
}

// The cell's file is the layout that the captions were solved for.
TEST(ThesisStudy, HasTheCellOfTheChosenLayout) {
  const kinematics::Layout layout = kinematics::chosen_layout();
  for (std::size_t number = 0; number < kCases.size(); ++number) {
    const cell::Cell& cell = begun().cases[number].cell;
    EXPECT_EQ(cell.storage.angle, kCases[number].storage_angle);
    EXPECT_EQ(cell.storage.home, kinematics::kStorageHome);
    EXPECT_EQ(cell.storage.radius, layout.storage_radius[number]);
    EXPECT_EQ(cell.machine.azimuth(), kinematics::kMachineAzimuth);
    EXPECT_EQ(cell.machine.radius, layout.machine_radius);
    EXPECT_EQ(cell.machine.height, layout.machine_height);
    EXPECT_EQ(cell.gripper.sphere.radius, layout.sphere_radius);
    EXPECT_EQ(cell.gripper.sphere.center.z(), -layout.sphere_distance);
    EXPECT_EQ(cell.material.drop, layout.drop);
    EXPECT_EQ(cell.clearance, layout.clearance);
    EXPECT_EQ(cell.robot.joints[1].home, layout.home.lean);
    EXPECT_EQ(cell.robot.joints[2].home, layout.home.elevation);
    const Eigen::Vector3d& place = cell.storage.slots[cell.material.slot].place;
    EXPECT_EQ(cell.storage.height + place.z(), layout.storage_height[number]);
    EXPECT_NEAR(place.y(), -layout.gap - layout.side / 2, 1e-12);
    EXPECT_EQ(cell.machine.slots[cell.material.machine_slot].place.y(), place.y());
  }
}

TEST(CaseStudy, StopsAtTheFirstStepThatTouches) {
  for (const CaseStudy& its : begun().cases) {
    ASSERT_EQ(its.stops.size(), 2U);
    for (const Stop& stop : its.stops) {
      EXPECT_TRUE(stop.at.contact());
      EXPECT_FALSE(stop.before.contact());
      EXPECT_TRUE(stop.thesis_at);
      EXPECT_FALSE(stop.thesis_before);
    }
    EXPECT_EQ(its.process.failure, "");
    EXPECT_EQ(its.moments.size(), its.process.moves.size() + 1);
    EXPECT_EQ(its.snapshots[its.moments[its.stops[0].move].stop].slot, cell::StationSlot::Storage);
    EXPECT_EQ(its.snapshots[its.moments[its.stops[0].move + 1].stop].slot, std::nullopt);
    EXPECT_GT(its.asked, 4U);
    for (const std::uint64_t wrong : its.wrong) EXPECT_EQ(wrong, 0U);
  }
  EXPECT_EQ(begun().cases[0].stops[0].face, "counter-clockwise side");
  EXPECT_EQ(begun().cases[0].stops[1].face, "upper face");
}

TEST(DrawnCell, FollowsTheMaterial) {
  for (const CaseStudy& its : begun().cases) {
    const auto drawn = drawn_moments(its);
    // What is gripped stays where it is at that moment, and then goes along.
    const auto material = [&](std::size_t i) {
      return drawn.at(its.moments[i].name).at("material").get<std::vector<double>>();
    };
    const std::size_t grip = its.stops[0].move;
    const auto lying = material(grip), gripped = material(grip + 1), carried = material(grip + 2);
    for (std::size_t i = 0; i < lying.size(); ++i) EXPECT_NEAR(lying[i], gripped[i], 1e-9);
    EXPECT_NE(gripped, carried);
  }
}

// Each part is drawn in the frame of its own link, not of a neighbour.
TEST(DrawnCell, PutsEveryLinkAtItsJoint) {
  const Study& study = begun();
  const auto links = drawn_moments(study.cases[0]).at("case 1, home").at("links");
  ASSERT_EQ(links.size(), study.cell.robot.links.size());
  const auto height = [&](std::size_t link) { return links.at(link).at(11).get<double>(); };
  EXPECT_EQ(height(0), 0);
  EXPECT_EQ(height(1), 200);
  EXPECT_EQ(height(2), kinematics::kShoulderHeight);
  const kinematics::Layout layout = kinematics::chosen_layout();
  const Eigen::Vector3d wrist =
      kinematics::wrist(kinematics::aristo(layout.coupling, layout.hand), study.cases[0].process.stops[0].commanded);
  EXPECT_GT(height(3), wrist.z());  // the forearm slopes down at home
  EXPECT_NEAR(height(5), wrist.z(), 1e-9);
  EXPECT_NEAR(links.at(5).at(9).get<double>(), wrist.x(), 1e-9);
  EXPECT_NEAR(height(6), wrist.z() - kinematics::kHand, 1e-9);
}

TEST(DrawnCell, CoversEveryFaceWithTriangles) {
  for (const auto& part : drawn_parts(begun().parts)) {
    const std::size_t vertices = part.at("vertices").size();
    EXPECT_GE(part.at("triangles").size(), part.at("loops").size()) << part.at("name");
    for (const auto& triangle : part.at("triangles"))
      for (const auto& corner : triangle) EXPECT_LT(corner.get<std::size_t>(), vertices);
  }
  EXPECT_EQ(gripper_outline(begun().parts).corners.size(), 8U);
  EXPECT_EQ(gripper_outline(begun().parts).area(), 90 * 75 - 50 * 45);
}

// Fig 5.22 and `touchstone cell area` give one answer, which is that of `touchstone cell run`.
TEST(Reconfiguration, IsThatOfTheWholeProcess) {
  const Study& study = begun();
  const auto tried = [&](double angle, double radius) {
    return cell::try_place(study.cell, study.parts, study.covered, {}, angle, radius, study.cell.storage.height);
  };
  EXPECT_EQ(outcome_of(tried(1, 480.2)), "from the side");
  EXPECT_EQ(outcome_of(tried(-33, 609)), "from above");
  EXPECT_EQ(outcome_of(tried(1, 150)), "in-the-way");
  EXPECT_EQ(outcome_of(tried(1, 900)), "out-of-reach");
  EXPECT_EQ(tried(67, 600).cause, cell::FailureCause::InTheWay);
  for (const auto& [angle, radius] : {std::pair(1.0, 300.0), {-90.0, 500.0}, {20.0, 560.0}, {45.0, 450.0}}) {
    cell::Cell cell = study.cell;
    cell.storage.angle = angle, cell.storage.radius = radius;
    const cell::Process process = cell::simulate(cell::Workcell(cell, study.parts, study.covered));
    EXPECT_EQ(tried(angle, radius).cause, process.cause);
    EXPECT_EQ(tried(angle, radius).reason, process.failure);
  }
}

TEST(Reconfiguration, FindsTheEndsOfWhatCompletesAndWhatDoesNotBetween) {
  const auto places = [](const std::string& marks) {
    std::vector<cell::Tried> all;
    for (const char mark : marks)
      all.push_back({0, 0, 5.0 * static_cast<double>(all.size()),
                     mark == '+'   ? std::nullopt
                     : mark == '-' ? std::optional(cell::FailureCause::OutOfReach)
                                   : std::optional(cell::FailureCause::InTheWay),
                     ""});
    return all;
  };
  const auto gaps_of = [&](const std::string& marks) {
    return gaps(places(marks), *completing(places(marks)), &cell::Tried::height);
  };
  EXPECT_FALSE(completing({}));
  EXPECT_FALSE(completing(places("---")));
  const auto ends = completing(places("-+-++-++--"));
  ASSERT_TRUE(ends);
  EXPECT_EQ(ends->first, 1U);
  EXPECT_EQ(ends->last, 7U);
  EXPECT_EQ(gaps_of("-+++-"), "");
  EXPECT_EQ(gaps_of("-+-"), "");
  EXPECT_EQ(gaps_of("-+-x+---+-"), "10 mm (out-of-reach), 15 mm (in-the-way), 25 to 35 mm (out-of-reach)");
}

double number_of(const std::vector<Entry>& entries, std::string_view id, std::string_view what) {
  const Entry& entry = *std::ranges::find_if(entries, [&](const Entry& each) { return each.id == id; });
  const auto number = std::ranges::find_if(entry.numbers, [&](const Number& n) { return n.what.starts_with(what); });
  EXPECT_NE(number, entry.numbers.end()) << id << ": " << what;
  return number == entry.numbers.end() ? NAN : number->ours.value;
}

// Figures 5.18, 5.19, 5.22, 6.30 and 6.31 against the scans, each other, and the case studies, which complete.
TEST(Reconfiguration, FiguresHoldBothCaseStudies) {
  const Study& study = small();
  const std::vector<Entry> entries = entries_of(study);
  for (const auto& [what, places] : {std::pair("radii", &study.radii),
                                     {"heights 1", &study.heights[0]},
                                     {"heights 2", &study.heights[1]},
                                     {"area", &study.area}})
    for (const cell::Tried& place : *places)
      EXPECT_EQ(place.cause.has_value(), !place.reason.empty()) << what << ' ' << place.radius << ' ' << place.height;
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const cell::Station& storage = study.cases[i].cell.storage;
    EXPECT_EQ(study.cases[i].process.failure, "");
    EXPECT_LE(number_of(entries, "5.18", "least radius that completes"), storage.radius);
    EXPECT_GE(number_of(entries, "5.19", "greatest radius that completes"), storage.radius);
    EXPECT_LE(number_of(entries, "5.22", "least angle at which some radius completes"), storage.angle);
    EXPECT_GE(number_of(entries, "5.22", "largest angle at which some radius completes"), storage.angle);
    const std::string at = "at case " + std::to_string(i + 1) + "'s";
    EXPECT_GE(number_of(entries, "6.30", "greatest height that completes, " + at), storage.height);
    EXPECT_LE(number_of(entries, "6.31", "least height that completes, " + at), storage.height);
    const auto own = std::ranges::find(study.heights[i], storage.height, &cell::Tried::height);
    ASSERT_NE(own, study.heights[i].end());
    EXPECT_FALSE(own->cause) << own->reason;
  }
  EXPECT_EQ(gaps(study.radii, *completing(study.radii), &cell::Tried::radius), "");
  for (const auto& heights : study.heights) EXPECT_EQ(gaps(heights, *completing(heights), &cell::Tried::height), "");
  const auto own = std::ranges::find(study.radii, study.cell.storage.radius, &cell::Tried::radius);
  ASSERT_NE(own, study.radii.end());
  EXPECT_FALSE(own->cause) << own->reason;
}

// What a figure says of a place that does not complete is what the scan says of it.
TEST(Reconfiguration, FiguresNameAReasonForWhatDoesNotComplete) {
  const Study& study = small();
  std::size_t reasons = 0;
  for (const Entry& entry : entries_of(study)) {
    EXPECT_EQ(entry.text.find(": ."), std::string::npos) << entry.id << ": " << entry.text;
    const bool radius = entry.id == "5.18" || entry.id == "5.19";
    if (!radius && entry.id != "6.30" && entry.id != "6.31") continue;
    const std::regex said(radius ? R"(It does not complete at ([0-9.]+) mm: )"
                                 : R"(Case (\d) does not complete at ([0-9.]+) mm: )");
    for (std::sregex_iterator m(entry.text.begin(), entry.text.end(), said), end; m != end; ++m, ++reasons) {
      const auto& places = radius ? study.radii : study.heights.at(std::stoul((*m)[1]) - 1);
      const auto place = std::ranges::find(places, std::stod((*m)[radius ? 1 : 2]),
                                           radius ? &cell::Tried::radius : &cell::Tried::height);
      ASSERT_NE(place, places.end()) << entry.text;
      EXPECT_TRUE(place->cause) << entry.text;
      EXPECT_FALSE(place->reason.empty()) << entry.text;
      EXPECT_TRUE(std::string(m->suffix()).starts_with(place->reason + ".")) << entry.text;
    }
  }
  EXPECT_EQ(reasons, 4U);  // too close, too far, both cases too high: both complete at the lowest
}

TEST(Reconfiguration, PresetsThatAreTooCloseOrTooFarDoNotComplete) {
  for (const char* name : {"too close", "too far"}) {
    const cell::Cell cell = cell::read_cell(begun().cell.file, {}, cell::preset(begun().cell.file, name));
    EXPECT_TRUE(cell::try_place(cell, begun().parts, begun().covered, {}, cell.storage.angle, cell.storage.radius,
                                cell.storage.height)
                    .cause)
        << name;
  }
}

TEST(ThesisCommand, RefusesNoSamples) {
  const auto ran = run_tests::run_captured(commands::thesis_command, {"--samples", "0"});
  EXPECT_NE(ran.err.find("--samples"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace touchstone::figures
