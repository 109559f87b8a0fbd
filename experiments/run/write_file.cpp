// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/write_file.h"

#include <fstream>
#include <stdexcept>

namespace touchstone::run {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace touchstone::run
