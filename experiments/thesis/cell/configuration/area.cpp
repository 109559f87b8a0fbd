// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/configuration/area.h"

#include <algorithm>
#include <utility>

#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/solid_faces.h"

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
                                             const std::atomic<bool>& stop, const run::Progress& progress) {
  std::vector<Tried> tried(grid.size());
  const std::size_t heights = grid.heights.size(), radii = grid.radii.size();
  const std::uint64_t done = run::run_blocks(tried.size(), threads, stop, progress, [&](unsigned, std::uint64_t i) {
    tried[i] = try_place(cell, parts, covered, rule, grid.angles[i / heights / radii], grid.radii[i / heights % radii],
                         grid.heights[i % heights]);
  });
  if (done < tried.size()) return std::nullopt;
  return tried;
}

}  // namespace touchstone::cell
