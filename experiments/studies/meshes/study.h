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
#include "experiments/harness/blocks.h"
#include "experiments/studies/meshes/mesh_balls.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::meshes {

using cases::kTests;
using cases::Test;

/// The name is short, unique in a run, and drives the random numbers.
struct NamedMesh {
  std::string name;
  Mesh mesh;
};

struct Settings {
  std::vector<const cases::Method*> methods{};
  std::uint64_t seed = 1;
  std::uint64_t faces = std::numeric_limits<std::uint64_t>::max();  ///< of each mesh, the first ones, at most
  unsigned threads = 1;
};

/// What one method answered to one test.
struct Count {
  std::uint64_t trials = 0;
  std::uint64_t wrongly_in = 0, wrongly_out = 0, boundary_missed = 0;  ///< as cases::Outcome

  [[nodiscard]] std::uint64_t wrong() const { return wrongly_in + wrongly_out + boundary_missed; }
  Count& operator+=(const Count& other);
};

struct MethodCounts {
  std::array<std::array<Count, kTests.size()>, kPlaces.size()> at{};  ///< by place, then test
  std::uint64_t faces_wrong = 0;                                      ///< faces with at least one wrong final answer

  /// Over all places.
  [[nodiscard]] Count total(Test test) const;
  MethodCounts& operator+=(const MethodCounts& other);
};

struct MeshCounts {
  std::uint64_t faces = 0;                              ///< that were come to: accepted or rejected
  std::uint64_t rejected = 0;                           ///< of these, by the contract
  std::uint64_t queries = 0;                            ///< balls that each method was asked about
  std::array<std::uint64_t, kPlaces.size()> missing{};  ///< faces near which no such ball was found
  std::vector<MethodCounts> methods;                    ///< in the order of the settings

  MeshCounts& operator+=(const MeshCounts& other);
};

struct RejectedFace {
  std::size_t mesh;
  std::uint64_t face;
  Rejection rejection;
};

/// A query that a method answered wrongly.
struct Failure {
  std::size_t method, mesh;
  std::uint64_t face;
  std::size_t ball;  ///< in draw_mesh_balls
  std::array<bool, kTests.size()> wrong;
  int steps;
  std::uint64_t lot;  ///< random, to choose among equals
};

/// How many failures of each method are kept: a wrong final answer before others, then those farther from the
/// threshold, then by lot.
inline constexpr std::size_t kKeptFailures = 20;

struct Result {
  std::vector<MeshCounts> meshes;      ///< in the order given
  std::vector<RejectedFace> rejected;  ///< by mesh, then face
  std::vector<Failure> failures;       ///< by method, the worst first
  std::uint64_t faces = 0;             ///< that were to be asked about, in all meshes
};

/// Asks every method about every ball of every face, and compares with `exact` as cases::compare does.
///
/// A function of settings and meshes; `threads` changes nothing, and neither do the other meshes and methods what is
/// counted for one. A run that was stopped has come to the first faces, in the order of the meshes.
[[nodiscard]] Result run_study(const Settings& settings, const std::vector<NamedMesh>& meshes,
                               const std::atomic<bool>& stop, const harness::Progress& progress);

/// Progress is counted in blocks; there are so many.
[[nodiscard]] std::uint64_t block_count(const Settings& settings, const std::vector<NamedMesh>& meshes);

}  // namespace touchstone::meshes
