// SPDX-License-Identifier: Apache-2.0
// touchstone::read_mesh: meshes from OBJ, OFF, STL and PLY files.
#pragma once

#include "geometry/io/read_mesh.h"
