// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/input_lines.h"

#include <fmt/core.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <new>

#include "experiments/run/input.h"

namespace touchstone::cases {
namespace {

using Take = std::function<bool(Line&&)>;

bool read_stream(std::istream& stream, const std::string& name, std::uint64_t& bytes, const Take& take) {
  std::string text;
  for (std::size_t number = 1; std::getline(stream, text); ++number) {
    bytes += text.size() + 1;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    Line line{.text = text, .place = fmt::format("{}: line {}", name, number), .read = {}, .complaint = {}};
    line.file = name;
    line.end = bytes;
    try {
      line.read = read_case(text);
    } catch (const run::NotJson& error) {
      line.complaint = fmt::format("{}: not JSON: {}", line.place, error.what());
    } catch (const std::bad_alloc&) {
      line.complaint = fmt::format("{}: there is not enough memory to read the case", line.place);
    }
    if (!take(std::move(line))) return false;
  }
  // Only the C stream records errors of standard input.
  const bool failed = &stream == &std::cin ? std::ferror(stdin) != 0 : stream.bad();
  if (!failed) return true;
  return take({.text = {}, .place = {}, .read = {}, .complaint = fmt::format("{}: cannot be read to its end", name)});
}

}  // namespace

void read_lines(const std::vector<std::string>& files, const Take& take) {
  std::uint64_t bytes = 0;
  if (files.empty()) {
    run::announce_standard_input("cases");
    read_stream(std::cin, "standard input", bytes, take);
  }
  for (const std::string& file : files) {
    std::ifstream stream;
    std::string complaint;
    try {
      stream = run::open_file(file);
    } catch (const std::runtime_error& error) {
      complaint = error.what();
    }
    const bool continues = complaint.empty() ? read_stream(stream, file, bytes, take)
                                             : take({.text = {}, .place = {}, .read = {}, .complaint = complaint});
    if (!continues) return;
  }
}

}  // namespace touchstone::cases
