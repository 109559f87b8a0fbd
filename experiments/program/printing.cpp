// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/printing.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "experiments/program/statistics/shares.h"

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

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

const char* code(Colour colour) {
  switch (colour) {
    case Colour::Red: return "31";
    case Colour::Green: return "32";
    case Colour::Bold: break;
  }
  return "1";
}

}  // namespace

bool takes_colours(std::FILE* stream) {
  return variable("NO_COLOR").empty() && variable("TERM") != "dumb" && isatty(fileno(stream)) == 1;
}

std::string coloured(const std::string& text, Colour colour, std::FILE* stream) {
  if (!takes_colours(stream)) return text;
  return std::string("\033[") + code(colour) + "m" + text + "\033[0m";
}

namespace {

/// Formats a duration: `40 s`, `12 min`, `3.5 h`.
std::string duration_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

/// Returns the text of the line after `seconds` of work, which finished `done` items of `total`.
std::string progress_text(const std::string& what, std::uint64_t done, std::uint64_t total, double seconds) {
  std::string text = what + ": " + statistics::percent_to_places(statistics::share_of(done, total), 0) + " %";
  if (done > 0) {
    const double pace = seconds / static_cast<double>(done);
    text += fmt::format(", {} left", duration_text(pace * static_cast<double>(total - done)));
  }
  return text;
}

}  // namespace

ProgressLine::ProgressLine(std::string what, std::uint64_t total, bool wanted)
    : what_(std::move(what)),
      total_(total),
      shown_(wanted && isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      last_(begin_) {}

ProgressLine::~ProgressLine() { erase(); }

void ProgressLine::erase() const {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::operator()(std::uint64_t done) {
  constexpr std::chrono::milliseconds kInterval(200);
  const auto now = Clock::now();
  if (!shown_ || now - last_ < kInterval) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  fmt::print(stderr, "\r{} \033[K", progress_text(what_, done, total_, seconds));
  std::fflush(stderr);
}

}  // namespace touchstone::program
