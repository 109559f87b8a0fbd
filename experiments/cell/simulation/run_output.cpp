// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/simulation/run_output.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "experiments/cases/output_lines.h"
#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"
#include "robust/exact/exact.h"

namespace touchstone::cell {
namespace {

const std::string& joint_name(const Workcell& workcell, Moved joint) {
  return workcell.arm().chain.joints()[joint].name;
}

/// Returns where the material is at a stop: a place, or `gripper`.
std::string_view holder(const Process& process, std::size_t stop) {
  std::optional<Place> place;
  for (const Custody& custody : process.custody)
    if (custody.stop == 0 || custody.stop < stop) place = custody.place;
  return place ? word(*place) : "gripper";
}

/// The move that a stop belongs to; none of the first one, and of the last ones of a run that failed within a move.
const Move* move_of(const Process& process, std::size_t stop) {
  const std::size_t move = process.stops[stop].move;
  return stop == 0 || move >= process.moves.size() ? nullptr : &process.moves[move];
}

std::string moves_text(const Workcell& workcell, const Process& process) {
  std::string text = "move,phase,joint,until,degrees,exact_deg,margin_deg,contact_low_deg,contact_high_deg,kind,face\n";
  for (std::size_t i = 0; i < process.moves.size(); ++i) {
    const Move& m = process.moves[i];
    text += fmt::format("{},{},{},{},{},{:.6f},{:.6f}", i + 1, word(m.phase), joint_name(workcell, m.joint),
                        word(m.until), m.degrees, m.exact, m.margin);
    text += m.contact
                ? fmt::format(",{},{},{},{}\n", m.contact->low, m.contact->high, word(m.contact->kind), m.contact->face)
                : ",,,,\n";
  }
  return text;
}

std::string trajectory_text(const Workcell& workcell, const Process& process) {
  std::string text = "stop,phase,joint";
  for (const auto& joint : workcell.arm().chain.joints()) text += "," + harness::csv_field(joint.name + "_deg");
  text += ",sphere_x,sphere_y,sphere_z,target,touched_face,material\n";
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    const Move* move = move_of(process, i);
    text += fmt::format("{},{},{}", i, move ? word(move->phase) : "home",
                        move ? joint_name(workcell, move->joint) : std::string());
    for (const double angle : stop.commanded) text += fmt::format(",{}", angle);
    const Eigen::Vector3d& at = stop.sphere.center;
    text += fmt::format(",{},{},{},{},{},{}\n", at.x(), at.y(), at.z(), stop.target ? word(*stop.target) : "",
                        stop.touched ? std::to_string(*stop.touched) : "", holder(process, i));
  }
  return text;
}

std::string trajectory_json(const Workcell& workcell, const Process& process) {
  using Json = nlohmann::ordered_json;
  Json joints = Json::array(), stops = Json::array();
  for (const auto& joint : workcell.arm().chain.joints()) joints.push_back(joint.name);
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Stop& stop = process.stops[i];
    const Move* move = move_of(process, i);
    const Eigen::Vector3d& at = stop.sphere.center;
    stops.push_back({{"phase", move ? word(move->phase) : "home"},
                     {"joint", move ? Json(joint_name(workcell, move->joint)) : Json()},
                     {"angles", stop.commanded},
                     {"sphere", {at.x(), at.y(), at.z()}},
                     {"target", stop.target ? Json(word(*stop.target)) : Json()},
                     {"touched", stop.touched ? Json(*stop.touched) : Json()},
                     {"material", holder(process, i)}});
  }
  const Json whole{{"cell", workcell.cell().name},
                   {"unit", workcell.cell().unit.name},
                   {"joints", joints},
                   {"radius", workcell.arm().sphere.radius},
                   {"failure", process.failure.empty() ? Json() : Json(process.failure)},
                   {"stops", stops}};
  return whole.dump(1) + "\n";
}

std::string methods_text(const Contest& contest) {
  std::string text = "method,asked,wrong_hits,wrong_misses,unsure,stops,share_low,share_high\n";
  for (const Score& s : contest.scores) {
    const auto limits = statistics::clopper_pearson(s.wrong_hits + s.wrong_misses, s.asked);
    text += fmt::format("{},{},{},{},{},{},{:.3g},{:.3g}\n", s.method->name(), s.asked, s.wrong_hits, s.wrong_misses,
                        s.unsure, s.stops, limits.lower, limits.upper);
  }
  return text;
}

std::string disagreements_text(const Contest& contest, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, contest.disagreements.size()); ++i) {
    const Disagreement& d = contest.disagreements[i];
    std::vector<std::string> tags{"cell", d.owner};
    for (const std::string& method : d.methods) tags.push_back("fails:" + method);
    const auto answer = cases::PartialAnswer::of(exact::answer(d.sphere, d.polygon), "exact");
    text += cases::case_line(fmt::format("stop-{}-{}-{}", d.stop, d.owner, d.face), d.sphere, d.polygon, tags, answer);
  }
  return text;
}

}  // namespace

std::string summary(const Workcell& workcell, const Process& process, const Contest& contest) {
  std::string text;
  for (const Move& m : process.moves) {
    text += fmt::format("{:<16} {:<10} {:+8g}  {:<8} at {:+.6f}", word(m.phase), joint_name(workcell, m.joint),
                        m.degrees, word(m.until), m.exact);
    if (m.contact) text += fmt::format(", face {}, {}", m.contact->face, word(m.contact->kind));
    text += "\n";
  }
  double overhang = 0;
  std::size_t balls = 0;
  for (const Covered& part : workcell.covered()) {
    overhang = std::max(overhang, part.cover.overhang());
    balls += part.cover.smallest().size();
  }
  const std::string_view unit = workcell.cell().unit.name;
  text += fmt::format(
      "\n{} stops; the arm is covered by {} balls that reach at most {:.3g} {} beyond it; {} balls of "
      "spheres and covers were asked of the obstacles\n",
      process.stops.size(), balls, overhang, unit, process.balls);
  for (const Custody& custody : process.custody)
    if (custody.shift > 0)
      text += fmt::format("put in the {}: {:.1f} {} from where the gripper held it\n", word(*custody.place),
                          custody.shift, unit);
  text += fmt::format("{} pairs of a stop and a face, {} whose boxes meet\n\n", contest.pairs, contest.met);
  text += fmt::format("{:<20} {:>9} {:>11} {:>13} {:>7}\n", "method", "asked", "wrong hits", "wrong misses", "unsure");
  for (const Score& s : contest.scores) {
    text += fmt::format("{:<20} {:>9} {:>11} {:>13} {:>7}", s.method->name(), s.asked, s.wrong_hits, s.wrong_misses,
                        s.unsure);
    if (s.wrong_hits + s.wrong_misses == 0 && s.asked > 0)
      text += fmt::format("   none wrong: at most {:.2g} of such questions (95 %)",
                          statistics::clopper_pearson(0, s.asked).upper);
    text += "\n";
  }
  if (!process.failure.empty()) text += fmt::format("\nnot completed: {}\n", process.failure);
  return text;
}

void write_run(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
               const Contest& contest, std::size_t most) {
  harness::write_file(folder / "moves.csv", moves_text(workcell, process));
  harness::write_file(folder / "trajectory.csv", trajectory_text(workcell, process));
  harness::write_file(folder / "trajectory.json", trajectory_json(workcell, process));
  harness::write_file(folder / "methods.csv", methods_text(contest));
  harness::write_file(folder / "disagreements.jsonl", disagreements_text(contest, most));
}

}  // namespace touchstone::cell
