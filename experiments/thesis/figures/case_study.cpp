// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/case_study.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"
#include "experiments/thesis/cell/simulation/method_comparison.h"
#include "robust/filtered/filtered.h"

namespace touchstone::figures {
namespace {

/// The face that is nearest to a ball's centre.
std::size_t nearest(const std::vector<Polygon>& faces, const Ball& ball) {
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t i) {
    return filtered::answer(ball, filtered::PreparedPolygon(faces[i])).distance;
  };
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  return nearest;
}

bool by_thesis(const Ball& ball, const std::vector<Polygon>& faces) {
  return std::ranges::any_of(faces, [&](const Polygon& face) {
    return methods::find_method("thesis")->prepare(face)->ask(ball, cases::QueryKind::Contact).contact.value();
  });
}

/// In words, where a face of the material in a slot is, by the direction of its normal in the station's frame.
std::string words_of(const Polygon& face, const Pose& station) {
  const Eigen::Vector3d out = station.rotation.transpose() * cell::doubled_area(face);
  Eigen::Index axis = 0;
  out.cwiseAbs().maxCoeff(&axis);
  if (axis == 2) return out.z() > 0 ? "upper face" : "underside";
  if (axis == 0) return out.x() > 0 ? "side away from the base" : "side towards the base";
  return out.y() > 0 ? "counter-clockwise side" : "clockwise side";
}

/// The sphere of an arm whose joint has turned by `degrees` of a move, as the process has it at the stop.
Ball sphere_at(const cell::Workcell& workcell, const cell::Stop& stop, const cell::Move& move, double degrees) {
  kinematics::Angles angles = stop.commanded;
  angles[move.joint] += degrees - move.degrees;
  return workcell.arm().sphere_at(angles);
}

}  // namespace

std::size_t CaseStudy::moves_to_machine() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      process.moves, [](const cell::Move& move) { return move.phase <= cell::Phase::ToMachine; }));
}

CaseStudy study_case(const cell::Cell& cell, const std::vector<cell::ModelPart>& parts,
                     const std::shared_ptr<const std::vector<cell::Covered>>& covered, std::size_t number) {
  using cell::StationSlot;
  CaseStudy study{cell, {}, {}, {}, {}, {}};
  const cell::Workcell workcell(cell, parts, covered);
  study.copy = workcell.at(StationSlot::Machine).copy->pose;
  study.process = cell::simulate(workcell);
  study.snapshots = cell::browser::snapshots_of(workcell, study.process);
  const auto& stops = study.process.stops;
  const auto& moves = study.process.moves;
  if (!stops.empty()) study.moments.push_back({fmt::format("case {}, home", number + 1), 0});
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const bool last = i + 1 == stops.size() || stops[i + 1].move != stops[i].move;
    if (!last || stops[i].move >= moves.size()) continue;
    study.moments.push_back({fmt::format("case {}, move {}", number + 1, stops[i].move + 1), i});
    const cell::Move& move = moves[stops[i].move];
    if (move.until != cell::Until::Contact || move.phase > cell::Phase::ToMachine) continue;
    const bool at_machine = move.phase == cell::Phase::ToMachine;
    const cell::Workplace& place = workcell.at(at_machine ? StationSlot::Machine : StationSlot::Storage);
    const std::vector<Polygon> faces = cell::polygons_of((at_machine ? place.copy : place.material)->faces);
    const double step = move.degrees < 0 ? -cell.step : cell.step;
    const Ball at = stops[i].sphere, before = sphere_at(workcell, stops[i], move, move.degrees - step);
    const std::size_t face = nearest(faces, at);
    const filtered::PreparedPolygon prepared(faces[face]);
    study.stops.push_back({stops[i].move, words_of(faces[face], place.material->pose), filtered::answer(at, prepared),
                           filtered::answer(before, prepared), at.center,
                           sphere_at(workcell, stops[i], move, move.exact).center, before.center, by_thesis(at, faces),
                           by_thesis(before, faces)});
  }
  std::vector<const cases::Method*> methods;
  for (const std::string_view name : kMethods) methods.push_back(methods::find_method(name));
  const cell::MethodComparison comparison = cell::compare_methods(workcell, study.process, methods, false);
  study.asked = comparison.met;
  for (std::size_t m = 0; m < kMethods.size(); ++m)
    study.wrong[m] = comparison.scores[m].wrong_hits + comparison.scores[m].wrong_misses;
  return study;
}

}  // namespace touchstone::figures
