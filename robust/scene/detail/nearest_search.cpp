// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/nearest_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::scene::detail {

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
  return triangle ? exact::PreparedPolygon(*triangle) : exact::PreparedPolygon(parts_of(*polygon).polygon);
}

namespace {

using Eigen::Vector3d;

constexpr double kLargestDouble = std::numeric_limits<double>::max();

filtered::NoCounts uncounted;

Feature nearest_feature(const Vector3d& center, const Triangle& triangle) {
  const Ball point{center, 0};
  return filtered::detail::kernels().plain.triangle_nearest(filtered::detail::view_of(point, triangle), uncounted);
}

double feature_distance(const Vector3d& center, const Triangle& triangle, const Feature& feature) {
  const Ball point{center, 0};
  return filtered::detail::kernels().plain.triangle_distance(filtered::detail::view_of(point, triangle), feature,
                                                             uncounted);
}

}  // namespace

NearestSearch::NearestSearch(const Ball& given) : given_radius_(given.radius), ball_{given.center, kLargestDouble} {}

bool NearestSearch::touched(const Met& met) const {
  if (!has_shrunk()) return true;
  const MetFace& face = met.face;
  return face.triangle ? filtered::contact(ball_, *face.triangle) : filtered::contact(ball_, *face.polygon);
}

void NearestSearch::shrink_to(double distance) {
  ball_.radius = std::min(ball_.radius, std::nextafter(distance, std::numeric_limits<double>::infinity()));
}

bool NearestSearch::has_shrunk() const { return ball_.radius < kLargestDouble; }

void NearestSearch::shrink(const Triangle& triangle) {
  shrink_to(feature_distance(ball_.center, triangle, nearest_feature(ball_.center, triangle)));
}

void NearestSearch::expect(const filtered::PreparedPolygon& polygon) {
  if (has_shrunk()) return;
  const Vector3d vertex = parts_of(polygon).polygon.vertex(0);
  const Ball around{ball_.center,
                    (vertex - ball_.center).norm() * (1 + 0x1p-40) + parts_of(polygon).exact_form().bigint.off_plane()};
  if (around.radius < kLargestDouble && filtered::contact(around, polygon)) ball_.radius = around.radius;
}

void NearestSearch::meet(const Triangle& triangle, std::uint32_t number) {
  met_.push_back({{{first_.object, first_.face + number}, triangle}, std::nullopt, std::nullopt});
}

void NearestSearch::meet(const filtered::PreparedPolygon& polygon, std::uint32_t number) {
  const Answer answer = filtered::answer({ball_.center, 0}, polygon);
  met_.push_back({{{first_.object, first_.face + number}, polygon},
                  answer.nearest,
                  filtered::ClosestPoint{answer.nearest, answer.point, answer.distance, answer.contact_normal}});
  shrink_to(answer.distance);
}

const Feature& NearestSearch::feature(Met& met) const {
  if (!met.feature) met.feature = nearest_feature(ball_.center, *met.face.triangle);
  return *met.feature;
}

double NearestSearch::distance(Met& met) const {
  if (met.closest) return met.closest->distance;
  return feature_distance(ball_.center, *met.face.triangle, feature(met));
}

int NearestSearch::compare(const Met& first, double first_distance, const Met& second, double second_distance) const {
  // Distances whose doubles differ are in the same order.
  if (first_distance != second_distance) return first_distance < second_distance ? -1 : 1;
  return exact::compare_distances(ball_, first.face.exactly(), second.face.exactly());
}

NearestSearch::Met* NearestSearch::best() {
  Met* best = nullptr;
  std::optional<double> least;  // the distance of the best face
  // A face that the ball does not touch is farther than some other that it touches.
  for (Met& met : met_) {
    if (best == nullptr) {
      best = &met;
      continue;
    }
    int order = 0;
    std::optional<double> here = least;
    if (const auto at = met.face.place(feature(met));
        !at || at != best->face.place(feature(*best))) {  // exact: coordinates as they were given
      if (!touched(met)) continue;
      if (!least) least = distance(*best);
      here = distance(met);
      order = compare(met, *here, *best, *least);
    }
    if (order < 0 || (order == 0 && met.face.id < best->face.id)) best = &met, least = here;
  }
  return best;
}

std::optional<FaceId> NearestSearch::nearest_face() {
  const Met* const found = best();
  return found == nullptr ? std::nullopt : std::optional(found->face.id);
}

std::optional<NearestFace> NearestSearch::nearest() {
  const Met* const best = this->best();
  if (best == nullptr) return std::nullopt;
  const Ball given{ball_.center, given_radius_};
  filtered::ClosestPoint closest{};
  double depth = 0;
  if (best->closest) {
    closest = *best->closest;
    depth = given_radius_ > 0 ? filtered::answer(given, *best->face.polygon).depth : 0.0 - closest.distance;
  } else {
    filtered::detail::kernels().plain.triangle_closest(filtered::detail::view_of(given, *best->face.triangle), closest,
                                                       &depth, uncounted);
  }
  return NearestFace{best->face.id, closest.feature, closest.point, closest.distance, closest.contact_normal, depth};
}

}  // namespace touchstone::scene::detail
