// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/near_edge/map.h"

#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>

#include "experiments/workloads/doubles.h"
#include "experiments/workloads/placement.h"
#include "robust/exact/exact.h"

namespace touchstone::near_edge {
namespace {

using workloads::PlacedOutline;

constexpr std::size_t kDistances = std::size(kOriginDistances);
constexpr auto kSide = static_cast<std::size_t>(Map::kSize);

std::size_t reflex_vertex(const workloads::Outline& outline) {
  std::size_t i = 0;
  while (workloads::corner(outline, i).convex()) ++i;
  return i;
}

/// The axis across which a polygon spreads least; here, that of its normal's largest component, but for near ties.
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

struct Scene {
  Polygon polygon;
  Ball middle;
  int first_axis, second_axis;

  [[nodiscard]] Ball ball(std::size_t row, std::size_t column) const {
    Ball ball = middle;
    const auto from_middle = [](std::size_t i) { return static_cast<std::int64_t>(i) - Map::kSize / 2; };
    ball.center[first_axis] = workloads::move_by_doubles(ball.center[first_axis], from_middle(column));
    ball.center[second_axis] = workloads::move_by_doubles(ball.center[second_axis], -from_middle(row));
    return ball;
  }
};

Scene draw_scene(double origin_distance, std::uint64_t seed) {
  workloads::Workload workload;
  workload.family = workloads::Family::L;
  workload.placement = workloads::Placement::Rotated;
  workload.origin_distance = origin_distance;
  constexpr std::uint64_t kAttempts = 10000;
  for (std::uint64_t index = 0; index < kAttempts; ++index) {
    const PlacedOutline placed = workloads::draw_placed_outline(workload, seed, index);
    const auto vertex = workloads::corner(placed.outline, reflex_vertex(placed.outline)).here;
    const auto height = static_cast<double>(workloads::bounding_box(placed.outline.outer).size()) / 4;
    const Eigen::Vector3d center =
        placed.frame.at(static_cast<double>(vertex.x), static_cast<double>(vertex.y), height);
    const int flat = flat_axis(placed.frame), first = (flat + 1) % 3, second = (flat + 2) % 3;
    if (!same_binade(center[first], center[second])) continue;
    const double distance = exact::answer({center, 0}, placed.polygon).distance;
    return {placed.polygon, {center, distance}, first, second};
  }
  throw std::runtime_error("no L was found whose coordinates lie in one binade");
}

/// What one thread has prepared of one scene.
struct Prepared {
  Prepared(const Scene& scene, const std::vector<const methods::Method*>& methods) : exact(scene.polygon) {
    for (const auto* method : methods) asked.push_back(method->prepare(scene.polygon));
  }
  exact::PreparedPolygon exact;
  std::vector<std::unique_ptr<methods::PreparedMethod>> asked;
};

char letter(Test test, const methods::PartialAnswer& truth) {
  if (test == Test::Contact) return *truth.contact ? 'c' : 'n';
  return word(*truth.foot).front();
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

void draw_row(const Scene& scene, const Prepared& prepared, const std::vector<bool>& knows_boundary, std::size_t row,
              Map* foot_and_contact) {
  for (std::size_t column = 0; column < kSide; ++column) {
    const Ball ball = scene.ball(row, column);
    methods::PartialAnswer truth;
    truth.foot = exact::foot(ball, prepared.exact);
    truth.contact = exact::contact(ball, prepared.exact);
    const std::size_t pixel = row * kSide + column;
    for (Map* map = foot_and_contact; map != foot_and_contact + 2; ++map) {
      map->truth[pixel] = letter(map->test, truth);
      for (std::size_t m = 0; m < prepared.asked.size(); ++m) {
        const auto answer = prepared.asked[m]->ask(ball, question(map->test));
        map->verdicts[m][pixel] = letter(compare(map->test, answer, truth, knows_boundary[m]));
      }
    }
  }
}

}  // namespace

std::uint64_t map_blocks() { return kDistances * kSide; }

std::vector<Map> draw_maps(const std::vector<const methods::Method*>& methods, std::uint64_t seed, unsigned threads,
                           const std::atomic<bool>& stop, const run::Progress& progress) {
  std::vector<bool> knows_boundary;
  for (const auto* method : methods) knows_boundary.push_back(judge::knows_boundary(*method));
  std::vector<Scene> scenes;
  std::vector<Map> maps;
  for (const double distance : kOriginDistances) {
    scenes.push_back(draw_scene(distance, seed));
    for (const Test test : {Test::Foot, Test::Contact}) {
      const std::string empty(kSide * kSide, '?');
      maps.push_back({distance, test, empty, std::vector<std::string>(methods.size(), empty)});
    }
  }
  std::vector<std::vector<std::unique_ptr<Prepared>>> prepared(threads);  // [thread][scene]
  for (auto& list : prepared)
    for (const Scene& scene : scenes) list.push_back(std::make_unique<Prepared>(scene, methods));

  const std::uint64_t done =
      run::run_blocks(map_blocks(), threads, stop, progress, [&](unsigned thread, std::uint64_t block) {
        const auto scene = static_cast<std::size_t>(block) / kSide, row = static_cast<std::size_t>(block) % kSide;
        draw_row(scenes[scene], *prepared[thread][scene], knows_boundary, row, &maps[2 * scene]);
      });
  maps.resize(2 * (static_cast<std::size_t>(done) / kSide), {0, Test::Foot, {}, {}});
  return maps;
}

}  // namespace touchstone::near_edge
