// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_cell.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/json.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/change_cell.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/read_solid.h"
#include "experiments/thesis/cell/model/read_things.h"

namespace touchstone::cell {
namespace {

constexpr double kMostStops = 100'000;  // of a joint, from limit to limit: about ten seconds of a process

program::StrictJson load(const std::filesystem::path& file) {
  const std::string text = read_at_most<BadCell>(file, kMostCellMib);
  try {
    program::StrictJson read = program::read_strict_json(text);
    if (read.duplicate_key) throw BadCell(fmt::format("{}: duplicate key \"{}\"", file.string(), *read.duplicate_key));
    if (read.too_deep)
      throw BadCell(fmt::format("{}: is nested deeper than {} levels", file.string(), program::kMostLevels));
    return read;
  } catch (const program::NotJson& error) {
    throw BadCell(fmt::format("{}: is not JSON: {}", file.string(), error.what()));
  }
}

std::map<std::string, std::vector<std::string>> presets_of(const CellEntry& whole) {
  std::map<std::string, std::vector<std::string>> presets;
  if (const auto entry = whole.find("presets"))
    for (const auto& [name, changes] : entry->members())
      for (const CellEntry& change : changes.items()) presets[name].push_back(change.text());
  return presets;
}

/// The paths of all values, and those of numbers.
struct Paths {
  std::set<std::string> all, numbers;

  void take(const CellEntry& entry) {
    if (!entry.path().empty()) all.insert(entry.path());
    if (entry.is_number()) numbers.insert(entry.path());
    if (entry.is_object())
      for (const auto& [key, member] : entry.members()) take(member);
    if (entry.is_array())
      for (const CellEntry& item : entry.items()) take(item);
  }
};

void read_labels(std::map<std::string, Label>& labels, const CellEntry& whole) {
  const CellEntry entry = whole.at("labels");
  Paths paths;
  for (const auto& [key, member] : whole.members())
    if (key != "labels") paths.take(member);
  for (const auto& [path, label] : entry.members()) {
    const std::string word = label.text();
    if (word.size() != 1 || std::string("TSDC").find(word) == std::string::npos)
      label.bad("must be \"T\", \"S\", \"D\" or \"C\"");
    if (paths.all.count(path) == 0) label.bad("there is no value of this path");
    labels[path] = static_cast<Label>(word[0]);
  }
  for (const std::string& path : paths.numbers) {
    try {
      (void)label_of(labels, path);
    } catch (const std::out_of_range& error) {
      entry.bad(error.what());
    }
  }
}

}  // namespace

std::map<std::string, std::vector<std::string>> read_presets(const std::filesystem::path& file) {
  const program::StrictJson json = load(file);
  return presets_of(CellEntry(file.string(), "", json.value));
}

std::vector<std::string> preset(const std::filesystem::path& file, const std::string& name) {
  const auto presets = read_presets(file);
  const auto found = presets.find(name);
  if (found != presets.end()) return found->second;
  std::string names;
  for (const auto& [each, changes] : presets) names += (names.empty() ? "" : ", ") + each;
  throw BadCell(fmt::format("{}: presets: no preset is named \"{}\"; there are: {}", file.string(), name, names));
}

Plant read_plant(const std::filesystem::path& file, const std::optional<std::filesystem::path>& meshes,
                 const std::vector<std::string>& changes) {
  program::StrictJson json = load(file);
  for (const std::string& change : changes) change_cell(json.value, change);
  const CellEntry whole(file.string(), "", json.value);
  whole.has_only({"name", "unit", "step", "clearance", "meshes", "robot", "robots", "gripper", "storage", "storages",
                  "machine", "machines", "material", "materials", "obstacles", "zones", "labels", "presets"});
  static_cast<void>(presets_of(whole));
  const std::filesystem::path folder = file.parent_path();
  SolidContext context{read_unit(whole.at("unit")), folder.empty() ? "." : folder};
  if (const auto given = whole.find("meshes")) context.mesh_folder = folder / given->text();
  if (meshes) context.mesh_folder = *meshes;
  if (!std::filesystem::is_directory(context.mesh_folder))
    whole.at("meshes").bad("there is no folder " + context.mesh_folder.string());

  Plant plant{.file = file,
              .name = whole.at("name").text(),
              .unit = context.unit,
              .step = whole.at("step").positive(),
              .clearance = whole.at("clearance").positive()};
  if (plant.step > 90) whole.at("step").bad(fmt::format("must be at most 90, is {}", plant.step));
  read_things(plant, whole, folder, context);
  read_labels(plant.labels, whole);
  for (std::size_t i = 0; i < plant.pieces.size(); ++i) check_cell(cell_of(plant, i));
  return plant;
}

void check_cell(const Cell& cell) {
  for (const Joint& joint : cell.robot.joints) {
    const double stops = (joint.upper - joint.lower) / cell.step;
    if (stops > kMostStops)
      throw BadCell(fmt::format(
          "{}: step: at {:g} degrees a stop, joint \"{}\" would take {:.3g} stops from {:g} to {:g} degrees; at "
          "most {:g} are allowed",
          cell.file.string(), cell.step, joint.name, stops, joint.lower, joint.upper, kMostStops));
  }
  if (const auto fault = reach_fault(cell)) throw BadCell(fmt::format("{}: {}", cell.file.string(), *fault));
}

Cell read_cell(const std::filesystem::path& file, const std::optional<std::filesystem::path>& meshes,
               const std::vector<std::string>& changes) {
  return cell_of(read_plant(file, meshes, changes), 0);
}

std::size_t piece_named(const Plant& plant, const std::string& name) {
  std::string names;
  for (std::size_t i = 0; i < plant.pieces.size(); ++i) {
    if (plant.pieces[i].name == name) return i;
    names += (names.empty() ? "" : ", ") + plant.pieces[i].name;
  }
  throw BadCell(
      fmt::format("{}: no piece of material is named \"{}\"; there are: {}", plant.file.string(), name, names));
}

}  // namespace touchstone::cell
