// SPDX-License-Identifier: GPL-3.0-or-later
// A line is not JSON, a rejection of the contract, or shapes that read_case gives again from what is written of them.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "experiments/cases/case.h"
#include "experiments/cases/verdict.h"
#include "experiments/program/json.h"

using namespace touchstone;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const cases::Case read = cases::read_case({reinterpret_cast<const char*>(data), size});
    if (const auto* shapes = std::get_if<cases::Shapes>(&read.content)) {
      const std::string line = cases::case_line("again", *shapes, {});
      const cases::Case again = cases::read_case(line);
      const auto& same = std::get<cases::Shapes>(again.content);
      if (!(same.polygon == shapes->polygon) || same.ball().center != shapes->ball().center ||
          same.ball().radius != shapes->ball().radius || same.question.index() != shapes->question.index() ||
          (shapes->motion() && same.motion()->to != shapes->motion()->to))
        throw std::logic_error("not read again as it was written: " + line);
    }
  } catch (const program::NotJson&) {
  }
  return 0;
}
