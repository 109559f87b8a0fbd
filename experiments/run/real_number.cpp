// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/real_number.h"

#include <fmt/core.h>

#include <string_view>

#include "geometry/io/detail/text_number.h"

namespace touchstone::run {

std::function<std::string(const std::string&)> real_number(double lowest, double highest) {
  return [lowest, highest](const std::string& text) -> std::string {
    const auto value = io::nearest_double(text);
    if (!value || !(*value >= lowest && *value <= highest))
      return fmt::format("\"{}\" is not a number from {} to {}", text, lowest, highest);
    const std::string_view digits = std::string_view(text).substr(0, text.find_first_of("eE"));
    if (*value == 0 && digits.find_first_of("123456789") != std::string_view::npos)
      return fmt::format("\"{}\" is not 0, but nearer to 0 than to any other double", text);
    return {};
  };
}

}  // namespace touchstone::run
