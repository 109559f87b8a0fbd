// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/experiments/support/scratch.h"

namespace touchstone::fuzz_tests {

/// The bytes as a file of this name, in a folder of this process.
inline std::filesystem::path written_file(const std::string& name, const std::uint8_t* data, std::size_t size) {
  static const run_tests::Scratch scratch;
  const std::filesystem::path file = scratch.path / name;
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return file;
}

}  // namespace touchstone::fuzz_tests
