// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/cases/workloads/meshes.h"
#include "experiments/run/sweep.h"
#include "experiments/studies/scenes/balls.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {

/// The faces of a mesh that are polygons of the contract.
struct Object {
  std::string name;
  scene::Faces faces;                               ///< triangles first
  std::vector<std::vector<std::uint32_t>> numbers;  ///< the faces of the mesh of which each was made, from 0, ascending
  std::vector<mesh::SegmentFace> segments;          ///< the faces of the mesh that are taken as segments, ascending
  std::vector<double> off_plane;      ///< how far the vertices of each are from its plane, as in an answer
  std::vector<std::string> rejected;  ///< a sentence for each of the first other faces, with its place in the file
  std::uint64_t faces_rejected = 0;   ///< the number of all other faces
};

/// How the faces of a mesh become those of an object: each as it is; those that lie in one plane merged
/// (mesh::merge_faces); or each as it is, and one whose corners lie on one line as a segment or a point.
enum class Taken { Alone, Merged, AsSegments };

/// Returns the object of a mesh. Cost: that of mesh::scene_faces or mesh::merge_faces.
[[nodiscard]] Object object_of(workloads::NamedFile file, Taken taken);

enum class Question { Any, All, Nearest };

/// A face that a moving ball touches, and its first contact, with the keys that the method computes.
struct FaceOnWay {
  scene::FaceId face;
  cases::PartialAnswer first;
};

/// The answer to one ball; only the members that the question requires are set.
struct BallAnswer {
  std::vector<scene::FaceId> touched;         ///< All: ascending. Any: at most one of them
  std::vector<FaceOnWay> on_way;              ///< All, for a ball that moves: these faces in the order of their times
  std::optional<scene::NearestFace> nearest;  ///< Nearest: set unless there are no faces
  std::uint64_t unsure = 0;  ///< faces about which the method could not decide; they count as not touched
};

struct Order {
  Question question = Question::All;
  bool merged = false;
  std::vector<std::uint32_t> objects{};  ///< ascending
  unsigned threads = 1;                  ///< does not change answers
};

/// Queries the scene about the balls; returns the answers to the first ones, to all unless stopped.
[[nodiscard]] std::vector<BallAnswer> ask_scene(const scene::Scene& scene, const Order& order,
                                                std::span<const NamedBall> balls, const std::atomic<bool>& stop);

/// Asks a method about every ball and every face of the objects; returns no answers if stopped.
///
/// Compares distances and times as the method rounds them: among equal ones the lowest object and face is first. Throws
/// std::invalid_argument if the method does not compute the requested answer. Prepares the faces itself, block by
/// block.
[[nodiscard]] std::vector<BallAnswer> ask_every_face(const cases::Method& method, const std::vector<Object>& objects,
                                                     const Order& order, std::span<const NamedBall> balls,
                                                     const std::atomic<bool>& stop, const run::Progress& progress);

/// Returns the number of blocks of faces that ask_every_face processes for some balls, as its progress counts them.
[[nodiscard]] std::uint64_t face_blocks(const std::vector<Object>& objects, const Order& order);

/// Returns a line of JSON for each of the answers, which may be fewer than the balls: `id`, `ball` and `motion` as in a
/// case of the contract, then the requested answer: `touches`, `touched` (object and face; of a ball that moves also
/// the first contact) or `nearest` (object, face, feature, point and distance; null if there are no faces). Faces have
/// the numbers of their mesh: `face` or, if they are merged, `faces`. A face that is not planar has `off_plane`; one
/// that is taken as a segment has `corners`, which are the vertices of its degenerate triangle.
[[nodiscard]] std::vector<std::string> answer_lines(std::span<const NamedBall> balls,
                                                    std::span<const BallAnswer> answers, const Order& order,
                                                    const std::vector<Object>& objects);

/// The differences between a method's answers and the scene's. They are compared here, not by cases::differing_keys,
/// because they name faces of the scene.
struct Differences {
  std::uint64_t balls = 0;
  std::uint64_t answers = 0;    ///< balls with another answer: touched or not, other faces, or another nearest face
                                ///< at another distance
  std::uint64_t distances = 0;  ///< Nearest: balls with another distance
  std::uint64_t unsure = 0;     ///< balls for which the method could not decide about some face

  void add(const BallAnswer& given, const BallAnswer& truth, Question question);
};

}  // namespace touchstone::scenes
