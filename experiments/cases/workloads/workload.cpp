// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/workload.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"

namespace touchstone::workloads {
namespace {

void check(const Workload& workload) {
  require_vertices({workload.family}, workload.vertices);
  if (workload.holes > kMostHoles) throw std::invalid_argument("more than 1000 holes");
  if (!(workload.koch_dimension > 1 && workload.koch_dimension < 2))
    throw std::invalid_argument("the dimension of a Koch curve lies between 1 and 2");
  if (!(workload.origin_distance >= 0 && workload.origin_distance <= 0x1p53))
    throw std::invalid_argument("the distance from the origin lies between 0 and 2^53 sizes");
}

std::string shortest(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string id(const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  std::string text;
  text.append(to_string(workload.family)).append("-").append(to_string(workload.placement)).append("-");
  text.append(to_string(workload.ball));
  text += "-n" + std::to_string(workload.vertices) + "-h" + std::to_string(workload.holes) + "-k" +
          std::to_string(workload.doubles);
  if (workload.way != Way::Static) text.append("-").append(to_string(workload.way));
  const Workload usual;
  if (workload.koch_dimension != usual.koch_dimension) text += "-d" + shortest(workload.koch_dimension);
  if (workload.origin_distance != usual.origin_distance) text += "-o" + shortest(workload.origin_distance);
  return text + "-s" + std::to_string(seed) + "-i" + std::to_string(index);
}

std::vector<std::string> tags(const Workload& workload) {
  std::vector<std::string> words{std::string(to_string(workload.family)), std::string(to_string(workload.placement)),
                                 std::string(to_string(workload.ball))};
  if (workload.ball == BallPlace::LatticeTangent && workload.doubles == 0) words.emplace_back("tangent");
  if (workload.way != Way::Static) words.insert(words.end(), {"moving", std::string(to_string(workload.way))});
  return words;
}

using Eigen::Vector3d;

constexpr std::uint64_t kStream = std::uint64_t{1} << 40;  // beyond those of the parts of a sample

double size_of(const PlacedOutline& placed) {
  return static_cast<double>(bounding_box(placed.outline.outer).size()) * placed.frame.unit;
}

/// Returns the direction, scaled by a power of two to about the length.
Vector3d of_length(const Vector3d& direction, double length) {
  const double largest = direction.cwiseAbs().maxCoeff();
  if (largest == 0) return direction;
  return std::ldexp(1.0, std::ilogb(length) - std::ilogb(largest)) * direction;
}

/// Returns a direction of the lattice.
Vector3d random_direction(Random& random, const Frame& frame) {
  const auto part = [&random] { return static_cast<double>(random.integer(-4, 4)); };
  const double x = part(), y = part(), h = part();
  return x * frame.u + y * frame.v + h * frame.w;
}

/// Returns a direction perpendicular to the one from the closest point to the centre.
Vector3d across(Random& random, const Ball& ball, const PlacedOutline& placed) {
  const Vector3d away = ball.center - exact::answer(ball, placed.polygon).point;
  const Vector3d axes[] = {placed.frame.u, placed.frame.v, placed.frame.w, random_direction(random, placed.frame)};
  return away.cross(axes[random.integer(0, 3)]);
}

/// Returns the direction of a random edge.
Vector3d along(Random& random, const Polygon& polygon) {
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  const Vector3d edge = polygon.vertex(polygon.next(i)) - polygon.vertex(i);
  return random.coin() ? edge : Vector3d(-edge);
}

/// Returns the ball with its centre in the plane, and the radius that just fits there, moved by the workload's doubles.
Ball in_plane(const Ball& ball, const PlacedOutline& placed, int doubles) {
  const Frame& frame = placed.frame;
  const double height = std::round((ball.center - frame.origin).dot(frame.w) / (frame.unit * frame.unit));
  const Vector3d center = ball.center - height * frame.w;
  const double fit = exact::answer({center, 0}, placed.polygon).distance;
  return {center, fit > 0 ? std::max(0.0, move_by_doubles(fit, doubles)) : ball.radius};
}

Motion through(const Ball& ball, const Vector3d& half) {
  return {{ball.center - half, ball.radius}, ball.center + half};
}

/// Draws the motion of sample `index`, given its ball at the place `workload.ball`, on the way `workload.way`, which is
/// not Static.
///
/// A way has about the length of the outline. In a lattice frame with a tangent ball every number is exact, so that the
/// ball grazes, slides, starts or ends in exact contact. Otherwise a threshold of the radius is one of the way, too: a
/// ball that passes at distance d, across except for an angle of e, comes as near as d cos(e).
Motion draw_motion(const Ball& ball, const PlacedOutline& placed, const Workload& workload, std::uint64_t seed,
                   std::uint64_t index) {
  Random random(seed, index, kStream);
  const double length = std::ldexp(size_of(placed), static_cast<int>(random.integer(-3, 0)));
  const auto anywhere = [&] { return of_length(random_direction(random, placed.frame), length); };
  switch (workload.way) {
    case Way::Static:
    case Way::Rest: break;
    case Way::Anywhere: {
      Workload other = workload;
      other.ball = BallPlace::Anywhere;
      return {ball, draw_ball(placed, other, ~seed, index).center};
    }
    case Way::Start: return {ball, ball.center + anywhere()};
    case Way::End: return {{ball.center + anywhere(), ball.radius}, ball.center};
    case Way::Across: return through(ball, of_length(across(random, ball, placed), length));
    case Way::Along: return through(ball, of_length(along(random, placed.polygon), length));
    case Way::Through: return through(in_plane(ball, placed, workload.doubles), of_length(placed.frame.w, length));
  }
  return {ball, ball.center};
}

}  // namespace

std::variant<Ball, Motion> Sample::question() const {
  if (to) return Motion{ball, *to};
  return ball;
}

Sample sample(const Workload& workload, std::uint64_t seed, std::uint64_t index) {
  check(workload);
  PlacedOutline placed = draw_placed_outline(workload, seed, index);
  const Ball ball = draw_ball(placed, workload, seed, index);
  if (workload.way == Way::Static) return {id(workload, seed, index), ball, std::move(placed.polygon), tags(workload)};
  const Motion motion = draw_motion(ball, placed, workload, seed, index);
  return {id(workload, seed, index), motion.ball, std::move(placed.polygon), tags(workload), motion.to};
}

std::string_view to_string(Family family) {
  switch (family) {
    case Family::Triangle: return "triangle";
    case Family::Convex: return "convex";
    case Family::Star: return "star";
    case Family::Comb: return "comb";
    case Family::Spiral: return "spiral";
    case Family::RandomSimple: return "random-simple";
    case Family::Koch: return "koch";
    case Family::U: return "u";
    case Family::L: return "l";
    case Family::E: return "e";
  }
  return "";
}

std::string_view to_string(Placement placement) {
  switch (placement) {
    case Placement::LatticeFrame: return "lattice-frame";
    case Placement::Planar: return "planar";
    case Placement::Rotated: break;
  }
  return "rotated";
}

const std::vector<Placement>& all_placements() {
  static const std::vector<Placement> placements{Placement::LatticeFrame, Placement::Planar, Placement::Rotated};
  return placements;
}

std::string_view to_string(BallPlace place) {
  switch (place) {
    case BallPlace::Anywhere: return "anywhere";
    case BallPlace::NearFace: return "near-face";
    case BallPlace::NearEdge: return "near-edge";
    case BallPlace::NearVertex: return "near-vertex";
    case BallPlace::FootNearEdge: return "foot-near-edge";
    case BallPlace::FootNearVertex: return "foot-near-vertex";
    case BallPlace::LatticeTangent: return "lattice-tangent";
  }
  return "";
}

std::string_view to_string(Way way) {
  switch (way) {
    case Way::Static: return "static";
    case Way::Rest: return "rest";
    case Way::Anywhere: return "anywhere";
    case Way::Start: return "start";
    case Way::End: return "end";
    case Way::Across: return "across";
    case Way::Along: return "along";
    case Way::Through: return "through";
  }
  return "";
}

const std::vector<Family>& all_families() {
  static const std::vector<Family> families{
      Family::Triangle,     Family::Convex, Family::Star, Family::Comb, Family::Spiral,
      Family::RandomSimple, Family::Koch,   Family::U,    Family::L,    Family::E};
  return families;
}

std::vector<Family> find_families(const std::vector<std::string>& names) {
  std::string known;
  for (const Family family : all_families()) known.append(to_string(family)).append(", ");
  for (const std::string& name : names)
    if (name != "all" && std::ranges::none_of(all_families(), [&](Family family) { return to_string(family) == name; }))
      throw std::invalid_argument("--families: there is no family \"" + name + "\"; there are " + known + "or all");
  std::vector<Family> found;
  for (const Family family : all_families())
    if (std::ranges::any_of(names, [&](const std::string& name) { return name == "all" || name == to_string(family); }))
      found.push_back(family);
  return found;
}

void require_vertices(const std::vector<Family>& families, std::size_t vertices) {
  for (const Family family : families)
    if (const std::size_t most = family == Family::RandomSimple ? kMostRandomSimple : kMostVertices; vertices > most)
      throw std::invalid_argument("--vertices " + std::to_string(vertices) + ": outlines of the family " +
                                  std::string(to_string(family)) + " have at most " + std::to_string(most));
}

std::string selected_names(const std::vector<std::string>& names) {
  std::string selected;
  for (const Family family : find_families(names))
    selected.append(selected.empty() ? "" : ",").append(to_string(family));
  return selected;
}

const std::vector<BallPlace>& all_ball_places() {
  static const std::vector<BallPlace> places{
      BallPlace::Anywhere,     BallPlace::NearFace,       BallPlace::NearEdge,      BallPlace::NearVertex,
      BallPlace::FootNearEdge, BallPlace::FootNearVertex, BallPlace::LatticeTangent};
  return places;
}

const std::vector<Way>& all_ways() {
  static const std::vector<Way> ways{Way::Static, Way::Rest,   Way::Anywhere, Way::Start,
                                     Way::End,    Way::Across, Way::Along,    Way::Through};
  return ways;
}

}  // namespace touchstone::workloads
