// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/input.h"

#include <fmt/core.h>
#include <sys/auxv.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace touchstone::program {
namespace {

/// Returns the path of the program; where /proc is not mounted, by the name by which it was called.
std::filesystem::path program_path() {
  std::error_code without_proc;
  auto path = std::filesystem::read_symlink("/proc/self/exe", without_proc);
  if (!without_proc) return path;
  // The system passes the address of the name as a number. NOLINTNEXTLINE(performance-no-int-to-ptr)
  return std::filesystem::canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN)));
}

/// Returns the folder of this name in the folder of the program or, if there is none, beside that.
std::filesystem::path folder_near_program(const char* name) {
  const std::filesystem::path program = program_path().parent_path();
  return (std::filesystem::exists(program / name) ? program : program.parent_path()) / name;
}

}  // namespace

std::filesystem::path data(const std::string& name) {
  const char* const chosen = std::getenv("TOUCHSTONE_DATA");
  std::filesystem::path path = (chosen != nullptr ? chosen : folder_near_program("share/touchstone")) / name;
  std::error_code error;
  if (std::filesystem::exists(path, error)) return path;
  throw std::runtime_error(path.string() + ": is missing; the variable TOUCHSTONE_DATA names the folder of the data");
}

std::filesystem::path helper_program(const std::string& name) {
  return folder_near_program("libexec/touchstone") / name;
}

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

}  // namespace touchstone::program
