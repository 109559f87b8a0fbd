// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/merging/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/harness/write_file.h"
#include "experiments/statistics/clopper_pearson.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::merging {
namespace {

double mean_vertices(const Counts& counts) {
  return static_cast<double>(counts.vertices) / static_cast<double>(std::max<std::size_t>(counts.polygons, 1));
}

std::string counts_row(const std::string& name, const Counts& c, double seconds) {
  const std::size_t unmergeable = c.edges.non_manifold + c.edges.inconsistent + c.edges.folded;
  return fmt::format("{:<28}{:>8}{:>6}{:>9}{:>8}{:>7}{:>8}{:>8.2f}{:>8}{:>7}{:>8}{:>10}{:>10.3g}{:>9.1f}\n", name,
                     c.faces, c.rejected, c.polygons, c.single, c.holes, c.largest, mean_vertices(c), c.splits,
                     c.edges.kept_apart, c.edges.border, unmergeable, c.off_plane, 1e3 * seconds);
}

std::string counts_table(const std::vector<MeshResult>& results) {
  std::string text = fmt::format("{:<28}{:>8}{:>6}{:>9}{:>8}{:>7}{:>8}{:>8}{:>8}{:>7}{:>8}{:>10}{:>10}{:>9}\n", "mesh",
                                 "faces", "bad", "polygons", "single", "holes", "largest", "mean", "splits", "apart",
                                 "border", "unmerged", "off plane", "ms");
  Counts sum;
  double seconds = 0;
  for (const MeshResult& result : results) {
    text += counts_row(io::legible(result.name), result.counts, result.merge_seconds);
    sum += result.counts;
    seconds += result.merge_seconds;
  }
  if (results.size() > 1) text += counts_row("all", sum, seconds);
  return text;
}

/// The geometric mean of a cost beside that of the scene of faces; "-" where no mesh has one.
template <class Cost>
std::string mean_ratio(const std::vector<MeshResult>& results, Kind kind, const Cost& cost) {
  double sum = 0, count = 0;
  for (const MeshResult& result : results) {
    const double base = cost(result.measured[0]);
    if (!(base > 0)) continue;
    sum += std::log(cost(result.measured[static_cast<std::size_t>(kind)]) / base);
    ++count;
  }
  return count > 0 ? fmt::format("{:.2f}", std::exp(sum / count)) : "-";
}

std::string costs_table(const std::vector<MeshResult>& results) {
  std::string text = fmt::format("\n{:<28}{:>8}{:>10}{:>9}{:>10}{:>10}{:>11}{:>10}{:>12}\n", "mesh", "scene",
                                 "triangles", "polygons", "any ns", "all ns", "nearest ns", "memory KB", "build ms");
  for (const MeshResult& result : results)
    for (const Kind kind : kKinds) {
      const Measured& m = result.measured[static_cast<std::size_t>(kind)];
      text += fmt::format("{:<28}{:>8}{:>10}{:>9}{:>10.0f}{:>10.0f}{:>11.0f}{:>10.0f}{:>12.2f}\n",
                          kind == Kind::Faces ? io::legible(result.name) : "", word(kind), m.triangles, m.polygons,
                          m.nanoseconds[0], m.nanoseconds[1], m.nanoseconds[2], static_cast<double>(m.memory) / 1024,
                          1e3 * m.seconds);
    }
  for (const Kind kind : {Kind::Merged, Kind::Mixed}) {
    const auto query = [&](std::size_t i) {
      return mean_ratio(results, kind, [i](const Measured& m) { return m.nanoseconds[i]; });
    };
    text += fmt::format("{:<28}{:>8}{:>10}{:>9}{:>10}{:>10}{:>11}{:>10}{:>12}\n", "mean ratio to faces", word(kind), "",
                        "", query(0), query(1), query(2),
                        mean_ratio(results, kind, [](const Measured& m) { return static_cast<double>(m.memory); }),
                        mean_ratio(results, kind, [](const Measured& m) { return m.seconds; }));
  }
  return text;
}

std::string differences_lines(const std::vector<MeshResult>& results) {
  Differences sum;
  for (const MeshResult& result : results) {
    for (std::size_t i = 0; i < kQuestions.size(); ++i) {
      sum.asked[i] += result.differences.asked[i];
      sum.differ[i] += result.differences.differ[i];
    }
    sum.distance = std::max(sum.distance, result.differences.distance);
  }
  std::string text = "\nAnswers that differ from those of the faces (95 % limits):\n";
  for (std::size_t i = 0; i < kQuestions.size(); ++i) {
    const auto limits = statistics::clopper_pearson(sum.differ[i], sum.asked[i]);
    text += fmt::format("  {:<8} {} of {}, at most {:.2g} %\n", word(kQuestions[i]), sum.differ[i], sum.asked[i],
                        100 * limits.upper);
  }
  return text + fmt::format("  the largest difference of nearest distances: {:.3g}\n", sum.distance);
}

constexpr const char* kLegend = R"(
bad: faces that the contract rejects, left out. single: polygons of one face. largest, mean: vertices of a polygon.
splits: how often a region was cut, since it touched or covered itself; apart: edges between coplanar faces left by
that. border: edges of one face. unmerged: edges of more than two faces, of two that are not oriented alike, or of two
that are folded onto each other. off plane: the largest move of a vertex onto the plane of its polygon.
)";

constexpr const char* kCostsLegend =
    R"(faces: the scene of the mesh's own faces; merged: of all polygons, those of three vertices as triangles; mixed: of the
polygons that stand for {} faces or more, and the other faces as they are. Times: median of {} repetitions, a ball near
the surface; nearest: of every tenth ball. memory: what the scene has allocated. mean ratio: geometric, over meshes.
)";

}  // namespace

void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  std::string text =
      "mesh,faces,rejected,polygons,single,holes,vertices,largest,splits,border,non_manifold,inconsistent,merged_edges,"
      "folded,kept_apart,crease,off_plane";
  for (const Question question : kQuestions) text += fmt::format(",{0}_asked,{0}_differ", word(question));
  text += ",distance_difference\n";
  for (const MeshResult& result : results) {
    const Counts& c = result.counts;
    const mesh::EdgeCounts& e = c.edges;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", harness::csv_field(result.name), c.faces,
                        c.rejected, c.polygons, c.single, c.holes, c.vertices, c.largest, c.splits, e.border,
                        e.non_manifold, e.inconsistent, e.merged, e.folded, e.kept_apart, e.crease, c.off_plane);
    for (std::size_t i = 0; i < kQuestions.size(); ++i)
      text += fmt::format(",{},{}", result.differences.asked[i], result.differences.differ[i]);
    text += fmt::format(",{}\n", result.differences.distance);
  }
  harness::write_file(folder / "merge.csv", text);
}

void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  std::string text = "mesh,polygon,faces,edges,holes,off_plane\n";
  for (const MeshResult& result : results) {
    const std::string mesh = harness::csv_field(result.name);
    for (std::size_t i = 0; i < result.polygons.size(); ++i) {
      const PolygonCounts& polygon = result.polygons[i];
      text +=
          fmt::format("{},{},{},{},{},{}\n", mesh, i, polygon.faces, polygon.edges, polygon.holes, polygon.off_plane);
    }
  }
  harness::write_file(folder / "polygons.csv", text);
}

void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  std::string text =
      "mesh,merge_seconds,scene,triangles,polygons,memory_bytes,build_seconds,any_ns,all_ns,nearest_ns\n";
  for (const MeshResult& result : results)
    for (const Kind kind : kKinds) {
      const Measured& m = result.measured[static_cast<std::size_t>(kind)];
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", harness::csv_field(result.name), result.merge_seconds,
                          word(kind), m.triangles, m.polygons, m.memory, m.seconds, m.nanoseconds[0], m.nanoseconds[1],
                          m.nanoseconds[2]);
    }
  harness::write_file(folder / "merge-times.csv", text);
}

std::string table(const Settings& settings, const std::vector<MeshResult>& results) {
  std::string text = counts_table(results);
  const bool compared =
      std::ranges::any_of(results, [](const MeshResult& result) { return result.differences.asked[0] > 0; });
  if (compared) text += costs_table(results) + differences_lines(results);
  text += kLegend;
  if (compared) text += fmt::format(fmt::runtime(kCostsLegend), settings.least, settings.repetitions);
  return text;
}

}  // namespace touchstone::merging
