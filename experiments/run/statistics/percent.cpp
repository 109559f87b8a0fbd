// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/percent.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace touchstone::statistics {

double share_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string percent_to_places(double share, int places) {
  if (share == 0 || share == 1) return share == 0 ? "0" : "100";
  const std::string text = fmt::format("{:.{}f}", 100 * share, places);
  if (share > 0 && std::stod(text) == 0) return fmt::format("<{:.{}f}", std::pow(10, -places), places);
  if (share < 1 && std::stod(text) >= 100) return fmt::format(">{:.{}f}", 100 - std::pow(10, -places), places);
  return text;
}

std::string percent_to_digits(double share, int digits) {
  const std::string text = fmt::format("{:.{}g}", 100 * share, digits);
  return std::stod(text) == 100 ? percent_to_places(share, std::max(1, digits - 2)) : text;
}

}  // namespace touchstone::statistics
