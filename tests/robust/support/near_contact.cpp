// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/near_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "geometry/contact/fast.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using workloads::Random;

std::optional<Polygon> valid(const std::vector<Loop>& loops) {
  try {
    Polygon polygon = polygon_of(loops);
    if (!exact::validate(polygon)) return polygon;
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

/// The polygon on a plane through the origin whose slopes are quarters: sums of coordinates of 50 bits are doubles there.
std::optional<Polygon> flattened(const Polygon& polygon) {
  const Eigen::Vector3d normal = fast::PreparedPolygon<>(polygon).plane().normal;
  const int k = dropped_axis(normal), u = (k + 1) % 3, v = (k + 2) % 3;
  const double slope_u = std::round(-4 * normal[u] / normal[k]) / 4,
               slope_v = std::round(-4 * normal[v] / normal[k]) / 4;
  double largest = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    largest = std::max(largest, polygon.vertex(i).cwiseAbs().maxCoeff());
  const double grid = std::exp2(std::ilogb(largest) - 49);
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& p : loop) {
      for (const int axis : {u, v}) p[axis] = std::round(p[axis] / grid) * grid;
      p[k] = slope_u * p[u] + slope_v * p[v];
    }
  return valid(loops);
}

/// The polygon with a vertex of a hole moved to one of another loop.
std::optional<Polygon> pinched(const Polygon& polygon, Random& random) {
  const std::vector<Loop> loops = loops_of(polygon);
  for (int attempt = 0; attempt < 30; ++attempt) {
    std::vector<Loop> touching = loops;
    const auto any = [&](const Loop& loop) {
      return static_cast<std::size_t>(random.integer(0, std::ssize(loop) - 1));
    };
    touching[1][any(loops[1])] = loops[0][any(loops[0])];
    if (auto found = valid(touching)) return found;
  }
  return std::nullopt;
}

bool is_at(Spot spot, const Answer& answer, const Polygon& polygon) {
  const auto& [kind, index] = answer.nearest;
  if (!(answer.distance > 0)) return false;
  if (spot == Spot::Face) return kind == Feature::Kind::Face;
  if (spot == Spot::Edge) return kind == Feature::Kind::Edge;
  if (spot == Spot::Hole) return kind != Feature::Kind::Face && index >= polygon.loop_end(0);
  if (kind != Feature::Kind::Vertex) return false;
  if (spot == Spot::Vertex) return true;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    if (i != index && polygon.vertex(i) == polygon.vertex(index)) return true;
  return false;
}

/// A point near the feature, at a distance of up to 2 sizes.
Eigen::Vector3d draw_center(Spot spot, const Polygon& polygon, const Eigen::Vector3d& normal, Random& random) {
  const auto any = [&](std::size_t first, std::size_t end) {
    return static_cast<std::size_t>(
        random.integer(static_cast<std::int64_t>(first), static_cast<std::int64_t>(end) - 1));
  };
  const std::size_t count = polygon.vertex_count(), i = any(spot == Spot::Hole ? polygon.loop_end(0) : 0, count);
  const Eigen::Vector3d start = polygon.vertex(i), end = polygon.vertex(polygon.next(i)),
                        across = (end - start).cross(normal);
  const bool on_edge = spot == Spot::Edge || (spot == Spot::Hole && random.coin());
  const double share = random.unit(), turn = 6.28 * random.unit(), lift = 1.57 * (2 * random.unit() - 1);
  const double length = extent(polygon) * (random.coin() ? 2 * random.unit() : std::exp2(-3 - 24 * random.unit()));
  Eigen::Vector3d out = across.normalized() * (random.coin() ? 1 : -1), from = start;
  if (!on_edge) out = std::cos(turn) * across.normalized() + std::sin(turn) * (end - start).normalized();
  if (on_edge) from += share * (end - start);
  if (spot != Spot::Face) return from + length * (std::cos(lift) * out + std::sin(lift) * normal);
  from += share * (polygon.vertex(any(0, count)) - from);
  from += random.unit() * (polygon.vertex(any(0, count)) - from);
  return from + (random.coin() ? length : -length) * normal;
}

std::optional<Case> at(Spot spot, std::string id, const Eigen::Vector3d& center, Polygon polygon) {
  const Answer answer = filtered::answer({center, 0}, polygon);
  if (!is_at(spot, answer, polygon)) return std::nullopt;
  return Case{std::move(id), {center, answer.distance}, std::move(polygon)};
}

}  // namespace

const std::vector<Spot>& all_spots() {
  static const std::vector<Spot> all{Spot::Face, Spot::Edge, Spot::Vertex, Spot::Hole, Spot::Pinch};
  return all;
}

std::string_view to_string(Spot spot) {
  constexpr std::string_view kNames[] = {"face", "edge", "vertex", "hole", "pinch"};
  return kNames[static_cast<int>(spot)];
}

std::optional<Case> near_contact(Spot spot, Lie lie, std::uint64_t seed, std::uint64_t index) try {
  Random random(seed, index, 2'000'000);
  workloads::Workload workload;
  const auto& families = workloads::all_families();
  workload.family = families[static_cast<std::size_t>(random.integer(0, std::ssize(families) - 1))];
  if (lie == Lie::Triangle) workload.family = workloads::Family::Triangle;
  workload.placement = workloads::Placement::Rotated;
  workload.vertices = static_cast<std::size_t>(random.integer(3, 24));
  const bool needs_hole = spot == Spot::Hole || spot == Spot::Pinch;
  if (lie != Lie::Triangle) workload.holes = static_cast<std::size_t>(random.integer(needs_hole ? 1 : 0, 2));
  std::optional<Polygon> polygon = workloads::sample(workload, seed, index).polygon;
  if (spot == Spot::Pinch) polygon = pinched(*polygon, random);
  if (polygon && lie == Lie::Planar) polygon = flattened(*polygon);
  if (!polygon) return std::nullopt;
  const Eigen::Vector3d normal = fast::PreparedPolygon<>(*polygon).plane().normal.normalized();
  const std::string id = std::string(to_string(spot)) + '-' + std::to_string(seed) + '-' + std::to_string(index);
  for (int attempt = 0; attempt < 40; ++attempt)
    if (auto found = at(spot, id, draw_center(spot, *polygon, normal, random), *polygon)) return found;
  return std::nullopt;
} catch (const std::invalid_argument&) {
  return std::nullopt;  // the family has no such outline
}

rc::Gen<Case> near_contact(Spot spot, Lie lie) {
  return [=](const rc::Random& random, int) {
    const auto first = [&] {
      for (std::uint64_t index = 0;; ++index)
        if (auto found = near_contact(spot, lie, rc::Random(random).next(), index)) return *std::move(found);
    };
    return rc::shrinkable::shrinkRecur(first(), [=](const Case& c) {
      std::vector<Case> smaller;
      for (Case& less : with_less(c))
        if (auto found = at(spot, less.id, c.ball.center, std::move(less.polygon)))
          smaller.push_back(*std::move(found));
      return rc::seq::fromContainer(std::move(smaller));
    });
  };
}

}  // namespace touchstone::contact_tests
