// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>

#include "experiments/cases/truth_as_given.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"

namespace touchstone::near_edge {
namespace {

using workloads::PlacedOutline;

constexpr std::array kSpots{Spot::Face, Spot::Edge, Spot::Vertex, Spot::ReflexVertex};
constexpr std::size_t kMaps = (2 * kSpots.size() - 1) * std::size(kOriginDistances);
constexpr auto kSide = static_cast<std::size_t>(Map::kSize);

/// A point of the lattice's plane.
struct Position {
  double x, y;
};

Position middle(workloads::LatticePoint a, workloads::LatticePoint b) {
  return {(static_cast<double>(a.x) + static_cast<double>(b.x)) / 2,
          (static_cast<double>(a.y) + static_cast<double>(b.y)) / 2};
}

/// An L, its vertices counted from the reflex one: 3 is the opposite corner, and its edges are parallel to the axes.
class LetterL {
 public:
  explicit LetterL(const workloads::LatticeLoop& loop, std::size_t reflex) : loop_(loop), reflex_(reflex) {}

  [[nodiscard]] Position at(Spot spot) const {
    switch (spot) {
      case Spot::Face: return middle(vertex(0), vertex(3));
      case Spot::Edge: return middle(vertex(2), vertex(3));
      case Spot::Vertex: return middle(vertex(3), vertex(3));
      case Spot::ReflexVertex: break;
    }
    return middle(vertex(0), vertex(0));
  }

  /// So far out of the L that no other feature is as near; for the reflex vertex in the notch, halfway to the end of
  /// its shorter edge.
  [[nodiscard]] Position beyond(Spot spot, double distance) const {
    const workloads::LatticePoint diagonal = vertex(3) - vertex(0), along = vertex(3) - vertex(2);
    const auto [x, y] = at(spot);
    double dx = std::copysign(distance, static_cast<double>(diagonal.x));
    double dy = std::copysign(distance, static_cast<double>(diagonal.y));
    switch (spot) {
      case Spot::Face: return {x, y};
      case Spot::Edge: return along.x == 0 ? Position{x + dx, y} : Position{x, y + dy};
      case Spot::Vertex: return {x + dx, y + dy};
      case Spot::ReflexVertex: break;
    }
    const double inward = std::min(length(vertex(1) - vertex(0)), length(vertex(5) - vertex(0))) / 2;
    return {x - std::copysign(inward, dx), y - std::copysign(inward, dy)};
  }

 private:
  [[nodiscard]] workloads::LatticePoint vertex(std::size_t i) const { return loop_[(reflex_ + i) % loop_.size()]; }
  static double length(workloads::LatticePoint a) {
    return std::hypot(static_cast<double>(a.x), static_cast<double>(a.y));
  }

  const workloads::LatticeLoop& loop_;
  std::size_t reflex_;
};

LetterL letter_of(const workloads::Outline& outline) {
  std::size_t reflex = 0;
  while (workloads::corner(outline, reflex).convex()) ++reflex;
  return LetterL(outline.outer, reflex);
}

/// The axis across which a polygon spreads least; here, that of its normal's largest component, except for near ties.
int flat_axis(const workloads::Frame& frame) {
  int axis = 0;
  frame.w.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// In one binade, and not so near to its end that a map would leave it.
bool same_binade(double a, double b) {
  const auto inner = [](double x) {
    int exponent = 0;
    const double fraction = std::abs(std::frexp(x, &exponent));
    return fraction > 0.51 && fraction < 0.99;
  };
  return std::ilogb(a) == std::ilogb(b) && inner(a) && inner(b);
}

/// The subject of a map, prepared for all threads.
struct Scene {
  Scene(Polygon drawn, Ball ball, int flat, const std::vector<const cases::Method*>& methods)
      : polygon(std::move(drawn)),
        middle(std::move(ball)),
        first_axis((flat + 1) % 3),
        second_axis((flat + 2) % 3),
        contract(methods::find_method("exact")->prepare(polygon)) {
    for (const auto* method : methods) asked.push_back(method->prepare(polygon));
  }

  [[nodiscard]] Ball ball(std::size_t row, std::size_t column) const {
    Ball ball = middle;
    const auto from_middle = [](std::size_t i) { return static_cast<std::int64_t>(i) - Map::kSize / 2; };
    ball.center[first_axis] = workloads::move_by_doubles(ball.center[first_axis], from_middle(column));
    ball.center[second_axis] = workloads::move_by_doubles(ball.center[second_axis], -from_middle(row));
    return ball;
  }

  Polygon polygon;
  Ball middle;
  int first_axis, second_axis;
  std::unique_ptr<cases::PreparedMethod> contract;
  std::vector<std::unique_ptr<cases::PreparedMethod>> asked;
};

Scene draw_scene(Spot spot, Test test, double origin_distance, std::uint64_t seed,
                 const std::vector<const cases::Method*>& methods) {
  workloads::Workload workload;
  workload.family = workloads::Family::L;
  workload.placement = workloads::Placement::Rotated;
  workload.origin_distance = origin_distance;
  constexpr std::uint64_t kAttempts = 10000;
  for (std::uint64_t index = 0; index < kAttempts; ++index) {
    const PlacedOutline placed = workloads::draw_placed_outline(workload, seed, index);
    const auto height = static_cast<double>(workloads::bounding_box(placed.outline.outer).size()) / 4;
    const LetterL letter = letter_of(placed.outline);
    const Position place = test == Test::Foot ? letter.at(spot) : letter.beyond(spot, height);
    const Eigen::Vector3d center = placed.frame.at(place.x, place.y, height);
    const int flat = flat_axis(placed.frame);
    if (!same_binade(center[(flat + 1) % 3], center[(flat + 2) % 3])) continue;
    const double distance = exact::answer({center, 0}, placed.polygon).distance;
    return {placed.polygon, {center, distance}, flat, methods};
  }
  throw std::runtime_error("no L was found whose coordinates lie in one binade");
}

char letter(Test test, const cases::PartialAnswer& truth) {
  if (test == Test::Contact) return *truth.contact ? 'c' : 'n';
  return to_string(*truth.foot).front();
}

char letter(const std::optional<Outcome>& verdict) {
  if (!verdict) return '?';
  switch (*verdict) {
    case Outcome::Right: return '=';
    case Outcome::WronglyIn: return '+';
    case Outcome::WronglyOut: return '-';
    case Outcome::BoundaryMissed: break;
  }
  return 'b';
}

/// Draws one row of a map. What is right is the contract's answer if a method lifts vertices, otherwise that about the
/// polygon as given.
void draw_row(const Scene& scene, const std::vector<cases::Understanding>& understandings, std::size_t row, Map& map) {
  const cases::TruthAsGiven truth_as_given(*scene.contract, scene.polygon);
  for (std::size_t column = 0; column < kSide; ++column) {
    const Ball ball = scene.ball(row, column);
    const cases::QueryKind kind = query_kind(map.test);
    const cases::PartialAnswer contract = scene.contract->ask(ball, kind), as_given = truth_as_given.ask(ball, kind);
    const std::size_t pixel = row * kSide + column;
    map.truth[pixel] = letter(map.test, as_given);
    for (std::size_t m = 0; m < scene.asked.size(); ++m) {
      const auto& [knows_boundary, lifts_vertices] = understandings[m];
      map.verdicts[m][pixel] = letter(
          compare(map.test, scene.asked[m]->ask(ball, kind), lifts_vertices ? contract : as_given, knows_boundary));
    }
  }
}

}  // namespace

std::string_view to_string(Spot spot) {
  switch (spot) {
    case Spot::Face: return "face";
    case Spot::Edge: return "edge";
    case Spot::Vertex: return "vertex";
    case Spot::ReflexVertex: break;
  }
  return "reflex-vertex";
}

std::uint64_t map_rows() { return kMaps * kSide; }

std::vector<Map> draw_maps(const std::vector<const cases::Method*>& methods, std::uint64_t seed, unsigned threads,
                           const std::atomic<bool>& stop, const program::Progress& progress) {
  std::vector<cases::Understanding> understandings;
  for (const auto* method : methods)
    understandings.push_back({cases::knows_boundary(*method), cases::lifts_vertices(*method)});
  std::vector<Scene> scenes;
  std::vector<Map> maps;
  const std::string empty(kSide * kSide, ' ');
  for (const Spot spot : kSpots)
    for (const double distance : kOriginDistances)
      for (const Test test : {Test::Foot, Test::Contact}) {
        if (spot == Spot::Face && test == Test::Foot) continue;
        scenes.push_back(draw_scene(spot, test, distance, seed, methods));
        maps.push_back({spot, distance, test, empty, std::vector<std::string>(methods.size(), empty)});
      }
  const std::uint64_t done =
      program::run_blocks(map_rows(), threads, stop, progress, [&](unsigned, std::uint64_t number) {
        const std::size_t map = number / kSide;
        draw_row(scenes[map], understandings, number % kSide, maps[map]);
      });
  maps.resize(static_cast<std::size_t>(done) / kSide);
  return maps;
}

}  // namespace touchstone::near_edge
