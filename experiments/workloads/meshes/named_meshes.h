// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/io/read_mesh.h"

namespace touchstone::workloads {

/// What files are called: without the extension, with the folder that they lie in; where several have the same name,
/// the second and later ones get the next number that leaves no two alike: `puma/puma_link1`, `puma/puma_link1#2`.
[[nodiscard]] std::vector<std::string> short_names(const std::vector<std::string>& files);

/// A mesh file as it was read.
struct NamedFile {
  std::string name, file;
  ReadMesh content;
};

struct NamedFiles {
  std::vector<NamedFile> read;
  std::size_t parts_left_out = 0;
  bool all_read = true;
};

/// Reads what can be read; says on standard error what cannot, and the first parts that are left out of each file.
[[nodiscard]] NamedFiles read_named_files(const std::vector<std::string>& files, OnFault on_fault);

/// left-out.txt: a sentence a line for what was left out of the files, as ReadMesh has it, and how many more there are.
[[nodiscard]] std::string left_out_text(const NamedFiles& files);

}  // namespace touchstone::workloads
