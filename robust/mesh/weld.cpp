// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/weld.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include "geometry/detail/floating_point_state.h"

namespace touchstone::mesh {

namespace {

/// Returns the vertices that are finite or that a face uses, ascending.
std::vector<std::uint32_t> kept_vertices(const Mesh& mesh) {
  std::vector<bool> kept(mesh.vertices.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = mesh.vertices[i].allFinite();
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
    for (const std::uint32_t vertex : mesh.faces[face]) {
      const bool exists = vertex < kept.size();
      if (!exists || mesh.vertices[vertex].hasNaN())
        throw std::invalid_argument("face " + std::to_string(face) + " of the mesh has vertex " +
                                    std::to_string(vertex) +
                                    (exists ? ", which is NaN" : "; there are " + std::to_string(kept.size())));
      kept[vertex] = true;
    }
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < kept.size(); ++i)
    if (kept[i]) numbers.push_back(i);
  return numbers;
}

}  // namespace

Mesh weld(const Mesh& mesh) {
  const FloatingPointState nearest;
  const std::vector<std::uint32_t> kept = kept_vertices(mesh);
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    const Eigen::Vector3d &p = mesh.vertices[i], &q = mesh.vertices[j];
    return std::tie(p.x(), p.y(), p.z()) < std::tie(q.x(), q.y(), q.z());
  };
  std::vector<std::uint32_t> order = kept;
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return less(i, j) || (!less(j, i) && i < j); });

  std::vector<std::uint32_t> first(mesh.vertices.size());  // the first of equal vertices
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && !less(order[k - 1], order[k]) ? first[order[k - 1]] : order[k];

  Mesh welded;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (const std::uint32_t i : kept) {
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
