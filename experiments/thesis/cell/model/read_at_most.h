// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "experiments/run/input.h"

namespace touchstone::cell {

/// Returns all bytes of a file. Throws an `Error`, whose message names the file, if the file cannot be read or has more
/// than `most_mib` MiB. Reads no more than that, even from a device that never ends.
template <class Error>
[[nodiscard]] std::string read_at_most(const std::filesystem::path& file, std::size_t most_mib) {
  std::ifstream stream;
  try {
    stream = run::open_file(file);
  } catch (const std::runtime_error& error) {
    throw Error(error.what());
  }
  std::string text;
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  while (stream && text.size() <= most_mib << 20) {
    const std::size_t size = text.size();
    text.resize(size + kBlock);
    stream.read(text.data() + size, kBlock);
    text.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw Error(file.string() + ": cannot be read to its end");
  if (text.size() > most_mib << 20) throw Error(fmt::format("{}: has more than {} MiB", file.string(), most_mib));
  return text;
}

}  // namespace touchstone::cell
