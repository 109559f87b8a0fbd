// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/method.h"
#include "experiments/run/blocks.h"
#include "experiments/studies/meshes/mesh_balls.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::meshes {

using cases::kTests;
using cases::Test;

/// A named mesh. The name is short, unique in a run, and seeds the random numbers.
struct NamedMesh {
  std::string name;
  Mesh mesh;
};

struct Settings {
  std::vector<const cases::Method*> methods{};
  std::uint64_t seed = 1;
  std::uint64_t faces = std::numeric_limits<std::uint64_t>::max();  ///< the most faces per mesh, from the first on
  unsigned threads = 1;
};

/// The answers of one method to one test.
struct Count {
  std::uint64_t trials = 0;
  std::uint64_t wrongly_in = 0, wrongly_out = 0, boundary_missed = 0;  ///< as cases::Outcome

  [[nodiscard]] std::uint64_t wrong() const { return wrongly_in + wrongly_out + boundary_missed; }
  Count& operator+=(const Count& other);
};

struct MethodCounts {
  std::array<std::array<Count, kTests.size()>, kPlaces.size()> at{};  ///< by place, then test
  std::uint64_t faces_wrong = 0;                                      ///< faces with at least one wrong final answer

  /// Returns the sum over all places.
  [[nodiscard]] Count total(Test test) const;
  MethodCounts& operator+=(const MethodCounts& other);
};

struct MeshCounts {
  std::uint64_t faces = 0;                              ///< processed faces, accepted or rejected
  std::uint64_t rejected = 0;                           ///< of these, by the contract
  std::uint64_t queries = 0;                            ///< balls, each asked about with every method
  std::array<std::uint64_t, kPlaces.size()> missing{};  ///< faces near which no such ball was found
  std::vector<MethodCounts> methods;                    ///< in the order of the settings

  MeshCounts& operator+=(const MeshCounts& other);
};

struct RejectedFace {
  std::size_t mesh;
  std::uint64_t face;
  Rejection rejection;
};

/// A query with a wrong answer of a method.
struct Failure {
  std::size_t method, mesh;
  std::uint64_t face;
  std::size_t ball;  ///< index in draw_mesh_balls
  std::array<bool, kTests.size()> wrong;
  int steps;
  std::uint64_t lot;  ///< random, to break ties
};

/// The number of failures kept per method: wrong final answers first, then those farther from the threshold, then by
/// lot.
inline constexpr std::size_t kKeptFailures = 20;

struct Result {
  std::vector<MeshCounts> meshes;      ///< in the order given
  std::vector<RejectedFace> rejected;  ///< by mesh, then face
  std::vector<Failure> failures;       ///< by method, the worst first
  std::uint64_t faces = 0;             ///< the number of requested faces in all meshes
};

/// Asks every method about every ball of every face, and compares the answers with `exact` as cases::compare does.
///
/// A function of settings and meshes. `threads` does not change it, and the counts of one mesh and method do not depend
/// on the others. A stopped run has processed the first faces, in the order of the meshes.
[[nodiscard]] Result run_study(const Settings& settings, const std::vector<NamedMesh>& meshes,
                               const std::atomic<bool>& stop, const run::Progress& progress);

/// Returns the number of blocks, in which progress is counted.
[[nodiscard]] std::uint64_t block_count(const Settings& settings, const std::vector<NamedMesh>& meshes);

}  // namespace touchstone::meshes
