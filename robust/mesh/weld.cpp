// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/weld.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

#include "geometry/detail/floating_point_state.h"

namespace touchstone::mesh {

namespace {

void expect_mesh(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (mesh.vertices[i].hasNaN()) throw std::invalid_argument("vertex " + std::to_string(i) + " of the mesh is NaN");
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
    for (const std::uint32_t vertex : mesh.faces[face])
      if (vertex >= mesh.vertices.size())
        throw std::invalid_argument("face " + std::to_string(face) + " of the mesh has vertex " +
                                    std::to_string(vertex) + "; there are " + std::to_string(mesh.vertices.size()));
}

}  // namespace

Mesh weld(const Mesh& mesh) {
  const FloatingPointState nearest;
  expect_mesh(mesh);
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    const Eigen::Vector3d &p = mesh.vertices[i], &q = mesh.vertices[j];
    return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
  };
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return less(i, j) || (!less(j, i) && i < j); });

  std::vector<std::uint32_t> first(count);  // the first of equal vertices
  for (std::uint32_t k = 0; k < count; ++k)
    first[order[k]] = k > 0 && !less(order[k - 1], order[k]) ? first[order[k - 1]] : order[k];

  Mesh welded;
  std::vector<std::uint32_t> number(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (first[i] == i) {
      number[i] = static_cast<std::uint32_t>(welded.vertices.size());
      welded.vertices.push_back(mesh.vertices[i]);
    } else {
      number[i] = number[first[i]];
    }
  }
  welded.faces = mesh.faces;
  for (auto& face : welded.faces)
    for (std::uint32_t& vertex : face) vertex = number[vertex];
  return welded;
}

}  // namespace touchstone::mesh
