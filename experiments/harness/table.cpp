// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/table.h"

#include <fmt/core.h>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"

namespace touchstone::harness {

std::string field(std::string_view text) { return csv_field(std::string(text)); }

std::string digits(double number, int count) { return fmt::format("{:.{}g}", number, count); }

std::string places(double number, int count) { return fmt::format("{:.{}f}", number, count); }

std::string shortest(double number) { return fmt::format("{}", number); }

void write_table_file(const std::filesystem::path& file, const std::string& text) { write_file(file, text); }

double rate_of(const Share& share) {
  return share.trials == 0 ? 0 : static_cast<double>(share.count) / static_cast<double>(share.trials);
}

std::string rate_field(const Share& share) { return digits(rate_of(share)); }

std::string lower_field(const Share& share) {
  return digits(statistics::clopper_pearson(share.count, share.trials).lower);
}

std::string upper_field(const Share& share) {
  return digits(statistics::clopper_pearson(share.count, share.trials).upper);
}

}  // namespace touchstone::harness
