// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/outline.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"

namespace touchstone::workloads {
namespace {

constexpr std::int64_t kSide = 2 * kLatticeRadius;

std::int64_t signed_count(std::size_t n) { return static_cast<std::int64_t>(n); }

/// Moves the loop so that the centre of its bounding box is the origin.
LatticeLoop centred(LatticeLoop loop) {
  const LatticeBox box = bounding_box(loop);
  const LatticePoint centre{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  for (LatticePoint& p : loop) p = p - centre;
  return loop;
}

/// Draws increasing numbers from 0 to at most `total`, whose steps are random within a factor of 8.
std::vector<std::int64_t> random_marks(Random& random, std::size_t steps, std::int64_t total) {
  const std::int64_t step = total / signed_count(steps);
  std::vector<std::int64_t> marks{0};
  for (std::size_t i = 0; i < steps; ++i) marks.push_back(marks.back() + random.integer((step + 7) / 8, step));
  return marks;
}

/// The heights above which teeth end and below which the gaps between them end.
struct Heights {
  std::int64_t total;

  std::int64_t tooth(Random& random) const { return random.integer(total * 5 / 8, total); }
  std::int64_t gap(Random& random) const { return random.integer(total / 8, total / 2); }
};

LatticeLoop rectangular_comb(Random& random, std::size_t teeth) {
  const Heights heights{random.integer(kSide / 4, kSide)};
  const std::vector<std::int64_t> x = random_marks(random, 2 * teeth - 1, kSide);
  LatticeLoop loop{{x.front(), 0}, {x.back(), 0}};
  for (std::size_t i = x.size() - 1; i > 0; --i) {  // teeth end at the even steps from the right, gaps at the odd
    const bool tooth = (x.size() - 1 - i) % 2 == 0;
    const std::int64_t y = tooth ? heights.tooth(random) : heights.gap(random);
    loop.push_back({x[i], y});
    loop.push_back({x[i - 1], y});
  }
  return centred(loop);
}

LatticeLoop saw(Random& random, std::size_t vertices) {
  const Heights heights{random.integer(kSide / 4, kSide)};
  const std::vector<std::int64_t> x = random_marks(random, vertices - 3, kSide);
  LatticeLoop loop{{x.front(), 0}, {x.back(), 0}};
  for (std::size_t i = 0; i < x.size(); ++i)
    loop.push_back({x[x.size() - 1 - i], i % 2 == 0 ? heights.tooth(random) : heights.gap(random)});
  return centred(loop);
}

/// Draws the n steps along one axis of a closed walk: from the least of n random marks to the greatest over some of
/// them, and back over the others.
std::vector<std::int64_t> closed_steps(Random& random, std::size_t n) {
  std::vector<std::int64_t> marks;
  for (std::size_t i = 0; i < n; ++i) marks.push_back(random.integer(0, kSide));
  std::sort(marks.begin(), marks.end());
  std::vector<std::int64_t> steps;
  std::int64_t there = marks.front(), back = marks.front();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (random.coin()) {
      steps.push_back(marks[i] - there);
      there = marks[i];
    } else {
      steps.push_back(back - marks[i]);
      back = marks[i];
    }
  }
  steps.push_back(marks.back() - there);
  steps.push_back(back - marks.back());
  return steps;
}

/// Returns whether a precedes b counterclockwise from the positive x axis, exactly.
bool before_in_angle(LatticePoint a, LatticePoint b) {
  const auto lower_half = [](LatticePoint p) { return p.y < 0 || (p.y == 0 && p.x < 0); };
  if (lower_half(a) != lower_half(b)) return lower_half(b);
  return cross(a, b) > 0;
}

/// Returns the point at `t` in [0, 8 r) on the boundary of the square |x|, |y| <= r, counterclockwise.
LatticePoint on_square(std::int64_t t, std::int64_t r) {
  const std::int64_t along = t % (2 * r) - r;
  switch (t / (2 * r)) {
    case 0: return {r, along};
    case 1: return {-along, r};
    case 2: return {-r, -along};
    default: return {along, -r};
  }
}

/// Draws a star, star-shaped about the origin if no sector of 180 degrees is empty.
LatticeLoop star_of_radius(Random& random, std::size_t vertices, std::int64_t radius) {
  constexpr std::int64_t kShares = 1 << 20;
  const std::int64_t perimeter = 8 * radius, n = signed_count(vertices);
  const std::int64_t turn = random.integer(0, perimeter - 1);
  LatticeLoop loop;
  for (std::int64_t i = 0; i < n; ++i) {
    // One direction in the first three quarters of each n-th part of the square's boundary.
    const std::int64_t t = (perimeter * i + random.integer(0, perimeter * 3 / 4)) / n;
    const LatticePoint direction = on_square((t + turn) % perimeter, radius);
    const std::int64_t share = random.integer(kShares / 5, kShares);
    loop.push_back({direction.x * share / kShares, direction.y * share / kShares});
  }
  return loop;
}

/// Draws a triangle, an upright square or a star within `radius` of a point.
LatticeLoop hole(Random& random, LatticePoint centre, std::int64_t radius) {
  const std::int64_t half = std::max<std::int64_t>(1, radius * 2 / 3);
  LatticeLoop loop{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  const std::int64_t kind = random.integer(0, 2);
  if (kind != 0) loop = star_of_radius(random, kind == 1 ? 3 : static_cast<std::size_t>(random.integer(5, 8)), half);
  for (LatticePoint& p : loop) p = p + centre;
  return loop;
}

/// Adds a hole, disjoint from all loops. Returns false if no room was found.
bool add_hole(Random& random, Outline& outline) {
  constexpr int kTries = 400;
  const LatticeBox box = bounding_box(outline.outer);
  for (int i = 0; i < kTries; ++i) {
    const LatticePoint centre{random.integer(box.low.x, box.high.x), random.integer(box.low.y, box.high.y)};
    const double share = 0.2 + 0.7 * random.unit();
    if (!contains(outline, centre)) continue;
    const auto radius = static_cast<std::int64_t>(share * clearance(outline, centre));
    if (radius < 32) continue;
    outline.holes.push_back(hole(random, centre, radius));
    return true;
  }
  return false;
}

bool is_region(const Outline& outline) {
  const auto in_plane = [](const LatticeLoop& lattice) {
    Loop loop;
    for (const LatticePoint& p : lattice) loop.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y), 0);
    return loop;
  };
  std::vector<Loop> holes;
  for (const LatticeLoop& loop : outline.holes) holes.push_back(in_plane(loop));
  try {
    return !exact::validate(Polygon(in_plane(outline.outer), holes));
  } catch (const Rejected&) {
    return false;
  }
}

LatticeLoop draw_loop(Random& random, const Workload& workload) {
  switch (workload.family) {
    case Family::Triangle: return triangle(random);
    case Family::Convex: return convex(random, workload.vertices);
    case Family::Star: return star(random, workload.vertices);
    case Family::Comb: return comb(random, workload.vertices);
    case Family::Spiral: return spiral(random, workload.vertices);
    case Family::RandomSimple: return random_simple(random, workload.vertices);
    case Family::Koch: return koch(random, workload.vertices, workload.koch_dimension);
    case Family::U: return letter_u(random);
    case Family::L: return letter_l(random);
    case Family::E: return letter_e(random);
  }
  throw std::invalid_argument("unknown family");
}

/// Applies a random symmetry of the square, a random first vertex and a random orientation.
void rearrange(Random& random, LatticeLoop& loop) {
  const std::int64_t x_sign = random.coin() ? 1 : -1, y_sign = random.coin() ? 1 : -1;
  const bool exchange = random.coin();
  for (LatticePoint& p : loop) {
    p = {x_sign * p.x, y_sign * p.y};
    if (exchange) std::swap(p.x, p.y);
  }
  const auto first = static_cast<std::ptrdiff_t>(random.integer(0, signed_count(loop.size()) - 1));
  std::rotate(loop.begin(), loop.begin() + first, loop.end());
  if (random.coin()) std::reverse(loop.begin(), loop.end());
}

std::optional<Outline> try_outline(const Workload& workload, Random shape, Random holes) {
  Outline outline{draw_loop(shape, workload), {}};
  rearrange(shape, outline.outer);
  const bool may_be_convex = workload.family == Family::Triangle || workload.family == Family::Convex;
  if (!may_be_convex && is_convex(outline.outer)) return std::nullopt;
  while (outline.holes.size() < workload.holes)
    if (!add_hole(holes, outline)) return std::nullopt;
  for (LatticeLoop& loop : outline.holes)
    if (holes.coin()) std::reverse(loop.begin(), loop.end());
  if (!is_region(outline)) return std::nullopt;
  return outline;
}

struct Point {
  double x, y;
};

/// Returns 4^(-1/dimension), the same double on every machine.
double koch_ratio(double dimension) {
  free_mpfr_at_thread_end();
  mpfr_t value;
  mpfr_init2(value, 200);
  mpfr_set_d(value, dimension, MPFR_RNDN);
  mpfr_si_div(value, -2, value, MPFR_RNDN);
  mpfr_exp2(value, value, MPFR_RNDN);
  const double ratio = mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  return ratio;
}

/// Returns a counterclockwise square or triangle about the origin, all vertices at the given distance from it.
std::vector<Point> base(Random& random, bool square, double radius) {
  const double half = std::sqrt(0.5), tall = std::sqrt(0.75);
  std::vector<Point> points = square ? std::vector<Point>{{half, half}, {-half, half}, {-half, -half}, {half, -half}}
                                     : std::vector<Point>{{0, 1}, {-tall, -0.5}, {tall, -0.5}};
  // A rational rotation, or none.
  const bool rotated = random.coin();
  const auto p = static_cast<double>(random.integer(1, 64));
  const auto q = static_cast<double>(rotated ? random.integer(-64, 64) : 0);
  const double cosine = (p * p - q * q) / (p * p + q * q), sine = 2 * p * q / (p * p + q * q);
  for (Point& point : points)
    point = {radius * (cosine * point.x - sine * point.y), radius * (sine * point.x + cosine * point.y)};
  return points;
}

/// Replaces every edge by four of `ratio` times its length, the middle two pointing to its right.
std::vector<Point> refined(const std::vector<Point>& points, double ratio) {
  const double height = std::sqrt(ratio - 0.25);
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    const Point along{b.x - a.x, b.y - a.y};
    result.push_back(a);
    result.push_back({a.x + ratio * along.x, a.y + ratio * along.y});
    result.push_back({(a.x + b.x) / 2 + height * along.y, (a.y + b.y) / 2 - height * along.x});
    result.push_back({b.x - ratio * along.x, b.y - ratio * along.y});
  }
  return result;
}

}  // namespace

LatticeLoop triangle(Random& random) {
  LatticeLoop loop;
  for (int i = 0; i < 3; ++i)
    loop.push_back(
        LatticePoint{random.integer(-kLatticeRadius, kLatticeRadius), random.integer(-kLatticeRadius, kLatticeRadius)});
  return loop;
}

// Two closed walks of random steps, one an axis, paired at random; the steps in order of angle bound a convex region.
LatticeLoop convex(Random& random, std::size_t vertices) {
  const std::size_t n = std::max<std::size_t>(vertices, 3);
  const std::vector<std::int64_t> dx = closed_steps(random, n);
  std::vector<std::int64_t> dy = closed_steps(random, n);
  for (std::size_t i = n - 1; i > 0; --i)
    std::swap(dy[i], dy[static_cast<std::size_t>(random.integer(0, signed_count(i)))]);

  LatticeLoop steps;
  for (std::size_t i = 0; i < n; ++i)
    if (dx[i] != 0 || dy[i] != 0) steps.push_back({dx[i], dy[i]});
  std::stable_sort(steps.begin(), steps.end(), before_in_angle);

  LatticeLoop loop{{0, 0}};
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) loop.push_back(loop.back() + steps[i]);
  return centred(loop);
}

LatticeLoop star(Random& random, std::size_t vertices) {
  return star_of_radius(random, std::max<std::size_t>(vertices, 5), kLatticeRadius);
}

LatticeLoop comb(Random& random, std::size_t vertices) {
  if (random.coin()) return rectangular_comb(random, std::max<std::size_t>((vertices + 2) / 4, 2));
  return saw(random, std::max<std::size_t>(vertices, 5));
}

LatticeLoop letter_u(Random& random) { return rectangular_comb(random, 2); }
LatticeLoop letter_e(Random& random) { return rectangular_comb(random, 3); }

LatticeLoop letter_l(Random& random) {
  const std::vector<std::int64_t> x = random_marks(random, 2, kSide), y = random_marks(random, 2, kSide);
  return centred({{0, 0}, {x[2], 0}, {x[2], y[1]}, {x[1], y[1]}, {x[1], y[2]}, {0, y[2]}});
}

// Arm j of the corridor lies along side j mod s of the square or triangle, between the lines normal . p = outer and
// normal . p = inner; arm j + s lies further in. Corners are the points where the lines of neighbouring arms meet.
LatticeLoop spiral(Random& random, std::size_t vertices) {
  const LatticeLoop square{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, triangle{{0, -1}, {1, 1}, {-1, 1}};
  const LatticeLoop& normals = random.coin() ? square : triangle;
  const std::size_t sides = normals.size();
  const std::size_t arms = std::max<std::size_t>(vertices / 2, 4) - 1;

  struct Level {
    std::int64_t outer, inner;
  };
  // Levels are even, so that the triangle's lines meet in lattice points; its corners lie up to twice as far out.
  const std::int64_t widest = sides == 4 ? kLatticeRadius : kLatticeRadius / 2;
  const std::int64_t step = widest / 2 / signed_count(2 * (arms / sides + 1));
  const auto gap = [&] { return 2 * random.integer((step + 3) / 4, step); };
  std::vector<Level> levels(sides, Level{widest, widest});  // arm j is levels[sides + j]; the first starts at `widest`
  for (std::size_t j = 0; j <= arms; ++j) {
    const std::int64_t outer = levels[j].inner - gap();
    levels.push_back({outer, outer - gap()});
  }
  levels.back().inner = levels.back().outer;  // where both walls of the last arm end

  const auto meet = [&](std::size_t j, std::int64_t level, std::int64_t next_level) {
    const LatticePoint a = normals[j % sides], b = normals[(j + 1) % sides];
    return LatticePoint{(level * b.y - next_level * a.y) / cross(a, b), (next_level * a.x - level * b.x) / cross(a, b)};
  };
  LatticeLoop loop, inner_wall;
  for (std::size_t j = sides - 1; j + 1 < levels.size(); ++j) {
    loop.push_back(meet(j, levels[j].outer, levels[j + 1].outer));
    inner_wall.push_back(meet(j, levels[j].inner, levels[j + 1].inner));
  }
  loop.insert(loop.end(), inner_wall.rbegin(), inner_wall.rend());
  return centred(loop);
}

Outline draw_outline(const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kAttempts = 100;
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    auto outline = try_outline(workload, part_of_sample(seed, index, Part::Outline, attempt),
                               part_of_sample(seed, index, Part::Holes, attempt));
    if (outline) return *std::move(outline);
  }
  throw std::invalid_argument("no " + std::string(to_string(workload.family)) + " outline of " +
                              std::to_string(workload.vertices) + " vertices and " + std::to_string(workload.holes) +
                              " holes on the lattice");
}

LatticeLoop koch(Random& random, std::size_t vertices, double dimension) {
  const bool square = random.coin();
  // The curve stays within sqrt(2) times the radius of the base.
  const double radius = static_cast<double>(kLatticeRadius) / 1.5 * (0.5 + 0.5 * random.unit());
  const double ratio = koch_ratio(dimension);

  std::vector<Point> points = base(random, square, radius);
  do points = refined(points, ratio);
  while (2 * vertices > 5 * points.size());  // 4 m is nearer to `vertices` than m

  LatticeLoop loop;
  for (const Point& point : points) loop.push_back({std::llround(point.x), std::llround(point.y)});
  return loop;
}

}  // namespace touchstone::workloads
