// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/cell/model/link_model.h"

namespace touchstone::cell {

/// A model that cannot be converted; the message names the file and the face.
class BadConversion : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads a model file (`.txt`), or a mesh of any format that read_mesh knows as a model of one part; both are named as
/// the file is. Throws BrokenMesh.
[[nodiscard]] LinkModel read_model(const std::filesystem::path& file);

/// The text of a file of the format that the extension tells: .txt, .obj, .off, .stl or .ply. Numbers are the shortest
/// that are read as the same doubles. Parts are kept by .txt, and named by .obj. Requires what `prepared` makes of a
/// model. Throws BadConversion for another extension.
[[nodiscard]] std::string model_text(const LinkModel& model, const std::filesystem::path& file);

enum class Preparation {
  None,
  Weld,   ///< equal vertices of a part become one
  Merge,  ///< and coplanar faces become polygons with holes (mesh::merge_faces)
};

/// The model as a file of this extension can hold it: polygons with holes are cut into triangles, all faces for .stl.
/// The preparation comes first, and drops vertices of no face. Throws BadConversion, which names the part and the face,
/// where a face that is to be cut or merged is one that the contract rejects.
[[nodiscard]] LinkModel prepared(const LinkModel& model, Preparation preparation, const std::filesystem::path& file);

/// What conversions compare.
struct ModelCounts {
  std::size_t parts = 0, vertices = 0, polygons = 0, triangles = 0, holes = 0;
  std::size_t points = 0;      ///< different ones among the corners of polygons
  Eigen::AlignedBox3d bounds;  ///< of these
};

[[nodiscard]] ModelCounts counts_of(const LinkModel& model);

/// What the second lacks or has other than the first, a sentence each: numbers of polygons and their corners, points,
/// bounds, all exactly. Vertices and parts are not compared, since formats differ in them.
[[nodiscard]] std::vector<std::string> differences(const LinkModel& written, const LinkModel& read);

}  // namespace touchstone::cell
