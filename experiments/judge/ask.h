// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/polygon.h"
#include "robust/scene/scene.h"

// What `touchstone ask` reads: shapes as people write them, and the faces of a mesh file.
namespace touchstone::judge {

/// Returns the polygon of a text. The text is either loops or WKT:
///  - loops are separated by `;`, the outer loop first; their points by `,`; coordinates by white space:
///    `0 0 0, 4 0 0, 0 4 0; 1 1 0, 2 1 0, 1 2 0`;
///  - WKT repeats the first point of each loop at its end, which is left out here:
///    `POLYGON Z ((0 0 0, 4 0 0, 0 4 0, 0 0 0))`.
///
/// A point of two coordinates lies at z = 0. Numbers are read as the nearest doubles. Throws std::runtime_error, which
/// names the loop and the point, if the text does not have this form, and Rejected as Polygon and exact::validate say.
[[nodiscard]] Polygon polygon_of(std::string_view text);

/// Returns the numbers of a text such as `1,2.5,-3`. Throws std::runtime_error, which names the number, if there are
/// not as many, or one is not finite.
[[nodiscard]] Eigen::VectorXd numbers_of(std::string_view text, int count);

/// The faces of a mesh file.
struct AskedMesh {
  Mesh mesh;
  scene::Scene scene;                  ///< of one object, named by folder and file: `arm/link1`
  std::vector<std::uint32_t> numbers;  ///< of each face of the scene: its number in the mesh, from 0
  std::vector<double> off_plane;       ///< of each face of the scene, as in an answer
};

/// Reads it, and prints its warnings on standard error.
///
/// Throws std::runtime_error, which names the file and the place, for what `read_mesh` refuses and for the first face
/// that the contract rejects.
[[nodiscard]] AskedMesh read_asked_mesh(const std::string& file);

/// A ball of a file.
struct ListedBall {
  std::size_t line;  ///< of the file, from 1
  cases::Question question;
};

/// Reads one ball a line: four numbers, x y z r, or seven, x y z r and the end of its way, separated by blanks, with `#`
/// before a comment. Skips lines of white space; "-" is standard input.
///
/// Throws std::runtime_error, which names file and line, for invalid input and for a ball that the contract rejects.
[[nodiscard]] std::vector<ListedBall> read_balls(const std::string& file);

/// Returns a line of JSON for each ball: `id` (the number of its line), `ball` and `motion` as in a case of the contract;
/// then `touched`, the faces that it touches, ascending, or, of a ball that moves, in the order of time with the first
/// contact of each; or with `nearest` the nearest face with its feature, point and distance, for balls at a place.
///
/// Cost: that of the scene's questions about many balls, which use all cores, and about 10 us for each line.
[[nodiscard]] std::string answers_about(const AskedMesh& mesh, std::span<const ListedBall> balls, bool nearest);

}  // namespace touchstone::judge
