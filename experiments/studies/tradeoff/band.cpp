// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/band.h"

#include <fmt/core.h>

#include <bit>
#include <cstdlib>

namespace touchstone::tradeoff {
namespace {

std::string offset_text(std::int64_t offset) {
  if (offset == 0) return "0";
  const auto size = static_cast<std::uint64_t>(std::abs(offset));
  const std::string sign = offset < 0 ? "-" : "+";
  constexpr std::uint64_t kWritten = 1024;  // beyond it offsets are powers of two
  if (size <= kWritten) return sign + std::to_string(size);
  const bool last = std::abs(offset) == cases::all_offsets().back();
  return fmt::format("{}2^{}{}", sign, std::countr_zero(size), last ? " or beyond" : "");
}

}  // namespace

Band band_of(const MethodErrors& errors) {
  Band band;
  for (std::size_t i = 0; i < errors.offsets.size(); ++i) {
    if (errors.offsets[i].wrong == 0) continue;
    const std::int64_t offset = cases::all_offsets()[i];
    if (!band.lowest) band.lowest = offset;
    band.highest = offset;
  }
  return band;
}

std::string text_of(const Band& band) {
  if (!band.lowest) return "none seen";
  if (band.lowest == band.highest) return offset_text(*band.lowest);
  return offset_text(*band.lowest) + " to " + offset_text(*band.highest);
}

}  // namespace touchstone::tradeoff
