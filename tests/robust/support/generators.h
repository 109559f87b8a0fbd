// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::contact_tests {

/// A ball and a polygon that `exact::validate` accepts.
struct Case {
  std::string id;  ///< the id of the sample, and what was done to it
  Ball ball;
  Polygon polygon;
};

/// One line in the contract's form, so that a counterexample goes straight into `touchstone judge`.
void showValue(const Case& drawn, std::ostream& out);

/// Which samples of touchstone::workloads are drawn, and how they are made worse.
struct Draw {
  std::vector<workloads::Placement> placements{workloads::Placement::LatticeFrame, workloads::Placement::Rotated};
  std::vector<workloads::BallPlace> balls = workloads::all_ball_places();
  std::size_t fewest_holes = 0;
  std::size_t most_holes = 2;
  double farthest = 0x1p20;    ///< from the origin, in sizes
  int largest_warp = 18;       ///< half of the samples have vertices moved by up to 2^(warp - 20) of the size; 0: none
  int largest_exponent = 900;  ///< a third of the samples are scaled by 2^e, |e| up to this, where that is exact
};

/// The cases with one hole or one vertex less, as far as `exact::validate` accepts them: smaller counterexamples.
[[nodiscard]] std::vector<Case> with_less(const Case& c, std::size_t fewest_holes = 0);

/// Samples of all families; shrinks in vertices, holes, doubles, warp and exponent, then vertex by vertex.
[[nodiscard]] rc::Gen<Case> samples(const Draw& draw = {});

/// Small integers throughout, where ties, touching, and feet on edges and vertices are common: loops on a grid of 7 x 7
/// in the planes x = h, y = h or z = h, with or without a hole, at most `largest_warp` off it.
[[nodiscard]] rc::Gen<Case> grid_cases(int largest_warp = 0);

/// The same cases, but every zero of each has the sign of a random bit.
[[nodiscard]] rc::Gen<Case> with_signed_zeros(rc::Gen<Case> gen);

/// The values of a generator that knows some draws to be impossible, with signed zeros.
[[nodiscard]] rc::Gen<Case> possible(rc::Gen<std::optional<Case>> gen);

/// Samples and grid cases.
[[nodiscard]] rc::Gen<Case> any_case();

}  // namespace touchstone::contact_tests
