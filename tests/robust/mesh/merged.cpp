// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/mesh/merged.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "robust/exact/validate.h"

namespace touchstone::mesh_tests {

std::vector<Numbers> groups(const mesh::MergedMesh& merged) {
  std::vector<Numbers> groups;
  for (const mesh::MergedFace& face : merged.faces) groups.push_back(face.faces);
  return groups;
}

void expect_sound(const Mesh& mesh, const mesh::MergedMesh& merged, const std::string& what) {
  Numbers seen;
  for (const mesh::MergedFace& face : merged.faces) {
    EXPECT_EQ(exact::validate(face.polygon), std::nullopt) << what;
    EXPECT_TRUE(std::is_sorted(face.faces.begin(), face.faces.end())) << what;
    seen.insert(seen.end(), face.faces.begin(), face.faces.end());
  }
  for (const auto& rejected : merged.rejected) seen.push_back(rejected.face);
  std::sort(seen.begin(), seen.end());
  Numbers all(mesh.faces.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(seen, all) << what;
}

}  // namespace touchstone::mesh_tests
