// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/link_model.h"

namespace touchstone::cell {

/// Thrown for a model that cannot be converted; the message names the file and the face.
class BadConversion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a model file (`.txt`), or a mesh of any format that read_mesh knows as a model of one part. Model and part
/// have the file's name. Throws BrokenMesh.
[[nodiscard]] LinkModel read_model(const std::filesystem::path& file);

/// Returns the text of a file in the format of the extension: .txt, .obj, .off, .stl or .ply. Numbers are the shortest
/// that are read as the same doubles. .txt keeps parts, .obj keeps their names. Requires a model that `prepared` has
/// returned. Throws BadConversion for another extension.
[[nodiscard]] std::string model_text(const LinkModel& model, const std::filesystem::path& file);

enum class Preparation {
  None,
  Weld,   ///< equal vertices of a part become one
  Merge,  ///< and coplanar faces become polygons with holes (mesh::merge_faces)
};

/// Returns the model as a file of this extension can hold it: cuts polygons with holes into triangles, for .stl all
/// faces. Applies the preparation first and drops vertices without a face. Throws BadConversion, which names the part
/// and the face, if the contract rejects a face that must be cut or merged.
[[nodiscard]] LinkModel prepared(const LinkModel& model, Preparation preparation, const std::filesystem::path& file);

/// The counts and bounds by which conversions are compared.
struct ModelCounts {
  std::size_t parts = 0, vertices = 0, polygons = 0, triangles = 0, holes = 0;
  std::size_t points = 0;      ///< distinct corners of polygons
  Eigen::AlignedBox3d bounds;  ///< of these points
};

[[nodiscard]] ModelCounts counts_of(const LinkModel& model);

/// Returns a sentence for each difference between the two models: numbers of polygons and of their corners, points,
/// bounds, all compared exactly. Vertices and parts are not compared, since formats differ in them.
[[nodiscard]] std::vector<std::string> differences(const LinkModel& written, const LinkModel& read);

}  // namespace touchstone::cell
