// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/meshes/study.h"

namespace touchstone::meshes {

// Results only: byte for byte the same for the same settings and meshes, whatever the number of threads. Faces are
// numbered from 0. Each throws std::runtime_error, which names the file, where it cannot be written.

/// meshes.csv: a line a mesh, method, place and test: trials, wrong answers, and which way they were wrong.
void write_meshes(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                  const Result& result);
/// rejected.csv: a line a face that the contract rejects: mesh, face, code and sentence.
void write_rejected(const std::filesystem::path& folder, const std::vector<NamedMesh>& meshes, const Result& result);
/// failures.jsonl: the failures that were kept, in the contract's form of a case; a query that several methods fail
/// stands there once, with the tags of all. `expected` holds the exact answer to the tests that they fail, no more, so
/// that a method that meets it has those right.
void write_failures(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                    const Result& result);

/// The table for the terminal: a row a mesh, the sum, the totals of each method, the rejected faces and a legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result);

}  // namespace touchstone::meshes
