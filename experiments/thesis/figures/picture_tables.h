// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

/// Writes the tables behind the pictures; picture_tables() says what they hold. Throws std::runtime_error, which names
/// the file, if one cannot be written.
void write_picture_tables(const std::filesystem::path& folder, const Study& study);

[[nodiscard]] std::vector<run::TableDescription> picture_tables();

/// Returns how tables write a truth value.
[[nodiscard]] inline const char* yes_or_no(bool yes) { return yes ? "yes" : "no"; }

}  // namespace touchstone::figures
