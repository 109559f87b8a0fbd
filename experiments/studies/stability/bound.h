// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "experiments/studies/stability/axis.h"
#include "experiments/studies/stability/stress.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/filtered.h"

namespace touchstone::stability {

/// The uses of bounds on rounding errors.
enum class BoundStage {
  Maxima,        ///< signs.h in plain doubles, bounded through the largest components (triangle_filter.h)
  Permanent,     ///< signs.h in plain doubles, bounded through the products that were formed (permanent.h)
  DoubleDouble,  ///< signs.h in double-doubles
  Frame,         ///< heights and foot in the isometric frame of a prepared polygon (frame_query.h)
  FastPlanarity  ///< the bound within which `fast` takes a loop for planar: stated there, not proved
};

[[nodiscard]] std::string_view to_string(BoundStage stage);

/// A quantity with a bound.
struct BoundedQuantity {
  BoundStage stage;
  std::string_view name;  ///< from signs.h: vertex, along, ...; from the frame: height, along, across
  /// The bound is `constant` x condition x |exact value|, except for underflow: the line of a picture.
  double constant;
};

[[nodiscard]] const std::vector<BoundedQuantity>& bounded_quantities();

/// One computed number, compared with the exact one.
struct Observation {
  std::size_t quantity;   ///< index in bounded_quantities()
  double tightness;       ///< |computed - exact| / bound
  bool holds;             ///< compared exactly: |computed - exact| <= bound
  double condition;       ///< the bound without its constant factor / |exact|; infinite if the exact value is zero
  double relative_error;  ///< |computed - exact| / |exact|; NaN if the exact value is zero
};

/// A polygon with its exact lifted loops, in rationals, with which its bounds are compared.
class BoundTrial {
 public:
  /// Keeps a reference. Cost: linear, about 10 us per vertex.
  explicit BoundTrial(const Polygon& polygon);

  /// Returns all bounded quantities of a ball and an edge, each only if the filter would use it: within its window.
  /// Maxima and Frame are computed in the given mode, for which they are proved; the others in the default mode, as in
  /// the filter. Bounds are multiplied by `bound_factor`. Cost: about 100 us.
  void observe(const Ball& ball, std::size_t edge, const FloatingPointMode& mode, double bound_factor,
               std::vector<Observation>& observations) const;

 private:
  void observe_signs_in_doubles(const Ball&, std::size_t, const FloatingPointMode&, double,
                                std::vector<Observation>&) const;
  void observe_prepared_signs(const Ball&, std::size_t, double, std::vector<Observation>&) const;
  void observe_frame(const Ball&, std::size_t, const FloatingPointMode&, double, std::vector<Observation>&) const;
  void observe_fast(std::size_t vertex, double, std::vector<Observation>&) const;

  const Polygon& polygon_;
  filtered::PreparedPolygon prepared_;
  RationalVector normal_;  ///< the Newell sum of the outer loop
  std::vector<RationalVector> lifted_;
  double fast_noise_;
  Eigen::Vector3d fast_normal_;
};

}  // namespace touchstone::stability
