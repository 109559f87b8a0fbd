// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/run/timing/measurement.h"

namespace touchstone::timing {

/// Returns the lines of one benchmark: a heading and a row for each candidate. Medians; quartiles in brackets.
[[nodiscard]] std::string table(const Result& result);
/// Returns the number of goals that were met, and the goals that were not.
[[nodiscard]] std::string goals(const std::vector<Result>& results);
/// Returns an explanation of the columns.
[[nodiscard]] std::string legend();

/// Returns all results: quartiles and every repetition of times and ratios, goals, wrong answers.
[[nodiscard]] nlohmann::ordered_json json(const std::vector<Result>& results);
/// Returns the vector extensions that the program was compiled for, and those of the processor.
[[nodiscard]] nlohmann::ordered_json processor_features();

}  // namespace touchstone::timing
