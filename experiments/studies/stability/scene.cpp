// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/scene.h"

#include <fmt/core.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/cases/workloads/placement.h"
#include "robust/exact/detail/nearest_double.h"
#include "robust/exact/validate.h"

namespace touchstone::stability {
namespace {

/// With the operations in this order on every machine.
Eigen::Vector3d product(const Eigen::Matrix3d& m, const Eigen::Vector3d& p) {
  Eigen::Vector3d result;
  for (int row = 0; row < 3; ++row) result[row] = m(row, 0) * p[0] + m(row, 1) * p[1] + m(row, 2) * p[2];
  return result;
}

}  // namespace

Eigen::Matrix3d small_rotation(Random& random) {
  // A quaternion (a, v) turns by 2 atan(|v| / a): 1.0 degree for |v| / a = 1 / 115.
  std::int64_t x = 0, y = 0, z = 0;
  while (x * x + y * y + z * z < 400) {
    x = random.integer(-100, 100);
    y = random.integer(-100, 100);
    z = random.integer(-100, 100);
  }
  std::int64_t a = 0;
  while (a * a < std::int64_t{115} * 115 * (x * x + y * y + z * z)) ++a;
  const auto unit = static_cast<double>(a * a + x * x + y * y + z * z);
  const auto entry = [unit](std::int64_t numerator) { return static_cast<double>(numerator) / unit; };  // one rounding
  Eigen::Matrix3d matrix;
  matrix << entry(a * a + x * x - y * y - z * z), entry(2 * (x * y - a * z)), entry(2 * (x * z + a * y)),
      entry(2 * (x * y + a * z)), entry(a * a - x * x + y * y - z * z), entry(2 * (y * z - a * x)),
      entry(2 * (x * z - a * y)), entry(2 * (y * z + a * x)), entry(a * a - x * x - y * y + z * z);
  return matrix;
}

std::vector<Eigen::Vector3d> rotated_in_steps(std::vector<Eigen::Vector3d> points, const Eigen::Matrix3d& matrix,
                                              std::uint64_t steps) {
  for (std::uint64_t step = 0; step < steps; ++step)
    for (Eigen::Vector3d& point : points) point = product(matrix, point);
  return points;
}

Eigen::Matrix3d pose_in_steps(const Eigen::Matrix3d& matrix, std::uint64_t steps) {
  Eigen::Matrix3d pose = Eigen::Matrix3d::Identity();
  for (std::uint64_t step = 0; step < steps; ++step)
    for (int column = 0; column < 3; ++column) {
      const Eigen::Vector3d before = pose.col(column);
      pose.col(column) = product(matrix, before);
    }
  return pose;
}

Eigen::Vector3d posed(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& point) {
  Eigen::Vector3d result;
  for (int row = 0; row < 3; ++row) {
    mpq_class sum = 0;
    for (int column = 0; column < 3; ++column) sum += mpq_class(matrix(row, column)) * mpq_class(point[column]);
    result[row] = exact::detail::nearest_double(sum.get_num(), sum.get_den());
  }
  return result;
}

namespace {

using Eigen::Vector3d;
using workloads::Frame;

constexpr std::uint64_t kAttempts = 300;
/// From here on what broke is drawn in a plane, or about a point, where it keeps.
constexpr std::uint64_t kGentleFrom = 100;

struct Draft {
  Placed placed;
  std::vector<std::size_t> critical;
};

bool within_factor_two(double measured, double level) { return measured >= level / 2 && measured <= level * 2; }

std::optional<Polygon> legal_polygon(const Loop& loop) {
  try {
    Polygon polygon(loop);
    if (!exact::validate(polygon)) return polygon;
  } catch (const Rejected&) {  // equal neighbours, or beyond the doubles
  }
  return std::nullopt;
}

std::optional<Draft> place(Random& random, const Flat& flat, const Frame& frame) {
  Loop loop;
  loop.reserve(flat.points.size());
  for (const FlatPoint p : flat.points) loop.push_back(frame.at(p.x, p.y, 0));
  auto polygon = legal_polygon(loop);
  if (!polygon) return std::nullopt;
  return Draft{{*std::move(polygon), draw_placements(random, flat, frame)}, flat.critical};
}

/// Every vertex and centre moved.
template <class Move>
std::optional<Placed> moved(const Placed& placed, const Move& move) {
  Loop loop;
  for (std::size_t i = 0; i < placed.polygon.vertex_count(); ++i) loop.push_back(move(placed.polygon.vertex(i)));
  auto polygon = legal_polygon(loop);
  if (!polygon) return std::nullopt;
  Placed there{*std::move(polygon), placed.placements};
  for (BallPlacement& placement : there.placements) placement.center = move(placement.center);
  return there;
}

/// An oblique frame for outlines about 2 across, at zero or about it.
Frame oblique_frame(Random& random, bool at_zero, double origin_distance = 0) {
  Frame frame = workloads::rotated_frame(random, 2, origin_distance);
  if (at_zero) frame.origin.setZero();
  return frame;
}

/// At zero, u along a coordinate axis, so that lengths along u and across it are never added.
Frame axis_parallel_frame(Random& random) {
  const auto axis = static_cast<int>(random.integer(0, 2));
  const double t = random.unit(), cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
  Frame frame{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), 1};
  frame.u[axis] = 1;
  frame.v[(axis + 1) % 3] = cosine;
  frame.v[(axis + 2) % 3] = sine;
  frame.w[(axis + 1) % 3] = -sine;
  frame.w[(axis + 2) % 3] = cosine;
  return frame;
}

Frame lattice_frame(Random& random, const Flat& flat) {
  return workloads::lattice_frame(random, static_cast<std::int64_t>(flat.size), 0);
}

/// Even samples stand where no coordinate is rounded, the others in a rotated plane.
std::optional<Draft> ordinary(Random& random, std::uint64_t index) {
  if (index % 2 != 0) {
    const Frame frame = oblique_frame(random, false);
    return place(random, flat_outline(random), frame);
  }
  const Flat flat = flat_lattice_outline(random);
  return place(random, flat, lattice_frame(random, flat));
}

std::optional<Draft> squeezed(Random& random, double aspect, std::uint64_t index, std::uint64_t attempt) {
  const bool parallel = index % 2 == 0 || attempt >= 2 * kGentleFrom;
  Flat flat = attempt < kGentleFrom ? flat_outline(random) : flat_triangle(random);
  flat.feature = 2 / aspect;
  Frame frame = parallel ? axis_parallel_frame(random) : oblique_frame(random, false);
  frame.v /= aspect;
  auto draft = place(random, flat, frame);
  if (draft && !within_factor_two(aspect_ratio(draft->placed.polygon), aspect)) return std::nullopt;
  return draft;
}

std::optional<Draft> near_parallel(Random& random, double angle, std::uint64_t index, std::uint64_t attempt) {
  const bool gentle = index / 2 % 2 == 0 || attempt >= kGentleFrom;
  const bool crack = index % 2 == 0;
  const Flat flat = crack ? flat_crack(random, angle) : flat_bend(random, angle);
  const Frame frame = gentle && !crack ? axis_parallel_frame(random) : oblique_frame(random, gentle);
  auto draft = place(random, flat, frame);
  if (draft && !within_factor_two(sine_at(draft->placed.polygon, flat.critical[0]), std::sin(angle)))
    return std::nullopt;
  return draft;
}

std::optional<Draft> near_duplicate(Random& random, double distance, std::uint64_t index, std::uint64_t attempt) {
  const bool at_zero = index / 2 % 2 == 0 || attempt >= kGentleFrom;
  const Flat flat = index % 2 == 0 ? flat_cut_corner(random, distance) : flat_pocket(random, distance);
  auto draft = place(random, flat, oblique_frame(random, at_zero));
  if (draft &&
      !within_factor_two(relative_distance(draft->placed.polygon, flat.critical[0], flat.critical[1]), distance))
    return std::nullopt;
  return draft;
}

std::optional<Draft> far_away(Random& random, double distance, std::uint64_t attempt) {
  const Flat flat = attempt < kGentleFrom ? flat_outline(random) : flat_triangle(random);
  auto draft = place(random, flat, oblique_frame(random, false, distance));
  if (draft && !within_factor_two(relative_origin_distance(draft->placed.polygon), distance)) return std::nullopt;
  return draft;
}

std::optional<Draft> scaled(const Draft& draft, int exponent) {
  const int shift = exponent - largest_exponent(draft.placed.polygon);
  const auto scale = [shift](const Vector3d& p) {
    return Vector3d(std::ldexp(p.x(), shift), std::ldexp(p.y(), shift), std::ldexp(p.z(), shift));
  };
  auto placed = moved(draft.placed, scale);
  if (!placed) return std::nullopt;
  for (BallPlacement& placement : placed->placements) {
    placement.radius = std::ldexp(placement.radius, shift);
    if (!placement.center.allFinite() || !std::isfinite(placement.radius)) return std::nullopt;
  }
  return Draft{*std::move(placed), draft.critical};
}

std::optional<Draft> of_exponent(Random& random, int exponent, std::uint64_t index) {
  const auto draft = ordinary(random, index);
  auto there = draft ? scaled(*draft, exponent) : std::nullopt;
  if (there && largest_exponent(there->placed.polygon) != exponent) return std::nullopt;  // a subnormal rounded up
  return there;
}

/// The lattice is stretched along the coordinate axes: exact, and as planar as before.
std::optional<Draft> of_mixed_exponents(Random& random, int spread) {
  const Flat flat = flat_lattice_outline(random);
  const auto draft = place(random, flat, lattice_frame(random, flat));
  if (!draft) return std::nullopt;
  int exponents[] = {-spread / 2, spread / 2, static_cast<int>(random.integer(-spread / 2, spread / 2))};
  std::rotate(exponents, exponents + random.integer(0, 2), exponents + 3);
  auto placed = moved(draft->placed, [&](const Vector3d& p) {
    return Vector3d(std::ldexp(p.x(), exponents[0]), std::ldexp(p.y(), exponents[1]), std::ldexp(p.z(), exponents[2]));
  });
  if (!placed) return std::nullopt;
  return Draft{*std::move(placed), draft->critical};
}

/// One vertex of an exactly planar outline is moved along the axis of the largest component of its normal.
std::optional<Draft> off_plane(Random& random, double ulps) {
  const Flat flat = flat_lattice_outline(random);
  if (flat.points.size() < 4) return std::nullopt;
  const Frame frame = lattice_frame(random, flat);
  auto draft = place(random, flat, frame);
  if (!draft) return std::nullopt;
  const Polygon& polygon = draft->placed.polygon;
  const auto vertex =
      static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  int axis = 0;
  frame.w.cwiseAbs().maxCoeff(&axis);
  const double step = (random.coin() ? ulps : -ulps) * std::ldexp(1.0, largest_exponent(polygon) - 52);

  Loop loop;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) loop.push_back(polygon.vertex(i));
  const double before = loop[vertex][axis];
  loop[vertex][axis] = before + step;
  if (loop[vertex][axis] - before != step) return std::nullopt;  // exact
  auto lifted = legal_polygon(loop);
  if (!lifted || largest_exponent(*lifted) != largest_exponent(polygon)) return std::nullopt;
  draft->placed.polygon = *std::move(lifted);
  draft->critical = {vertex};
  return draft;
}

std::optional<Draft> straight_run(Random& random, double count, bool rounded) {
  Flat flat = flat_straight_run(random, static_cast<std::size_t>(count));
  if (!rounded) return place(random, flat, lattice_frame(random, flat));
  // In an oblique plane a lattice of this size is rounded like any other coordinates.
  return place(random, flat, workloads::rotated_frame(random, static_cast<std::int64_t>(flat.size), 0));
}

/// Even samples exactly on a lattice, the others rounded.
std::optional<Draft> of_many_vertices(Random& random, double count, std::uint64_t index) {
  const Flat flat = flat_star(random, static_cast<std::size_t>(count));
  if (index % 2 == 0) return place(random, flat, lattice_frame(random, flat));
  return place(random, flat, workloads::rotated_frame(random, static_cast<std::int64_t>(flat.size), 0));
}

/// Some of the products that methods form become subnormal, or the coordinates are.
std::optional<Draft> of_subnormal_products(Random& random, std::uint64_t index) {
  const int lowest[] = {-166, -170, -174, -1026};
  return of_exponent(random, lowest[index % 4] + static_cast<int>(random.integer(0, 7)), index / 4);
}

std::optional<Draft> draw(Axis axis, const Level& level, std::uint64_t index, std::uint64_t attempt, Random& random) {
  switch (axis) {
    case Axis::Aspect: return squeezed(random, level.value, index, attempt);
    case Axis::Parallel: return near_parallel(random, level.value, index, attempt);
    case Axis::Duplicate: return near_duplicate(random, level.value, index, attempt);
    case Axis::CollinearExact: return straight_run(random, level.value, false);
    case Axis::CollinearRounded: return straight_run(random, level.value, true);
    case Axis::Origin: return far_away(random, level.value, attempt);
    case Axis::Small:
    case Axis::Large: return of_exponent(random, static_cast<int>(level.value), index);
    case Axis::Mixed: return of_mixed_exponents(random, static_cast<int>(level.value));
    case Axis::OffPlane: return off_plane(random, level.value);
    case Axis::Vertices: return of_many_vertices(random, level.value, index);
    case Axis::ChainInput:
    case Axis::ChainMotion:
    case Axis::PoseInput:
    case Axis::PoseMotion:
    case Axis::Rounding: return ordinary(random, index);
    case Axis::Flush: return of_subnormal_products(random, index);
  }
  return std::nullopt;
}

bool moves(Axis axis) {
  return axis == Axis::ChainInput || axis == Axis::ChainMotion || axis == Axis::PoseInput || axis == Axis::PoseMotion;
}

/// Returns nothing if rounding broke the polygon on the way.
std::optional<Placed> after_motion(Axis axis, std::uint64_t steps, const Placed& before, Random& random) {
  const Eigen::Matrix3d matrix = small_rotation(random);
  if (axis == Axis::PoseInput || axis == Axis::PoseMotion) {
    const Eigen::Matrix3d pose = pose_in_steps(matrix, steps);
    return moved(before, [&](const Vector3d& p) { return posed(pose, p); });
  }
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < before.polygon.vertex_count(); ++i) points.push_back(before.polygon.vertex(i));
  for (const BallPlacement& placement : before.placements) points.push_back(placement.center);
  const auto after = rotated_in_steps(points, matrix, steps);
  std::size_t next = 0;  // `moved` goes through them in the same order
  return moved(before, [&](const Vector3d&) { return after[next++]; });
}

FloatingPointMode mode_of(Axis axis, std::size_t level) {
  using Mode = FloatingPointMode;
  constexpr int kDirections[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  constexpr unsigned kFlushes[] = {0, Mode::kGivenAsZero, Mode::kTakenAsZero, Mode::kGivenAsZero | Mode::kTakenAsZero};
  if (axis == Axis::Rounding) return {kDirections[level], 0};
  if (axis == Axis::Flush) return {FE_TONEAREST, kFlushes[level]};
  return {};
}

}  // namespace

std::optional<Scene> draw_scene(Axis axis, std::size_t level, std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t drawn_level = axis == Axis::Rounding || axis == Axis::Flush ? 0 : level;
  const std::uint64_t stream = ((static_cast<std::uint64_t>(axis) + 1) << 40) + (drawn_level << 32);
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    Random random(seed, index, stream + attempt);
    auto draft = draw(axis, levels(axis)[level], index, attempt, random);
    if (!draft) continue;
    Scene scene{fmt::format("stability-{}-{}-s{}-i{}", to_string(axis), levels(axis)[level].name, seed, index),
                std::move(draft->placed), std::nullopt, mode_of(axis, level), std::move(draft->critical)};
    if (moves(axis)) {
      auto after = after_motion(axis, static_cast<std::uint64_t>(levels(axis)[level].value), scene.asked, random);
      if (!after) continue;
      std::swap(scene.asked, *after);
      if (against_motion(axis)) scene.meant = *std::move(after);
    }
    return scene;
  }
  return std::nullopt;
}

}  // namespace touchstone::stability
