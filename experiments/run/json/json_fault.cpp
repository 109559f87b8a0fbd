// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/json/json_fault.h"

#include "geometry/io/detail/legible.h"

namespace touchstone::run {

std::string json_fault(const nlohmann::json::exception& error, std::string_view text) {
  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ..."
  std::string_view message = error.what();
  const auto pass = [&message](std::string_view beginning) {
    if (message.starts_with(beginning)) message.remove_prefix(beginning.size());
  };
  if (const std::size_t tag = message.find("] ");
      message.starts_with("[json.exception.") && tag != std::string_view::npos)
    message.remove_prefix(tag + 2);
  pass("parse error at ");
  if (!text.empty() && text.find('\n') == std::string_view::npos) pass("line 1, ");
  return io::legible(message);
}

}  // namespace touchstone::run
