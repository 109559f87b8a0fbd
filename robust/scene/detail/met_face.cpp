// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/met_face.h"

#include <algorithm>
#include <cstddef>

#include "robust/filtered/detail/prepared.h"

namespace touchstone::scene {

std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> MetFace::place(const Feature& feature) const {
  if (feature.kind == Feature::Kind::Face) return std::nullopt;
  if (polygon != nullptr && !parts_of(*polygon).exact_form().bigint.planar()) return std::nullopt;
  const auto vertex = [this](std::size_t i) -> Eigen::Vector3d {
    if (!triangle) return parts_of(*polygon).polygon.vertex(i);
    return i == 0 ? triangle->a : i == 1 ? triangle->b : triangle->c;
  };
  const std::size_t i = feature.index;
  Eigen::Vector3d first = vertex(i);
  if (feature.kind == Feature::Kind::Vertex) return std::pair(first, first);
  Eigen::Vector3d second = vertex(triangle ? (i + 1) % 3 : parts_of(*polygon).polygon.next(i));
  if (std::lexicographical_compare(second.begin(), second.end(), first.begin(), first.end())) std::swap(first, second);
  return std::pair(first, second);
}

exact::PreparedPolygon MetFace::exactly() const {
  return exact::PreparedPolygon(triangle ? Polygon({triangle->a, triangle->b, triangle->c})
                                         : parts_of(*polygon).polygon);
}

}  // namespace touchstone::scene
