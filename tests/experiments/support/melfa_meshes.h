// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/run/output.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::run_tests {

/// A folder with the meshes that melfa.json names, as tetrahedra.
struct MelfaMeshes {
  MelfaMeshes() {
    for (const char* const folder : {"melfa-sim", "VMC_toolchange"})
      std::filesystem::create_directory(scratch.path / folder);
    for (int i = 1; i <= 7; ++i) write("melfa-sim/link" + std::to_string(i) + ".stl");
    for (const char* const part : {"base", "head", "saddle", "table", "arm", "carousel"})
      write(std::string("VMC_toolchange/") + part + ".stl");
  }
  void write(const std::string& file) const {
    const std::vector<std::string> corners{"0 0 0", "9 0 0", "0 9 0", "0 0 9"};
    std::string text = "solid t\n";
    for (const auto& [a, b, c] : {std::tuple{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int i : {a, b, c}) text += "vertex " + corners[static_cast<std::size_t>(i)] + "\n";
      text += "endloop\nendfacet\n";
    }
    run::write_file(scratch.path / file, text + "endsolid t\n");
  }
  const Scratch scratch;
};

}  // namespace touchstone::run_tests
