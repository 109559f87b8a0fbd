// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/generators.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::contact_tests {
namespace {

using workloads::BallPlace;
using workloads::Placement;
using workloads::Random;

/// All that is needed to draw a case again.
struct Recipe {
  workloads::Workload workload;
  std::uint64_t seed, index;
  int warp, exponent;
};

rc::Gen<Recipe> recipes(const Draw& draw) {
  return rc::gen::exec([draw] {
    using rc::gen::elementOf, rc::gen::inRange;
    Recipe recipe{};
    recipe.workload.family = *elementOf(workloads::all_families());
    recipe.workload.ball = *elementOf(draw.balls);
    const bool tangent = recipe.workload.ball == BallPlace::LatticeTangent;
    recipe.workload.placement = tangent ? Placement::LatticeFrame : *elementOf(draw.placements);
    recipe.workload.vertices = *inRange<std::size_t>(3, 20);
    recipe.workload.holes = *inRange(draw.fewest_holes, draw.most_holes + 1);
    recipe.workload.doubles = *inRange(-2, 3);
    if (tangent) recipe.workload.doubles = 0;
    recipe.workload.origin_distance = *rc::gen::element(0.0, 0.0, 1.0, 0x1p10, 0x1p20);
    recipe.workload.origin_distance = std::min(recipe.workload.origin_distance, draw.farthest);
    recipe.seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
    recipe.index = *rc::gen::noShrink(inRange<std::uint64_t>(0, 1000));
    recipe.warp = *inRange(-draw.largest_warp, draw.largest_warp + 1);
    if (*inRange(0, 3) == 2) recipe.exponent = *inRange(-draw.largest_exponent, draw.largest_exponent + 1);
    return recipe;
  });
}

/// Every vertex moved by up to 2^(warp - 20) of the size in every coordinate; nothing where the loops then meet.
std::optional<Polygon> warped(const Polygon& polygon, const Recipe& recipe) {
  Random random(recipe.seed, recipe.index, 1'000'000);
  const double step = std::exp2(std::ilogb(extent(polygon)) - 20);
  const std::int64_t most = std::int64_t{1} << recipe.warp;
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop)
      for (double& x : vertex) x += step * static_cast<double>(random.integer(-most, most));
  try {
    Polygon moved = polygon_of(loops);
    if (!exact::validate(moved)) return moved;
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

/// Nothing where the workload has no such sample.
std::optional<Case> build(const Recipe& recipe) try {
  workloads::Sample sample = workloads::sample(recipe.workload, recipe.seed, recipe.index);
  Case built{std::move(sample.id), sample.ball, std::move(sample.polygon)};
  if (recipe.warp > 0) {
    auto polygon = warped(built.polygon, recipe);
    if (!polygon) return std::nullopt;
    built.polygon = *std::move(polygon);
    built.id += "-w" + std::to_string(recipe.warp);
  }
  if (recipe.exponent != 0 && scales_exactly(built, recipe.exponent)) {
    built = scaled(built, recipe.exponent);
    built.id += "-e" + std::to_string(recipe.exponent);
  }
  return built;
} catch (const std::invalid_argument&) {
  return std::nullopt;
}

struct GridPoint {
  int x, y, lift;
};

/// A point of the plane at height h, with axis k for its normal.
Eigen::Vector3d on_grid(const GridPoint& point, int k, double h) {
  Eigen::Vector3d v;
  v[k] = h + point.lift;
  v[(k + 1) % 3] = point.x;
  v[(k + 2) % 3] = point.y;
  return v;
}

/// `count` points of [low, high]^2.
Loop grid_loop(int count, int low, int high, int warp, int axis, double h) {
  Loop loop;
  for (int i = 0; i < count; ++i) {
    const int x = *rc::gen::inRange(low, high + 1), y = *rc::gen::inRange(low, high + 1);
    loop.push_back(on_grid({x, y, *rc::gen::inRange(0, warp + 1)}, axis, h));
  }
  return loop;
}

/// A rectangle about (3, 3), so that points with x = 3 are as far from its left as from its right.
Loop rectangle(int axis, double h) {
  const int a = *rc::gen::inRange(1, 3), b = *rc::gen::inRange(1, 3);
  Loop loop;
  for (const GridPoint& p : {GridPoint{3 - a, 3 - b, 0}, {3 + a, 3 - b, 0}, {3 + a, 3 + b, 0}, {3 - a, 3 + b, 0}})
    loop.push_back(on_grid(p, axis, h));
  return loop;
}

/// A random loop; or in a square with one corner moved a random hole, or a rectangular one and the ball in its middle.
std::optional<Case> grid_case(int warp) {
  const int axis = *rc::gen::inRange(0, 3);
  const double h = *rc::gen::inRange(-2, 3);
  const int kind = *rc::gen::inRange(0, 4);
  const bool with_hole = kind >= 2, tie = kind == 3;
  std::vector<Loop> loops;
  if (with_hole) {
    const int corner = *rc::gen::inRange(5, 7);
    loops.emplace_back();
    for (const GridPoint& p : {GridPoint{0, 0, 0}, {6, 0, 0}, {corner, corner, 0}, {0, 6, 0}})
      loops[0].push_back(on_grid(p, axis, h));
  }
  const int count = *rc::gen::inRange(3, with_hole ? 5 : 7);
  if (tie)
    loops.push_back(rectangle(axis, h));
  else
    loops.push_back(with_hole ? grid_loop(count, 0, 4, warp, axis, h) : grid_loop(count, 0, 6, warp, axis, h));
  const int x = tie ? 3 : *rc::gen::inRange(-2, 9), y = *rc::gen::inRange(-2, 9);
  const Ball ball{on_grid({x, y, *rc::gen::inRange(-4, 5)}, axis, h), static_cast<double>(*rc::gen::inRange(0, 9))};
  try {
    Polygon polygon = polygon_of(loops);
    if (!exact::validate(polygon)) return Case{"grid", ball, std::move(polygon)};
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

}  // namespace

// As a line of JSON, which `touchstone judge` reads.
void showValue(const Case& drawn, std::ostream& out) {
  const auto number = [&out](double value) {
    std::array<char, 32> digits;
    out << std::string_view(digits.begin(), std::to_chars(digits.begin(), digits.end(), value).ptr);
  };
  const auto point = [&](const Eigen::Vector3d& p) {
    for (int axis = 0; axis < 3; ++axis) number((out << (axis == 0 ? '[' : ','), p[axis]));
    out << ']';
  };
  const auto loop = [&](std::size_t number_of_loop) {
    for (std::size_t i = drawn.polygon.loop_begin(number_of_loop); i < drawn.polygon.loop_end(number_of_loop); ++i) {
      out << (i == drawn.polygon.loop_begin(number_of_loop) ? '[' : ',');
      point(drawn.polygon.vertex(i));
    }
    out << ']';
  };
  out << R"({"id":")" << drawn.id << R"(","ball":{"center":)";
  point(drawn.ball.center);
  out << R"(,"radius":)";
  number(drawn.ball.radius);
  out << R"(},"polygon":{"outer":)";
  loop(0);
  out << R"(,"holes":[)";
  for (std::size_t hole = 1; hole < drawn.polygon.loop_count(); ++hole) {
    if (hole > 1) out << ',';
    loop(hole);
  }
  out << "]}}\n";
}

rc::Gen<Case> with_signed_zeros(rc::Gen<Case> gen) {
  return rc::gen::exec([gen = std::move(gen)] {
    Case drawn = *gen;
    Random random(*rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()), 0);
    sign_zeros(drawn.ball, random);
    sign_zeros(drawn.polygon, random);
    return drawn;
  });
}

rc::Gen<Case> possible(rc::Gen<std::optional<Case>> gen) {
  return with_signed_zeros(
      rc::gen::map(rc::gen::suchThat(std::move(gen), [](const auto& drawn) { return drawn.has_value(); }),
                   [](std::optional<Case> drawn) { return *std::move(drawn); }));
}

std::vector<Case> with_less(const Case& c, std::size_t fewest_holes) {
  std::vector<Case> found;
  const auto add = [&](const std::vector<Loop>& loops) {
    try {
      Polygon polygon = polygon_of(loops);
      if (!exact::validate(polygon)) found.push_back({c.id + "-less", c.ball, std::move(polygon)});
    } catch (const Rejected&) {
    }
  };
  const std::vector<Loop> loops = loops_of(c.polygon);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Loop> less = loops;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    if (i != 0 && less.size() > fewest_holes) add(less);
    for (std::ptrdiff_t j = 0; j < std::ssize(loops[i]); ++j) {
      less = loops;
      less[i].erase(less[i].begin() + j);
      add(less);
    }
  }
  return found;
}

rc::Gen<Case> samples(const Draw& draw) {
  return [drawn = possible(rc::gen::map(recipes(draw), build)), fewest = draw.fewest_holes](const rc::Random& random,
                                                                                            int size) {
    return rc::shrinkable::mapcat(drawn(random, size), [fewest](const Case& c) {
      return rc::shrinkable::shrinkRecur(
          c, [fewest](const Case& larger) { return rc::seq::fromContainer(with_less(larger, fewest)); });
    });
  };
}

rc::Gen<Case> grid_cases(int largest_warp) {
  return possible(rc::gen::resize(100, rc::gen::exec([largest_warp] { return grid_case(largest_warp); })));
}

rc::Gen<Case> any_case() { return rc::gen::oneOf(samples(), grid_cases(), grid_cases(2)); }

}  // namespace touchstone::contact_tests
