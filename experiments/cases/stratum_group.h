// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/cases/threshold.h"
#include "experiments/run/table.h"

namespace touchstone::cases {

/// The strata behind a row of a table: one stratum, or those that differ in their family alone.
struct StratumGroup {
  std::string family;  ///< `all` for several
  workloads::Placement placement;
  Threshold threshold;
  std::vector<std::size_t> strata;
};

/// Returns each stratum of the families, then the groups of all of them.
[[nodiscard]] std::vector<StratumGroup> stratum_groups(const std::vector<workloads::Family>& families);

/// Returns the columns `family`, `placement` and `threshold`; `group`: a member of Row that points to a StratumGroup.
template <class Row>
[[nodiscard]] std::vector<run::Column<Row>> stratum_columns(const StratumGroup* Row::*group) {
  return {{"family", "the family of polygons, or `all`", [group](const Row& row) { return (row.*group)->family; }},
          {"placement", "on the lattice, or rotated", [group](const Row& row) { return (row.*group)->placement; }},
          {"threshold", "the threshold that balls cross", [group](const Row& row) { return (row.*group)->threshold; }}};
}

}  // namespace touchstone::cases
