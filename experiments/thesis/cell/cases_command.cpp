// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/workcell.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"

namespace touchstone::cell {
namespace {

constexpr double kNearInRadii = 4;  // radii
constexpr std::size_t kMostVertices = 16;

/// The stop at which the sphere is nearest to the face; none where it never is near.
std::optional<std::size_t> nearest_stop(const cell::Process& process, const Polygon& polygon) {
  std::optional<std::size_t> nearest;
  double least = kNearInRadii * process.stops.front().sphere.radius;
  const filtered::PreparedPolygon prepared(polygon);
  for (std::size_t i = 0; i < process.stops.size(); ++i)
    if (const double distance = filtered::answer(process.stops[i].sphere, prepared).distance; distance < least) {
      least = distance;
      nearest = i;
    }
  return nearest;
}

std::string lines_about(const std::string& id, const std::string& origin, const Ball& sphere, const Polygon& polygon) {
  const cases::Shapes at_stop{sphere, polygon};
  const cases::PartialAnswer truth = exact_answer(at_stop);
  std::string lines = corpus::line_of({id, at_stop, {"sphere"}, origin}, truth);
  for (const int doubles : {-1, 0, 1}) {
    const Ball ball{sphere.center, workloads::move_by_doubles(*truth.distance, doubles)};
    if (ball.radius < 0) continue;
    const cases::Shapes shapes{ball, polygon};
    const cases::PartialAnswer there = exact_answer(shapes);
    if (corpus::failing_witnesses(shapes, there).empty()) continue;
    lines += corpus::line_of({fmt::format("{}-k{}", id, doubles),
                              shapes,
                              {"near"},
                              fmt::format("{}, the radius {} doubles beside the distance", origin, doubles)},
                             there);
  }
  return lines;
}

/// Cases of a cell's run, one per line, as experiments/judge/corpus/given/gripper.jsonl holds them. For every face of
/// the obstacles and of the material that the gripper's sphere comes near, takes the stop nearest to the face, with the
/// sphere's own radius; also with the double nearest to the distance and its neighbours, if a witness is wrong there.
/// Not part of `make`, since libraries differ in the last bits of sines and cosines.
std::string gripper_cases(const std::string& cell_file) {
  const cell::Cell cell = cell::read_cell(cell_file, std::nullopt, {});
  const cell::Workcell workcell(cell, cell::build_model(cell));
  const cell::Process process = cell::simulate(workcell);
  const std::string name = std::filesystem::path(cell_file).stem().string();

  std::string text;
  const auto add = [&](const std::string& owner, std::size_t face, const Polygon& polygon) {
    if (polygon.vertex_count() > kMostVertices || exact::validate(polygon)) return;
    const auto stop = nearest_stop(process, polygon);
    if (!stop) return;
    text += lines_about(fmt::format("{}-{}-{}", name, owner, face),
                        fmt::format("touchstone cell cases {}.json: stop {}, face {} of {}", name, *stop, face, owner),
                        process.stops[*stop].sphere, polygon);
  };
  const auto standing = polygons_of(workcell.obstacles().faces);
  for (std::size_t i = 0; i < standing.size(); ++i) add(workcell.obstacles().owners[i], i, standing[i]);
  for (const cell::StationSlot slot : {cell::StationSlot::Storage, cell::StationSlot::Machine}) {
    const auto material = polygons_of(workcell.at(slot).material->faces);
    for (std::size_t i = 0; i < material.size(); ++i)
      add(fmt::format("material-in-{}", to_string(slot)), i, material[i]);
  }
  return text;
}

}  // namespace

program::Command cases_command() {
  program::Command command("cases", "Print the gripper's cases of a run, as the corpus holds them");
  auto file = std::make_shared<std::string>();
  command.text("CELL", *file, "A cell file").required();
  command.help().examples.emplace_back("cell cases experiments/thesis/cell/cells/aristo.json");
  command.runs([file] {
    fmt::print("{}", gripper_cases(*file));
    return 0;
  });
  return command;
}

}  // namespace touchstone::cell
