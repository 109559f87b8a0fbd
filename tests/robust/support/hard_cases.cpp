// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/hard_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::contact_tests {
namespace {

using workloads::move_by_doubles;
using workloads::Random;

/// inRange whatever RapidCheck's size is.
template <class T>
T in_range(T lowest, T highest) {
  return *rc::gen::resize(100, rc::gen::inRange<T>(lowest, highest + 1));
}

Case soak_case(std::uint64_t seed, std::uint64_t index) {
  workloads::adversarial::Case drawn = workloads::adversarial::draw_case(seed, index);
  const std::string id =
      "soak-s" + std::to_string(seed) + "-i" + std::to_string(index) + "-" + std::string(to_string(drawn.family));
  return {id, drawn.ball, std::move(drawn.polygon)};
}

std::uint64_t any_seed() { return *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>()); }

/// The case if its loops are legal.
std::optional<Case> valid(const std::string& id, const Ball& ball, const std::vector<Loop>& loops) {
  try {
    Polygon polygon = polygon_of(loops);
    if (!find_fault(ball) && !exact::validate(polygon)) return Case{id, ball, std::move(polygon)};
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

std::optional<Case> degenerate(Case c) {
  const std::size_t i = in_range<std::size_t>(0, c.polygon.vertex_count() - 1);
  const Eigen::Vector3d a = c.polygon.vertex(i), b = c.polygon.vertex(c.polygon.next(i));
  switch (in_range(0, 3)) {
    case 0: c.ball.center = a; break;
    case 1: c.ball.center = a / 2 + b / 2; break;
    case 2: c.ball.center = {a.x(), a.y(), b.z()}; break;
    default: break;
  }
  const Eigen::Vector3d half = a / 2 - b / 2;
  const double radii[] = {0,
                          std::numeric_limits<double>::denorm_min(),
                          std::numeric_limits<double>::max(),
                          2 * std::hypot(half.x(), half.y(), half.z()),
                          extent(c.polygon) * 0x1p60,
                          c.ball.radius};
  c.ball.radius = radii[in_range(0, 5)];
  if (find_fault(c.ball)) return std::nullopt;
  c.id += "-degenerate";
  return c;
}

/// Every coordinate moved; the numbers depend on the seed alone.
std::optional<Case> off_plane(const Case& c, std::uint64_t seed, int bits) {
  Random random(seed, 0);
  const std::int64_t most = std::int64_t{1} << std::min(bits, 40);
  const double tenth = extent(c.polygon) / 10;
  std::vector<Loop> loops = loops_of(c.polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop)
      for (double& x : vertex)
        x = bits > 40 ? x + tenth * (2 * random.unit() - 1) : move_by_doubles(x, random.integer(-most, most));
  return valid(c.id + "-off" + std::to_string(bits) + "-" + std::to_string(seed), c.ball, loops);
}

std::optional<Case> island(std::uint64_t seed, int exponent) {
  Random random(seed, 0);
  const auto square = [](double half) {
    return std::vector<std::pair<double, double>>{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  };
  const double cosine = random.coin() ? 1 : 0.6, sine = random.coin() ? 0 : 0.8,
               slope = random.coin() ? 0 : random.unit();
  const auto place = [&](double x, double y, double h) {
    return Eigen::Vector3d(cosine * x - sine * y, sine * x + cosine * y, h + slope * x);
  };
  std::vector<Loop> loops;
  for (const double half : {8.0, 6.0, 4.0, 2.0}) {
    loops.emplace_back();
    for (const auto& [x, y] : square(half)) loops.back().push_back(place(x, y, 0));
    if (random.coin()) std::reverse(loops.back().begin(), loops.back().end());
  }
  const auto number = [&] { return static_cast<double>(random.integer(-9, 9)); };
  const double x = number(), y = random.coin() ? x : number();
  const Ball ball{place(x, y, number()), std::abs(number())};
  const auto c = valid("island-" + std::to_string(seed), ball, loops);
  if (!c || exponent == 0) return c;
  const Case larger = scaled(*c, exponent);
  return valid(larger.id + "-e" + std::to_string(exponent), larger.ball, loops_of(larger.polygon));
}

}  // namespace

rc::Gen<Case> soak_cases() {
  return with_signed_zeros(rc::gen::exec([] {
    const std::uint64_t seed = any_seed();
    return soak_case(seed, in_range<std::uint64_t>(0, 1'000'000));
  }));
}

rc::Gen<Case> threshold_cases() {
  return with_signed_zeros(rc::gen::exec([] {
    Case c = *any_case();
    const double distance = exact::answer(c.ball, c.polygon).distance;
    if (!std::isfinite(distance)) return c;
    const std::int64_t few = in_range(-9, 9), many = std::int64_t{1} << in_range(4, 45);
    const int kind = in_range(0, 3);
    const std::int64_t steps = kind < 2 ? few : kind == 2 ? many : -many;
    const double radius = move_by_doubles(distance, steps);
    if (!(radius >= 0 && std::isfinite(radius))) return c;
    c.ball.radius = radius;
    c.id += "-threshold" + std::to_string(steps);
    return c;
  }));
}

rc::Gen<Case> degenerate_balls() {
  return possible(rc::gen::exec([] { return degenerate(*any_case()); }));
}

rc::Gen<Case> off_plane_cases() {
  return possible(rc::gen::exec([] {
    const Case c = *rc::gen::oneOf(samples({.largest_warp = 0}), grid_cases());
    const std::uint64_t seed = any_seed();
    return off_plane(c, seed, in_range(0, 44));
  }));
}

rc::Gen<Case> scaled_cases() {
  return possible(rc::gen::exec([]() -> std::optional<Case> {
    const Case c = *rc::gen::oneOf(samples({.largest_exponent = 0}), grid_cases(), grid_cases(2));
    const int exponents[] = {-1074 + in_range(0, 60), -1000, -500, 480, 960, 1000 + in_range(0, 23),
                             in_range(-1074, 1023)};
    const int exponent = exponents[in_range(0, 6)];
    if (!scales_exactly(c, exponent)) return std::nullopt;
    Case larger = scaled(c, exponent);
    larger.id += "-e" + std::to_string(exponent);
    return larger;
  }));
}

rc::Gen<Case> islands() {
  return possible(rc::gen::exec([] {
    const std::uint64_t seed = any_seed();
    const int exponents[] = {0, 0, 0, -1074, -500, 480, 1000};
    return island(seed, exponents[in_range(0, 6)]);
  }));
}

rc::Gen<Case> hard_cases() {
  return rc::gen::oneOf(soak_cases(), soak_cases(), any_case(), threshold_cases(), degenerate_balls(),
                        off_plane_cases(), scaled_cases(), islands());
}

rc::Gen<Case> hard_triangles() {
  return with_signed_zeros(rc::gen::exec([] {
    const std::uint64_t seed = any_seed(), index = in_range<std::uint64_t>(0, 1'000'000);
    return soak_case(seed, index % 10 == 9 ? index - 1 : index);
  }));
}

}  // namespace touchstone::contact_tests
