// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/cases/failures.h"
#include "experiments/program/sweep.h"
#include "experiments/program/table.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/rejection.h"

/// Wrong answers near every face of meshes.
namespace touchstone::near_edge::faces {

using cases::Failures;
using cases::kTests;
using cases::Test;
using cases::Threshold;

/// The thresholds near which balls are drawn.
inline constexpr std::array kPlaces{Threshold::Face, Threshold::Edge, Threshold::Vertex, Threshold::FootEdge};
/// Returns the name of a place in the tables.
[[nodiscard]] std::string_view place_name(Threshold place);

/// The numbers of doubles by which balls are moved: the radius from the double nearest to the exact distance; for a
/// foot, the centre along one axis.
inline constexpr std::array kSteps{-2, -1, 0, 1, 2};

/// The balls near one face: one per step for each place, in order. Truths are whole answers.
struct FaceCrossing : cases::Crossing {
  std::vector<std::size_t> places;   ///< of kPlaces, those with balls
  std::vector<std::size_t> missing;  ///< those for which none was found, as near needles thinner than the doubles there
  std::size_t mesh = 0;
  std::uint64_t face = 0;

  /// Returns the place of a ball in kPlaces, and its step.
  [[nodiscard]] std::size_t place(std::size_t ball) const { return places[ball / kSteps.size()]; }
  [[nodiscard]] static int steps(std::size_t ball) { return kSteps[ball % kSteps.size()]; }
};

/// Draws balls near one face of a mesh: a function of the arguments alone. Distances are log-uniform, from a hundredth
/// of the face's size to four times it, and smaller only if such balls miss the feature. `exact` verifies every nearest
/// feature. The radius of a ball near a foot is ample.
[[nodiscard]] FaceCrossing draw_face_crossing(const Polygon& polygon, std::uint64_t seed, std::string_view mesh,
                                              std::uint64_t face);

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

struct MethodCounts {
  std::array<std::array<Failures, kTests.size()>, kPlaces.size()>
      at{};                       ///< by place, then test; without undecided ones
  std::uint64_t faces_wrong = 0;  ///< faces with at least one wrong final answer

  /// Returns the sum over all places.
  [[nodiscard]] Failures total(Test test) const;
  auto members() { return std::tie(at, faces_wrong); }
};

struct MeshCounts {
  std::uint64_t faces = 0;                              ///< processed faces, accepted or rejected
  std::uint64_t rejected = 0;                           ///< of these, by the contract
  std::uint64_t queries = 0;                            ///< balls, each asked about with every method
  std::array<std::uint64_t, kPlaces.size()> missing{};  ///< faces near which no such ball was found
  std::vector<MethodCounts> methods;                    ///< in the order of the settings

  auto members() { return std::tie(faces, rejected, queries, missing, methods); }
};

struct RejectedFace {
  std::size_t mesh;
  std::uint64_t face;
  Rejection rejection;

  auto members() { return std::tie(mesh, face, rejection.code, rejection.message); }
};

/// A query with a wrong answer of a method.
struct Failure {
  std::size_t method, mesh;
  std::uint64_t face;
  std::size_t ball;  ///< of the crossing
  std::array<bool, kTests.size()> wrong;
  std::uint64_t lot;  ///< random, to break ties

  auto members() { return std::tie(method, mesh, face, ball, wrong, lot); }
};

/// The number of failures kept per method: wrong final answers first, then those farther from the threshold, then by
/// lot.
inline constexpr std::size_t kKeptFailures = 20;

/// The results about some faces.
struct Result {
  std::vector<MeshCounts> meshes;      ///< in the order given
  std::vector<RejectedFace> rejected;  ///< by mesh, then face
  std::vector<Failure> failures;       ///< by method, the worst first

  /// Adds the results about other faces.
  Result& operator+=(const Result& other);
  auto members() { return std::tie(meshes, rejected, failures); }
};

/// Returns the number of faces.
[[nodiscard]] std::uint64_t items_done(const Result& result);

/// Returns the number of requested faces in all meshes.
[[nodiscard]] std::uint64_t face_count(const Settings& settings, const std::vector<NamedMesh>& meshes);

/// Returns the result about no faces.
[[nodiscard]] Result no_result(const Settings& settings, const std::vector<NamedMesh>& meshes);

/// Asks every method about every ball of the faces of the part, in the order of the meshes; `exact` says what is right.
///
/// A function of settings and meshes. `threads` does not change it, and the counts of one mesh and method do not depend
/// on the others.
void measure(const Settings& settings, const std::vector<NamedMesh>& meshes, const program::RunControl& control,
             Result& result);

/// meshes.csv, rejected.csv, and failures.jsonl: the kept failures, in the contract's form of a case. A query that
/// several methods fail is written once, with the tags of all. `expected` holds the exact answer to only those tests
/// that they fail, so that a method that matches it passes these tests.
///
/// Byte for byte the same for the same settings and meshes, whatever the number of threads. Faces are numbered from 0.
/// Throws std::runtime_error, which names the file, if it cannot be written.
void write(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
           const Result& result);

/// Returns what the tables hold.
[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns the text for the terminal: a row per method, a line per mesh, the rejected faces and a legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result);

}  // namespace touchstone::near_edge::faces
