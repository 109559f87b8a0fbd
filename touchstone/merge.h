// SPDX-License-Identifier: Apache-2.0
// touchstone::mesh::merge_faces: polygons with holes from the coplanar faces of a mesh.
#pragma once

#include "robust/mesh/merge.h"
