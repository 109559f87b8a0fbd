// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/pictures.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
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

/// Runs a script of experiments/report. Returns whether it did what it should; `where`: the place of the data.
bool run_script(const char* name, const std::string& arguments, const std::string& where) {
  const auto python = find_python();
  if (!python) {
    fmt::print(stderr, "touchstone: no pictures: no python3 with jinja2, matplotlib and numpy{}\n", where);
    return false;
  }
  const std::string script = shell_quoted(data(std::string("experiments/report/") + name).string());
  if (std::system((*python + " -B " + script + " " + arguments).c_str()) == 0) return true;
  fmt::print(stderr, "touchstone: the pictures could not be drawn{}\n", where);
  return false;
}

}  // namespace

int draw_pictures(const std::string& name, const OutputFolder& folder) {
  folder.share();
  const std::string path = folder.path().string();
  return run_script("draw.py", name + " " + shell_quoted(path), "; the data are in " + path) ? 0 : 1;
}

int draw_png(const std::string& svg, const std::filesystem::path& file) {
  // A file without a name, which the script inherits and nobody needs to remove.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> drawing(std::tmpfile(), std::fclose);
  if (!drawing || std::fwrite(svg.data(), 1, svg.size(), drawing.get()) != svg.size() ||
      std::fflush(drawing.get()) != 0)
    throw std::system_error(errno, std::generic_category(), "a temporary file cannot be written");
  const int number = ::fileno(drawing.get());
  return run_script("svg_to_png.py", fmt::format("/dev/fd/{} {}", number, shell_quoted(file.string())), "") ? 0 : 1;
}

}  // namespace touchstone::run
