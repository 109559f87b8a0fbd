// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/workload.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "experiments/cases/workloads/balls.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ways.h"

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
  return placement == Placement::LatticeFrame ? "lattice-frame" : "rotated";
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
