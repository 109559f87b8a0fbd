// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/io/mesh_builder.h"
#include "geometry/io/mesh_source.h"

namespace touchstone::io {

// Each reads a file of one format into the builder, in the words of `read_mesh`.

void read_obj(const MeshSource& source, MeshBuilder& builder);
void read_off(const MeshSource& source, MeshBuilder& builder);
void read_stl(const MeshSource& source, MeshBuilder& builder);
void read_ply(const MeshSource& source, MeshBuilder& builder);

}  // namespace touchstone::io
