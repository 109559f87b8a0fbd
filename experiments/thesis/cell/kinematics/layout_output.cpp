// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/layout_output.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "experiments/run/command_run.h"
#include "experiments/run/table.h"
#include "experiments/thesis/cell/cell_commands.h"

namespace touchstone::kinematics {
namespace {

constexpr std::array<const char*, 6> kJoints{"base", "shoulder", "elbow", "wrist roll", "wrist pitch", "hand roll"};

/// Returns the names of moves in the captions of a case, in the order of the moves.
std::vector<std::string> captions_of(std::size_t number) {
  if (number == 0)
    return {"elbow down 3", "base 149 CW; contact", "elbow up 38", "base 66", "shoulder down 28; contact"};
  return {"elbow up 12", "base 183 CW",  "shoulder down 25; contact", "not captioned (11 derived)",
          "elbow up 23", "base 100 CCW", "shoulder down 14"};
}

using run::path;
using run::Table;

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
            [](const Member& row) { return run::yes_or_no(row.failure.empty()); }},
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
  const auto contact = [](const auto& get) {
    return [get](const MoveRow& row) {
      return row.move->contact ? std::optional(std::invoke(get, *row.move->contact)) : std::nullopt;
    };
  };
  return {
      "moves.csv",
      "a move of one joint in a case study",
      {{"case", "1 or 2", &MoveRow::its_case},
       {"move", "its number", &MoveRow::number},
       {"caption", "what the thesis's caption says", &MoveRow::caption},
       {"joint", "the joint", [](const MoveRow& row) { return kJoints[row.move->joint]; }},
       {"until", "what ends the move", path(&MoveRow::move, &cell::Move::until)},
       {"degrees", "the result", path(&MoveRow::move, &cell::Move::degrees)},
       {"exact_deg", "the angle before it is rounded to degrees", path(&MoveRow::move, &cell::Move::exact), "{:.6f}"},
       {"margin_deg", "the change of exact_deg that changes degrees", path(&MoveRow::move, &cell::Move::margin),
        "{:.6f}"},
       {"contact_low_deg", "the certified enclosure of the first contact", contact(&FirstContact::low), "{:.17g}"},
       {"contact_high_deg", "its upper end", contact(&FirstContact::high), "{:.17g}"},
       {"kind", "the kind of contact", contact(&FirstContact::kind)},
       {"feature", "the kind of feature that is touched",
        contact([](const FirstContact& first) { return first.feature.kind; })}}};
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

double net_of(const cell::Process& path, cell::Moved joint) {
  return path.turned(joint, cell::Phase::ToStorage) + path.turned(joint, cell::Phase::ToMachine);
}

/// `get`: a function of a path, which must be complete.
template <class Get>
auto of_path(Get get) {
  return [get](const Prediction& row) { return row.path.cause ? std::nullopt : std::optional(get(row.path)); };
}

/// Both tables of predictions.
Table<Prediction> predictions_csv(const char* file, const char* about) {
  const auto to_storage = [](cell::Moved joint) {
    return of_path([joint](const cell::Process& path) { return path.turned(joint, cell::Phase::ToStorage); });
  };
  const auto net = [](cell::Moved joint) {
    return of_path([joint](const cell::Process& path) { return net_of(path, joint); });
  };
  return {file,
          about,
          {{"place", "the case whose radius the storage has", [](const Prediction& p) { return p.place + 1; }},
           {"storage_angle_deg", "the angle of the storage", &Prediction::angle, "{:g}"},
           {"storage_height_mm", "its height", &Prediction::height, "{:g}"},
           {"elbow_to_storage", "degrees of the elbow until contact in the storage", to_storage(cell::kElbow)},
           {"base_to_storage", "the same of the base", to_storage(cell::kBase)},
           {"shoulder_to_storage", "the same of the shoulder", to_storage(cell::kShoulder)},
           {"lift", "degrees by which the shoulder lifts the material", of_path([](const cell::Process& path) {
              const auto lift = std::ranges::find(path.moves, cell::Until::Cleared, &cell::Move::until);
              return lift == path.moves.end() ? 0 : lift->degrees;
            })},
           {"base_to_machine", "degrees of the base from the storage to the machine",
            of_path([](const cell::Process& path) { return path.turned(cell::kBase, cell::Phase::ToMachine); })},
           {"net_elbow", "the sum of all moves of the elbow", net(cell::kElbow)},
           {"net_shoulder", "the same of the shoulder", net(cell::kShoulder)},
           {"least_margin_deg", "the least change of an angle that changes its degrees",
            of_path([](const cell::Process& path) {
              return std::ranges::min_element(path.moves, {}, &cell::Move::margin)->margin;
            }),
            "{:.6f}"},
           {"otherwise", "why there are no moves", path(&Prediction::path, &cell::Process::failure)}}};
}

Table<Prediction> angles_csv() { return predictions_csv("angles.csv", "a whole angle of the storage"); }

Table<Prediction> heights_csv() { return predictions_csv("heights.csv", "a height of the storage"); }

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

/// Returns the number of predictions that satisfy what the captions imply for every angle.
std::size_t kept(const std::vector<Prediction>& predictions) {
  return static_cast<std::size_t>(std::ranges::count_if(predictions, [](const Prediction& p) {
    const cell::Process& r = p.path;
    return !r.cause && r.turned(cell::kBase, cell::Phase::ToStorage) == kStorageHome + p.angle &&
           net_of(r, cell::kBase) == kMachineAzimuth && net_of(r, cell::kElbow) == 35 &&
           net_of(r, cell::kShoulder) == 28;
  }));
}

}  // namespace

void write_layout(const std::filesystem::path& folder, const LayoutStudy& study) {
  family_csv().write(folder, study.grid);
  one_height_csv().write(folder, study.one_height);
  choice_csv().write(folder, choice_rows(study));
  moves_csv().write(folder, move_rows(study));
  angles_csv().write(folder, study.angles);
  heights_csv().write(folder, study.heights);
  poses_csv().write(folder, pose_rows(study));
}

std::vector<run::TableDescription> layout_tables() {
  return {family_csv().description(), one_height_csv().description(), choice_csv().description(),
          moves_csv().description(),  angles_csv().description(),     heights_csv().description(),
          poses_csv().description()};
}

std::string layout_table(const LayoutStudy& study) {
  std::string text;
  for (std::size_t number = 0; number < study.cases.size(); ++number) {
    text += fmt::format("case {}: storage at {:+g} degrees\n", number + 1, kCases[number].storage_angle);
    const auto captions = captions_of(number);
    const auto& moves = study.cases[number].moves;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const cell::Move& m = moves[i];
      text += fmt::format("  {:<28} {:<9}{:+4}   ", captions.at(i), kJoints[m.joint], m.degrees);
      text += m.until == cell::Until::Facing
                  ? "exactly: it faces the station\n"
                  : fmt::format("{} at {:.6f}, {:.3f} from the next degree\n", to_string(m.until), m.exact, m.margin);
    }
  }
  text += fmt::format(
      "storage at -60 to 60 degrees: base {:g} + angle and 67 - angle, net elbow +35, net shoulder +28 in {} of {}\n",
      kStorageHome, kept(study.angles), study.angles.size());
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

struct Options : run::FolderOptions {
  bool quick = false;
};

int run_layout(const Options& options) {
  run::CommandRun run(options);
  const kinematics::HomeSteps homes = options.quick ? kinematics::HomeSteps{30, 15} : kinematics::HomeSteps{};
  const std::uint64_t work = kinematics::layout_work(homes);
  std::optional<kinematics::LayoutStudy> study;
  {
    run::ProgressLine line = run.progress("layouts", work);
    study = kinematics::study_layout(homes, run.stop(), std::ref(line));
  }
  if (!study) return run.finish_unwritten();
  kinematics::write_layout(run.folder(), *study);
  return run.finish({.samples_asked = work, .samples_done = work}, kinematics::layout_table(*study), "cell_layout");
}

}  // namespace

run::Command layout_command() {
  auto options = std::make_shared<Options>();
  options->output = "results/cell-layout";
  run::Command command("layout", "Find the home pose and places that reproduce the thesis's captioned angles");
  command.footer(
      "Solves for the home pose, storage and machine that reproduce both case studies' angles to the degree. Shows "
      "the family of solutions, the chosen one, and its predictions for other angles and heights.");
  command.flag(
      "--quick", options->quick,
      "Coarser steps between the home poses of the family; the chosen layout and its predictions are the same");
  run::declare_output(command, *options, "Folder for the CSV files, run.json and pictures", true);
  run::declare_printing(command, *options);
  command.writes(kinematics::layout_tables());
  command.example("cell layout --quick");
  command.runs([options] { return run_layout(*options); });
  return command;
}

}  // namespace touchstone::cell
