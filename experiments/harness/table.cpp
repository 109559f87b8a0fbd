// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/table.h"

#include <fmt/core.h>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"

namespace touchstone::harness {

std::string text_field(std::string_view text) { return csv_field(std::string(text)); }

std::string number_field(std::int64_t number, const char* format) { return fmt::format(fmt::runtime(format), number); }

std::string number_field(std::uint64_t number, const char* format) { return fmt::format(fmt::runtime(format), number); }

std::string number_field(double number, const char* format) { return fmt::format(fmt::runtime(format), number); }

void write_table(const std::filesystem::path& file, const std::string& text) { write_file(file, text); }

Rate rate(std::uint64_t count, std::uint64_t trials) {
  const auto limits = statistics::clopper_pearson(count, trials);
  return {trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials), limits.lower, limits.upper};
}

}  // namespace touchstone::harness
