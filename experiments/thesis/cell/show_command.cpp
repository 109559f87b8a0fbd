// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/command_run.h"
#include "experiments/program/output.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/link_model.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/simulation/arm.h"

namespace touchstone::cell {
namespace {

std::string parts_table(const std::vector<ModelPart>& parts) {
  std::string text = fmt::format("{:<28} {:>6} {:>6} {:>9} {:>10} {:>13}  {}\n", "part", "faces", "holes", "vertices",
                                 "off_plane", "volume", "bounds in the frame of what it moves with");
  for (const ModelPart& part : parts) {
    Eigen::AlignedBox3d bounds;
    for (const Face& face : part.faces.faces)
      for (std::size_t i = 0; i < face.polygon.vertex_count(); ++i) bounds.extend(face.polygon.vertex(i));
    const Eigen::Vector3d &a = bounds.min(), &b = bounds.max();
    text += fmt::format("{:<28} {:>6} {:>6} {:>9} {:>10.3g} {:>13}  [{:g}, {:g}] x [{:g}, {:g}] x [{:g}, {:g}]\n",
                        part.name, part.faces.faces.size(), part.faces.holes(), part.faces.vertices(),
                        part.faces.off_plane(),
                        part.faces.volume ? fmt::format("{:.8g}", *part.faces.volume)
                                          : fmt::format("of {} faces", part.faces.merged_from),
                        a.x(), b.x(), a.y(), b.y(), a.z(), b.z());
  }
  return text;
}

std::string joints_table(const Robot& robot) {
  std::string text = fmt::format("{:<12} {:<12} {:>24} {:>18} {:>16} {:>8}\n", "joint", "carries", "origin", "axis",
                                 "limits (deg)", "home");
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const Eigen::Vector3d &at = joint.origin.translation, &axis = joint.axis;
    text += fmt::format("{:<12} {:<12} {:>24} ", joint.name, robot.links[i + 1].name,
                        fmt::format("{:g} {:g} {:g}", at.x(), at.y(), at.z()));
    text += joint.kind == Joint::Kind::Fixed
                ? fmt::format("{:>18}\n", "fixed")
                : fmt::format("{:>18} {:>16} {:>8g}\n", fmt::format("{:g} {:g} {:g}", axis.x(), axis.y(), axis.z()),
                              fmt::format("{:g} to {:g}", joint.lower, joint.upper), joint.home);
  }
  for (const Coupling& coupling : robot.couplings)
    text += fmt::format("{} turns by {:g} times what {} is commanded, too\n", robot.joints[coupling.joint].name,
                        coupling.factor, robot.joints[coupling.leader].name);
  return text;
}

std::string station_line(const char* name, const Station& station) {
  return fmt::format("{}: at {:g} {:+g} degrees, radius {:g}, height {:g}, {} slots\n", name, station.home,
                     station.angle, station.radius, station.height, station.slots.size());
}

std::string labels_lines(const Cell& cell) {
  constexpr std::array<std::pair<Label, const char*>, 4> kWords{{{Label::Text, "the thesis's text"},
                                                                 {Label::Source, "another source"},
                                                                 {Label::Derived, "derived"},
                                                                 {Label::Chosen, "chosen"}}};
  std::string text = "where values come from (the nearest path above a value counts):\n";
  for (const auto& [label, words] : kWords) {
    std::string paths;
    for (const auto& [path, its_label] : cell.labels)
      if (its_label == label) paths.append(paths.empty() ? "" : ", ").append(path);
    if (!paths.empty()) text += fmt::format("  {}: {}\n", words, paths);
  }
  return text;
}

struct FaceRow {
  const ModelPart* part;
  std::size_t number;
  const Face* face;
};

const program::Table<FaceRow>& faces_csv() {
  using program::path;
  static const program::Table<FaceRow> table(
      "faces.csv", "a face of the model",
      {{"part", "the part", path(&FaceRow::part, &ModelPart::name)},
       {"moves_with", "what carries the part", path(&FaceRow::part, &ModelPart::carrier)},
       {"face", "its number in the part", &FaceRow::number},
       {"vertices", "of all loops", [](const FaceRow& row) { return row.face->polygon.vertex_count(); }},
       {"holes", "holes", [](const FaceRow& row) { return row.face->polygon.loop_count() - 1; }},
       {"off_plane", "the largest distance of a vertex from the face's plane",
        path(&FaceRow::face, &Face::off_plane)}});
  return table;
}

/// For the terminal: parts with their faces, joints, stations, and where values come from.
std::string summary(const Cell& cell, const std::vector<ModelPart>& parts) {
  const Reach reach = reach_of(cell);
  std::string text = fmt::format("{} ({}, degrees)\n\n{}\n", cell.name, cell.unit.name, parts_table(parts));
  text += fmt::format(
      "{}: base at height {:g}; sphere {:g} to {:g} from a circle of radius {:g} at height {:g}{}\n{}", cell.robot.name,
      cell.robot.base.translation.z(), reach.inner, reach.outer, reach.radius, reach.height,
      reach.beside == 0 ? "" : fmt::format(", in the arm's plane, {:g} beside the base's axis", reach.beside),
      joints_table(cell.robot));
  const Eigen::Vector3d& at = cell.gripper.sphere.center;
  text += fmt::format("gripper: sphere of radius {:g} at ({:g}, {:g}, {:g}) of {}\n", cell.gripper.sphere.radius,
                      at.x(), at.y(), at.z(), cell.robot.flange().name);
  text += station_line("storage", cell.storage) + station_line("machine", cell.machine);
  text += fmt::format("material: in slot {}, to be taken to {}; step {:g} degrees\n\n",
                      cell.storage.slots[cell.material.slot].name, cell.machine.slots[cell.material.machine_slot].name,
                      cell.step);
  return text + labels_lines(cell);
}

void write_faces(const std::filesystem::path& folder, const std::vector<ModelPart>& parts) {
  std::vector<FaceRow> rows;
  for (const ModelPart& part : parts)
    for (std::size_t i = 0; i < part.faces.faces.size(); ++i) rows.push_back({&part, i, &part.faces.faces[i]});
  faces_csv().write(folder, rows);
}

/// One file for all parts of a link, and one for every other part. Returns their number.
std::size_t write_models(const std::filesystem::path& folder, const std::vector<ModelPart>& parts) {
  const auto models = link_models(parts);
  for (const auto& [name, model] : models) program::write_file(folder / (name + ".txt"), link_model_text(model));
  return models.size();
}

struct ShowOptions : program::FolderOptions {
  std::string file, meshes;
};

/// Throws BadCell for a preset that cannot be applied, and warns of an arm that cannot run.
void check(const Cell& cell, const std::optional<std::filesystem::path>& meshes) {
  for (const auto& [name, changes] : read_presets(cell.file)) {
    try {
      static_cast<void>(read_plant(cell.file, meshes, changes));
    } catch (const std::exception& error) {
      throw BadCell(fmt::format("{}: presets.{}: {}", cell.file.string(), name, error.what()));
    }
  }
  try {
    const PlanarArm plane(cell, arm_of(cell));
  } catch (const BadCell& refused) {
    fmt::print(stderr, "touchstone: warning: {}; cell run refuses it\n", refused.what());
  }
}

int run(const ShowOptions& options) {
  program::CommandRun run(options);
  if (run.has_folder()) program::make_folder(run.folder() / "models");
  const auto meshes = options.meshes.empty() ? std::nullopt : std::optional<std::filesystem::path>(options.meshes);
  const Cell cell = read_cell(options.file, meshes);
  check(cell, meshes);
  std::vector<ModelPart> parts;
  {
    std::optional<program::ProgressLine> line;
    parts = build_model(cell, [&](std::size_t done, std::size_t total) {
      if (!line) line.emplace("cell: parts", total, !options.quiet);
      (*line)(done);
    });
  }
  std::string text = summary(cell, parts);
  const auto print = [&] {
    program::print_result(text, options.quiet);
    return 0;
  };
  if (!run.has_folder()) return print();
  write_faces(run.folder(), parts);
  const std::size_t models = write_models(run.folder() / "models", parts);
  run.write_record({.samples_asked = parts.size(), .samples_done = parts.size()});
  text += fmt::format("\nfaces.csv and {} model files: {}\n", models, options.output);
  return print();
}

}  // namespace

program::Command show_command() {
  program::Command command("show", "Check a cell file, build its model, and summarize it");
  auto options = std::make_shared<ShowOptions>();
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  command.text("--meshes", options->meshes, "The folder of mesh files, instead of the cell file's").takes("FOLDER");
  program::declare_output(command, *options,
                          "A folder for faces.csv, one line per face, and models/, one model file (.txt) per link");
  program::declare_quiet(command, options->quiet);
  command.writes({faces_csv().description()});
  command.help().examples.emplace_back("cell show experiments/thesis/cell/cells/aristo.json");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
