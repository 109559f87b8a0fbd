// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "experiments/judge/case.h"
#include "experiments/judge/verdict.h"
#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"

namespace touchstone {
namespace {

std::vector<judge::Case> corpus(const std::string& file) {
  std::vector<judge::Case> cases;
  std::ifstream stream(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "tests/corpus" / file);
  for (std::string line; std::getline(stream, line);) cases.push_back(judge::read_case(line));
  return cases;
}

const std::vector<std::string> kFiles{"edge.jsonl",  "face.jsonl",   "features.jsonl",       "foot-on-edge.jsonl",
                                      "far.jsonl",   "holes.jsonl",  "off-plane.jsonl",      "sliver.jsonl",
                                      "point.jsonl", "vertex.jsonl", "tangent-lattice.jsonl"};

TEST(Corpus, ExactMeetsEveryExpectation) {
  for (const std::string& file : kFiles) {
    const auto cases = corpus(file);
    EXPECT_GE(cases.size(), 20u) << file;
    for (const judge::Case& read : cases) {
      ASSERT_TRUE(std::holds_alternative<judge::Shapes>(read.content)) << *read.id;
      const auto& [ball, polygon] = std::get<judge::Shapes>(read.content);
      const auto given = judge::object_of(methods::PartialAnswer::of(exact::answer(ball, polygon), ""));
      EXPECT_TRUE(judge::differences(*read.expected, given).empty())
          << *read.id << ": " << judge::differences(*read.expected, given).front();
    }
  }
}

TEST(Corpus, EveryRejectionHasItsCode) {
  const auto cases = corpus("rejections.jsonl");
  EXPECT_GE(cases.size(), 30u);
  for (const judge::Case& read : cases) {
    ASSERT_TRUE(std::holds_alternative<Rejection>(read.content)) << *read.id;
    EXPECT_EQ(word(std::get<Rejection>(read.content).code), read.expected->at("error").get<std::string>()) << *read.id;
  }
}

// The hand-made cases of ordinary size are small integers, in which doubles round nothing that decides.
TEST(Corpus, FastMeetsTheHandMadeCasesOfOrdinarySize) {
  int compared = 0;
  for (const judge::Case& read : corpus("features.jsonl")) {
    const auto& [ball, polygon] = std::get<judge::Shapes>(read.content);
    const bool ordinary = read.id->find("scale-") == std::string::npos &&
                          read.id->find("double") == std::string::npos && read.id->find("-tie") == std::string::npos &&
                          read.id->find("lift") == std::string::npos && ball.center.cwiseAbs().maxCoeff() < 1e9 &&
                          ball.radius > 1e-9;
    if (!ordinary && *read.id != "edge-before-vertex-on-a-tie") continue;
    ++compared;
    const Answer answer = fast::answer(ball, polygon), truth = exact::answer(ball, polygon);
    EXPECT_EQ(answer.plane, truth.plane) << *read.id;
    EXPECT_EQ(answer.foot, truth.foot) << *read.id;
    EXPECT_EQ(answer.edges_hit, truth.edges_hit) << *read.id;
    EXPECT_EQ(answer.relation, truth.relation) << *read.id;
    EXPECT_EQ(answer.nearest, truth.nearest) << *read.id;
    EXPECT_EQ(answer.point, truth.point) << *read.id;
    EXPECT_EQ(answer.distance, truth.distance) << *read.id;
    EXPECT_EQ(fast::contact(ball, polygon), truth.contact()) << *read.id;
    EXPECT_EQ(fast::relation(ball, polygon), truth.relation) << *read.id;
  }
  EXPECT_GE(compared, 25);
}

// N = (-1/2, -1/2, 2) and the mean height is 1/8: vertex 2 sinks from 1/2 to 3/8.
TEST(Fast, LiftsVerticesOntoThePlane) {
  const Polygon quad({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}});
  for (const Answer& answer : {fast::answer({{3, 3, 0}, 1}, quad), exact::answer({{3, 3, 0}, 1}, quad)}) {
    EXPECT_EQ(answer.point, Eigen::Vector3d(1, 1, 0.375));
    EXPECT_EQ(answer.off_plane, 0.125);
  }
}

}  // namespace
}  // namespace touchstone
