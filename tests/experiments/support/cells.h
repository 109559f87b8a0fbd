// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/cell.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::run_tests {

/// The cells that come with the program, and the default one.
inline const std::filesystem::path kCells =
    std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "experiments/thesis/cell/cells";
inline const std::filesystem::path kAristo = kCells / "aristo.json";

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
    program::write_file(scratch.path / file, text + "endsolid t\n");
  }
  const Scratch scratch;
};

inline Eigen::Isometry3d isometry(const Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = pose.rotation;
  result.translation() = pose.translation;
  return result;
}

/// Where each link is, for joint angles in degrees about the joints' axes (couplings apart).
inline std::vector<Eigen::Isometry3d> links_at(const cell::Robot& robot, const std::vector<double>& degrees) {
  std::vector<Eigen::Isometry3d> links{isometry(robot.base)};
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    links.push_back(links.back() * isometry(robot.joints[i].origin) *
                    Eigen::AngleAxisd(degrees[i] * std::numbers::pi / 180, robot.joints[i].axis));
  return links;
}

}  // namespace touchstone::run_tests
