// SPDX-License-Identifier: GPL-3.0-or-later
// Methods along a run, beside the exact answers.
#include "experiments/thesis/cell/simulation/method_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

const Score& score(const MethodComparison& comparison, std::string_view name) {
  return *std::ranges::find_if(comparison.scores, [&](const Score& s) { return s.method->name() == name; });
}

/// A block with a notch from above, and a run that lowers the sphere into it without touching anything: beside the
/// plane of the block's side, within the outline's notch.
const std::vector<std::string> kNotched{
    R"(material.solid={"difference":[{"box":{"from":[-20,-20,0],"to":[20,20,40]}},{"box":{"from":[-14,-30,4],"to":[14,30,50]}}]})"};

Process into_the_notch(const Workcell& workcell) {
  Process process;
  const Lying& lies = workcell.at(StationSlot::Storage).material;
  process.transfers.push_back({0, StationSlot::Storage, 0, 0, {}, lies});
  for (int i = 0; i <= 49; ++i) {
    const Eigen::Vector3d local{0, 20, 60.0 - i};  // in the plane of the side
    const Eigen::Vector3d center = lies->pose * local;
    process.stops.push_back({0, workcell.arm().home, {center, 6}, StationSlot::Storage, {}});
  }
  return process;
}

TEST(MethodComparison, CountsWhatTheThesissMethodGetsWrongInANotch) {
  const Workcell workcell = aristo(kNotched);
  const Process process = into_the_notch(workcell);
  for (const Stop& stop : process.stops)
    for (const Polygon& face : workcell.at(StationSlot::Storage).material->faces.polygons)
      ASSERT_FALSE(exact::contact(stop.sphere, face));
  const MethodComparison comparison =
      compare_methods(workcell, process, methods::find_methods({"filtered", "fast", "thesis", "thesis-signed"}), false);
  for (const char* right : {"filtered", "fast", "thesis-signed"}) {
    EXPECT_EQ(score(comparison, right).wrong_hits + score(comparison, right).wrong_misses, 0U) << right;
    EXPECT_EQ(score(comparison, right).asked, comparison.met) << right;
  }
  // With the centre at heights of 10 to 40, within the notch of the side's outline.
  const Score& thesis = score(comparison, "thesis");
  EXPECT_GE(thesis.wrong_hits, 30U);
  EXPECT_EQ(thesis.wrong_misses, 0U);
  EXPECT_EQ(thesis.wrong_hits, thesis.stops);
  EXPECT_EQ(comparison.disagreements.size(), thesis.wrong_hits);
  for (const Disagreement& d : comparison.disagreements) {
    EXPECT_EQ(d.owner, "material");
    EXPECT_EQ(d.methods, std::vector<std::string>{"thesis"});
    EXPECT_FALSE(exact::contact(d.sphere, d.polygon));
  }
}

// None of the whole steps comes very near; a sphere whose radius is nearly, or exactly, a distance does.
TEST(MethodComparison, CountsHowNearQuestionsComeToContact) {
  const Workcell workcell = aristo(kNotched);
  Process process = into_the_notch(workcell);
  const MethodComparison some = compare_methods(workcell, process, {}, false, true);
  EXPECT_EQ(some.questions, some.met);
  const MethodComparison all = compare_methods(workcell, process, {}, true, true);
  EXPECT_EQ(all.questions, all.pairs);
  for (std::size_t k = 1; k < all.near.size(); ++k) EXPECT_LE(all.near[k], all.near[k - 1]) << k;
  EXPECT_GT(all.near[0], 0U);
  EXPECT_EQ(all.near[30], 0U);
  EXPECT_EQ(compare_methods(workcell, process, {}, true).near[0], 0U);  // was not to be counted

  const Workplace& at = workcell.at(StationSlot::Storage);
  const Polygon& side = at.material->faces.polygons.front();
  const Eigen::Vector3d center =
      at.material->pose.translation + at.material->pose.rotation * Eigen::Vector3d(0, 200, 20);
  const double distance = exact::answer({center, 0}, side).distance;
  process.stops.assign(1, {0, workcell.arm().home, {center, distance * (1 + 0x1p-20)}, StationSlot::Storage, {}});
  const MethodComparison near = compare_methods(workcell, process, {}, true, true);
  EXPECT_GE(near.near[10], 1U);
  EXPECT_EQ(near.near[40], 0U);
  process.stops.front().sphere.radius = distance;
  EXPECT_GE(compare_methods(workcell, process, {}, true, true).near[kNearest], 1U);
}

TEST(MethodComparison, BoxesHideNothingFromARightMethod) {
  const Workcell workcell = aristo(kSecondCase);
  const Process process = simulate(workcell);
  ASSERT_EQ(process.failure, "");
  const auto methods = methods::find_methods({"filtered", "exact"});
  const MethodComparison culled = compare_methods(workcell, process, methods, false);
  EXPECT_GT(culled.met, 4U);
  EXPECT_LT(culled.met * 100, culled.pairs);
  // `exact`, asked of all faces at every 25th stop, agrees with the boxes.
  Process some = process;
  some.stops.clear();
  for (std::size_t i = 0; i < process.stops.size(); i += 25) some.stops.push_back(process.stops[i]);
  const MethodComparison all = compare_methods(workcell, some, methods::find_methods({"filtered"}), true);
  EXPECT_EQ(all.scores[0].asked, all.pairs);
  EXPECT_EQ(all.scores[0].wrong_hits + all.scores[0].wrong_misses, 0U);
  for (const Score& each : culled.scores) EXPECT_EQ(each.wrong_hits + each.wrong_misses + each.unsure, 0U);
}

TEST(MethodComparison, TheMaterialIsAskedAboutWhereItIsAndWhereItsCopyIs) {
  const Workcell workcell = aristo();
  Process process;
  process.transfers = {{0, StationSlot::Storage, 0, 0, {}, workcell.at(StationSlot::Storage).material},
                       {1, std::nullopt, 0, 0, Pose{}},
                       {3, StationSlot::Machine, 0, 0, {}, workcell.at(StationSlot::Machine).material}};
  const Ball far{{0, 0, 2000}, 1};
  for (int i = 0; i < 6; ++i) process.stops.push_back({0, workcell.arm().home, far, {}, {}});
  process.stops[3].target = StationSlot::Machine;  // its virtual copy
  const MethodComparison comparison = compare_methods(workcell, process, {}, false);
  const std::size_t standing = workcell.obstacles().owners.size();
  // Stops 0 and 1 in storage, 2 with the gripper, 3 its copy, 4 and 5 at the machine: five times six faces.
  EXPECT_EQ(comparison.pairs, 6 * standing + 5 * 6);
}

}  // namespace
}  // namespace touchstone::cell
