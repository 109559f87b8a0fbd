// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/run/state.h"
#include "experiments/run/table.h"
#include "experiments/run/timing.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/mesh.h"
#include "robust/mesh/merge.h"

/// The study of meshes whose coplanar faces are merged into polygons: `touchstone merging`.
namespace touchstone::merging {

struct Settings {
  double tolerance = 0;        ///< in the meshes' own unit
  std::uint64_t balls = 1000;  ///< queries of each scene, per mesh; 0: scenes are not compared
  std::size_t least = 8;       ///< the least number of faces that a polygon of the mixed scene replaces
  unsigned repetitions = 7;    ///< for every timing
  std::uint64_t seed = 1;
  unsigned threads = 1;  ///< that compare answers; timings are those of one thread
};

/// The compared scenes, all of the same faces.
enum class Kind {
  Faces,   ///< as the mesh has them
  Merged,  ///< every merged face as one polygon
  Mixed,   ///< only those of at least `least` faces
};
inline constexpr std::array kKinds{Kind::Faces, Kind::Merged, Kind::Mixed};

/// The queries that scenes answer.
enum class Question { Any, All, Nearest };
inline constexpr std::array kQuestions{Question::Any, Question::All, Question::Nearest};

[[nodiscard]] std::string_view to_string(Kind kind);
[[nodiscard]] std::string_view to_string(Question question);

/// The result of merging a mesh: a function of the mesh and the tolerance.
struct Counts {
  std::size_t faces = 0, rejected = 0;  ///< of the mesh
  std::size_t polygons = 0;             ///< merged faces
  std::size_t single = 0;               ///< of these, those of one face
  std::size_t holes = 0, vertices = 0;  ///< of all merged faces
  run::Maximum<std::size_t> largest{};  ///< vertices of the largest
  std::size_t splits = 0;
  mesh::EdgeCounts edges;
  run::Maximum<double> off_plane{};  ///< the largest

  auto members() {
    return std::tie(faces, rejected, polygons, single, holes, vertices, largest, splits, edges.border,
                    edges.non_manifold, edges.inconsistent, edges.merged, edges.folded, edges.kept_apart, edges.crease,
                    off_plane);
  }
};

/// A merged face.
struct PolygonCounts {
  std::size_t faces = 0;  ///< of the mesh
  std::size_t edges = 0, holes = 0;
  double off_plane = 0;  ///< as MergedFace has it

  auto members() { return std::tie(faces, edges, holes, off_plane); }
};

/// A scene of one kind.
struct Measured {
  std::size_t triangles = 0, polygons = 0;
  std::size_t memory = 0;                                          ///< bytes, as the C library counts what is allocated
  double seconds = 0;                                              ///< to build it
  std::array<timing::Quartiles, kQuestions.size()> nanoseconds{};  ///< a ball, of the repetitions

  auto members() { return std::tie(triangles, polygons, memory, seconds, nanoseconds); }
};

/// Answers that differ from those of the scene of faces.
struct Differences {
  std::array<std::uint64_t, kQuestions.size()> asked{}, differ{};  ///< in both other scenes together
  run::Maximum<double> distance{};                                 ///< the largest difference of nearest distances

  void note(Question question, bool differs) {
    ++asked[static_cast<std::size_t>(question)];
    differ[static_cast<std::size_t>(question)] += differs ? 1 : 0;
  }
  auto members() { return std::tie(asked, differ, distance); }
};

struct MeshResult {
  std::string name;
  Counts counts;
  std::vector<PolygonCounts> polygons;       ///< by their lowest face of the mesh
  std::vector<mesh::RejectedFace> rejected;  ///< not kept in checkpoints
  double merge_seconds = 0;
  std::array<Measured, kKinds.size()> measured{};  ///< zeros if scenes are not compared
  Differences differences;

  auto members() { return std::tie(name, counts, polygons, merge_seconds, measured, differences); }
};

/// The results of some files.
struct Results {
  std::uint64_t files = 0;                   ///< those too that are bad
  std::uint64_t bad = 0;                     ///< files that cannot be read, or have faces that are not polygons
  std::map<std::uint64_t, MeshResult> read;  ///< by the number of the file

  /// Adds the results of other files.
  Results& operator+=(const Results& other) {
    files += other.files, bad += other.bad;
    read.insert(other.read.begin(), other.read.end());
    return *this;
  }
  /// Returns those of the meshes, in the order of the files.
  [[nodiscard]] std::vector<MeshResult> meshes() const {
    std::vector<MeshResult> meshes;
    for (const auto& [file, mesh] : read) meshes.push_back(mesh);
    return meshes;
  }
  auto members() { return std::tie(files, bad, read); }
};

[[nodiscard]] inline std::uint64_t items_done(const Results& results) { return results.files; }

/// Draws a ball near the surface: its centre is a point of a random face, moved by 2^-11 to 2^-1 of the mesh's size;
/// its radius is between half and one and a half times that distance. Always finite: values that would overflow become
/// the largest double. A function of the arguments. Requires a face that is not rejected.
[[nodiscard]] Ball draw_ball(const Mesh& mesh, const mesh::MergedMesh& merged, std::uint64_t seed, std::uint64_t index);

/// Merges, and queries the scenes; asks `nearest` about every tenth ball. Only times and memory differ between two
/// runs. Returns nothing if `stop` was set before it finished; checks `stop` for each face, polygon and ball.
[[nodiscard]] std::optional<MeshResult> study(const Settings& settings, std::string name, const Mesh& mesh,
                                              const std::atomic<bool>& stop);

// Each writes a table: tables() says what it holds. All but the times have the same bytes for the same settings and
// meshes. Each throws std::runtime_error, which names the file, if it cannot be written.

void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the table for the terminal: one row per mesh and the sum; if scenes were compared, their costs; and a
/// legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<MeshResult>& results);

}  // namespace touchstone::merging
