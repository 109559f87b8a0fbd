// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/convert.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "experiments/methods/triangulate.h"
#include "geometry/io/read_mesh.h"
#include "robust/exact/validate.h"
#include "robust/mesh/merge.h"
#include "robust/mesh/weld.h"

namespace touchstone::cell {
namespace {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

std::string point_text(const Eigen::Vector3d& p) { return fmt::format("{} {} {}", p.x(), p.y(), p.z()); }

/// All parts' vertices and polygons, numbered together from `first`.
template <class AddVertex, class AddPolygon>
void for_all(const LinkModel& model, std::size_t first, const AddVertex& add_vertex, const AddPolygon& add_polygon) {
  for (const LinkPart& part : model.parts)
    for (const Eigen::Vector3d& vertex : part.vertices) add_vertex(vertex);
  for (const LinkPart& part : model.parts) {
    for (const LinkPolygon& polygon : part.polygons) {
      std::vector<std::size_t> numbers;
      for (const std::uint32_t corner : polygon.outer) numbers.push_back(first + corner);
      add_polygon(part, polygon, numbers);
    }
    first += part.vertices.size();
  }
}

std::string obj_text(const LinkModel& model) {
  std::string text;
  const LinkPart* current = nullptr;
  for_all(
      model, 1, [&](const Eigen::Vector3d& vertex) { text += "v " + point_text(vertex) + "\n"; },
      [&](const LinkPart& part, const LinkPolygon&, const std::vector<std::size_t>& numbers) {
        if (current != &part) text += "o " + part.name + "\n";
        current = &part;
        text += fmt::format("f {}\n", fmt::join(numbers, " "));
      });
  return text;
}

/// Vertices and then polygons, each led by its number of corners, as OFF and PLY have them.
std::string counted_lines(const LinkModel& model) {
  std::string text;
  for_all(
      model, 0, [&](const Eigen::Vector3d& vertex) { text += point_text(vertex) + "\n"; },
      [&](const LinkPart&, const LinkPolygon&, const std::vector<std::size_t>& numbers) {
        text += fmt::format("{} {}\n", numbers.size(), fmt::join(numbers, " "));
      });
  return text;
}

std::string off_text(const LinkModel& model) {
  const ModelCounts counts = counts_of(model);
  return fmt::format("OFF\n{} {} 0\n", counts.vertices, counts.polygons) + counted_lines(model);
}

std::string ply_text(const LinkModel& model) {
  const ModelCounts counts = counts_of(model);
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
             "element face {}\nproperty list uint uint vertex_indices\nend_header\n",
             counts.vertices, counts.polygons) +
         counted_lines(model);
}

std::string stl_text(const LinkModel& model) {
  std::string text = "solid " + model.name + "\n";
  for (const LinkPart& part : model.parts)
    for (const LinkPolygon& polygon : part.polygons) {
      const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& { return part.vertices[polygon.outer[i]]; };
      const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).stableNormalized();
      text += "facet normal " + point_text(normal.allFinite() ? normal : Eigen::Vector3d(0, 0, 0)) + "\nouter loop\n";
      for (std::size_t i = 0; i < 3; ++i) text += "vertex " + point_text(corner(i)) + "\n";
      text += "endloop\nendfacet\n";
    }
  return text + "endsolid " + model.name + "\n";
}

Polygon polygon_of(const std::string& name, std::size_t face, const LinkPart& part, const LinkPolygon& given) {
  const auto loop = [&](const std::vector<std::uint32_t>& numbers) {
    Loop result;
    for (const std::uint32_t number : numbers) result.push_back(part.vertices[number]);
    return result;
  };
  std::optional<Rejection> rejection;
  try {
    std::vector<Loop> holes;
    for (const auto& hole : given.holes) holes.push_back(loop(hole));
    Polygon polygon(loop(given.outer), holes);
    rejection = exact::validate(polygon);
    if (!rejection) return polygon;
  } catch (const Rejected& rejected) {
    rejection = rejected.rejection();
  }
  throw BadConversion(fmt::format("{}: part {}: face {}: {}: {}", name, part.name, face, to_string(rejection->code),
                                  rejection->message));
}

bool has_holes(const LinkPart& part) {
  return std::any_of(part.polygons.begin(), part.polygons.end(), [](const auto& each) { return !each.holes.empty(); });
}

Mesh mesh_of(const LinkPart& part) {
  Mesh mesh{part.vertices, {}};
  for (const LinkPolygon& polygon : part.polygons) mesh.faces.push_back(polygon.outer);
  return mesh;
}

LinkPart triangulated(const std::string& name, const LinkPart& part, bool all) {
  LinkPart result{part.name, part.vertices, {}};
  for (std::size_t face = 0; face < part.polygons.size(); ++face) {
    const LinkPolygon& given = part.polygons[face];
    if (given.holes.empty() && (!all || given.outer.size() == 3)) {
      result.polygons.push_back(given);
      continue;
    }
    std::vector<std::uint32_t> numbers = given.outer;
    for (const auto& hole : given.holes) numbers.insert(numbers.end(), hole.begin(), hole.end());
    for (const auto& triangle : methods::triangulate(polygon_of(name, face, part, given)))
      result.polygons.push_back({{numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]]}, {}});
  }
  return result;
}

LinkPart merged(const std::string& name, const LinkPart& part) {
  const Mesh mesh = mesh_of(part);
  mesh::MergedMesh merged = mesh::merge_faces(mesh);
  if (!merged.rejected.empty()) {
    const auto& [face, rejection] = merged.rejected.front();
    throw BadConversion(fmt::format("{}: part {}: face {}: {}: {}", name, part.name, face, to_string(rejection.code),
                                    rejection.message));
  }
  SolidFaces faces;
  for (mesh::MergedFace& face : merged.faces) faces.faces.push_back({std::move(face.polygon), face.off_plane});
  return link_part(part.name, faces);
}

LinkPart welded(const LinkPart& part) {
  Mesh loops{part.vertices, {}};
  for (const LinkPolygon& polygon : part.polygons) {
    loops.faces.push_back(polygon.outer);
    loops.faces.insert(loops.faces.end(), polygon.holes.begin(), polygon.holes.end());
  }
  Mesh welded = mesh::weld(loops);
  LinkPart result{part.name, std::move(welded.vertices), {}};
  auto loop = welded.faces.begin();
  for (const LinkPolygon& polygon : part.polygons) {
    const auto holes = static_cast<std::ptrdiff_t>(polygon.holes.size());
    result.polygons.push_back({*loop, {loop + 1, loop + 1 + holes}});
    loop += 1 + holes;
  }
  return result;
}

/// The corners of all polygons, each once, in order.
std::vector<std::array<double, 3>> points_of(const LinkModel& model) {
  std::vector<std::array<double, 3>> points;
  for (const LinkPart& part : model.parts)
    for (const LinkPolygon& polygon : part.polygons) {
      const auto take = [&](const std::vector<std::uint32_t>& loop) {
        for (const std::uint32_t number : loop) {
          const Eigen::Vector3d& p = part.vertices[number];
          points.push_back({p.x(), p.y(), p.z()});
        }
      };
      take(polygon.outer);
      for (const auto& hole : polygon.holes) take(hole);
    }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Returns the number of polygons by number of corners.
std::map<std::size_t, std::size_t> corners_of(const LinkModel& model) {
  std::map<std::size_t, std::size_t> count;
  for (const LinkPart& part : model.parts)
    for (const LinkPolygon& polygon : part.polygons) {
      std::size_t corners = polygon.outer.size();
      for (const auto& hole : polygon.holes) corners += hole.size();
      ++count[corners];
    }
  return count;
}

}  // namespace

LinkModel read_model(const std::filesystem::path& file) {
  if (extension_of(file) == ".txt") return read_link_model(file);
  const std::string name = file.stem().string();
  return {name, {link_part(name, read_mesh(file).mesh)}};
}

std::string model_text(const LinkModel& model, const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".txt") return link_model_text(model);
  if (extension == ".obj") return obj_text(model);
  if (extension == ".off") return off_text(model);
  if (extension == ".ply") return ply_text(model);
  if (extension == ".stl") return stl_text(model);
  throw BadConversion(file.string() + ": the extension '" + extension + "' must be .txt, .obj, .off, .stl or .ply");
}

LinkModel prepared(const LinkModel& model, Preparation preparation, const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  LinkModel result{model.name, {}};
  for (const LinkPart& part : model.parts) {
    LinkPart next = part;
    if (preparation == Preparation::Merge) {
      // Holes are cut away for the merging, which finds them again.
      next = merged(model.name, has_holes(next) ? triangulated(model.name, next, false) : next);
    } else if (preparation == Preparation::Weld) {
      next = welded(next);
    }
    if (extension != ".txt") next = triangulated(model.name, next, extension == ".stl");
    result.parts.push_back(std::move(next));
  }
  return result;
}

ModelCounts counts_of(const LinkModel& model) {
  ModelCounts counts;
  counts.parts = model.parts.size();
  for (const LinkPart& part : model.parts) {
    counts.vertices += part.vertices.size();
    counts.polygons += part.polygons.size();
    for (const LinkPolygon& polygon : part.polygons) {
      counts.holes += polygon.holes.size();
      if (polygon.outer.size() == 3 && polygon.holes.empty()) ++counts.triangles;
    }
  }
  const auto points = points_of(model);
  counts.points = points.size();
  for (const auto& [x, y, z] : points) counts.bounds.extend(Eigen::Vector3d(x, y, z));
  return counts;
}

std::vector<std::string> differences(const LinkModel& written, const LinkModel& read) {
  const ModelCounts a = counts_of(written), b = counts_of(read);
  std::vector<std::string> result;
  if (a.polygons != b.polygons) result.push_back(fmt::format("{} polygons became {}", a.polygons, b.polygons));
  if (a.holes != b.holes) result.push_back(fmt::format("{} holes became {}", a.holes, b.holes));
  if (corners_of(written) != corners_of(read)) result.emplace_back("polygons have other numbers of corners");
  if (points_of(written) != points_of(read))
    result.push_back(fmt::format("{} points became {} or others", a.points, b.points));
  if (!a.bounds.isEmpty() && (a.bounds.min() != b.bounds.min() || a.bounds.max() != b.bounds.max()))
    result.emplace_back("the bounds have changed");
  return result;
}

}  // namespace touchstone::cell
