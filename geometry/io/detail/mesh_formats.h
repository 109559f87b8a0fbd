// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/mesh_source.h"

namespace touchstone::io {

/// The content of a file, which may be without faces.
struct Content {
  ReadMesh read;
  std::string passed_over;  ///< a message about the first part that the format does not define, or empty
};

/// Reads a file like `read_mesh`, but accepts files without faces.
[[nodiscard]] Content read_content(const std::filesystem::path& file, OnFault on_fault);

// Each of these reads a file of one format into the builder. `read_mesh` documents the formats.

void read_obj(const MeshSource& source, MeshBuilder& builder);
void read_off(const MeshSource& source, MeshBuilder& builder);
void read_stl(const MeshSource& source, MeshBuilder& builder);
void read_ply(const MeshSource& source, MeshBuilder& builder);

}  // namespace touchstone::io
