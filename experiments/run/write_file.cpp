// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/write_file.h"

#include <fstream>
#include <stdexcept>
#include <system_error>

namespace touchstone::run {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

void refuse_overwriting(const std::filesystem::path& path, bool force) {
  std::error_code error;
  if (!force && std::filesystem::exists(std::filesystem::symlink_status(path, error)))
    throw std::runtime_error(path.string() + ": is there already; --force writes over it");
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": cannot be made: " + (error ? error.message() : "it is no folder"));
}

}  // namespace touchstone::run
