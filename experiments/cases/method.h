// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cases {

/// What can be asked of a method: one of the contract's tests alone, or all of its keys.
enum class Question { Contact, Relation, PlaneSide, Foot, EdgesHit, Answer };

/// The keys of the contract, each present where the method computes it and knows it.
struct PartialAnswer {
  std::optional<PlaneSide> plane;
  std::optional<bool> plane_tangent;
  std::optional<PointLocation> foot;
  std::optional<std::vector<std::size_t>> edges_hit;
  std::optional<Relation> relation;
  std::optional<bool> contact;
  std::optional<Feature> nearest;
  std::optional<Eigen::Vector3d> point;
  std::optional<double> distance;
  std::optional<double> off_plane;
  bool unsure = false;     ///< a key that was asked for, and that the method computes, is absent: it could not decide
  std::string_view stage;  ///< which stage decided, for --explain

  /// All keys of a whole answer.
  static PartialAnswer of(const Answer& answer, std::string_view stage);
};

/// A polygon as one method has prepared it. Asking changes nothing and is safe from several threads.
class PreparedMethod {
 public:
  virtual ~PreparedMethod() = default;
  /// At least the key that the question names, if the method computes it; with Question::Answer all that it computes.
  [[nodiscard]] virtual PartialAnswer ask(const Ball& ball, Question question) const = 0;
};

/// One way to answer: ours, a historical one, or another engine. One file a method.
///
/// Requires polygons that `exact::validate` accepts and balls that `find_fault` accepts.
class Method {
 public:
  virtual ~Method() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view summary() const = 0;  ///< one line
  /// Does a question take tens of microseconds? Studies may ask such a method less than others.
  [[nodiscard]] virtual bool slow() const { return false; }
  [[nodiscard]] virtual std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const = 0;
};

}  // namespace touchstone::cases
