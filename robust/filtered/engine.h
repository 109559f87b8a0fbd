// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "robust/filtered/stage.h"
#include "robust/filtered/triangle_question.h"

namespace touchstone::filtered {

/// The functions that are compiled once for each instruction set, and gathered here for the machine at hand.
struct Engine {
  bool (*triangle_contact)(const TriangleQuestion&);
  bool (*counted_triangle_contact)(const TriangleQuestion&, StageCounts&);
};

[[nodiscard]] const Engine& baseline_engine();
[[nodiscard]] const Engine& avx2_engine();

/// The fastest engine that this machine can run. All give the same answers.
[[nodiscard]] const Engine& engine();

}  // namespace touchstone::filtered
