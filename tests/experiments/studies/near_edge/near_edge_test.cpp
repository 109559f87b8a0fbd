// SPDX-License-Identifier: GPL-3.0-or-later
// The study of thresholds: what is compared, that its samples stand at thresholds, and that it keeps its promises.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/truth_as_given.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/program/study.h"
#include "experiments/studies/near_edge/map.h"
#include "experiments/studies/near_edge/measure.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::near_edge {
namespace {

namespace fs = std::filesystem;
using cases::PartialAnswer;
using run_tests::Scratch;
using run_tests::text_of;
using workloads::Family;
using workloads::Placement;
using Tested = cases::Test;  // within TEST, Test is GoogleTest's

using run_tests::kNeverStop;
using run_tests::kSilent;
const cases::Method& kExact = *methods::find_method("exact");

Settings settings(const std::vector<std::string>& methods, std::uint64_t samples, unsigned threads = 1) {
  return {methods::find_methods(methods), {Family::Star, Family::L}, samples, 7, threads};
}

/// What a whole run gives.
Result whole(const Settings& settings) {
  Result result = no_result(settings);
  run_study(settings, {.stop = kNeverStop, .progress = kSilent}, result);
  return result;
}

std::vector<std::size_t> strata(Placement placement, cases::Threshold threshold) {
  std::vector<std::size_t> found;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s)
    if (cases::all_strata()[s].placement == placement && cases::all_strata()[s].threshold == threshold)
      found.push_back(s);
  return found;
}

std::size_t place_of(double offset) {
  const auto& offsets = cases::all_offsets();
  return static_cast<std::size_t>(std::find(offsets.begin(), offsets.end(), offset) - offsets.begin());
}

/// The wrong and undecided answers of the first method in these strata.
std::uint64_t failures(const Result& result, const std::vector<std::size_t>& strata, Tested test) {
  return cases::total(sum(result.counts, strata, test, 0).offsets).not_right();
}

const Failures& at_offset(const Result& result, std::size_t stratum, Tested test, std::size_t place) {
  return result.counts[stratum][static_cast<std::size_t>(test)][0].offsets[place];
}

PartialAnswer foot(PointLocation place) {
  PartialAnswer answer;
  answer.foot = place;
  return answer;
}

TEST(NearEdgeComparison, FrontAndBehindCountAlike) {
  PartialAnswer front, behind, across;
  front.plane = PlaneSide::InFront;
  behind.plane = PlaneSide::Behind;
  across.plane = PlaneSide::Intersects;
  EXPECT_EQ(compare(Tested::Plane, front, behind, true), Outcome::Right);
  EXPECT_EQ(compare(Tested::Plane, across, behind, true), Outcome::WronglyIn);
  EXPECT_EQ(compare(Tested::Plane, front, across, true), Outcome::WronglyOut);
}

TEST(NearEdgeComparison, ABoundaryIsAskedOfThoseWhoKnowTheWord) {
  const auto inside = foot(PointLocation::Inside), boundary = foot(PointLocation::Boundary),
             outside = foot(PointLocation::Outside);
  EXPECT_EQ(compare(Tested::Foot, boundary, boundary, true), Outcome::Right);
  EXPECT_EQ(compare(Tested::Foot, inside, boundary, true), Outcome::BoundaryMissed);
  EXPECT_EQ(compare(Tested::Foot, outside, boundary, true), Outcome::WronglyOut);
  EXPECT_EQ(compare(Tested::Foot, boundary, outside, true), Outcome::WronglyIn);
  EXPECT_EQ(compare(Tested::Foot, inside, boundary, false), Outcome::Right);
  EXPECT_EQ(compare(Tested::Foot, outside, boundary, false), Outcome::Right);
  EXPECT_EQ(compare(Tested::Foot, inside, outside, false), Outcome::WronglyIn);
  EXPECT_TRUE(cases::knows_boundary(*methods::find_method("exact")));
  EXPECT_TRUE(cases::knows_boundary(*methods::find_method("fast")));
  EXPECT_FALSE(cases::knows_boundary(*methods::find_method("thesis")));
}

TEST(NearEdgeComparison, EdgesAreComparedAsLists) {
  PartialAnswer truth, fewer, other;
  truth.edges_hit = {1, 4};
  fewer.edges_hit = {4};
  other.edges_hit = {4, 5};
  EXPECT_EQ(compare(Tested::Edges, truth, truth, true), Outcome::Right);
  EXPECT_EQ(compare(Tested::Edges, fewer, truth, true), Outcome::WronglyOut);
  EXPECT_EQ(compare(Tested::Edges, other, truth, true), Outcome::WronglyIn);
  EXPECT_EQ(compare(Tested::Edges, PartialAnswer{}, truth, true), std::nullopt);
}

// Radii: no contact below the distance, contact above it. Feet: not outside at offset 0, outside at the next one. Each
// ball is as far away as its offset says, up to a quarter of it.
TEST(NearEdgeThreshold, LiesAtOffsetZero) {
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
    const auto crossing = cases::draw_crossing({s, {}, 3, 0}, kExact);
    ASSERT_TRUE(crossing) << s;
    const auto threshold = cases::all_strata()[s].threshold;
    const Ball& middle = crossing->balls[crossing->middle()];
    const double unit = cases::rounding_unit(crossing->polygon);
    EXPECT_GT(crossing->balls.size(), 20U) << s;
    for (std::size_t i = 0; i < crossing->balls.size(); ++i) {
      const double offset = cases::all_offsets()[crossing->offsets[i]];
      const Ball& ball = crossing->balls[i];
      const double moved = cases::moves_radius(threshold) ? ball.radius - middle.radius
                                                          : (ball.center - middle.center).cwiseAbs().maxCoeff();
      EXPECT_NEAR(cases::moves_radius(threshold) ? moved : std::copysign(moved, offset), offset * unit,
                  std::abs(offset) * unit / 4)
          << s << " " << offset;
      const auto& truth = crossing->truths[i];
      if (!cases::moves_radius(threshold)) {
        if (i == crossing->middle() || i == crossing->middle() + 1) {
          EXPECT_EQ(truth.foot == PointLocation::Outside, offset > 0) << s << " " << offset;
        }
      } else if (offset != 0 || threshold == cases::Threshold::Tangent) {
        EXPECT_EQ(truth.contact, offset >= 0) << s << " " << offset;
      }
    }
  }
}

// Exactly planar loops have one truth. Of rotated ones the edges differ, and with them contact; triangles are not lifted.
TEST(NearEdgeThreshold, HasTwoTruthsWhereVerticesAreLifted) {
  std::uint64_t edges = 0, contacts = 0;
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s)
    for (std::uint64_t n = 0; n < 5; ++n) {
      const auto crossing = cases::draw_crossing({s, {}, 3, n}, kExact);
      ASSERT_TRUE(crossing) << s;
      const auto& [family, placement, threshold] = cases::all_strata()[s];
      for (std::size_t i = 0; i < crossing->balls.size(); ++i) {
        const auto &contract = crossing->truths[i], &given = crossing->given(i);
        EXPECT_EQ(contract.foot, given.foot);
        EXPECT_EQ(contract.plane, given.plane);
        if (placement != Placement::Rotated || family == Family::Triangle) {
          EXPECT_EQ(contract.edges_hit, given.edges_hit) << s;
          EXPECT_EQ(contract.contact, given.contact) << s;
        }
        edges += contract.edges_hit != given.edges_hit ? 1 : 0;
        contacts += contract.contact != given.contact ? 1 : 0;
        // Lifting moves vertices by a few u x size.
        if (std::abs(cases::all_offsets()[crossing->offsets[i]]) >= 64) {
          EXPECT_EQ(contract.contact, given.contact) << s;
        }
      }
    }
  EXPECT_GT(edges, 100U);
  EXPECT_GT(contacts, 50U);
}

// The shape of a triangle does not matter to the truth, nor that its squares leave the doubles.
TEST(NearEdgeComparison, TellsTheEdgesAsGivenExactly) {
  const auto& exact = *methods::find_method("exact");
  for (const int exponent : {-520, -300, 0, 300, 480}) {
    const double unit = std::ldexp(1.0, exponent);
    const Polygon polygon({{0, 0, 0}, {4 * unit, 0, 0}, {4 * unit, std::ldexp(1.0, -200) * unit, 0}});
    const auto contract = exact.prepare(polygon);
    const cases::TruthAsGiven given(*contract, polygon);
    for (const double y : {-1.0, 0.0, 0x1p-201, 3.0})
      for (const double radius : {0.0, std::nextafter(1.0, 0.0), 1.0, 3.0, 5.0}) {
        const Ball ball{{2 * unit, y * unit, 0}, radius * unit};
        EXPECT_EQ(given.ask(ball, cases::QueryKind::EdgesHit).edges_hit,
                  contract->ask(ball, cases::QueryKind::EdgesHit).edges_hit)
            << exponent << " " << y << " " << radius;
        EXPECT_EQ(given.ask(ball, cases::QueryKind::Contact).contact,
                  contract->ask(ball, cases::QueryKind::Contact).contact);
      }
  }
}

// Whoever computes with more than doubles does, and `fast` does not.
TEST(NearEdgeComparison, TellsWhoLiftsVertices) {
  for (const char* name :
       {"exact", "filtered", "rational", "interval", "cgal-epeck", "fast-long-double", "fast-mpfr-101"})
    EXPECT_TRUE(cases::lifts_vertices(*methods::find_method(name))) << name;
  for (const char* name : {"fast", "fast-float", "cgal-double", "cgal-epick", "thesis", "thesis-newell"})
    EXPECT_FALSE(cases::lifts_vertices(*methods::find_method(name))) << name;
}

// Of exactly planar loops. Nothing is wrong of those near vertices, whose distance needs no plane.
TEST(NearEdgeStudy, SumsFailuresByProperty) {
  const Result result = whole(settings({"fast"}, 40));
  const auto sum_of = [&](cases::Threshold threshold, Property property) {
    CrossingFailures sum;
    for (const auto& range :
         result.by_property[static_cast<std::size_t>(threshold)][static_cast<std::size_t>(property)])
      program::add(sum, cases::total(range.offsets[0]));
    return sum;
  };
  for (const auto threshold : {cases::Threshold::Face, cases::Threshold::Edge, cases::Threshold::Vertex}) {
    const auto all = cases::total(sum(result.counts, strata(Placement::Planar, threshold), Tested::Contact, 0).offsets);
    EXPECT_EQ(sum_of(threshold, Property::Radius), all) << to_string(threshold);
    EXPECT_EQ(sum_of(threshold, Property::Tilt), all) << to_string(threshold);
    EXPECT_EQ(sum_of(threshold, Property::Length).trials, threshold == cases::Threshold::Edge ? all.trials : 0);
    EXPECT_EQ(sum_of(threshold, Property::Angle).trials, threshold == cases::Threshold::Vertex ? all.trials : 0);
  }
}

// What is filled in between by monotony is what `exact` says; and `exact`, as a method, never fails.
TEST(NearEdgeStudy, ExactNeverFails) {
  const auto setting = settings({"exact"}, 3);
  const Result result = whole(setting);
  EXPECT_EQ(result.missing, 0U);
  for (const Tested test : kTests)
    for (const cases::Threshold threshold : cases::all_thresholds()) {
      const auto on_lattice = strata(Placement::LatticeFrame, threshold);
      EXPECT_EQ(failures(result, on_lattice, test), 0U) << to_string(test) << " " << to_string(threshold);
      EXPECT_EQ(sum(result.counts, on_lattice, test, 0).samples.trials, 6U);
      if (threshold == cases::Threshold::Tangent) continue;
      for (const Placement placement : {Placement::Planar, Placement::Rotated})
        EXPECT_EQ(failures(result, strata(placement, threshold), test), 0U);
    }
}

// What docs/methods.md and the report say the rate depends on. Of about 80 to 4,000 answers each.
TEST(NearEdgeStudy, FailuresDependOnThinnessTiltAndLengthAndNotOnTheRadius) {
  Settings setting{methods::find_methods({"fast"}), workloads::all_families(), 300, 7, 2};
  setting.placements = {Placement::Planar};
  const Result result = whole(setting);
  const auto share = [&](cases::Threshold threshold, Property property, std::size_t range, double offset) {
    const auto& offsets =
        result.by_property[static_cast<std::size_t>(threshold)][static_cast<std::size_t>(property)][range].offsets[0];
    CrossingFailures both = offsets[place_of(-offset)];
    program::add(both, offsets[place_of(offset)]);
    EXPECT_GT(both.trials, 30U) << to_string(property) << " " << range;
    return both.share();
  };
  using enum cases::Threshold;
  EXPECT_GT(share(Face, Property::Thinness, 4, 1), 2 * share(Face, Property::Thinness, 0, 1));
  EXPECT_LT(2 * share(Face, Property::Tilt, 4, 0.5), share(Face, Property::Tilt, 1, 0.5));
  EXPECT_LT(4 * share(Edge, Property::Length, 1, 0.0625), share(Edge, Property::Length, 3, 0.0625));
  for (std::size_t range = 0; range < 3; ++range)
    EXPECT_NEAR(share(Face, Property::Radius, range, 0.125), share(Face, Property::Radius, range + 1, 0.125), 0.15);
  const auto vertex = sum(result.counts, strata(Placement::Planar, Vertex), Tested::Contact, 0);
  EXPECT_GT(vertex.offsets[place_of(0)].wrong, 0U);
  EXPECT_EQ(cases::total(vertex.offsets).wrong, vertex.offsets[place_of(0)].wrong);
}

// In rotated planes rounding is felt at once; the sweep reaches to where it is no longer.
TEST(NearEdgeStudy, FastFailsNearAPlane) {
  const auto setting = settings({"fast"}, 30);
  const Result result = whole(setting);
  std::uint64_t near = 0, far = 0;
  for (const std::size_t s : strata(Placement::Rotated, cases::Threshold::Face)) {
    for (const double k : {-0.25, 0.0, 0.25}) near += at_offset(result, s, Tested::Plane, place_of(k)).not_right();
    far += at_offset(result, s, Tested::Plane, 0).not_right();
    far += at_offset(result, s, Tested::Plane, cases::all_offsets().size() - 1).not_right();
  }
  EXPECT_GT(near, 0U);
  EXPECT_EQ(far, 0U);
}

// Touching is a contact, but not to the thesis: |s| < r is strict. Where a contact is seen nevertheless, a wrong foot
// or rounding saw it.
TEST(NearEdgeStudy, ThesisMissesTangentBalls) {
  const auto setting = settings({"thesis-signed", "thesis-closed"}, 30);
  const Result result = whole(setting);
  for (const std::size_t s : strata(Placement::LatticeFrame, cases::Threshold::Tangent)) {
    const Failures& tangent = at_offset(result, s, Tested::Contact, place_of(0));
    EXPECT_GE(2 * tangent.not_right(), tangent.trials);
  }
}

TEST(NearEdgeStudy, TheNumberOfThreadsChangesNothing) {
  const Scratch scratch;
  const std::vector<std::string> names{"fast", "thesis"};
  for (const unsigned threads : {1U, 2U}) {
    const auto setting = settings(names, 4, threads);
    const auto folder = scratch.path / std::to_string(threads);
    fs::create_directories(folder);
    const Result result = whole(setting);
    write_failures(folder, setting, result);
    write_maps(folder, setting, draw_maps(setting.methods, setting.seed, threads, kNeverStop, kSilent));
  }
  int files = 0;
  for (const auto& file : fs::directory_iterator(scratch.path / "1")) {
    EXPECT_EQ(text_of(file.path()), text_of(scratch.path / "2" / file.path().filename())) << file.path();
    ++files;
  }
  EXPECT_EQ(files, 24);
}

// Sums of the largest sweep that the options allow stay below 2^64.
TEST(NearEdgeCounts, DoNotOverflow) {
  using program::kMostSamples;
  const std::uint64_t most = kMostSamples * cases::all_strata().size() * cases::all_offsets().size() * kTests.size();
  EXPECT_EQ(most / cases::all_strata().size() / cases::all_offsets().size() / kTests.size(), kMostSamples);
  EXPECT_LT(kMostSamples * cases::all_strata().size(), std::uint64_t{1} << 48) << "indices and redrawn ones stay apart";
}

// The counts of a family do not depend on which others are asked for.
TEST(NearEdgeStudy, FamiliesStandAlone) {
  auto alone = settings({"fast"}, 3);
  const auto both = alone;
  alone.families = {Family::L};
  const Result one = whole(alone), two = whole(both);
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
    if (cases::all_strata()[s].family != Family::L) continue;
    EXPECT_EQ(sum(one.counts, {s}, Tested::Contact, 0), sum(two.counts, {s}, Tested::Contact, 0)) << s;
  }
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::near_edge_command, std::move(arguments));
}

TEST(NearEdgeCommand, WritesResultsAndASidecar) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new" / "too";
  ASSERT_EQ(run_command({"--methods", "fast", "--families", "l", "--samples", "1", "--seed", "5", "--search", "0",
                         "--no-pictures", "--output", folder.string()}),
            0);
  const auto record = nlohmann::json::parse(text_of(folder / "run.json"));
  for (const char* key : {"command", "seed", "samples_asked", "samples_done", "samples_missing", "threads", "seconds",
                          "date", "commit", "compiler", "flags", "processor", "cores", "machine"})
    EXPECT_TRUE(record.contains(key)) << key;
  EXPECT_EQ(record["seed"], 5);
  EXPECT_EQ(record["samples_done"], 1);
  EXPECT_TRUE(fs::exists(folder / "rates.csv"));
  EXPECT_TRUE(fs::exists(folder / "bands.csv"));
  EXPECT_TRUE(fs::exists(folder / "properties.csv"));
  EXPECT_TRUE(fs::exists(folder / "map-edge-contact-1000000.csv"));
}

std::string error_of(const std::vector<std::string>& arguments) {
  return run_tests::message_of<std::exception>([&] { run_command(arguments); });
}

TEST(NearEdgeCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_command({"--methods", "slow"}), std::invalid_argument);
  EXPECT_THROW(run_command({"--families", "donut"}), std::invalid_argument);
  EXPECT_THROW(run_command({"--samples", "0"}), program::UsageError);
  EXPECT_THROW(run_command({"--samples", "1099511627777"}), program::UsageError);
  EXPECT_THROW(run_command({"--holes", "-1"}), program::UsageError);
  EXPECT_THROW(run_command({"--vertices", "2"}), program::UsageError);
  const Scratch scratch;
  EXPECT_EQ(error_of({"--vertices", "1025", "--output", scratch.path.string()}),
            "--vertices 1025: outlines of the family random-simple have at most 1024");
  EXPECT_THROW(run_command({"--origin-distance", "-1"}), program::UsageError);
}

}  // namespace
}  // namespace touchstone::near_edge
