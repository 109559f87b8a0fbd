// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/cell/browser/recording.h"

namespace touchstone::cell::browser {

/// The cell of a recording as glTF 2.0: a node for every link, in which its parts are, and for the gripper, the
/// storage, the machine, the material and the sphere; in metres, y up. The run is an animation of the nodes that move:
/// so many stops a second. A recording without stops has none. Source: [khronos2021].
///
/// Text of JSON with its buffer within (.gltf).
[[nodiscard]] std::string gltf_text(const Recording& recording, double stops_per_second);
/// The same as one binary file (.glb).
[[nodiscard]] std::string gltf_binary(const Recording& recording, double stops_per_second);

}  // namespace touchstone::cell::browser
