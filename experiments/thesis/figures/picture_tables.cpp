// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/picture_tables.h"

#include <fmt/core.h>

#include <array>
#include <memory>
#include <utility>

#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/figures/false_areas.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;
using program::path;

struct BranchRow {
  const Flowchart* flowchart;
  std::string_view method;
  End end, exact_end;
  std::uint64_t balls;
};

const program::Table<BranchRow>& branches_csv() {
  static const program::Table<BranchRow> table(
      "branches.csv", "an outline, radius, method, end of the method and exact end",
      {{"outline", "the outline", [](const BranchRow& row) { return row.flowchart->outline->name; }},
       {"radius_share", "the radius, relative to the outline's extent",
        path(&BranchRow::flowchart, &Flowchart::radius)},
       {"method", "the method", &BranchRow::method},
       {"end", "where the flowchart of the method ends", &BranchRow::end},
       {"exact_end", "where it ends exactly", &BranchRow::exact_end},
       {"balls", "balls", &BranchRow::balls}});
  return table;
}

const program::Table<MapPoint>& map_csv() {
  constexpr const char* kFormat = "{:.4f}";
  static const program::Table<MapPoint> table(
      "map.csv", "a point of the plane around the gripper",
      {{"x_mm", "the point", &MapPoint::x, kFormat},
       {"y_mm", "the point", &MapPoint::y, kFormat},
       {"sum_deg", "the sum of the angles at which the edges are seen, without signs", &MapPoint::sum, kFormat},
       {"inside", "whether it is inside", [](const MapPoint& point) { return program::yes_or_no(point.inside); }},
       {"called", "whether the thesis's method calls it inside",
        [](const MapPoint& point) { return program::yes_or_no(point.called); }}});
  return table;
}

struct ViewRow {
  std::string_view name;
  Eigen::Vector3d at;
  std::size_t edge;
  double angle;
};

const program::Table<ViewRow>& views_csv() {
  static const program::Table<ViewRow> table("views.csv", "a point and an edge of the gripper",
                                             {{"point", "in the palm or in the gap", &ViewRow::name},
                                              {"x_mm", "the point", [](const ViewRow& row) { return row.at.x(); }},
                                              {"y_mm", "the point", [](const ViewRow& row) { return row.at.y(); }},
                                              {"edge", "the edge", &ViewRow::edge},
                                              {"angle_deg", "the angle at which it is seen", &ViewRow::angle}});
  return table;
}

const program::Table<FalseArea>& areas_csv() {
  const auto limit = [](double statistics::Limits::*side) {
    return [side](const FalseArea& area) { return area.limits().*side; };
  };
  static const program::Table<FalseArea> table(
      "areas.csv", "an outline: the points that the thesis's sum of angles calls inside",
      {{"outline", "the outline", [](const FalseArea& area) { return area.outline->name; }},
       {"points", "random points", &FalseArea::points},
       {"right", "inside, and called inside", &FalseArea::right},
       {"wrong", "outside, but called inside", &FalseArea::wrong},
       {"missed", "inside, but not called so", &FalseArea::missed},
       {"share", "the outside area that is called inside, relative to the outline's", &FalseArea::share},
       {"lower", "its lower limit", limit(&statistics::Limits::lower)},
       {"upper", "its upper limit", limit(&statistics::Limits::upper)},
       {"hull", "the outside area in the convex hull, relative to the outline's",
        [](const FalseArea& area) { return convex_cover(*area.outline).hull; }, "{:.6g}"},
       {"parts", "convex parts that cover it, with no area outside",
        [](const FalseArea& area) { return convex_cover(*area.outline).parts; }}});
  return table;
}

struct ReachRow {
  std::string_view outline;
  const FactorReach* reach;
};

const program::Table<ReachRow>& reach_csv() {
  static const program::Table<ReachRow> table(
      "reach.csv", "an outline, edge and match factor",
      {{"outline", "the outline", &ReachRow::outline},
       {"edge", "the edge", path(&ReachRow::reach, &FactorReach::edge)},
       {"length", "of the edge", path(&ReachRow::reach, &FactorReach::length)},
       {"factor", "the match factor", path(&ReachRow::reach, &FactorReach::factor)},
       {"reach", "how far outside the edge points are called inside", path(&ReachRow::reach, &FactorReach::reach)},
       {"derived", "the same by a formula for convex outlines",
        [](const ReachRow& row) { return derived_factor_reach(row.reach->length, row.reach->factor); }}});
  return table;
}

struct TouchingRow {
  std::string_view touched;
  Touching counts;
};

const program::Table<TouchingRow>& touching_csv() {
  static const program::Table<TouchingRow> table(
      "touching.csv", "a feature that balls touch exactly",
      {{"touched", "the feature", &TouchingRow::touched},
       {"balls", "balls", path(&TouchingRow::counts, &Touching::samples)},
       {"missed", "missed by the original method", path(&TouchingRow::counts, &Touching::missed)},
       {"missed_signed", "missed with signed angles", path(&TouchingRow::counts, &Touching::missed_signed)},
       {"missed_closed", "missed if touching counts", path(&TouchingRow::counts, &Touching::missed_closed)}});
  return table;
}

const program::Table<FarAway>& far_csv() {
  const auto wrong = [](std::size_t method) { return [method](const FarAway& away) { return away.wrong[method]; }; };
  static const program::Table<FarAway> table("far.csv", "a distance from the origin",
                                             {{"offset_mm", "the distance", &FarAway::offset},
                                              {"balls", "balls", &FarAway::samples},
                                              {"wrong_signed", "wrong answers with signed angles", wrong(0)},
                                              {"wrong_signed_float", "the same in floats", wrong(1)},
                                              {"wrong_fast", "wrong answers of fast", wrong(2)}});
  return table;
}

struct PlaceRow {
  std::string_view scan;
  const cell::Tried* place;
};

const program::Table<PlaceRow>& places_csv() {
  static const program::Table<PlaceRow> table(
      "places.csv", "a place of the storage",
      {{"scan", "what is varied", &PlaceRow::scan},
       {"angle_deg", "of the storage", path(&PlaceRow::place, &cell::Tried::angle)},
       {"radius_mm", "from the robot's axis", path(&PlaceRow::place, &cell::Tried::radius)},
       {"height_mm", "of the storage", path(&PlaceRow::place, &cell::Tried::height)},
       {"outcome", "how the process ends", [](const PlaceRow& row) { return outcome_of(*row.place); }},
       {"failure", "what fails", path(&PlaceRow::place, &cell::Tried::reason)}});
  return table;
}

struct MoveRow {
  std::size_t number, move;
  const cell::Move* its;
};

const program::Table<MoveRow>& moves_csv() {
  static const program::Table<MoveRow> table(
      "moves.csv", "a move of one joint",
      {{"case", "the case study", &MoveRow::number},
       {"move", "its number", &MoveRow::move},
       {"joint", "the joint", [](const MoveRow& row) { return name_of(row.its->joint); }},
       {"phase", "the part of the process", path(&MoveRow::its, &cell::Move::phase)},
       {"until", "what ends the move", path(&MoveRow::its, &cell::Move::until)},
       {"degrees", "whole degrees", path(&MoveRow::its, &cell::Move::degrees)},
       {"exact_deg", "the angle before it is rounded to degrees", path(&MoveRow::its, &cell::Move::exact)},
       {"margin_deg", "the change of exact_deg that changes degrees", path(&MoveRow::its, &cell::Move::margin)}});
  return table;
}

struct JointRow {
  std::string moment;
  double height;
  std::string_view point;
  Eigen::Vector3d at;
};

const program::Table<JointRow>& sides_csv() {
  constexpr const char* kFormat = "{:.6f}";
  static const program::Table<JointRow> table(
      "sides.csv", "a moment, and a point of the arm in the plane of the arm",
      {{"moment", "the moment", &JointRow::moment},
       {"height_mm", "of the storage", &JointRow::height},
       {"point", "a joint, the flange or the sphere", &JointRow::point},
       {"out_mm", "its distance from the robot's axis", [](const JointRow& row) { return row.at.x(); }, kFormat},
       {"up_mm", "its height", [](const JointRow& row) { return row.at.z(); }, kFormat}});
  return table;
}

struct StopRow {
  std::size_t number, stop;
  std::string_view when;
  Eigen::Vector3d at;
};

const program::Table<StopRow>& stops_csv() {
  static const program::Table<StopRow> table(
      "stops.csv", "the sphere before, at first contact, or at a stop",
      {{"case", "the case study", &StopRow::number},
       {"stop", "the number of the stop", &StopRow::stop},
       {"when", "a step before, at first contact, or at the stop", &StopRow::when},
       {"x_mm", "the sphere's centre", [](const StopRow& row) { return row.at.x(); }},
       {"y_mm", "the sphere's centre", [](const StopRow& row) { return row.at.y(); }},
       {"z_mm", "the sphere's centre", [](const StopRow& row) { return row.at.z(); }}});
  return table;
}

std::vector<BranchRow> branch_rows(const Study& study) {
  std::vector<BranchRow> rows;
  for (const Flowchart& flowchart : study.flowcharts)
    for (std::size_t m = 0; m < kMethods.size(); ++m)
      for (const End end : kEnds)
        for (const End exact : kEnds)
          if (const auto balls =
                  flowchart.methods[m].counts[static_cast<std::size_t>(end)][static_cast<std::size_t>(exact)])
            rows.push_back({&flowchart, kMethods[m], end, exact, balls});
  return rows;
}

std::vector<ViewRow> view_rows(const Study& study) {
  std::vector<ViewRow> rows;
  const GripperPoints points = gripper_points(study.gripper());
  for (const auto& [name, at] : {std::pair("palm", points.palm), std::pair("gap", points.gap)}) {
    const AngleSum sum = angle_sum(study.gripper(), at);
    for (std::size_t i = 0; i < sum.angles.size(); ++i) rows.push_back({name, at, i, sum.angles[i]});
  }
  return rows;
}

std::vector<ReachRow> reach_rows(const Study& study) {
  std::vector<ReachRow> rows;
  for (const FactorReach& reach : study.square_reach) rows.push_back({"square", &reach});
  for (const FactorReach& reach : study.gripper_reach) rows.push_back({"gripper", &reach});
  return rows;
}

std::vector<TouchingRow> touching_rows(const Study& study) {
  const auto& [face, edge, corner] = study.touching;
  return {{"face", face}, {"edge", edge}, {"corner", corner}};
}

std::vector<PlaceRow> place_rows(const Study& study) {
  std::vector<PlaceRow> rows;
  const auto add = [&](const char* scan, const std::vector<cell::Tried>& places) {
    for (const cell::Tried& place : places) rows.push_back({scan, &place});
  };
  add("area", study.area);
  add("area, sphere alone", study.area_of_sphere);
  add("radii", study.radii);
  add("heights 1", study.heights[0]);
  add("heights 2", study.heights[1]);
  add("heights 1, sphere alone", study.heights_of_sphere[0]);
  add("heights 2, sphere alone", study.heights_of_sphere[1]);
  return rows;
}

std::vector<MoveRow> move_rows(const Study& study) {
  std::vector<MoveRow> rows;
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const auto& moves = study.cases[i].process.moves;
    for (std::size_t m = 0; m < moves.size(); ++m) rows.push_back({i + 1, m + 1, &moves[m]});
  }
  return rows;
}

/// Adds the joints and the sphere in the plane of the arm, whatever the base.
void add_joints(const cell::Arm& arm, const std::string& moment, double height, const Angles& commanded,
                std::vector<JointRow>& rows) {
  Angles in_plane = commanded;
  in_plane[kBase] = arm.home[kBase];
  const auto frames = arm.chain.frames(in_plane);
  rows.push_back({moment, height, "shoulder", frames[kShoulder].translation});
  rows.push_back({moment, height, "elbow", frames[kElbow].translation});
  rows.push_back({moment, height, "wrist", frames[kWristPitch].translation});
  rows.push_back({moment, height, "flange", frames.back().translation});
  rows.push_back({moment, height, "sphere", arm.sphere_at(in_plane).center});
}

std::vector<JointRow> side_rows(const Study& study) {
  std::vector<JointRow> rows;
  const cell::Arm arm = cell::arm_of(study.cell);
  for (const CaseStudy& its : study.cases)
    for (const Moment& moment : its.moments)
      add_joints(arm, moment.name, its.cell.storage.height, its.process.stops[moment.stop].commanded, rows);
  for (std::size_t i = 0; i < study.heights.size(); ++i) {
    const auto ends = completing(study.heights[i]);
    if (!ends) continue;
    for (const auto& [name, place] : {std::pair("lowest", ends->first), std::pair("highest", ends->last)}) {
      cell::Cell cell = study.cases[i].cell;
      cell.storage.height = study.heights[i][place].height;
      const std::shared_ptr<const std::vector<cell::Covered>> uncovered =
          std::make_shared<const std::vector<cell::Covered>>();
      const cell::Process process = cell::simulate(cell::Workcell(cell, study.parts, uncovered),
                                                   {.last = cell::Phase::ToStorage, .sphere_alone = true});
      if (!process.cause)
        add_joints(arm, fmt::format("case {}, {}", i + 1, name), cell.storage.height, process.stops.back().commanded,
                   rows);
    }
  }
  return rows;
}

std::vector<StopRow> stop_rows(const Study& study) {
  std::vector<StopRow> rows;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
    for (std::size_t s = 0; s < study.cases[i].stops.size(); ++s) {
      const Stop& stop = study.cases[i].stops[s];
      rows.push_back({i + 1, s + 1, "before", stop.center_before});
      rows.push_back({i + 1, s + 1, "first", stop.center_first});
      rows.push_back({i + 1, s + 1, "stop", stop.center_at});
    }
  return rows;
}

}  // namespace

void write_picture_tables(const std::filesystem::path& folder, const Study& study) {
  branches_csv().write(folder, branch_rows(study));
  map_csv().write(folder, study.map.points);
  views_csv().write(folder, view_rows(study));
  areas_csv().write(folder, study.areas);
  reach_csv().write(folder, reach_rows(study));
  touching_csv().write(folder, touching_rows(study));
  far_csv().write(folder, study.far_away);
  write_missed(folder, study.missed);
  places_csv().write(folder, place_rows(study));
  moves_csv().write(folder, move_rows(study));
  stops_csv().write(folder, stop_rows(study));
  sides_csv().write(folder, side_rows(study));
}

std::vector<program::TableDescription> picture_tables() {
  std::vector<program::TableDescription> all{
      branches_csv().description(), map_csv().description(),      views_csv().description(), areas_csv().description(),
      reach_csv().description(),    touching_csv().description(), far_csv().description(),   places_csv().description(),
      moves_csv().description(),    stops_csv().description(),    sides_csv().description()};
  for (auto& table : missed_tables()) all.push_back(std::move(table));
  return all;
}

}  // namespace touchstone::figures
