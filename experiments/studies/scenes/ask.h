// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/harness/blocks.h"
#include "experiments/studies/scenes/balls.h"
#include "experiments/studies/scenes/objects.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {

enum class Question { Any, All, Nearest };

/// To one ball; what the question asks for.
struct BallAnswer {
  std::vector<scene::FaceId> touched;         ///< All: ascending. Any: one of them, if there is one
  std::optional<scene::NearestFace> nearest;  ///< Nearest, where there is a face
  scene::FaceCounts counts;                   ///< of scene::Scene alone
  std::uint64_t unsure = 0;                   ///< faces about which the method could not decide; taken as not touched
};

struct Order {
  Question question = Question::All;
  std::vector<std::uint32_t> objects{};  ///< ascending
  unsigned threads = 1;                  ///< they change no answer
};

/// Asks the scene about the balls; returns the answers to the first ones, all unless stopped.
[[nodiscard]] std::vector<BallAnswer> ask_scene(const scene::Scene& scene, const Order& order,
                                                std::span<const NamedBall> balls, const std::atomic<bool>& stop);

/// Asks a method about every ball and every face of the objects; returns no answers if stopped.
///
/// Distances are compared as the method rounds them: among equal ones the lowest object and face is nearest. Throws
/// std::invalid_argument if the method does not compute what is asked for. Faces are prepared anew, some at a time.
[[nodiscard]] std::vector<BallAnswer> ask_every_face(const cases::Method& method, const std::vector<Object>& objects,
                                                     const Order& order, std::span<const NamedBall> balls,
                                                     const std::atomic<bool>& stop, const harness::Progress& progress);

/// How many blocks of faces ask_every_face goes through for some balls, as its progress counts them.
[[nodiscard]] std::uint64_t face_blocks(const std::vector<Object>& objects, const Order& order);

}  // namespace touchstone::scenes
