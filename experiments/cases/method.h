// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cases {

/// A question about a polygon: a ball at a place, or one that moves.
using Question = std::variant<Ball, Motion>;
/// Returns the ball; of one that moves, at its start.
[[nodiscard]] inline const Ball& ball_of(const Question& question) {
  const auto* motion = std::get_if<Motion>(&question);
  return motion ? motion->ball : std::get<Ball>(question);
}
/// Returns the question about a ball with another radius.
[[nodiscard]] Question with_radius(Question question, double radius);

/// The kinds of queries: a single test of the contract, or all keys of the answer.
enum class QueryKind { Contact, Relation, PlaneSide, Foot, EdgesHit, Answer };

/// A mesh under a pose. Every face is valid, as the mesh has it and posed.
class PosedMesh {
 public:
  /// Poses the faces (posing.h), of which there must be one. Throws Rejected: `not-finite` if a vertex or the pose is
  /// not finite, and else the rejection of the first bad face, which the message names.
  explicit PosedMesh(Mesh mesh, const Pose& pose = {});

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Returns the faces of the mesh with their posed vertices.
  [[nodiscard]] const std::vector<Polygon>& faces() const { return faces_; }
  /// Returns the numbers of the faces, the first of equals first: faces of three vertices, then the others, ascending.
  [[nodiscard]] const std::vector<std::size_t>& order() const { return order_; }

 private:
  Mesh mesh_;
  Pose pose_;
  std::vector<Polygon> faces_;
  std::vector<std::size_t> order_;
};

/// An answer with the keys of the contract, about a ball at a place or about a moving ball; a key is absent if the
/// method does not compute it or could not decide it. The keys that the contract calls `null` are absent, too.
struct PartialAnswer {
  std::optional<PlaneSide> plane;
  std::optional<bool> plane_tangent;
  std::optional<PointLocation> foot;
  std::optional<std::vector<std::size_t>> edges_hit;
  std::optional<std::vector<std::size_t>> touched;  ///< faces of a mesh
  std::optional<Relation> relation;
  std::optional<bool> contact;
  std::optional<FirstContactKind> first;
  std::optional<double> time;  ///< infinite if there is no contact
  std::optional<bool> momentary;
  std::optional<std::size_t> face;  ///< of a mesh: the nearest, or the first that is touched
  std::optional<Feature> feature;
  std::optional<Feature> nearest;
  std::optional<Eigen::Vector3d> point;
  std::optional<double> distance;
  std::optional<Eigen::Vector3d> contact_normal;
  std::optional<double> depth;
  std::optional<double> off_plane;
  bool unsure = false;     ///< the method computes a requested key, but could not decide it
  std::string_view stage;  ///< the stage that decided, for --explain

  /// Returns a partial answer with all keys of `answer`.
  static PartialAnswer of(const Answer& answer, std::string_view stage);
  /// Returns a partial answer about a moving ball with all keys of the contract.
  static PartialAnswer of(const FirstContact& first, double off_plane, std::string_view stage);
  /// Returns the answer about a mesh: what `of_face` says of its nearest or first face, the number of that face, if the
  /// ball has one, and those that it touches.
  static PartialAnswer of_mesh(PartialAnswer of_face, std::size_t face, std::vector<std::size_t> touched);
};

/// A polygon or a mesh prepared by one method. Queries do not change it; several threads may query it at once.
class PreparedMethod {
 public:
  virtual ~PreparedMethod() = default;
  /// Returns at least the key of the query, if the method computes it; for QueryKind::Answer all keys that it computes.
  [[nodiscard]] virtual PartialAnswer ask(const Ball& ball, QueryKind kind) const = 0;
  /// Returns all keys about a moving ball that the method computes, or nothing if it cannot answer about moving balls.
  [[nodiscard]] virtual std::optional<PartialAnswer> ask_moving(const Motion& motion) const;
  /// Returns all keys that the method computes, likewise.
  [[nodiscard]] std::optional<PartialAnswer> answer(const Question& question) const;
};

/// A way to answer queries: one of ours, a historical one, or a third-party engine. Each method has its own file.
///
/// Requires polygons that `exact::validate` accepts, and balls and motions for which `find_fault` finds nothing.
class Method {
 public:
  using Prepare = std::function<std::unique_ptr<PreparedMethod>(const Polygon& polygon)>;
  using PrepareMesh = std::function<std::unique_ptr<PreparedMethod>(const PosedMesh& mesh)>;
  enum class Kind {
    Usual,
    Slow,  ///< a query takes tens of microseconds; studies may ask such a method fewer queries
    Pipe,  ///< a program behind a pipe answers: its times include JSON, the pipe and two changes of process, and each of
           ///< its answers has all keys that it computes, whatever the query
  };

  /// `summary`: one line. `prepare`: several threads may call it at once. Without `prepare_mesh`, a mesh is asked face
  /// by face.
  Method(std::string name, std::string summary, Prepare prepare, Kind kind = Kind::Usual,
         PrepareMesh prepare_mesh = nullptr)
      : name_(std::move(name)),
        summary_(std::move(summary)),
        prepare_(std::move(prepare)),
        prepare_mesh_(std::move(prepare_mesh)),
        kind_(kind) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] std::string_view summary() const { return summary_; }
  [[nodiscard]] bool slow() const { return kind_ == Kind::Slow; }
  [[nodiscard]] bool through_pipe() const { return kind_ == Kind::Pipe; }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const { return prepare_(polygon); }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const PosedMesh& mesh) const;

 private:
  std::string name_, summary_;
  Prepare prepare_;
  PrepareMesh prepare_mesh_;
  Kind kind_;
};

}  // namespace touchstone::cases
