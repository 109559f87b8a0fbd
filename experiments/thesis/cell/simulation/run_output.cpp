// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/run_output.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/program/output.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/simulation/distance_output.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/timing.h"
#include "robust/exact/exact.h"

namespace touchstone::cell {
namespace {

using kinematics::FirstContact;

const std::string& joint_name(const Workcell& workcell, Moved joint) {
  return workcell.arm().chain.joints()[joint].name;
}

/// Returns where the material is at a stop: a place, or `gripper`.
std::string_view holder(const Process& process, std::size_t stop) {
  const auto slot = process.holding(stop).slot;
  return slot ? to_string(*slot) : "gripper";
}

/// The move that a stop belongs to; none of the first one, and of the last ones of a run that failed within a move.
const Move* move_of(const Process& process, std::size_t stop) {
  const std::size_t move = process.stops[stop].move;
  return stop == 0 || move >= process.moves.size() ? nullptr : &process.moves[move];
}

struct MoveRow {
  std::size_t number;
  std::string_view joint;
  const Move* move;
  std::optional<double> seconds;
};

program::Table<MoveRow> moves_csv() {
  using program::path;
  const auto contact = [](auto FirstContact::*member) {
    return [member](const MoveRow& row) {
      return row.move->contact ? std::optional((*row.move->contact).*member) : std::nullopt;
    };
  };
  return {
      "moves.csv",
      "a move",
      {{"move", "its number", &MoveRow::number},
       {"phase", "the part of the process", path(&MoveRow::move, &Move::phase)},
       {"joint", "the joint, or that which turns furthest", &MoveRow::joint},
       {"until", "what ends the move", path(&MoveRow::move, &Move::until)},
       {"degrees", "a whole number of steps, but not on a way that is found", path(&MoveRow::move, &Move::degrees)},
       {"exact_deg", "the angle before it is rounded to steps", path(&MoveRow::move, &Move::exact), "{:.6f}"},
       {"seconds", "it takes, as fast as its joints allow", &MoveRow::seconds, "{:.4f}"},
       {"margin_deg", "the change of exact_deg that changes degrees", path(&MoveRow::move, &Move::margin), "{:.6f}"},
       {"contact_low_deg", "the certified enclosure of the first contact", contact(&FirstContact::low)},
       {"contact_high_deg", "its upper end", contact(&FirstContact::high)},
       {"kind", "the kind of contact", contact(&FirstContact::kind)},
       {"face", "the face that is touched", contact(&FirstContact::face)},
       {"early_deg", "degrees by which a wrong stop is before the exact one",
        [](const MoveRow& row) { return row.move->wrong ? row.move->wrong->early : std::nullopt; }},
       {"gap", "between the sphere and its target at a wrong stop",
        [](const MoveRow& row) { return row.move->wrong ? std::optional(row.move->wrong->gap) : std::nullopt; }},
       {"rise", "of the hand, straight up or down",
        [](const MoveRow& row) { return row.move->rise != 0 ? std::optional(row.move->rise) : std::nullopt; }}}};
}

struct StopRow {
  std::size_t number;
  const Stop* stop;
  const Move* move;  ///< none at home
  std::string_view joint, material;

  [[nodiscard]] const Eigen::Vector3d& sphere() const { return stop->sphere.center; }
};

program::Table<StopRow> trajectory_csv(const std::vector<std::string>& joints) {
  using program::path;
  std::vector<program::Column<StopRow>> columns{
      {"stop", "its number", &StopRow::number},
      {"phase", "the part of the process",
       [](const StopRow& row) { return row.move ? to_string(row.move->phase) : std::string_view("home"); }},
      {"joint", "the joint that moves", &StopRow::joint}};
  for (std::size_t i = 0; i < joints.size(); ++i)
    columns.emplace_back(joints[i] + "_deg", "the angle of this joint",
                         [i](const StopRow& row) { return row.stop->commanded.at(i); });
  columns.emplace_back("sphere_x", "the first coordinate of the sphere's centre",
                       [](const StopRow& row) { return row.sphere().x(); });
  columns.emplace_back("sphere_y", "the second one", [](const StopRow& row) { return row.sphere().y(); });
  columns.emplace_back("sphere_z", "the third one", [](const StopRow& row) { return row.sphere().z(); });
  columns.emplace_back("target", "the place of the material that the sphere approaches or leaves",
                       path(&StopRow::stop, &Stop::target));
  columns.emplace_back("touched_face", "the lowest face of the target that it touches",
                       path(&StopRow::stop, &Stop::touched));
  columns.emplace_back("material", "where the material is", &StopRow::material);
  return {"trajectory.csv", "a stop", columns};
}

struct ScoreRow {
  const Score* score;
  program::Rate wrong;
};

program::Table<ScoreRow> methods_csv() {
  using program::path;
  return {"methods.csv",
          "a method beside the exact answers",
          {{"method", "the method", [](const ScoreRow& row) { return row.score->method->name(); }},
           {"asked", "questions", path(&ScoreRow::score, &Score::asked)},
           {"wrong_hits", "wrong answers yes", path(&ScoreRow::score, &Score::wrong_hits)},
           {"wrong_misses", "wrong answers no", path(&ScoreRow::score, &Score::wrong_misses)},
           {"unsure", "questions that it did not decide", path(&ScoreRow::score, &Score::unsure)},
           {"stops", "stops with a wrong answer", path(&ScoreRow::score, &Score::stops)},
           {"share_low", "the lower limit of the share of wrong answers", path(&ScoreRow::wrong, &program::Rate::lower),
            "{:.3g}"},
           {"share_high", "its upper limit", path(&ScoreRow::wrong, &program::Rate::upper), "{:.3g}"}}};
}

struct NearRow {
  std::size_t exponent;
  std::uint64_t near, questions;
};

program::Table<NearRow> near_csv() {
  return {"near.csv",
          "an exponent",
          {{"exponent", "k", &NearRow::exponent},
           {"near",
            "questions whose radius differs from the exact distance, as a double, by at most 2^-k of the largest side "
            "of the face's box",
            &NearRow::near},
           {"questions", "pairs of a stop and a face that methods are asked about", &NearRow::questions}}};
}

std::vector<NearRow> near_rows(const MethodComparison& comparison) {
  std::vector<NearRow> rows;
  for (std::size_t k = 0; k < comparison.near.size(); ++k)
    rows.push_back({k, comparison.near[k], comparison.questions});
  return rows;
}

std::vector<MoveRow> move_rows(const Workcell& workcell, const Process& process) {
  const Timing timing(workcell, process);
  std::vector<MoveRow> rows;
  for (const Move& move : process.moves)
    rows.push_back({rows.size() + 1, joint_name(workcell, move.joint), &move, timing.move(rows.size())});
  return rows;
}

std::vector<StopRow> stop_rows(const Workcell& workcell, const Process& process) {
  std::vector<StopRow> rows;
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    const Move* move = move_of(process, i);
    rows.push_back({i, &process.stops[i], move, move ? std::string_view(joint_name(workcell, move->joint)) : "",
                    holder(process, i)});
  }
  return rows;
}

std::vector<ScoreRow> score_rows(const MethodComparison& comparison) {
  std::vector<ScoreRow> rows;
  for (const Score& score : comparison.scores)
    rows.push_back({&score, program::rate(score.wrong_hits + score.wrong_misses, score.asked)});
  return rows;
}

std::string disagreements_text(const MethodComparison& comparison, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most, comparison.disagreements.size()); ++i) {
    const Disagreement& d = comparison.disagreements[i];
    std::vector<std::string> tags{"cell", d.owner};
    for (const std::string& method : d.methods) tags.push_back("fails:" + method);
    const auto answer = cases::PartialAnswer::of(exact::answer(d.sphere, d.polygon), "exact");
    text += cases::case_line(fmt::format("stop-{}-{}-{}", d.stop, d.owner, d.face), cases::Shapes{d.sphere, d.polygon},
                             tags, answer);
  }
  return text;
}

/// How fingers hold the material, a line for each.
std::string grip_text(const Workcell& workcell, const MaterialTransfer& transfer) {
  const std::string_view unit = workcell.cell().unit.name;
  std::string text =
      fmt::format("gripped at stop {}: the fingers are {:.6g} {} apart\n", transfer.stop, transfer.grip->opening, unit);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [way, gap, faces, place] = transfer.grip->fingers[i];
    const auto at = [](const Eigen::Vector3d& p) {
      return fmt::format("({:.4g}, {:.4g}, {:.4g})", p.x(), p.y(), p.z());
    };
    text += fmt::format("  {} closes by {:.6g} {} and touches face {} from {} to {} of the hand, within {:.1g} {}\n",
                        workcell.cell().gripper.fingers->parts[i].name, way, unit, fmt::join(faces, ", "),
                        at(place.min()), at(place.max()), gap, unit);
  }
  return text;
}

}  // namespace

std::string summary(const Workcell& workcell, const Process& process, const Separation& separation,
                    const MethodComparison& comparison) {
  std::string text;
  const std::string_view unit = workcell.cell().unit.name;
  for (const Move& m : process.moves) {
    if (m.rise != 0) {
      text += fmt::format("{:<16} straight {:+.6f} {}  {}\n", to_string(m.phase), m.rise, unit, to_string(m.until));
      continue;
    }
    if (m.until == Until::Through) {
      text += fmt::format("{:<16} {:<10} {:+8.2f}  {}\n", to_string(m.phase), joint_name(workcell, m.joint), m.degrees,
                          to_string(m.until));
      continue;
    }
    text += fmt::format("{:<16} {:<10} {:+8g}  {:<8} at {:+.6f}", to_string(m.phase), joint_name(workcell, m.joint),
                        m.degrees, to_string(m.until), m.exact);
    if (m.contact) text += fmt::format(", face {}, {}", m.contact->face, to_string(m.contact->kind));
    if (m.wrong)
      text += fmt::format("; WRONG STOP, {}, {:.2f} {} from the material",
                          m.wrong->early ? fmt::format("{:g} degrees early", *m.wrong->early)
                                         : std::string("there is no contact on the way"),
                          m.wrong->gap, workcell.cell().unit.name);
    text += "\n";
  }
  text += fmt::format("\n{} stops; {} distances were measured for obstacles\n", process.stops.size(), process.queries);
  for (const MaterialTransfer& transfer : process.transfers) {
    if (transfer.grip) text += grip_text(workcell, transfer);
    if (transfer.slot && transfer.stop > 0)
      text += fmt::format("let go in the {}: {:.1f} {} from its place, turned by {:.2f} degrees\n",
                          to_string(*transfer.slot), transfer.shift, unit, transfer.turn);
    if (transfer.landing)
      text += fmt::format("  it lies on {}, at most {:.1g} {} above it\n", transfer.landing->support,
                          transfer.landing->gap, unit);
  }
  text += "\n" + separation_text(workcell, process, separation) + "\n";
  if (const std::string triggers = triggers_text(workcell, process); !triggers.empty()) text += triggers + "\n";
  text += fmt::format("{} pairs of a stop and a face could touch: their boxes meet\n\n", comparison.met);
  text += methods_csv().aligned(score_rows(comparison)) +
          "share_low, share_high: 95 % limits of the share of wrong answers\n";
  if (!process.failure.empty()) text += fmt::format("\nnot completed: {}\n", process.failure);
  return text;
}

void write_run(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
               const Separation& separation, const MethodComparison& comparison, std::size_t most) {
  std::vector<std::string> joints;
  for (const auto& joint : workcell.arm().chain.joints()) joints.push_back(joint.name);
  moves_csv().write(folder, move_rows(workcell, process));
  trajectory_csv(joints).write(folder, stop_rows(workcell, process));
  write_separation(folder, workcell, process, separation);
  write_triggers(folder, workcell, process);
  methods_csv().write(folder, score_rows(comparison));
  near_csv().write(folder, near_rows(comparison));
  program::write_file(folder / "disagreements.jsonl", disagreements_text(comparison, most));
}

std::vector<program::TableDescription> run_tables() {
  return {moves_csv().description(),   trajectory_csv({"<joint>"}).description(),
          separation_table(),          triggers_table(),
          methods_csv().description(), near_csv().description()};
}

}  // namespace touchstone::cell
