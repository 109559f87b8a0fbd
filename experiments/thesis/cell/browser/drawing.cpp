// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/methods/triangulate.h"

namespace touchstone::cell::browser {
namespace {

using Json = nlohmann::ordered_json;

/// The faces of a solid as they are drawn. Used for pictures only, never for answers.
struct Drawing {
  NumberedPoints points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> face_ends;  ///< for each face, one past the last of its triangles
  /// The edges at which faces meet at more than 20 degrees, and the edges that do not have exactly two faces.
  std::vector<std::array<std::uint32_t, 2>> outline;
};

constexpr double kCosineOfOutline = 0.93969262078590838;  // of 20 degrees

/// The faces that lie on an edge.
struct Edge {
  std::size_t faces = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();  // where the first one looks
  bool bent = false;
};

Drawing drawing_of(const SolidFaces& solid) {
  Drawing drawing;
  std::map<std::array<std::uint32_t, 2>, Edge> edges;
  for (const Face& face : solid.faces) {
    const Polygon& polygon = face.polygon;
    std::vector<std::uint32_t> own;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) own.push_back(drawing.points.number(polygon.vertex(i)));
    for (const auto& triangle : methods::triangulate(polygon))
      drawing.triangles.push_back({own[triangle[0]], own[triangle[1]], own[triangle[2]]});
    drawing.face_ends.push_back(drawing.triangles.size());

    const Eigen::Vector3d normal = doubled_area(polygon).normalized();
    for (std::size_t i = 0; i < own.size(); ++i) {
      const auto [a, b] = std::minmax(own[i], own[polygon.next(i)]);
      Edge& edge = edges[{a, b}];
      if (edge.faces++ == 0)
        edge.first = normal;
      else if (edge.first.dot(normal) < kCosineOfOutline)
        edge.bent = true;
    }
  }
  for (const auto& [ends, edge] : edges)
    if (edge.bent || edge.faces != 2) drawing.outline.push_back(ends);
  return drawing;
}

/// The edges of a virtual object.
struct Edges {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> all;

  void operator()(const Zone::Face& face) {
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      all.emplace_back(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
  }
  void operator()(const Eigen::AlignedBox3d& box) {
    const auto corner = [&](unsigned bits) { return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(bits)); };
    for (unsigned bits = 0; bits < 8; ++bits)
      for (unsigned i = 0; i < 3; ++i)
        if (((bits >> i) & 1U) == 0) all.emplace_back(corner(bits), corner(bits | (1U << i)));
  }
  /// Circles across the axis at both ends, half circles beyond them, and lines along it.
  void operator()(const Zone::Capsule& capsule) {
    const Eigen::Vector3d way = capsule.to - capsule.from;
    const Eigen::Vector3d along = way.norm() > 0 ? Eigen::Vector3d(way.normalized()) : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d one = along.unitOrthogonal(), other = along.cross(one);
    constexpr int kSides = 32;
    const auto arc = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int sides) {
      const auto point = [&](int i) -> Eigen::Vector3d {
        const double angle = 2 * std::numbers::pi * i / kSides;
        return at + capsule.radius * (std::cos(angle) * u + std::sin(angle) * v);
      };
      for (int i = 0; i < sides; ++i) all.emplace_back(point(i), point(i + 1));
    };
    for (const Eigen::Vector3d& end : {capsule.from, capsule.to}) arc(end, one, other, kSides);
    for (const Eigen::Vector3d& across : {one, other}) {
      arc(capsule.to, across, along, kSides / 2);
      arc(capsule.from, across, -along, kSides / 2);
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d out = side * capsule.radius * across;
        all.emplace_back(capsule.from + out, capsule.to + out);
      }
    }
  }
};

}  // namespace

/// For pictures: the shortest number that is read as the nearest float.
double drawn(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), static_cast<float>(value)).ptr;
  double result = 0;
  std::from_chars(text.begin(), end, result);
  return result;
}

Json drawn(const Eigen::Vector3d& at) { return {drawn(at.x()), drawn(at.y()), drawn(at.z())}; }

Json part_json(const ModelPart& part) {
  const Drawing drawing = drawing_of(part.faces);
  Json points = Json::array(), triangles = Json::array(), outline = Json::array();
  for (const Eigen::Vector3d& point : drawing.points.points)
    for (const double coordinate : point) points.push_back(drawn(coordinate));
  for (const auto& triangle : drawing.triangles)
    for (const std::uint32_t corner : triangle) triangles.push_back(corner);
  for (const auto& edge : drawing.outline)
    for (const std::uint32_t end : edge) outline.push_back(end);
  return {{"name", part.name},
          {"carrier", to_string(part.carrier)},
          {"link", part.link},
          {"points", std::move(points)},
          {"triangles", std::move(triangles)},
          {"face_ends", drawing.face_ends},
          {"outline", std::move(outline)}};
}

Json zones_json(const Cell& cell) {
  Json zones = Json::array();
  for (const Zone& zone : cell.zones) {
    Edges edges;
    std::visit(edges, zone.shape);
    Json points = Json::array(), outline = Json::array();
    for (const auto& [from, to] : edges.all)
      for (const Eigen::Vector3d& end : {from, to}) {
        outline.push_back(outline.size());
        const Eigen::Vector3d at = zone.pose * end;
        for (const double coordinate : at) points.push_back(static_cast<float>(coordinate));
      }
    zones.push_back({{"name", zone.name},
                     {"stops", zone.stops},
                     {"points", std::move(points)},
                     {"triangles", Json::array()},
                     {"face_ends", Json::array()},
                     {"outline", std::move(outline)}});
  }
  return zones;
}

}  // namespace touchstone::cell::browser
