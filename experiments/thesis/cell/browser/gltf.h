// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/thesis/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// Returns the cell of a recording as glTF 2.0: one node for every link, with its parts, and one for each of gripper,
/// storage, machine, material and sphere; in metres, y up. The run is an animation of the moving nodes, at
/// `stops_per_second`. A recording without stops has no animation. Source: [khronos2021].
///
/// The result is JSON text with an embedded buffer (.gltf).
[[nodiscard]] std::string gltf_text(const Recording& recording, double stops_per_second);
/// Returns the same as one binary file (.glb).
[[nodiscard]] std::string gltf_binary(const Recording& recording, double stops_per_second);

}  // namespace touchstone::cell::browser
