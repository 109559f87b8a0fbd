// SPDX-License-Identifier: Apache-2.0
// touchstone::mesh::scene_faces: a merged mesh as an object of a scene.
#pragma once

#include "robust/mesh/scene_faces.h"
