// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/triangle.h"
#include "counts.h"

/// Many faces at once: exact contact questions about whole scenes, at a price that grows with what a ball is near.
///
/// Guarantees, for every ball that `find_fault` accepts and faces that `exact::validate` accepts:
///  (1) a face is said to be touched exactly where `exact::contact` of the ball and that face is true, whatever the
///      caller's rounding mode and flush-to-zero setting, and however many threads a batch has; a posed object's faces
///      are those of its posed vertices, each coordinate of R p + t rounded once to the nearest double (posing.h);
///  (2) the nearest face is the one of least exact distance; among equal distances that of the lowest object, then of
///      the lowest number;
///  (3) answers depend on where objects stand, not on how they came there: moved and moved back is as before;
///  (4) the caller's rounding mode, flush-to-zero setting and INVALID, OVERFLOW and DIVBYZERO flags are left as found.
namespace touchstone::scene {

/// The faces of an object: triangles first, then polygons, numbered together from 0.
struct Faces {
  std::vector<Triangle> triangles;  ///< first
  std::vector<Polygon> polygons;    ///< then
};

/// A face of an object of a scene. Ordered by object, then by number.
struct FaceId {
  /// @{
  /// Their numbers, from 0.
  std::uint32_t object, face;
  /// @}
  friend auto operator<=>(const FaceId&, const FaceId&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The face of a scene that is nearest to a centre.
struct NearestFace {
  FaceId face;            ///< the lowest of equals
  Feature feature;        ///< of that face
  Eigen::Vector3d point;  ///< of that face, rounded as in Answer
  double distance;        ///< rounded as in Answer
};

/// Objects by name, each under a pose. Asking is safe from several threads, while nothing is added or moved.
class Scene {
 public:
  Scene();  ///< no objects
  /// @{
  /// One that was moved from may only be assigned to or destroyed.
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  /// @}
  ~Scene();

  /// Returns the number of the object: objects are numbered from 0 as they are added. Throws std::invalid_argument for
  /// a name that is taken, Rejected naming the object and the face for a triangle that exact::validate rejects as a
  /// polygon and for a polygon without a normal, and what set_pose throws. Cost: about 1 us a triangle, 0.1 us a vertex
  /// of a polygon, and 1 to 3 us more in the first question whose ball comes near; memory: about 90 bytes a triangle,
  /// up to 120 where they lie so that leaves hold few.
  std::uint32_t add(std::string name, Faces faces, const Pose& pose = {});

  /// Moves an object from wherever it stands: its vertices are posed anew from those that were added, so nothing adds
  /// up. Its hierarchies are refitted, or built anew where turning has made their boxes a fifth larger. Polygons are
  /// prepared again when a ball comes near. Throws std::out_of_range for a number that no object has, and Rejected
  /// naming the object for a pose that is not finite (`not-finite`) or a face, the lowest one, whose posed vertices
  /// exact::validate rejects; then the object stays where it was. Cost: about 0.4 us a triangle, 1.2 us where the
  /// hierarchy is built anew, 1.2 us a vertex of a polygon, divided among all cores but for the refitting; memory: 72
  /// bytes more a triangle for as long as the pose is not the identity.
  void set_pose(std::uint32_t object, const Pose& pose);
  /// Where the object stands. Throws std::out_of_range, as above.
  [[nodiscard]] const Pose& pose(std::uint32_t object) const;

  /// How many objects were added.
  [[nodiscard]] std::size_t object_count() const { return objects_.size(); }
  /// The name that it was added by. Throws std::out_of_range, as above.
  [[nodiscard]] const std::string& name(std::uint32_t object) const;
  /// The object of that name. Throws std::invalid_argument where there is none.
  [[nodiscard]] std::uint32_t find(std::string_view name) const;
  /// How many triangles and polygons it has.
  [[nodiscard]] std::size_t face_count(std::uint32_t object) const;
  /// What the object's triangles and their hierarchy occupy in memory, in bytes.
  [[nodiscard]] std::size_t triangle_memory(std::uint32_t object) const;

  /// Which objects are asked about: all, or some. Asking throws std::out_of_range for a number that no object has,
  /// whatever the answer.
  class Objects {
   public:
    Objects() = default;  ///< all
    /// Some.
    Objects(std::vector<std::uint32_t> numbers);  // NOLINT: it is a set of objects

   private:
    friend class Scene;
    std::optional<std::vector<std::uint32_t>> some_;
  };

  /// Does the ball touch any face?
  [[nodiscard]] bool touches(const Ball& ball, const Objects& objects = {}) const;
  /// The faces that the ball touches, ascending.
  [[nodiscard]] std::vector<FaceId> touched(const Ball& ball, const Objects& objects = {}) const;
  /// The face nearest to the ball's centre; none where there is no face. Cost: a few times that of `touches` for a ball
  /// that reaches it; each face at the very same distance that does not share the nearest vertex or edge adds 20 us.
  [[nodiscard]] std::optional<NearestFace> nearest(const Ball& ball, const Objects& objects = {}) const;

  /// @{
  /// The same questions; what became of each face is added to the counts. Cost: twice the time or more.
  [[nodiscard]] bool touches(const Ball& ball, FaceCounts& counts, const Objects& objects = {}) const;
  [[nodiscard]] std::vector<FaceId> touched(const Ball& ball, FaceCounts& counts, const Objects& objects = {}) const;
  [[nodiscard]] std::optional<NearestFace> nearest(const Ball& ball, FaceCounts& counts,
                                                   const Objects& objects = {}) const;
  /// @}

  /// @{
  /// The same for many balls, by all cores of the machine: answer i is that of ball i. Throws std::invalid_argument for
  /// spans of different lengths.
  void touches(std::span<const Ball> balls, std::span<bool> answers, const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::vector<FaceId>> touched(std::span<const Ball> balls,
                                                         const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::optional<NearestFace>> nearest(std::span<const Ball> balls,
                                                                const Objects& objects = {}) const;
  /// @}

 private:
  struct Object;

  /// Throws std::out_of_range, as above.
  [[nodiscard]] const Object& at(std::uint32_t number) const;
  /// Throws it for a number among these that no object has.
  void expect(const Objects& objects) const;
  /// The object under another pose.
  static std::unique_ptr<const Object> moved(const Object& object, const Pose& pose);

  /// Calls f(number, object) for each of these, ascending; stops where it returns true, and returns that.
  template <class F>
  bool any_of(const Objects& objects, const F& f) const;

  // The questions for one way of counting.
  template <class T>
  bool touches(const Ball& ball, const Objects& objects, T& tally) const;
  template <class T>
  std::vector<FaceId> touched(const Ball& ball, const Objects& objects, T& tally) const;
  template <class T>
  std::optional<NearestFace> nearest(const Ball& ball, const Objects& objects, T& tally) const;

  std::vector<std::unique_ptr<const Object>> objects_;
};

}  // namespace touchstone::scene
