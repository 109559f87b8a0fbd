// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/nearest_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robust/exact/exact.h"

namespace touchstone::scene {

NearestSearch::NearestSearch(const Eigen::Vector3d& center) : ball_{center, std::numeric_limits<double>::max()} {}

void NearestSearch::meet(const Triangle& triangle, std::uint32_t number) {
  meet(Polygon({triangle.a, triangle.b, triangle.c}), number);
}

void NearestSearch::meet(const Polygon& polygon, std::uint32_t number) {
  const exact::PreparedPolygon prepared(polygon);
  Answer answer = exact::answer({ball_.center, 0}, prepared);
  const FaceId id{first_.object, first_.face + number};
  if (found_) {
    // Distances whose doubles differ are in the same order.
    const double known = found_->answer.distance;
    const int order = answer.distance != known
                          ? (answer.distance < known ? -1 : 1)
                          : exact::compare_distances(ball_, prepared, exact::PreparedPolygon(found_->face));
    if (order > 0 || (order == 0 && id > found_->id)) return;
  }
  ball_.radius = std::min(std::nextafter(answer.distance, std::numeric_limits<double>::infinity()),
                          std::numeric_limits<double>::max());
  found_.emplace(Found{id, polygon, std::move(answer)});
}

}  // namespace touchstone::scene
