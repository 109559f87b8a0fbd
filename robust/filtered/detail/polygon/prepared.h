// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/polygon/edge_tree.h"
#include "robust/filtered/detail/polygon/frame.h"
#include "robust/filtered/detail/signs/bigint_polygon.h"
#include "robust/filtered/filtered.h"

namespace touchstone::filtered {
namespace detail {

/// The lifted polygon in double-doubles, in the frame's unit of length but along the axes of the input.
struct LiftedPolygon {
  Vector3<DoubleDouble> normal;     ///< each component N_k to kDoubleDoubleUnit |N_k| + kNormalUnderflow (bounds.h)
  DoubleDouble per_square;          ///< 1 / N.N, to bounds::kPerSquare
  double normal_maximum;            ///< an upper bound of the magnitudes of its components
  bool exact_normal;                ///< whether the normal above is exact
  DoubleDouble slope_a, slope_b;    ///< N_a / N_k and N_b / N_k, to bounds::kSlope: k is the dropped axis, a the next
  std::vector<DoubleDouble> lifts;  ///< along the dropped axis, to bounds::kLift; empty if nothing is lifted
};

}  // namespace detail

/// A prepared polygon: what every query needs at once, and what few queries need, made for the first of them. Several
/// threads may query at once.
struct PreparedPolygon::Parts {
  /// Copies a polygon that will be queried often; keeps a reference to one that is queried once.
  explicit Parts(const Polygon& polygon, detail::EdgeIndex::Use use = detail::EdgeIndex::Use::Often);

 private:
  std::optional<Polygon> owned_;

 public:
  const Polygon& polygon;
  std::optional<detail::Frame> frame;  ///< empty if scaling would lose bits, or beyond kMostEdges; then `exact` answers
  detail::GivenPlane plane;            ///< that of the frame, if it may be used
  std::optional<detail::EdgeIndex> edges;  ///< in the frame, if there is one

  /// The polygon in integers of any size, and in double-doubles that are rounded from these if there is a frame.
  struct ExactForm {
    detail::BigIntPolygon bigint;
    detail::LiftedPolygon lifted;

    ExactForm(detail::BigIntPolygon integers, detail::LiftedPolygon doubles)
        : bigint(std::move(integers)), lifted(std::move(doubles)) {}
  };
  [[nodiscard]] __attribute__((always_inline)) const ExactForm& exact_form() const {
    const ExactForm* const made = made_form_.load(std::memory_order_acquire);
    return made != nullptr ? *made : make_exact_form();
  }
  /// Returns the polygon prepared for `exact`.
  [[nodiscard]] const exact::PreparedPolygon& exact() const;
  /// Makes everything that a query may need.
  void complete() const;

 private:
  /// Sets `frame` and `edges`, if the frame may be used. Returns the integers if double-doubles left the plane
  /// uncertain.
  std::optional<detail::BigIntPolygon> find_frame(detail::EdgeIndex::Use use);
  const ExactForm& make_exact_form() const;
  void keep_exact_form(detail::BigIntPolygon bigint) const;

  mutable std::once_flag form_once_, exact_once_;
  mutable std::unique_ptr<ExactForm> form_;
  mutable std::atomic<const ExactForm*> made_form_{nullptr};
  mutable std::optional<exact::PreparedPolygon> exact_;
};

/// Returns what was prepared; its type is complete in prepared.h. Requires a polygon that was not moved from.
[[nodiscard]] inline const PreparedPolygon::Parts& parts_of(const PreparedPolygon& polygon) { return *polygon.parts_; }

}  // namespace touchstone::filtered
