// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/mesh.h"

namespace touchstone::mesh_tests {

/// The unit cube of twelve triangles, oriented outwards.
[[nodiscard]] Mesh cube();

/// The unit squares of columns x rows of the plane z = 0 that are there, two triangles each; vertex (i, j) has number
/// j (columns + 1) + i. Counterclockwise as seen from above, or clockwise.
[[nodiscard]] Mesh grid(int columns, int rows, const std::function<bool(int i, int j)>& there, bool flipped = false);

/// Returns a row of `squares` squares in z = 0 about the origin, each beside the last, in turns of a right angle; turns
/// do not share vertices.
[[nodiscard]] Mesh winding(int squares);

/// Every face with vertices of its own.
[[nodiscard]] Mesh unwelded(const Mesh& mesh);

/// Every coordinate moved by up to `most`.
[[nodiscard]] Mesh shaken(Mesh mesh, double most, std::uint64_t index);

/// Calls f(mesh, index, words) for random meshes of triangles, welded: steps and terraces of several planes with gaps,
/// touching in vertices, some faces flipped, doubled, folded back or without area; in an exact lattice frame, so that
/// neighbours are exactly coplanar. Every third mesh has T-junctions. A function of the index.
void for_each_random_mesh(std::uint64_t count,
                          const std::function<void(const Mesh&, std::uint64_t, const std::string&)>& f);

/// Balls about vertices, edges and insides of these faces: on them, tangent to a plane, or anywhere near.
[[nodiscard]] std::vector<Ball> balls_near(const Mesh& mesh, const std::vector<std::uint32_t>& faces,
                                           std::uint64_t index);

}  // namespace touchstone::mesh_tests
