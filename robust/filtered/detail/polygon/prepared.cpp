// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/polygon/prepared.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "geometry/detail/floating_point_state.h"
#include "robust/filtered/detail/kernels.h"

namespace touchstone::filtered {

using namespace detail;

namespace {

/// Returns the lifts that bring N.(p - p_0) to the height of the plane.
std::vector<DoubleDouble> lifts(const Polygon& polygon, const Frame& frame, const Vector3<DoubleDouble>& normal,
                                const DoubleDouble& height) {
  std::vector<DoubleDouble> result;
  const auto from_origin = [&](std::size_t i, int axis) {
    return two_difference(frame.unit.scaled(polygon.coordinates(axis)[i]), frame.origin[axis]);
  };
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    const Vector3<DoubleDouble> p{from_origin(i, 0), from_origin(i, 1), from_origin(i, 2)};
    result.push_back((height - dot(normal, p)) / normal[frame.dropped_axis]);
  }
  return result;
}

Vector3<DoubleDouble> normal_of(const BigIntPolygon& bigint, int exponent) {
  return {bigint.normal(0, -2 * exponent), bigint.normal(1, -2 * exponent), bigint.normal(2, -2 * exponent)};
}

LiftedPolygon lifted_polygon(const Polygon& polygon, const BigIntPolygon& bigint, const Frame& frame) {
  const int exponent = frame.unit.exponent;
  const Vector3<DoubleDouble> normal = normal_of(bigint, exponent);
  const int k = frame.dropped_axis;
  LiftedPolygon lifted{.normal = normal,
                       .per_square = DoubleDouble(1) / dot(normal, normal),
                       .normal_maximum = 0,
                       .exact_normal = true,
                       .slope_a = normal[(k + 1) % 3] / normal[k],
                       .slope_b = normal[(k + 2) % 3] / normal[k],
                       .lifts = {}};
  for (int axis = 0; axis < 3; ++axis) {
    lifted.normal_maximum = std::max(lifted.normal_maximum, std::abs(lifted.normal[axis].high));
    lifted.exact_normal = lifted.exact_normal && bigint.normal_fits(axis, -2 * exponent);
  }
  if (!bigint.planar()) lifted.lifts = lifts(polygon, frame, lifted.normal, bigint.plane_height(-3 * exponent));
  return lifted;
}

}  // namespace

PreparedPolygon::Parts::Parts(const Polygon& loops, EdgeIndex::Use use)
    : owned_(use != EdgeIndex::Use::Once ? std::optional(loops) : std::nullopt), polygon(owned_ ? *owned_ : loops) {
  std::optional<BigIntPolygon> bigint = find_frame(use);
  if (!frame && !bigint) bigint.emplace(polygon);  // throws if there is no supporting plane
  if (bigint) keep_exact_form(std::move(*bigint));
}

std::optional<BigIntPolygon> PreparedPolygon::Parts::find_frame(EdgeIndex::Use use) {
  if (polygon.vertex_count() > EdgeTree::kMostEdges) return std::nullopt;
  const LengthUnit unit = frame_unit(polygon);
  const auto vertices = scaled_vertices(polygon, unit);
  if (!vertices) return std::nullopt;
  // A polygon parallel to a coordinate plane may be arbitrarily far from it, in units of its size.
  for (const double coordinate : vertices->front().coordinates)
    if (std::abs(coordinate) > Frame::kReach) return std::nullopt;
  const std::size_t outer = polygon.loop_end(0);
  NewellPlane newell(kernels().newell_sums(vertices->data(), outer), std::span(*vertices).first(outer));
  std::optional<BigIntPolygon> bigint;
  if (!newell.certain) {
    bigint.emplace(polygon);
    newell.take_exact(normal_of(*bigint, unit.exponent), bigint->dropped_axis());
  }
  if (!newell.certain) return bigint;
  if (auto in_frame = framed(polygon, *vertices, unit, newell)) {
    frame = in_frame->frame;
    plane = GivenPlane(*frame);
    edges.emplace(std::move(in_frame->edges), polygon, use);
  }
  return bigint;
}

void PreparedPolygon::Parts::keep_exact_form(BigIntPolygon bigint) const {
  LiftedPolygon lifted = frame ? lifted_polygon(polygon, bigint, *frame) : LiftedPolygon{};
  form_ = std::make_unique<ExactForm>(std::move(bigint), std::move(lifted));
  made_form_.store(form_.get(), std::memory_order_release);
}

const PreparedPolygon::Parts::ExactForm& PreparedPolygon::Parts::make_exact_form() const {
  const FloatingPointState nearest;
  std::call_once(form_once_, [this] { keep_exact_form(BigIntPolygon(polygon)); });
  return *form_;
}

const exact::PreparedPolygon& PreparedPolygon::Parts::exact() const {
  std::call_once(exact_once_, [this] { exact_.emplace(polygon); });
  return *exact_;
}

void PreparedPolygon::Parts::complete() const {
  (void)exact_form();
  (void)exact();  // for balls that are too far away for the frame
  if (edges && !edges->is_scanned()) (void)edges->tree();
}

PreparedPolygon::PreparedPolygon(const Polygon& polygon) {
  const FloatingPointState nearest;
  parts_ = std::make_unique<const Parts>(polygon);
}
PreparedPolygon::PreparedPolygon(PreparedPolygon&&) noexcept = default;
PreparedPolygon& PreparedPolygon::operator=(PreparedPolygon&&) noexcept = default;
PreparedPolygon::~PreparedPolygon() = default;

void PreparedPolygon::complete() const { parts_->complete(); }

}  // namespace touchstone::filtered
