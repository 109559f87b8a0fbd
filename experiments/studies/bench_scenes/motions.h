// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "experiments/run/timing.h"
#include "experiments/studies/bench_scenes/library.h"
#include "experiments/studies/bench_scenes/measure.h"
#include "geometry/shapes/motion.h"

namespace touchstone::bench_scenes {

/// Draws motions of balls that are near the surface, and do not touch it at their start, in random directions; a
/// function of the arguments. There may be fewer than `count`: balls that touch are left out. Requires the exact scene.
[[nodiscard]] std::vector<Motion> draw_motions(MotionLength length, const std::vector<Triangle>& triangles,
                                               BuiltScene& exact, std::uint64_t count, std::uint64_t seed);

/// A library and the scene that it has built.
struct Sweeping {
  const Library* library;
  std::shared_ptr<BuiltScene> scene;
};

/// The time in units of the whole motion by which an answer may differ from the exact one without being wrong.
inline constexpr double kTimeTolerance = 1e-6;
/// The goals: the time of a short sweep, relative to that of the question whether the ball touches anything at its
/// start; and that of every other library, relative to the exact one's.
inline constexpr timing::Goal kShortGoal{2}, kSweepGoal{1, false};
/// The name of the candidate that asks about the ball at its start.
inline constexpr const char* kAtStart = "Scene, at the start";

/// Asks every library that knows motions when the balls touch first. A library is wrong about a motion if it finds a
/// contact that does not exist, misses one, or finds another time, beyond the tolerance. The exact library is
/// compared with `exact`, asked triangle by triangle; each difference is added to `disputes`.
[[nodiscard]] timing::Benchmark motion_benchmark(const std::vector<Triangle>& triangles,
                                                 const std::vector<Sweeping>& built, MotionLength length,
                                                 std::vector<Motion> motions, std::vector<std::string>& disputes);

}  // namespace touchstone::bench_scenes
