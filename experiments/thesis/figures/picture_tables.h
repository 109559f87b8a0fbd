// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

/// Writes the tables behind the pictures; picture_tables() says what they hold. Throws std::runtime_error, which names
/// the file, if one cannot be written.
void write_picture_tables(const std::filesystem::path& folder, const Study& study);

[[nodiscard]] std::vector<program::TableDescription> picture_tables();

}  // namespace touchstone::figures
