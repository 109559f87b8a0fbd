// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/harness/write_file.h"
#include "experiments/thesis/drawn_cell.h"

namespace touchstone::thesis_figures {
namespace {

using namespace kinematics;
using harness::csv_field;
using nlohmann::ordered_json;

const char* yes_or_no(bool yes) { return yes ? "yes" : "no"; }

std::string entries_text(const std::vector<Entry>& entries) {
  std::string text = "id,caption,page,status,text,picture,shows\n";
  for (const Entry& entry : entries)
    text += fmt::format("{},{},{},{},{},{},{}\n", entry.caption->id, csv_field(std::string(entry.caption->text)),
                        entry.caption->page == 0 ? "" : std::to_string(entry.caption->page), entry.status_words(),
                        csv_field(entry.text), entry.shows.empty() ? "" : entry.file_stem(), csv_field(entry.shows));
  return text;
}

std::string numbers_text(const std::vector<Entry>& entries) {
  std::string text = "id,what,unit,ours,lower,upper,samples,stated,tolerance,label,agrees,rests_on\n";
  for (const Entry& entry : entries)
    for (const Number& n : entry.numbers) {
      text += fmt::format("{},{},{},{},", entry.caption->id, csv_field(n.what), n.unit, n.ours);
      text += n.limits ? fmt::format("{},{},{},", n.limits->lower, n.limits->upper, n.samples) : ",,,";
      text += n.stated ? fmt::format("{},{},{},{}", *n.stated, n.tolerance, static_cast<char>(*n.label),
                                     yes_or_no(*n.agrees()))
                       : ",,,";
      text += fmt::format(",{}\n", n.chosen ? "C" : "");
    }
  return text;
}

std::string branches_text(const Study& study) {
  std::string text = "outline,radius_share,method,end,exact_end,balls\n";
  for (const Flowchart& flowchart : study.flowcharts)
    for (std::size_t m = 0; m < kMethods.size(); ++m)
      for (const End end : kEnds)
        for (const End exact : kEnds)
          if (const auto balls =
                  flowchart.methods[m].counts[static_cast<std::size_t>(end)][static_cast<std::size_t>(exact)])
            text += fmt::format("{},{},{},{},{},{}\n", flowchart.outline->name, flowchart.radius, kMethods[m],
                                word(end), word(exact), balls);
  return text;
}

std::string map_text(const stability::AngleMap& map) {
  std::string text = "x_mm,y_mm,sum_deg,inside,called\n";
  for (const stability::MapPoint& p : map.points)
    text += fmt::format("{:.4f},{:.4f},{:.4f},{},{}\n", p.x, p.y, p.sum, yes_or_no(p.inside), yes_or_no(p.called));
  return text;
}

std::string views_text(const Study& study) {
  std::string text = "point,x_mm,y_mm,edge,angle_deg\n";
  const stability::GripperPoints points = stability::gripper_points(study.gripper());
  for (const auto& [name, at] : {std::pair("palm", points.palm), std::pair("gap", points.gap)}) {
    const stability::AngleSum sum = stability::angle_sum(study.gripper(), at);
    for (std::size_t i = 0; i < sum.angles.size(); ++i)
      text += fmt::format("{},{},{},{},{}\n", name, at.x(), at.y(), i, sum.angles[i]);
  }
  return text;
}

std::string areas_text(const Study& study) {
  std::string text = "outline,points,right,wrong,missed,share,lower,upper\n";
  for (const stability::FalseArea& area : study.areas) {
    const auto limits = area.limits();
    text += fmt::format("{},{},{},{},{},{},{},{}\n", area.outline->name, area.points, area.right, area.wrong,
                        area.missed, area.share(), limits.lower, limits.upper);
  }
  return text;
}

std::string reach_text(const Study& study) {
  std::string text = "outline,edge,length,factor,reach,derived\n";
  for (const auto& [name, all] : {std::pair("square", &study.square_reach), std::pair("gripper", &study.gripper_reach)})
    for (const FactorReach& r : *all)
      text += fmt::format("{},{},{},{},{},{}\n", name, r.edge, r.length, r.factor, r.reach,
                          derived_factor_reach(r.length, r.factor));
  return text;
}

std::string touching_text(const Study& study) {
  std::string text = "touched,balls,missed,missed_signed,missed_closed\n";
  constexpr std::array<const char*, 3> kNames{"face", "edge", "corner"};
  for (std::size_t i = 0; i < study.touching.size(); ++i)
    text += fmt::format("{},{},{},{},{}\n", kNames[i], study.touching[i].samples, study.touching[i].missed,
                        study.touching[i].missed_signed, study.touching[i].missed_closed);
  return text;
}

std::string far_text(const Study& study) {
  std::string text = "offset_mm,balls,wrong_signed,wrong_signed_float,wrong_fast\n";
  for (const FarAway& away : study.far_away)
    text += fmt::format("{},{},{},{},{}\n", away.offset, away.samples, away.wrong[0], away.wrong[1], away.wrong[2]);
  return text;
}

std::string places_text(const Study& study) {
  std::string text = "scan,angle_deg,radius_mm,height_mm,outcome,failure\n";
  const auto add = [&](const char* scan, const std::vector<Place>& places) {
    for (const Place& p : places)
      text +=
          fmt::format("{},{},{},{},{},{}\n", scan, p.angle, p.radius, p.height, word(p.outcome), csv_field(p.failure));
  };
  add("area", study.area);
  add("radii", study.radii);
  add("heights 1", study.heights[0]);
  add("heights 2", study.heights[1]);
  return text;
}

std::string_view name_of(AristoJoint joint) {
  constexpr std::array<std::string_view, 3> names{"base", "shoulder", "elbow"};
  return names.at(joint);
}

std::string moves_text(const Study& study) {
  std::string text = "case,move,joint,until,degrees,exact_deg,margin_deg\n";
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const auto& moves = study.cases[i].rehearsal.moves;
    for (std::size_t m = 0; m < moves.size(); ++m)
      text += fmt::format("{},{},{},{},{},{},{}\n", i + 1, m + 1, name_of(moves[m].joint), word(moves[m].until),
                          moves[m].degrees, moves[m].exact, moves[m].margin);
  }
  return text;
}

/// The joints and the sphere in the plane of the arm, whatever the base.
std::string points_text(const Layout& layout, const std::string& moment, double height, const Angles& commanded) {
  Angles in_plane = commanded;
  in_plane[kBase] = 0;
  const Chain chain = aristo(layout.coupling);
  const auto frames = chain.frames(in_plane);
  std::string text;
  const auto add = [&](const char* name, const Eigen::Vector3d& at) {
    text += fmt::format("{},{},{},{:.6f},{:.6f}\n", csv_field(moment), height, name, at.x(), at.z());
  };
  add("shoulder", frames[kShoulder].translation);
  add("elbow", frames[kElbow].translation);
  add("wrist", frames[kWristPitch].translation);
  add("flange", frames.back().translation);
  add("sphere", chain.place(in_plane, sphere_center(layout)));
  return text;
}

std::string sides_text(const Study& study) {
  std::string text = "moment,height_mm,point,out_mm,up_mm\n";
  for (const CaseStudy& its : study.cases)
    for (const Moment& moment : its.moments)
      text += points_text(study.layout, moment.name, its.storage.height, moment.commanded);
  for (std::size_t i = 0; i < study.heights.size(); ++i) {
    const Stretch run = longest_stretch(study.heights[i]);
    if (run.empty()) continue;
    for (const auto& [name, place] : {std::pair("lowest", run.first), std::pair("highest", run.last)}) {
      Station storage = study.cases[i].storage;
      storage.height = study.heights[i][place].height;
      Angles angles = home_pose(study.layout);
      for (const Move& move : rehearse(study.layout, storage).moves) {
        angles[move.joint] += move.degrees;
        if (move.until == Until::Contact) break;
      }
      text += points_text(study.layout, fmt::format("case {}, {}", i + 1, name), storage.height, angles);
    }
  }
  return text;
}

std::string stops_text(const Study& study) {
  std::string text = "case,stop,when,x_mm,y_mm,z_mm\n";
  for (std::size_t i = 0; i < study.cases.size(); ++i)
    for (std::size_t s = 0; s < study.cases[i].stops.size(); ++s) {
      const Stop& stop = study.cases[i].stops[s];
      for (const auto& [when, at] : {std::pair("before", stop.center_before), std::pair("first", stop.center_first),
                                     std::pair("stop", stop.center_at)})
        text += fmt::format("{},{},{},{},{},{}\n", i + 1, s + 1, when, at.x(), at.y(), at.z());
    }
  return text;
}

ordered_json box(const Eigen::AlignedBox2d& b) {
  return {{"from", {b.min().x(), b.min().y()}}, {"to", {b.max().x(), b.max().y()}}};
}

ordered_json drawing(const Study& study) {
  const Layout& layout = study.layout;
  ordered_json moments = ordered_json::object(), outlines = ordered_json::object();
  for (const CaseStudy& its : study.cases) moments.update(drawn_moments(study.cell, its));
  for (const stability::Outline& outline : study.outlines) outlines[std::string(outline.name)] = outline.corners;
  ordered_json joints = ordered_json::array(), links = ordered_json::array();
  for (const cell::Joint& joint : study.cell.robot.joints)
    joints.push_back({{"name", joint.name}, {"lower", joint.lower}, {"upper", joint.upper}, {"home", joint.home}});
  for (const cell::Link& link : study.cell.robot.links) links.push_back(link.name);
  const Station machine = layout.machine();
  const auto& [first, second] = study.cases;
  const auto station = [](const Station& s) {
    return ordered_json{{"azimuth", s.azimuth}, {"radius", s.radius}, {"height", s.height}};
  };
  return {
      {"parts", drawn_parts(study.parts)},
      {"primitives",
       {{"Base", drawn_primitives(study.cell.robot.links[0].parts)},
        {"Axis1", drawn_primitives(study.cell.robot.links[1].parts)}}},
      {"links", links},
      {"joints", joints},
      {"moments", moments},
      {"outlines", outlines},
      {"plan", {{"body", study.plan.body}, {"storage", box(study.plan.storage)}, {"machine", box(study.plan.machine)}}},
      {"stations",
       {{"storage 1", station(first.storage)}, {"storage 2", station(second.storage)}, {"machine", station(machine)}}},
      {"material", {{"side", layout.side}, {"gap", layout.gap}}},
      {"sphere_radius", layout.sphere_radius},
      {"reach",
       {{"first", kUpperArm}, {"second", {kForearm, kHand + layout.sphere_distance}}, {"shoulder", kShoulderHeight}}}};
}

}  // namespace

void write_entries(const std::filesystem::path& folder, const std::vector<Entry>& entries) {
  harness::write_file(folder / "entries.csv", entries_text(entries));
  harness::write_file(folder / "numbers.csv", numbers_text(entries));
}

void write_data(const std::filesystem::path& folder, const Study& study) {
  harness::write_file(folder / "branches.csv", branches_text(study));
  harness::write_file(folder / "map.csv", map_text(study.map));
  harness::write_file(folder / "views.csv", views_text(study));
  harness::write_file(folder / "areas.csv", areas_text(study));
  harness::write_file(folder / "reach.csv", reach_text(study));
  harness::write_file(folder / "touching.csv", touching_text(study));
  harness::write_file(folder / "far.csv", far_text(study));
  write_missed(folder, study.missed);
  harness::write_file(folder / "places.csv", places_text(study));
  harness::write_file(folder / "moves.csv", moves_text(study));
  harness::write_file(folder / "stops.csv", stops_text(study));
  harness::write_file(folder / "sides.csv", sides_text(study));
  harness::write_file(folder / "drawing.json", drawing(study).dump() + "\n");
  harness::make_folder(folder / "models");
  for (const LinkFile& file : study.link_files)
    if (file.model.name == "Axis1" || file.model.name == "Gripper1" || file.model.name == "machine-bottom")
      harness::write_file(folder / "models" / (file.model.name + ".txt"), file.text);
}

std::string table(const std::vector<Entry>& entries) {
  std::vector<std::pair<std::string_view, std::size_t>> statuses;
  std::size_t stated = 0, agreeing = 0;
  std::string differing;
  for (const Entry& entry : entries) {
    const auto same =
        std::ranges::find(statuses, entry.status_words(), &std::pair<std::string_view, std::size_t>::first);
    if (same == statuses.end())
      statuses.emplace_back(entry.status_words(), 1);
    else
      ++same->second;
    for (const Number& n : entry.numbers) {
      if (!n.stated) continue;
      ++stated;
      agreeing += *n.agrees();
      if (!*n.agrees())
        differing += fmt::format("  {}: {}: {:.6g} {}, stated {:g} [{}]\n", entry.caption->id, n.what, n.ours, n.unit,
                                 *n.stated, static_cast<char>(*n.label));
    }
  }
  std::ranges::sort(statuses, std::greater<>{}, &std::pair<std::string_view, std::size_t>::second);
  std::string text = fmt::format("{} figures and tables\n", entries.size());
  for (const auto& [words, count] : statuses) text += fmt::format("{:>5}  {}\n", count, words);
  text += fmt::format("{} of {} stated numbers (T in the thesis, S elsewhere, D derived) are reproduced\n", agreeing,
                      stated);
  if (!differing.empty()) text += "otherwise:\n" + differing;
  return text;
}

}  // namespace touchstone::thesis_figures
