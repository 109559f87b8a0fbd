// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/harness/timing/measurement.h"

namespace touchstone::timing {

/// The lines of one benchmark: a heading and a row a candidate. Medians; quartiles in brackets.
[[nodiscard]] std::string table(const Result& result);
/// How many goals were met, and which were not.
[[nodiscard]] std::string goals(const std::vector<Result>& results);
/// What the columns mean.
[[nodiscard]] std::string legend();

/// Everything: quartiles and every repetition of times and ratios, goals, wrong answers.
[[nodiscard]] nlohmann::ordered_json json(const std::vector<Result>& results);
/// The vector extensions that the program was compiled for, and those that the processor has.
[[nodiscard]] nlohmann::ordered_json processor_features();

}  // namespace touchstone::timing
