// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/input.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace touchstone::run {

std::ifstream open_file(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  int reason = stream ? 0 : errno != 0 ? errno : EIO;
  std::error_code ignored;
  if (stream && std::filesystem::is_directory(file, ignored)) reason = EISDIR;
  if (reason == 0) return stream;
  throw std::runtime_error(file.string() + ": cannot be read: " + std::generic_category().message(reason));
}

void announce_standard_input(const std::string& what) {
  if (isatty(STDIN_FILENO) == 1)
    fmt::print(stderr, "touchstone: reading {} from standard input; control-D on an empty line ends it\n", what);
}

}  // namespace touchstone::run
