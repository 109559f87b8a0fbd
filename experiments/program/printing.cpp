// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/printing.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <system_error>

namespace touchstone::program {
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

void print_result(const std::string& text, bool quiet) {
  if (!quiet) fmt::print("{}", text);
  flush_standard_output();
}

}  // namespace touchstone::program
