// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/meshes/study.h"

namespace touchstone::meshes {

// Results only: byte for byte the same for the same settings and meshes, whatever the number of threads. Faces are
// numbered from 0. Each throws std::runtime_error, which names the file, if it cannot be written. tables() says what
// the tables hold.

void write_meshes(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                  const Result& result);
void write_rejected(const std::filesystem::path& folder, const std::vector<NamedMesh>& meshes, const Result& result);
/// failures.jsonl: the kept failures, in the contract's form of a case. A query that several methods fail is written
/// once, with the tags of all. `expected` holds the exact answer to only those tests that they fail, so that a method
/// that matches it passes these tests.
void write_failures(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                    const Result& result);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the table for the terminal: one row per mesh, the sum, the totals of each method, the rejected faces and a
/// legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result);

}  // namespace touchstone::meshes
