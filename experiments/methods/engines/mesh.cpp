// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/engines/mesh.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace touchstone::methods {

// Sorts in place of a map: the nodes of a map would leave holes in the heap, where libraries that are timed then build.
Mesh::Mesh(std::span<const Triangle> all) : triangles(all), corners(all.size()) {
  const auto vertex = [&](std::size_t i) -> const Eigen::Vector3d& {
    const Triangle& t = all[i / 3];
    return i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c;
  };
  std::vector<std::size_t> order(3 * all.size()), first(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
    const Eigen::Vector3d &v = vertex(i), &w = vertex(j);
    return std::tie(v.x(), v.y(), v.z(), i) < std::tie(w.x(), w.y(), w.z(), j);
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool again = k > 0 && vertex(order[k]) == vertex(order[k - 1]);
    first[order[k]] = again ? first[order[k - 1]] : order[k];
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::int32_t& number = corners[i / 3][i % 3];
    if (first[i] == i) {
      number = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(vertex(i));
    } else {
      number = corners[first[i] / 3][first[i] % 3];
    }
  }
}

}  // namespace touchstone::methods
