// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace touchstone::run_tests {

/// A temporary folder of this process, removed at the end.
struct Scratch {
  Scratch() : path(std::filesystem::temp_directory_path() / ("touchstone-tests-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(path); }

  std::filesystem::path path;
};

/// Returns all bytes of a file.
inline std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace touchstone::run_tests
