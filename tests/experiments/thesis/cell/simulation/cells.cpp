// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/thesis/cell/simulation/cells.h"

#include <algorithm>
#include <optional>

namespace touchstone::cell {

const std::shared_ptr<const std::vector<Covered>>& covered_aristo() {
  static const auto covered = std::make_shared<const std::vector<Covered>>(cover_arm(build_model(read_cell(kAristo))));
  return covered;
}

Workcell aristo(const std::vector<std::string>& changes) {
  static const auto parts = build_model(read_cell(kAristo));
  const Cell cell = read_cell(kAristo, std::nullopt, changes);
  const bool as_it_was = std::ranges::none_of(changes, [](const std::string& change) {
    for (const char* part : {"solid", "parts", "height", "stand", "obstacles", "storages", "machines", "robots"})
      if (change.find(part) != std::string::npos) return true;
    return false;
  });
  return {cell, as_it_was ? parts : build_model(cell), covered_aristo()};
}

}  // namespace touchstone::cell
