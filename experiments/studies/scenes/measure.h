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
#include "robust/scene/scene.h"

namespace touchstone::scenes {

/// The faces of a mesh that are polygons of the contract.
struct Object {
  std::string name;
  scene::Faces faces;                  ///< triangles first
  std::vector<std::uint32_t> numbers;  ///< indices of these faces in the mesh, from 0
  std::vector<std::string> rejected;   ///< a sentence for each of the first other faces, with its place in the file
  std::uint64_t faces_rejected = 0;    ///< the number of all other faces
};

/// Takes every face of the mesh as it is. Cost: that of exact::validate per face.
[[nodiscard]] Object object_of(workloads::NamedFile file);

enum class Question { Any, All, Nearest };

/// The answer to one ball; only the members that the question requires are set.
struct BallAnswer {
  std::vector<scene::FaceId> touched;         ///< All: ascending. Any: at most one of them
  std::optional<scene::NearestFace> nearest;  ///< Nearest: set unless there are no faces
  std::uint64_t unsure = 0;  ///< faces about which the method could not decide; they count as not touched
};

struct Order {
  Question question = Question::All;
  std::vector<std::uint32_t> objects{};  ///< ascending
  unsigned threads = 1;                  ///< does not change answers
};

/// Queries the scene about the balls; returns the answers to the first ones, to all unless stopped.
[[nodiscard]] std::vector<BallAnswer> ask_scene(const scene::Scene& scene, const Order& order,
                                                std::span<const NamedBall> balls, const std::atomic<bool>& stop);

/// Asks a method about every ball and every face of the objects; returns no answers if stopped.
///
/// Compares distances as the method rounds them: among equal ones the lowest object and face is nearest. Throws
/// std::invalid_argument if the method does not compute the requested answer. Prepares the faces itself, block by
/// block.
[[nodiscard]] std::vector<BallAnswer> ask_every_face(const cases::Method& method, const std::vector<Object>& objects,
                                                     const Order& order, std::span<const NamedBall> balls,
                                                     const std::atomic<bool>& stop, const run::Progress& progress);

/// Returns the number of blocks of faces that ask_every_face processes for some balls, as its progress counts them.
[[nodiscard]] std::uint64_t face_blocks(const std::vector<Object>& objects, const Order& order);

/// Returns a line of JSON: `id` and `ball` as in a case of the contract, then the requested answer: `touches`,
/// `touched` (object and face) or `nearest` (object, face, feature, point and distance; null if there are no faces).
/// Faces have the numbers of their mesh.
[[nodiscard]] std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
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
