// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/area.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/command_run.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/solid.h"
#include "experiments/thesis/cell/run_options.h"

namespace touchstone::cell {

std::vector<ModelPart> with_stand(std::vector<ModelPart> parts, const Station& storage) {
  for (ModelPart& part : parts)
    if (storage.stand && part.carrier == Carrier::Storage && part.name == storage.name + "/stand")
      part.faces = faces_of(stand_of(storage), part.name);
  return parts;
}

Tried try_place(Cell cell, const std::vector<ModelPart>& parts,
                const std::shared_ptr<const std::vector<Covered>>& covered, const Rule& rule, double angle,
                double radius, double height) {
  cell.storage.angle = angle;
  cell.storage.radius = radius;
  cell.storage.height = height;
  if (auto fault = reach_fault(cell)) return {angle, radius, height, FailureCause::OutOfReach, std::move(*fault)};
  Process process = simulate({cell, with_stand(parts, cell.storage), covered}, rule);
  const auto contact = std::ranges::find(process.moves, Until::Contact, &Move::until);
  const bool from_side = contact != process.moves.end() && contact->joint == kBase;
  return {angle, radius, height, process.cause, std::move(process.failure), from_side};
}

std::optional<std::vector<Tried>> try_places(const Cell& cell, const std::vector<ModelPart>& parts,
                                             const std::shared_ptr<const std::vector<Covered>>& covered,
                                             const Grid& grid, const Rule& rule, unsigned threads,
                                             const std::atomic<bool>& stop, const program::Progress& progress) {
  std::vector<Tried> tried(grid.size());
  const std::size_t heights = grid.heights.size(), radii = grid.radii.size();
  const std::uint64_t done = program::run_blocks(tried.size(), threads, stop, progress, [&](unsigned, std::uint64_t i) {
    tried[i] = try_place(cell, parts, covered, rule, grid.angles[i / heights / radii], grid.radii[i / heights % radii],
                         grid.heights[i % heights]);
  });
  if (done < tried.size()) return std::nullopt;
  return tried;
}

namespace {

struct AreaOptions : RunOptions, program::FolderOptions {
  double angle_step = 5, length_step = 25;
  unsigned threads = program::all_threads();
};

/// The multiples of a step from `low` to `high`, both at most half a step away.
std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> values;
  for (long i = std::lround(low / step); i <= std::lround(high / step); ++i)
    values.push_back(static_cast<double>(i) * step);
  return values;
}

/// The table of the tried places; `row`: what varies.
program::Table<Tried> tried_table(const std::string& file, const std::string& row) {
  return {file,
          row,
          {{"angle_deg", "of the storage about the robot", &Tried::angle},
           {"radius", "from the robot's axis, in the cell's unit", &Tried::radius},
           {"height", "in the cell's unit", &Tried::height},
           {"outcome", "completed, or the cause of the failure",
            [](const Tried& tried) { return tried.cause ? to_string(*tried.cause) : std::string_view("completed"); }},
           {"reason", "what failed", &Tried::reason}}};
}

program::Table<Tried> plan_csv() { return tried_table("plan.csv", "an angle and radius of the storage"); }

program::Table<Tried> heights_csv() { return tried_table("heights.csv", "a height and radius of the storage"); }

struct StationRow {
  std::string_view name;
  const Station* station;
};

const program::Table<StationRow>& stations_csv() {
  using program::path;
  static const program::Table<StationRow> table(
      "stations.csv", "a station of the cell",
      {{"station", "storage or machine", &StationRow::name},
       {"home_deg", "its home angle", path(&StationRow::station, &Station::home)},
       {"angle_deg", "the angle from there", path(&StationRow::station, &Station::angle)},
       {"radius", "from the robot's axis", path(&StationRow::station, &Station::radius)},
       {"height", "above the floor", path(&StationRow::station, &Station::height)}});
  return table;
}

std::string table_of(const std::vector<Tried>& tried) {
  std::array<std::size_t, 7> counts{};
  for (const Tried& each : tried) ++counts[each.cause ? static_cast<std::size_t>(*each.cause) + 1 : 0];
  std::string text = fmt::format("{} completed", counts[0]);
  for (const FailureCause cause : {FailureCause::OutOfReach, FailureCause::JointLimit, FailureCause::NoContact,
                                   FailureCause::NotHeld, FailureCause::Misplaced, FailureCause::InTheWay})
    text += fmt::format(", {} {}", counts[static_cast<std::size_t>(cause) + 1], to_string(cause));
  return text;
}

int run(const AreaOptions& options) {
  program::CommandRun run(options);
  const Cell cell = cell_of(options);
  const auto parts = build_model(cell);
  const auto covered = std::make_shared<const std::vector<Covered>>(cover_arm(parts));
  const Reach reach = reach_of(cell);
  const double step = options.length_step, furthest = reach.furthest() + step,
               lowest = cell.storage.stand ? step - cell.storage.stand->top : 0;
  constexpr double kMostPlaces = 1e7;
  if (const double places = furthest / step * (360 / options.angle_step + (reach.height + reach.outer - lowest) / step);
      !(places <= kMostPlaces))
    throw std::invalid_argument(fmt::format("--length-step {:g}: that is about {:.2g} places; at most {:g} are tried",
                                            step, places, kMostPlaces));
  const std::vector<double> radii = multiples(step, furthest, step);
  const Grid plan{multiples(-180, 180 - options.angle_step, options.angle_step), radii, {cell.storage.height}};
  const Grid heights{{cell.storage.angle}, radii, multiples(lowest, reach.height + reach.outer, step)};

  std::optional<std::vector<Tried>> in_plan, in_height;
  {
    program::ProgressLine line = run.progress("places of the storage", plan.size() + heights.size());
    in_plan = try_places(cell, parts, covered, plan, rule_of(options), options.threads, run.stop(), std::ref(line));
    if (in_plan)
      in_height = try_places(cell, parts, covered, heights, rule_of(options), options.threads, run.stop(),
                             [&](std::uint64_t done) { line(plan.size() + done); });
  }
  if (!in_height) return run.finish_unwritten();
  plan_csv().write(run.folder(), *in_plan);
  heights_csv().write(run.folder(), *in_height);
  stations_csv().write(run.folder(), {{"storage", &cell.storage}, {"machine", &cell.machine}});
  const std::uint64_t places = plan.size() + heights.size();
  return run.finish({.samples_asked = places, .samples_done = places, .threads = options.threads},
                    fmt::format("{}\nangle x radius at height {:g}: {}\nheight x radius at angle {:g}: {}\n", cell.name,
                                cell.storage.height, table_of(*in_plan), cell.storage.angle, table_of(*in_height)),
                    "cell_area");
}

}  // namespace

program::Command area_command() {
  program::Command command("area", "Find where the storage may stand: the area of configuration and the heights");
  auto options = std::make_shared<AreaOptions>();
  options->output = "results/cell-area";
  command.help().footer =
      "Runs the whole process with the storage at every place of a grid, and reports which runs complete, and why "
      "the others do not. Writes plan.csv (angles and radii at the storage's height), heights.csv (heights and "
      "radii at its angle), stations.csv, and pictures of them.";
  command.text("CELL", options->file, "A cell file (JSON): `cell new` writes one, docs/formats.md has its keys")
      .required();
  add_cell_options(command, *options);
  command.real("--angle-step", options->angle_step, "Between angles, in degrees", 0.1, 90.0);
  program::declare_positive(command, "--length-step", options->length_step,
                            "Between radii, and between heights, in the cell's unit");
  program::declare_threads(command, options->threads);
  program::declare_output(command, *options, "Folder for the CSV files, run.json and pictures", true);
  program::declare_quiet(command, options->quiet);
  command.writes({plan_csv().description(), heights_csv().description(), stations_csv().description()});
  command.help().examples.emplace_back(
      "cell area experiments/thesis/cell/cells/aristo.json --angle-step 90 --length-step 2000");
  command.runs([options] { return run(*options); });
  return command;
}

}  // namespace touchstone::cell
