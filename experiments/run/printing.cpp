// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/printing.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "experiments/run/table.h"

namespace touchstone::run {
namespace {

std::string cannot_be_written(int error) {
  const std::string text = "standard output: cannot be written";
  return error == 0 ? text : text + ": " + std::generic_category().message(error);
}

}  // namespace

void flush_standard_output() {
  errno = 0;  // set by the first failure alone: glibc then drops what it held back
  std::cout.flush();
  const bool is_flushed = std::fflush(stdout) == 0;
  if (!is_flushed || !std::cout || std::ferror(stdout) != 0) throw std::runtime_error(cannot_be_written(errno));
}

void require_standard_output() {
  // A write of no bytes fails where the stream takes no bytes at all.
  if (::write(STDOUT_FILENO, "", 0) < 0) throw std::runtime_error(cannot_be_written(errno));
}

std::string message_of(const std::exception& error) {
  const auto* const failure = dynamic_cast<const std::system_error*>(&error);
  return failure != nullptr && std::ferror(stdout) != 0 ? cannot_be_written(failure->code().value()) : error.what();
}

namespace {

/// A new folder for temporary files, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "touchstone-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

void Printing::print(const std::string& text, const std::filesystem::path& folder) const {
  if (json) fmt::print("{}", tables_json(folder, tables));
  if (prints_text()) fmt::print("{}", text);
  flush_standard_output();
}

void Printing::print(const std::string& text, const std::function<void(const std::filesystem::path&)>& write) const {
  if (!json) return print(text, std::filesystem::path());
  const ScratchFolder scratch;
  write(scratch.path());
  print(text, scratch.path());
}

void declare_printing(Command& command, Printing& printing) {
  command.quiet(printing.quiet);
  command.json(printing.json).excludes("--quiet");
  command.keep_tables(printing.tables);
}

}  // namespace touchstone::run
