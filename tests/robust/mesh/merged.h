// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robust/mesh/merge.h"

namespace touchstone::mesh_tests {

using Numbers = std::vector<std::uint32_t>;

/// Every merged face by the faces that it is made of.
[[nodiscard]] std::vector<Numbers> groups(const mesh::MergedMesh& merged);

/// Expects what holds for every mesh: each face is accounted for once, and everything is a polygon.
void expect_sound(const Mesh& mesh, const mesh::MergedMesh& merged, const std::string& what);

}  // namespace touchstone::mesh_tests
