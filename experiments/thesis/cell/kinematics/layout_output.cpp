// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/layout_output.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "experiments/program/command_run.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/cell_commands.h"

namespace touchstone::kinematics {
namespace {

/// Returns the names of moves in the captions of a case, in the order of the moves.
std::vector<std::string> captions_of(std::size_t number) {
  if (number == 0)
    return {"elbow down 3", "base 149 CW; contact", "elbow up 38", "base 66", "shoulder down 28; contact"};
  return {"elbow up 12", "base 183 CW",  "shoulder down 25; contact", "not captioned (11 derived)",
          "elbow up 23", "base 100 CCW", "shoulder down 14"};
}

using program::path;
using program::Table;

/// `member`: of Layout.
template <class Value>
auto of_layout(Value member) {
  return [member](const Member& row) {
    return row.layout ? std::optional<double>(std::invoke(member, *row.layout)) : std::nullopt;
  };
}

/// Both tables of home poses.
Table<Member> homes_csv(const char* file, const char* about) {
  constexpr const char* kDegrees = "{:.6f}";
  constexpr const char* kLength = "{:.4f}";
  return {file,
          about,
          {{"coupling", "`serial`: the forearm turns with the upper arm; `keeps-elevation`: it does not",
            path(&Member::linkage, &Linkage::coupling)},
           {"hand", "`level`: the wrist keeps it upright; `locked`: it turns with the forearm",
            path(&Member::linkage, &Linkage::hand)},
           {"lean_deg", "of the upper arm at home", path(&Member::home, &LinkAngles::lean), kDegrees},
           {"elevation_deg", "of the forearm at home", path(&Member::home, &LinkAngles::elevation), kDegrees},
           {"storage_radius_1_mm", "of the storage in case 1, from the robot's axis",
            of_layout([](const Layout& l) { return l.storage_radius[0]; }), kLength},
           {"storage_radius_2_mm", "the same in case 2", of_layout([](const Layout& l) { return l.storage_radius[1]; }),
            kLength},
           {"storage_height_1_mm", "of the storage in case 1",
            of_layout([](const Layout& l) { return l.storage_height[0]; }), kLength},
           {"storage_height_2_mm", "the same in case 2", of_layout([](const Layout& l) { return l.storage_height[1]; }),
            kLength},
           {"machine_radius_mm", "of the machine, from the robot's axis", of_layout(&Layout::machine_radius), kLength},
           {"machine_height_mm", "of the machine", of_layout(&Layout::machine_height), kLength},
           {"gap_mm", "from the storage's x axis to the near side of the material", of_layout(&Layout::gap), kLength},
           {"clearance_mm", "by which the sphere is lifted after gripping from above", of_layout(&Layout::clearance),
            kLength},
           {"captions_come_out", "whether the layout reproduces the captions: `yes` or `no`",
            [](const Member& row) { return program::yes_or_no(row.failure.empty()); }},
           {"otherwise", "why it does not", &Member::failure}}};
}

Table<Member> family_csv() { return homes_csv("family.csv", "a home pose, and the layout that it requires"); }

Table<Member> one_height_csv() {
  return homes_csv("one_height.csv", "a home pose with one height of the storage in both cases");
}

struct ChoiceRow {
  std::string name, value, unit;
  std::optional<double> lowest, highest;
};

Table<ChoiceRow> choice_csv() {
  return {"choice.csv",
          "a chosen value",
          {{"name", "what is chosen", &ChoiceRow::name},
           {"value", "the value", &ChoiceRow::value},
           {"unit", "its unit", &ChoiceRow::unit},
           {"label", "`C`: chosen", [](const ChoiceRow&) { return "C"; }},
           {"lowest", "the least value that alone changes no caption", &ChoiceRow::lowest, "{:.3f}"},
           {"highest", "the greatest one", &ChoiceRow::highest, "{:.3f}"}}};
}

std::vector<ChoiceRow> choice_rows(const LayoutStudy& study) {
  std::vector<ChoiceRow> rows{{"coupling", std::string(to_string(study.chosen.coupling)), "", {}, {}},
                              {"hand", std::string(to_string(study.chosen.hand)), "", {}, {}},
                              {"way to the material",
                               "from the side where the shoulder can stay; else from above; else from the side",
                               "",
                               {},
                               {}}};
  const Chain chain = aristo(study.chosen.coupling, study.chosen.hand);
  for (const Joint& joint : chain.joints())
    rows.push_back({fmt::format("limits of {} in degrees", joint.name),
                    fmt::format("{:g} to {:g}", joint.lowest, joint.highest),
                    "",
                    {},
                    {}});
  for (const Choice& c : study.choices)
    rows.push_back({c.name, fmt::format("{:.4g}", c.value), c.unit, c.lowest, c.highest});
  return rows;
}

struct MoveRow {
  std::size_t its_case, number;
  std::string caption;
  const cell::Move* move;
};

Table<MoveRow> moves_csv() {
  return {
      "moves.csv",
      "a move of one joint in a case study",
      {{"case", "1 or 2", &MoveRow::its_case},
       {"move", "its number", &MoveRow::number},
       {"caption", "what the thesis's caption says", &MoveRow::caption},
       {"joint", "the joint", [](const MoveRow& row) { return name_of(row.move->joint); }},
       {"until", "what ends the move", path(&MoveRow::move, &cell::Move::until)},
       {"degrees", "the result", path(&MoveRow::move, &cell::Move::degrees)},
       {"exact_deg", "the angle before it is rounded to degrees", path(&MoveRow::move, &cell::Move::exact), "{:.6f}"},
       {"margin_deg", "the change of exact_deg that changes degrees", path(&MoveRow::move, &cell::Move::margin),
        "{:.6f}"}}};
}

std::vector<MoveRow> move_rows(const LayoutStudy& study) {
  std::vector<MoveRow> rows;
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    const auto captions = captions_of(number);
    const auto& moves = study.cases[number].moves;
    for (std::size_t i = 0; i < moves.size(); ++i) rows.push_back({number + 1, i + 1, captions.at(i), &moves[i]});
  }
  return rows;
}

struct PoseRow {
  std::size_t its_case;
  const char *moment, *point;
  Eigen::Vector3d at;
};

Table<PoseRow> poses_csv() {
  return {"poses.csv",
          "a point of the arm at a moment",
          {{"case", "1 or 2", &PoseRow::its_case},
           {"moment", "`home`, or contact in the `storage` or at the `machine`", &PoseRow::moment},
           {"point", "the joint, the flange or the sphere's centre", &PoseRow::point},
           {"out_mm", "its distance from the robot's axis, in the plane of the arm",
            [](const PoseRow& row) { return row.at.x(); }, "{:.4f}"},
           {"up_mm", "its height", [](const PoseRow& row) { return row.at.z(); }, "{:.4f}"}}};
}

std::vector<PoseRow> pose_rows(const LayoutStudy& study) {
  std::vector<PoseRow> rows;
  const Layout& layout = study.chosen;
  const Chain chain = aristo(layout.coupling, layout.hand);
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    Angles angles = home_pose(layout);
    const auto draw = [&](const char* moment) {
      Angles in_plane = angles;
      in_plane[kBase] = 0;
      const auto frames = chain.frames(in_plane);
      rows.push_back({number + 1, moment, "shoulder", frames[kShoulder].translation});
      rows.push_back({number + 1, moment, "elbow", frames[kElbow].translation});
      rows.push_back({number + 1, moment, "wrist", frames[kWristPitch].translation});
      rows.push_back({number + 1, moment, "flange", frames.back().translation});
      rows.push_back({number + 1, moment, "sphere", chain.place(in_plane, sphere_center(layout))});
    };
    draw("home");
    int contacts = 0;
    for (const cell::Move& m : study.cases[number].moves) {
      angles[m.joint] += m.degrees;
      if (m.until == cell::Until::Contact) draw(++contacts == 1 ? "storage" : "machine");
    }
  }
  return rows;
}

}  // namespace

void write_layout(const std::filesystem::path& folder, const LayoutStudy& study) {
  family_csv().write(folder, study.grid);
  one_height_csv().write(folder, study.one_height);
  choice_csv().write(folder, choice_rows(study));
  moves_csv().write(folder, move_rows(study));
  poses_csv().write(folder, pose_rows(study));
}

std::vector<program::TableDescription> layout_tables() {
  return {family_csv().description(), one_height_csv().description(), choice_csv().description(),
          moves_csv().description(), poses_csv().description()};
}

std::string layout_table(const LayoutStudy& study) {
  std::string text;
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    text += fmt::format("case {}: storage at {:+g} degrees\n", number + 1, kCases[number].storage_angle);
    const auto captions = captions_of(number);
    const auto& moves = study.cases[number].moves;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const cell::Move& m = moves[i];
      text += fmt::format("  {:<28} {:<9}{:+4}   ", captions.at(i), name_of(m.joint), m.degrees);
      text += m.until == cell::Until::Facing
                  ? "exactly: it faces the station\n"
                  : fmt::format("{} at {:.6f}, {:.3f} from the next degree\n", to_string(m.until), m.exact, m.margin);
    }
  }
  for (const Hand hand : kHands)
    for (const Coupling coupling : kCouplings) {
      const auto is_so = [&](const Member& m) { return m.linkage.hand == hand && m.linkage.coupling == coupling; };
      text +=
          fmt::format("hand {}, forearm {}: all captions are reproduced by a layout of {} of {} home poses\n",
                      to_string(hand), to_string(coupling),
                      std::ranges::count_if(study.grid, [&](const Member& m) { return is_so(m) && m.failure.empty(); }),
                      std::ranges::count_if(study.grid, is_so));
    }
  text += "Every length but the arm's and every angle of the home pose is chosen: no public source gives them.\n";
  return text;
}

}  // namespace touchstone::kinematics

namespace touchstone::cell {
namespace {

struct LayoutOptions : program::FolderOptions {
  bool quick = false;
};

int run_layout(const LayoutOptions& options) {
  program::CommandRun run(options);
  const kinematics::HomeSteps homes = options.quick ? kinematics::HomeSteps{30, 15} : kinematics::HomeSteps{};
  const std::uint64_t work = kinematics::layout_work(homes);
  std::optional<kinematics::LayoutStudy> study;
  {
    program::ProgressLine line = run.progress("layouts", work);
    study = kinematics::study_layout(homes, run.stop(), std::ref(line));
  }
  if (!study) return run.finish_unwritten();
  kinematics::write_layout(run.folder(), *study);
  return run.finish({.samples_asked = work, .samples_done = work}, kinematics::layout_table(*study), "cell_layout");
}

}  // namespace

program::Command layout_command() {
  auto options = std::make_shared<LayoutOptions>();
  options->output = "results/cell-layout";
  program::Command command("layout", "Find the home pose and places that reproduce the thesis's captioned angles");
  command.help().footer =
      "Solves for the home pose, storage and machine that reproduce both case studies' angles to the degree. Shows "
      "the family of solutions, the chosen one, and how far each of its values may be moved alone.";
  command.flag("--quick", options->quick,
               "Coarser steps between the home poses of the family; the chosen layout is the same");
  program::declare_output(command, *options, "Folder for the CSV files, run.json and pictures", true);
  program::declare_quiet(command, options->quiet);
  command.writes(kinematics::layout_tables());
  command.help().examples.emplace_back("cell layout --quick");
  command.runs([options] { return run_layout(*options); });
  return command;
}

}  // namespace touchstone::cell
