// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/pictures.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>

#include "experiments/harness/run_record.h"

namespace touchstone::harness {

int draw_pictures(const std::string& name, const OutputFolder& folder) {
  folder.share();
  const std::string path = folder.path().string();
  const std::string script = shell_quoted((source_folder() / "experiments/report/draw.py").string());
  for (const char* python : {"/usr/bin/python3", "python3"}) {
    const std::string interpreter(python);
    if (std::system((interpreter + " -c 'import matplotlib, numpy' 2>/dev/null").c_str()) != 0) continue;
    const std::string command = interpreter + " -B " + script + " " + name + " " + shell_quoted(path);
    if (std::system(command.c_str()) == 0) return 0;
    fmt::print(stderr, "touchstone: the pictures could not be drawn; the data are in {}\n", path);
    return 1;
  }
  fmt::print(stderr, "touchstone: no pictures: no python3 with matplotlib and numpy; the data are in {}\n", path);
  return 1;
}

}  // namespace touchstone::harness
