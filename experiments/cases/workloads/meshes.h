// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/io/read_mesh.h"
#include "robust/mesh/merge.h"

namespace touchstone::workloads {

/// Returns a short name for each file: without the extension, with its folder. If several have the same name, the
/// second and later ones get the next number that keeps all names distinct: `puma/puma_link1`, `puma/puma_link1#2`.
[[nodiscard]] std::vector<std::string> short_names(const std::vector<std::string>& files);

/// Returns the files, separated by commas, each with a hash of what it holds, by which a later run knows whether it is
/// the same. A file that cannot be read has none. Cost: reads the files.
[[nodiscard]] std::string with_hashes(const std::vector<std::string>& files);

/// A mesh file and its content.
struct NamedFile {
  std::string name, file;
  ReadMesh content;
};

struct NamedFiles {
  std::vector<NamedFile> read;
  std::size_t parts_left_out = 0;
  bool all_read = true;
};

/// Returns whether `read_mesh` knows the extension of the file.
[[nodiscard]] bool is_own_format(const std::filesystem::path& file);

/// Returns the sentence about a face of a file, which begins with the file and, if it is known, the place.
[[nodiscard]] std::string sentence_of_face(const std::string& file, const ReadMesh& content,
                                           const mesh::RejectedFace& rejected);

/// Reads a file by `read_mesh`. Prints what it warns of on standard error.
[[nodiscard]] ReadMesh read_with_warnings(const std::filesystem::path& file, OnFault on_fault);

/// Reads all readable files. Reports on standard error the files that cannot be read, what is odd, and the first parts
/// that were left out of each file.
[[nodiscard]] NamedFiles read_named_files(const std::vector<std::string>& files, OnFault on_fault);

/// Returns the content of left-out.txt: one sentence per line for each part left out of the files, as listed in
/// ReadMesh, and the number of further parts.
[[nodiscard]] std::string left_out_text(const NamedFiles& files);

}  // namespace touchstone::workloads
