// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/run/blocks.h"
#include "experiments/studies/scenes/balls.h"
#include "experiments/studies/scenes/objects.h"
#include "robust/scene/scene.h"

namespace touchstone::scenes {

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

}  // namespace touchstone::scenes
