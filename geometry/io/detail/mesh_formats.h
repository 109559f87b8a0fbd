// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/mesh_source.h"

namespace touchstone::io {

/// What a file holds, though it be without a face.
struct Content {
  ReadMesh read;
  std::string passed_over;  ///< a sentence on the first part that the format does not know, or empty
};

/// As `read_mesh`, but for files without a face.
[[nodiscard]] Content read_content(const std::filesystem::path& file, OnFault on_fault);

// Each reads a file of one format into the builder, in the words of `read_mesh`.

void read_obj(const MeshSource& source, MeshBuilder& builder);
void read_off(const MeshSource& source, MeshBuilder& builder);
void read_stl(const MeshSource& source, MeshBuilder& builder);
void read_ply(const MeshSource& source, MeshBuilder& builder);

}  // namespace touchstone::io
