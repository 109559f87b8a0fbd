// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "experiments/run/input.h"
#include "experiments/run/quoting.h"

namespace touchstone::run {
namespace {

/// Returns the first Python interpreter that has the required packages.
std::optional<std::string> find_python() {
  for (const std::string python : {"/usr/bin/python3", "python3"})
    if (std::system((python + " -c 'import jinja2, matplotlib, numpy' 2>/dev/null").c_str()) == 0) return python;
  return std::nullopt;
}

}  // namespace

int draw_pictures(const std::string& name, const OutputFolder& folder) {
  folder.share();
  const std::string path = folder.path().string();
  const std::string script = shell_quoted(data("experiments/report/draw.py").string());
  const auto python = find_python();
  if (python && std::system(fmt::format("{} -B {} {} {}", *python, script, name, shell_quoted(path)).c_str()) == 0)
    return 0;
  fmt::print(stderr, "touchstone: {}; the data are in {}\n",
             python ? "the pictures could not be drawn" : "no pictures: no python3 with jinja2, matplotlib and numpy",
             path);
  return 1;
}

std::string png_of(const std::string& svg, double height) {
  constexpr double kMostPixels = 32767;  // that rsvg-convert draws
  // A file without a name, which the program inherits and nobody needs to remove.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> drawing(std::tmpfile(), std::fclose);
  if (!drawing || std::fwrite(svg.data(), 1, svg.size(), drawing.get()) != svg.size() ||
      std::fflush(drawing.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "a temporary file cannot be written");
  const double zoom = std::min(2.0, std::floor(kMostPixels / height * 1000) / 1000);
  const std::string command = fmt::format("rsvg-convert --zoom {} /dev/fd/{}", zoom, ::fileno(drawing.get()));
  std::FILE* drawn = ::popen(command.c_str(), "r");
  if (drawn == nullptr) throw std::system_error(errno, std::generic_category(), "rsvg-convert cannot be started");
  std::string png;
  std::array<char, 65536> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), drawn)) png.append(part.data(), size);
  if (::pclose(drawn) != 0)
    throw std::runtime_error("the picture could not be drawn by rsvg-convert, of Debian's package librsvg2-bin");
  return png;
}

}  // namespace touchstone::run
