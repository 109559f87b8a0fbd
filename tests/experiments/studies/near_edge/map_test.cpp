// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of failures: that each is about the place that it names, and holds what it shows.
#include "experiments/studies/near_edge/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "experiments/methods/registry.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::near_edge {
namespace {

using run_tests::kNeverStop;
using run_tests::kSilent;

TEST(NearEdgeMap, HoldsAllThatItShows) {
  const auto maps = draw_maps(methods::find_methods({"exact", "thesis"}), 1, 1, kNeverStop, kSilent);
  ASSERT_EQ(maps.size(), 21U);
  for (const Map& map : maps) {
    const std::string both = map.test == cases::Test::Foot ? "io" : "cn";
    for (const char letter : both)
      EXPECT_NE(map.truth.find(letter), std::string::npos) << to_string(map.spot) << " " << map.origin_distance;
    EXPECT_EQ(map.verdicts[0], std::string(map.truth.size(), '='));
    // Outside a reflex vertex the unsigned angles add up to more than 2 pi.
    if (map.spot == Spot::ReflexVertex && map.test == cases::Test::Foot) {
      EXPECT_NE(map.verdicts[1].find('+'), std::string::npos);
    }
  }
}

/// Says nothing, but keeps each polygon that it prepares with the balls that it is asked about.
class Watching : public cases::Method {
 public:
  struct Seen {
    Polygon polygon;
    std::vector<Ball> balls;
  };

  Watching()
      : Method("watching", "", [this](const Polygon& polygon) {
          seen.push_back(std::make_unique<Seen>(Seen{polygon, {}}));
          return std::make_unique<Prepared>(*seen.back());
        }) {}
  std::vector<std::unique_ptr<Seen>> seen;

 private:
  class Prepared : public cases::PreparedMethod {
   public:
    explicit Prepared(Seen& seen) : seen_(seen) {}
    cases::PartialAnswer ask(const Ball& ball, cases::QueryKind) const override {
      seen_.balls.push_back(ball);
      return {};
    }

   private:
    Seen& seen_;
  };
};

// Where the contact changes, it does at the feature that the map is about; about a reflex vertex at both of its edges.
TEST(NearEdgeMap, OfAContactIsAboutTheNearestFeature) {
  Watching method;
  const auto maps = draw_maps({&method}, 3, 1, kNeverStop, kSilent);
  method.seen.erase(method.seen.begin(), method.seen.begin() + 2);  // the squares that show how it understands polygons
  ASSERT_EQ(maps.size(), method.seen.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (maps[i].test != cases::Test::Contact) continue;
    const Spot spot = maps[i].spot;
    const auto& [polygon, balls] = *method.seen[i];
    ASSERT_EQ(balls.size(), maps[i].truth.size());
    const auto truth = methods::find_method("exact")->prepare(polygon);
    std::set<std::size_t> edges;
    for (std::size_t pixel = 0; pixel < balls.size(); pixel += 13) {
      const Feature nearest = *truth->ask(balls[pixel], cases::QueryKind::Answer).nearest;
      const auto expected = spot == Spot::Face     ? Feature::Kind::Face
                            : spot == Spot::Vertex ? Feature::Kind::Vertex
                                                   : Feature::Kind::Edge;
      ASSERT_EQ(nearest.kind, expected) << to_string(spot) << " " << maps[i].origin_distance;
      edges.insert(nearest.index);
    }
    EXPECT_EQ(edges.size(), spot == Spot::ReflexVertex ? 2U : 1U) << to_string(spot) << " " << maps[i].origin_distance;
  }
}

// Three quarters of the plane about a reflex vertex lie inside in the sum of all directions, one quarter about a
// vertex of an L, half about an edge; the map shows it from straight above, except for a projection along an axis.
TEST(NearEdgeMap, ShowsTheRegionAboutItsSpot) {
  for (const Map& map : draw_maps(methods::find_methods({"exact"}), 2, 2, kNeverStop, kSilent)) {
    if (map.test != cases::Test::Foot || map.origin_distance > 0) continue;
    const double inside = static_cast<double>(std::count(map.truth.begin(), map.truth.end(), 'i')) /
                          static_cast<double>(map.truth.size());
    const bool edge = map.spot == Spot::Edge, vertex = map.spot == Spot::Vertex;
    EXPECT_GT(inside, edge ? 0.4 : vertex ? 0.05 : 0.55) << to_string(map.spot);
    EXPECT_LT(inside, edge ? 0.6 : vertex ? 0.45 : 0.95) << to_string(map.spot);
  }
}

}  // namespace
}  // namespace touchstone::near_edge
