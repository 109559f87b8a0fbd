// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <urdf_model/model.h>

#include <optional>
#include <string>
#include <vector>

namespace touchstone::cell {

/// The names of the first and the last link of the arm within a URDF's tree.
struct UrdfEnds {
  std::optional<std::string> root;  ///< if none, the root of the tree
  std::optional<std::string> tip;   ///< if none, chain_of chooses
};

/// Returns the links of the arm, from the first to the last; each but the first is the child of the one before.
///
/// Without `tip` the arm leads to the end that most turning joints carry, among them none that mimics another or is
/// mimicked, as those of grippers are. If several ends are equal, the arm ends at the last link that carries them all.
///
/// Throws BadCell, whose message begins with `file`, for links that do not form a tree, for a name that no link has, a
/// root that does not carry the tip, and if equal ends part before the last of those joints: then `tip` must be given.
/// Cost: linear in the number of links times the depth of the tree.
[[nodiscard]] std::vector<urdf::LinkConstSharedPtr> chain_of(const urdf::ModelInterface& model, const UrdfEnds& ends,
                                                             const std::string& file);

}  // namespace touchstone::cell
