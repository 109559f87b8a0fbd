// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc.h"
#include "experiments/thesis/cell/first_contact/arc_pieces.h"
#include "experiments/thesis/cell/first_contact/chart.h"
#include "experiments/thesis/cell/first_contact/exact_face.h"
#include "geometry/contact/answer.h"

namespace touchstone::kinematics {

/// A ball whose centre moves along an arc, and one face: computes exactly the roots at which the ball touches.
class ArcFace {
 public:
  ArcFace(const Arc& arc, double radius, const Polygon& polygon);

  struct Contact {
    Moment moment;
    Feature feature;
    bool grazing;
  };
  /// Returns the first contact after the start with a feature near the arc, on the whole turn of 360 degrees or at most
  /// up to `latest`, which only saves time.
  [[nodiscard]] std::optional<Contact> first(const ArcPieces& pieces, double latest);
  [[nodiscard]] const Charts& charts() const { return charts_; }

 private:
  struct Piece;

  [[nodiscard]] std::optional<Root> face_root(const Piece& piece) const;
  [[nodiscard]] std::optional<Root> edge_root(const Piece& piece, std::size_t edge) const;
  [[nodiscard]] std::optional<Root> vertex_root(const Piece& piece, std::size_t vertex) const;
  [[nodiscard]] bool foot_inside(const PolynomialVector& foot, const Polynomial& weight, Root& root) const;

  int unit_;
  ExactFace face_;
  Charts charts_;
  IntegerVector start_, center_, spoke_;  // of the arc, and start - center, in the units of the face
  mpz_class radius_;
  std::vector<Eigen::Vector3d> points_;  // the vertices before they are lifted
};

}  // namespace touchstone::kinematics
