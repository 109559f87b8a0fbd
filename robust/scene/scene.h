// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/contact/first_contact.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/motion.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/triangle.h"

/// The parts that the library alone uses.
namespace touchstone::scene::detail {
class NearestSearch;
struct TriangleSet;
}  // namespace touchstone::scene::detail

/// Exact contact with many faces under poses. The cost of a query grows with the number of faces near the ball.
///
/// Guarantees, for every ball that `find_fault` accepts and faces that `exact::validate` accepts, or degenerate
/// triangles where Faces says so:
///  (1) a face is reported as touched if and only if `exact::contact` of the ball and that face is true, whatever the
///      caller's rounding mode and flush-to-zero setting, and however many threads run a batch. The faces of a posed
///      object have posed vertices: each coordinate of R p + t is rounded once, to the nearest double (posing.h);
///  (2) the nearest face is the one at the least exact distance; among equal distances the lowest object comes first,
///      then the lowest face number;
///  (3) for every motion that `find_fault` accepts, a face is touched on the way if and only if `exact::contact` of
///      motion and face is true, and the first face is the one whose exact first time is least; among equal times the
///      lowest object comes first, then the lowest face number; `touched_in_order` lists all of them in this order;
///  (4) answers depend on the current poses only: an object that is moved and moved back answers as before;
///  (5) the caller's rounding mode, flush-to-zero setting and INVALID, OVERFLOW and DIVBYZERO flags are left as found.
namespace touchstone::scene {

/// The faces of an object, numbered together from 0: first the triangles, then the polygons.
struct Faces {
  std::vector<Triangle> triangles;  ///< faces 0, 1, ...
  std::vector<Polygon> polygons;    ///< the faces after the triangles
  /// Whether triangles may be degenerate, as they are added and under every pose: they are then segments and points,
  /// whose features have the numbers of the triangle.
  Degenerate degenerate = Degenerate::Refuse;
};

/// A face of an object of a scene. Ordered by object, then by face.
struct FaceId {
  /// @{
  /// The numbers of the object in the scene and of the face in the object, from 0.
  std::uint32_t object, face;
  /// @}
  friend auto operator<=>(const FaceId&, const FaceId&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The face of a scene nearest to a centre.
struct NearestFace {
  FaceId face;                     ///< the lowest of several at the same distance
  Feature feature;                 ///< the feature of that face that contains the closest point
  Eigen::Vector3d point;           ///< the closest point, rounded as in Answer
  double distance;                 ///< rounded as in Answer
  Eigen::Vector3d contact_normal;  ///< as in Answer
  double depth;                    ///< as in Answer
};

/// A face of a scene that a moving ball touches.
struct FirstFace {
  FaceId face;           ///< of the face that is touched first: the lowest of several that are touched at the same time
  FirstContact contact;  ///< the first contact with that face: Start or Way
};

/// A set of named objects, each under a pose. Several threads may query a scene at once, while no object is added,
/// moved or removed.
///
/// A query comes only to the objects whose boxes the ball may touch, at rest or on its way. The time to find each grows
/// with the logarithm of the number of objects, and so do those to add, move and remove one, unless many boxes overlap.
class Scene {
 public:
  Scene();  ///< makes a scene without objects
  /// @{
  /// A moved-from object may only be assigned to or destroyed.
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  /// @}
  ~Scene();

  /// Adds an object and returns its number; objects are numbered from 0 in the order in which they are added.
  ///
  /// Throws std::invalid_argument if the name is taken; Rejected, naming the object and the face, for a triangle that
  /// expect_valid (posing.h) rejects and for a polygon without a normal; and whatever set_pose throws. Cost: about
  /// 1 us per triangle; 0.1 us per vertex of a polygon, and 1 to 3 us more in the first query whose ball comes near it.
  /// Memory: about 52 bytes per triangle of a closed mesh, 60 more where no two triangles share a vertex, and more if
  /// the triangles lie so that leaves hold few.
  std::uint32_t add(std::string name, Faces faces, const Pose& pose = {});

  /// Removes an object. Its number is not given again, and its name is free. Throws std::out_of_range if there is no
  /// object with this number. Cost: that of freeing its memory.
  void remove(std::uint32_t object);

  /// Sets the pose of an object. Its vertices are computed from those that were added, not from their current
  /// positions, so errors do not accumulate. Triangles are posed only when a ball comes so near that their exact
  /// positions matter, if R is within 2^-20 of a multiple of a rotation or reflection, and if a bound shows that
  /// rounding makes no triangle invalid, or degenerate triangles are valid. Else all are posed at once. Polygons always
  /// are, and are prepared again when a ball comes near.
  ///
  /// Throws std::out_of_range if there is no object with this number; Rejected, naming the object, if the pose is not
  /// finite (`not-finite`) or if exact::validate rejects the posed vertices of a face (the lowest such face). The
  /// object then keeps its pose. Cost: about 1 us for any number of triangles that need not be posed, and up to 10 us
  /// among 10,000 objects; for others about 0.4 us per triangle, or 1.2 us if they need a new hierarchy; 1.2 us per
  /// vertex of a polygon. All but the refitting of hierarchies is divided among all cores. Memory: as much again while
  /// all are posed.
  void set_pose(std::uint32_t object, const Pose& pose);
  /// Returns the pose of an object. Throws std::out_of_range, as above.
  [[nodiscard]] const Pose& pose(std::uint32_t object) const;

  /// Returns how many objects were added: their numbers are below this.
  [[nodiscard]] std::size_t object_count() const { return objects_.size(); }
  /// Returns whether there is an object with this number, which was not removed.
  [[nodiscard]] bool has(std::uint32_t object) const { return object < objects_.size() && objects_[object] != nullptr; }
  /// Returns the name under which an object was added. Throws std::out_of_range, as above.
  [[nodiscard]] const std::string& name(std::uint32_t object) const;
  /// Returns the number of the object with this name. Throws std::invalid_argument if no object has it.
  [[nodiscard]] std::uint32_t find(std::string_view name) const;
  /// Returns the number of faces of an object. Throws std::out_of_range, as above.
  [[nodiscard]] std::size_t face_count(std::uint32_t object) const;
  /// Returns the memory that the object's triangles and their hierarchy occupy, in bytes. Throws std::out_of_range, as
  /// above.
  [[nodiscard]] std::size_t triangle_memory(std::uint32_t object) const;

  /// The objects that take part in a query: all, or some. A query throws std::out_of_range if one of the numbers
  /// belongs to no object, whatever the answer.
  class Objects {
   public:
    Objects() = default;  ///< selects all objects
    /// Selects the objects with these numbers.
    Objects(std::vector<std::uint32_t> numbers);  // NOLINT: it is a set of objects

   private:
    friend class Scene;
    [[nodiscard]] bool has(std::uint32_t number) const;

    std::optional<std::vector<std::uint32_t>> some_;
  };

  /// Returns whether the ball touches any face.
  [[nodiscard]] bool touches(const Ball& ball, const Objects& objects = {}) const;
  /// Returns the faces that the ball touches, ascending.
  [[nodiscard]] std::vector<FaceId> touched(const Ball& ball, const Objects& objects = {}) const;
  /// Returns the face nearest to the ball's centre; nothing if there are no faces. Cost: a few times that of `touches`
  /// for a ball that reaches the nearest face. Each further face at exactly the same distance adds 20 us, unless it
  /// shares the nearest vertex or edge. A triangle whose coordinates, as seen from the centre, are all below 2^-200, or
  /// not all below 2^200, adds up to 30 us if the search comes to it.
  [[nodiscard]] std::optional<NearestFace> nearest(const Ball& ball, const Objects& objects = {}) const;
  /// Returns that face alone, for a finite centre. Cost: less than that of `nearest`, which rounds point, distance and
  /// normal.
  [[nodiscard]] std::optional<FaceId> nearest_face(const Eigen::Vector3d& center, const Objects& objects = {}) const;

  /// Returns whether the moving ball touches any face at any time. This is the contact of the capsule around the
  /// centre's way, too. Cost: that of the faces near the way.
  [[nodiscard]] bool touches(const Motion& motion, const Objects& objects = {}) const;
  /// Returns the faces that the moving ball touches at any time, or the capsule touches, ascending.
  [[nodiscard]] std::vector<FaceId> touched(const Motion& motion, const Objects& objects = {}) const;
  /// Returns the faces that the moving ball touches at any time, each with its first contact, in the order of their
  /// exact first times; among equal times the lowest face comes first. Cost: that of `touched`, and that of
  /// filtered::first_contact for each; and 100 us for each comparison of times that round to the same double.
  [[nodiscard]] std::vector<FirstFace> touched_in_order(const Motion& motion, const Objects& objects = {}) const;
  /// Returns the face that the moving ball touches first; nothing if it touches none. Cost: that of the faces near the
  /// way up to that time, and 0.3 to 0.6 us to round time and point. Each further face at exactly the same time adds
  /// 100 us, unless it shares the touched vertex or edge.
  [[nodiscard]] std::optional<FirstFace> first_contact(const Motion& motion, const Objects& objects = {}) const;

  /// @{
  /// The same for many balls or motions, on all cores of the machine: answer i is that of number i. Throws
  /// std::invalid_argument if the spans differ in length. Cost: balls walk together through the triangles of each
  /// object, in any order, if there are at most 64 objects, and 64 balls or more for each core in the search for the
  /// nearest face, or 1,024 in the question of contact. In one object of a thousand to a million triangles, 100,000
  /// balls take 0.4 to 0.9 of the time of single ones on one core in `touches` and `nearest`: the less, the nearer the
  /// balls are to each other. In `touched`, which makes a vector for each ball, they take 0.6 to 1.4. Motions are asked
  /// one by one. Among 65,536 faces and more those that start near each other follow each other: 100,000 among a
  /// million triangles take 0.7 of the time of single ones on one core.
  void touches(std::span<const Ball> balls, std::span<bool> answers, const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::vector<FaceId>> touched(std::span<const Ball> balls,
                                                         const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::optional<NearestFace>> nearest(std::span<const Ball> balls,
                                                                const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::optional<FaceId>> nearest_face(std::span<const Eigen::Vector3d> centers,
                                                                const Objects& objects = {}) const;
  void touches(std::span<const Motion> motions, std::span<bool> answers, const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::vector<FaceId>> touched(std::span<const Motion> motions,
                                                         const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::vector<FirstFace>> touched_in_order(std::span<const Motion> motions,
                                                                     const Objects& objects = {}) const;
  [[nodiscard]] std::vector<std::optional<FirstFace>> first_contact(std::span<const Motion> motions,
                                                                    const Objects& objects = {}) const;
  /// @}

  /// Takes the answer about ball number i.
  using TakeNearest = std::function<void(std::size_t i, const std::optional<NearestFace>& face)>;
  /// The same as `nearest` for many balls, but passes each answer to `take` instead of returning all in a vector: for
  /// callers that keep answers in another form. Calls `take` once for each ball, in any order, from several threads at
  /// once, in round to nearest without flush-to-zero. Ends with the exception of `take`, which it throws on.
  void nearest(std::span<const Ball> balls, const TakeNearest& take, const Objects& objects = {}) const;

 private:
  friend class Solid;
  struct Object;
  struct Index;

  /// Throws std::out_of_range, as above.
  [[nodiscard]] const Object& at(std::uint32_t number) const;
  /// Returns the triangles of an object. Throws std::out_of_range, as above.
  [[nodiscard]] const detail::TriangleSet& triangles(std::uint32_t object) const;
  /// Throws std::out_of_range if one of these numbers belongs to no object.
  void expect(const Objects& objects) const;
  /// Returns the object under another pose.
  static std::unique_ptr<const Object> moved(const Object& object, const Pose& pose);

  /// Calls f(number, object) for each of these, ascending. Stops if it returns true, and returns whether it did.
  template <class F>
  bool any_of(const Objects& objects, const F& f) const;
  /// @{
  /// The same for those of these whose faces the ball may touch, and perhaps for others. A moving ball comes to them in
  /// any order.
  template <class F>
  bool any_near(const Ball& ball, const Objects& objects, const F& f) const;
  template <class F>
  bool any_near(const Motion& motion, const Objects& objects, const F& f) const;
  /// @}
  /// Returns how many faces these have.
  [[nodiscard]] std::size_t face_count(const Objects& objects) const;
  /// Returns how many these are.
  [[nodiscard]] std::size_t count_of(const Objects& objects) const;
  /// Returns whether these are looked for by their boxes. If not, they are asked one by one.
  [[nodiscard]] bool by_boxes(const Objects& objects) const;

  // Contact with a ball or a motion.
  template <class Query>
  bool touches_any(const Query& query, const Objects& objects) const;
  template <class Query>
  std::vector<FaceId> all_touched(const Query& query, const Objects& objects) const;
  /// Passes to the search the faces of an object that may be nearest.
  static void search_nearest(detail::NearestSearch& search, std::uint32_t number, const Object& object);
  /// Passes to the search all faces that may be nearest.
  void search_nearest(detail::NearestSearch& search, const Objects& objects) const;
  /// Calls answer(i, search) for each ball i, with a search that has met all faces that may be nearest; where that is a
  /// single one, only if only_one(i, face) returns false.
  template <class OnlyOne, class Answer>
  void nearest_each(std::span<const Ball> balls, const Objects& objects, const OnlyOne& only_one,
                    const Answer& answer) const;
  /// Passes to the search for first contacts the faces that it wants.
  template <class Search>
  void search_on_way(Search& search, const Motion& motion, const Objects& objects) const;
  // The queries for many motions.
  template <class Answer>
  std::vector<Answer> answers_to(std::span<const Motion> motions, const Objects& objects,
                                 Answer (Scene::*answer)(const Motion&, const Objects&) const) const;

  std::vector<std::unique_ptr<const Object>> objects_;  ///< null where one was removed
  std::unique_ptr<Index> index_;
};

}  // namespace touchstone::scene
