// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/solid.h"
#include "geometry/io/read_mesh.h"

/// The thesis's model files: text, one file a link, of parts, of polygons. Their layout is not public; this is one that
/// fits what the captions of its chapter 5 say (a link of three parts, a gripper of one, polygons made of vertices).
///
///   file     = "Link" name  "Parts" count  part*
///   part     = "Part" name  "Vertices" count  vertex*  "Polygons" count  polygon*
///   vertex   = x y z
///   polygon  = loop hole*
///   hole     = "Hole" loop
///   loop     = count number*
///
/// Each of Link, Parts, Part, Vertices, Polygons, a vertex and a polygon has a line of its own. A name is one word
/// of UTF-8 without '#' and control characters. Numbers of vertices count from 0 within their part. Blank lines, and
/// what follows '#', mean nothing. Counts are those of what follows. A loop has at least three vertices.
namespace touchstone::cell {

struct LinkPolygon {
  std::vector<std::uint32_t> outer;
  std::vector<std::vector<std::uint32_t>> holes;
  friend bool operator==(const LinkPolygon&, const LinkPolygon&) = default;
};

struct LinkPart {
  std::string name;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<LinkPolygon> polygons;
  friend bool operator==(const LinkPart&, const LinkPart&) = default;
};

/// The contents of a model file. Its loops need not bound a region.
struct LinkModel {
  std::string name;
  std::vector<LinkPart> parts;
  friend bool operator==(const LinkModel&, const LinkModel&) = default;
};

/// Reads a model file. Throws BrokenMesh, which names the file and the line, for a file that is missing or has more
/// than 256 MiB, a word, name or number that does not fit the layout, a number beyond the finite doubles, a loop of
/// fewer than three vertices, an unknown vertex, and a wrong count. Numbers are read as the nearest doubles.
[[nodiscard]] LinkModel read_link_model(const std::filesystem::path& file);

/// Returns the text of a model file. Reading it returns the same model, bit by bit. Throws std::invalid_argument for a
/// name that a model file cannot have.
[[nodiscard]] std::string link_model_text(const LinkModel& model);

/// Returns the faces of a solid as a part, with equal points as one vertex, in order of first use.
[[nodiscard]] LinkPart link_part(std::string name, const SolidFaces& solid);
/// Returns model files by name: one of all parts of a link, `Axis1`, and one of every other part, `machine-bed`.
[[nodiscard]] std::map<std::string, LinkModel> link_models(const std::vector<ModelPart>& parts);

}  // namespace touchstone::cell
