// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/run/statistics/shares.h"
#include "experiments/run/table.h"
#include "experiments/studies/merging/measure.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::merging {
namespace {

double mean_vertices(const Counts& counts) {
  return static_cast<double>(counts.vertices) / static_cast<double>(std::max<std::size_t>(counts.polygons, 1));
}

std::string counts_row(const std::string& name, const Counts& c, double seconds) {
  const std::size_t unmergeable = c.edges.non_manifold + c.edges.inconsistent + c.edges.folded;
  return fmt::format("{:<28}{:>8}{:>6}{:>9}{:>8}{:>7}{:>8}{:>8.2f}{:>8}{:>7}{:>8}{:>10}{:>10.3g}{:>9.1f}\n", name,
                     c.faces, c.rejected, c.polygons, c.single, c.holes, c.largest.value, mean_vertices(c), c.splits,
                     c.edges.kept_apart, c.edges.border, unmergeable, c.off_plane.value, 1e3 * seconds);
}

std::string counts_lines(const std::vector<MeshResult>& results) {
  std::string text = fmt::format("{:<28}{:>8}{:>6}{:>9}{:>8}{:>7}{:>8}{:>8}{:>8}{:>7}{:>8}{:>10}{:>10}{:>9}\n", "mesh",
                                 "faces", "bad", "polygons", "single", "holes", "largest", "mean", "splits", "apart",
                                 "border", "unmerged", "off plane", "ms");
  Counts sum;
  double seconds = 0;
  for (const MeshResult& result : results) {
    text += counts_row(io::legible(result.name), result.counts, result.merge_seconds);
    run::add(sum, result.counts);
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
                          kind == Kind::Faces ? io::legible(result.name) : "", to_string(kind), m.triangles, m.polygons,
                          m.nanoseconds[0].median, m.nanoseconds[1].median, m.nanoseconds[2].median,
                          static_cast<double>(m.memory) / 1024, 1e3 * m.seconds);
    }
  for (const Kind kind : {Kind::Merged, Kind::Mixed}) {
    const auto query = [&](std::size_t i) {
      return mean_ratio(results, kind, [i](const Measured& m) { return m.nanoseconds[i].median; });
    };
    text += fmt::format("{:<28}{:>8}{:>10}{:>9}{:>10}{:>10}{:>11}{:>10}{:>12}\n", "mean ratio to faces",
                        to_string(kind), "", "", query(0), query(1), query(2),
                        mean_ratio(results, kind, [](const Measured& m) { return static_cast<double>(m.memory); }),
                        mean_ratio(results, kind, [](const Measured& m) { return m.seconds; }));
  }
  return text;
}

std::string differences_lines(const std::vector<MeshResult>& results) {
  Differences sum;
  for (const MeshResult& result : results) run::add(sum, result.differences);
  std::string text = "\nAnswers that differ from those of the faces (95 % limits):\n";
  for (std::size_t i = 0; i < kQuestions.size(); ++i) {
    const auto limits = statistics::clopper_pearson(sum.differ[i], sum.asked[i]);
    text += fmt::format("  {:<8} {} of {}, at most {:.2g} %\n", to_string(kQuestions[i]), sum.differ[i], sum.asked[i],
                        100 * limits.upper);
  }
  return text + fmt::format("  the largest difference of nearest distances: {:.3g}\n", sum.distance.value);
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

const run::Table<MeshResult>& counts_table() {
  using Row = MeshResult;
  using Edges = mesh::EdgeCounts;
  const auto count = [](auto Counts::*member) { return run::path(&Row::counts, member); };
  const auto largest = [](auto Counts::*member) {
    return run::path(&Row::counts, [member](const Counts& counts) { return (counts.*member).value; });
  };
  const auto edges = [](std::size_t Edges::*member) {
    return run::path(&Row::counts, run::path(&Counts::edges, member));
  };
  static const run::Table<Row> table = [&] {
    std::vector<run::Column<Row>> columns{
        {"mesh", "the mesh", &Row::name},
        {"faces", "its faces", count(&Counts::faces)},
        {"rejected", "faces that the contract rejects, left out", count(&Counts::rejected)},
        {"polygons", "merged polygons", count(&Counts::polygons)},
        {"single", "polygons of one face", count(&Counts::single)},
        {"holes", "holes", count(&Counts::holes)},
        {"vertices", "vertices of the polygons", count(&Counts::vertices)},
        {"largest", "vertices of the largest polygon", largest(&Counts::largest)},
        {"splits", "cuts of a region that touched or covered itself", count(&Counts::splits)},
        {"border", "edges of one face", edges(&Edges::border)},
        {"non_manifold", "edges of more than two faces", edges(&Edges::non_manifold)},
        {"inconsistent", "edges of two faces that are not oriented alike", edges(&Edges::inconsistent)},
        {"merged_edges", "edges within a polygon", edges(&Edges::merged)},
        {"folded", "edges of two faces that are folded onto each other", edges(&Edges::folded)},
        {"kept_apart", "edges between coplanar faces left by splits", edges(&Edges::kept_apart)},
        {"crease", "edges between faces that are not coplanar", edges(&Edges::crease)},
        {"off_plane", "the largest move of a vertex onto its polygon's plane", largest(&Counts::off_plane)}};
    for (std::size_t i = 0; i < kQuestions.size(); ++i) {
      const std::string question(to_string(kQuestions[i]));
      columns.emplace_back(question + "_asked", "balls compared with the faces",
                           [i](const Row& row) { return row.differences.asked[i]; });
      columns.emplace_back(question + "_differ", "answers that differ",
                           [i](const Row& row) { return row.differences.differ[i]; });
    }
    columns.emplace_back("distance_difference", "the largest difference of nearest distances",
                         [](const Row& row) { return row.differences.distance.value; });
    return run::Table<Row>("merge.csv", "a mesh", columns);
  }();
  return table;
}

struct PolygonRow {
  std::string_view mesh;
  std::size_t number;
  const PolygonCounts* counts;
};

const run::Table<PolygonRow>& polygons_table() {
  using run::path;
  static const run::Table<PolygonRow> table(
      "polygons.csv", "a merged polygon, numbered by its lowest face",
      {{"mesh", "the mesh", &PolygonRow::mesh},
       {"polygon", "the polygon", &PolygonRow::number},
       {"faces", "faces of the mesh that it is made of", path(&PolygonRow::counts, &PolygonCounts::faces)},
       {"edges", "its edges", path(&PolygonRow::counts, &PolygonCounts::edges)},
       {"holes", "its holes", path(&PolygonRow::counts, &PolygonCounts::holes)},
       {"off_plane", "the largest distance of a vertex of these faces from its plane, in the mesh's unit",
        path(&PolygonRow::counts, &PolygonCounts::off_plane)}});
  return table;
}

struct TimesRow {
  const MeshResult* mesh;
  Kind kind;
  const Measured* measured;
};

const run::Table<TimesRow>& times_table() {
  using run::path;
  const auto nanoseconds = [](std::size_t question, double timing::Quartiles::*which = &timing::Quartiles::median) {
    return [question, which](const TimesRow& row) { return row.measured->nanoseconds[question].*which; };
  };
  constexpr auto kLower = &timing::Quartiles::lower, kUpper = &timing::Quartiles::upper;
  static const run::Table<TimesRow> table(
      "merge-times.csv", "a mesh and a scene of it",
      {{"mesh", "the mesh", path(&TimesRow::mesh, &MeshResult::name)},
       {"merge_seconds", "of merging", path(&TimesRow::mesh, &MeshResult::merge_seconds)},
       {"scene", "of its faces, of merged polygons, or of both", &TimesRow::kind},
       {"triangles", "triangles in the scene", path(&TimesRow::measured, &Measured::triangles)},
       {"polygons", "polygons in the scene", path(&TimesRow::measured, &Measured::polygons)},
       {"memory_bytes", "allocated by the scene", path(&TimesRow::measured, &Measured::memory)},
       {"build_seconds", "of building the scene", path(&TimesRow::measured, &Measured::seconds)},
       {"any_ns", "a ball near the surface: does it touch any face? Median of the repetitions", nanoseconds(0)},
       {"any_lower_ns", "the same, lower quartile", nanoseconds(0, kLower)},
       {"any_upper_ns", "the same, upper quartile", nanoseconds(0, kUpper)},
       {"all_ns", "which faces does it touch? Median", nanoseconds(1)},
       {"all_lower_ns", "the same, lower quartile", nanoseconds(1, kLower)},
       {"all_upper_ns", "the same, upper quartile", nanoseconds(1, kUpper)},
       {"nearest_ns", "which face is nearest? Median", nanoseconds(2)},
       {"nearest_lower_ns", "the same, lower quartile", nanoseconds(2, kLower)},
       {"nearest_upper_ns", "the same, upper quartile", nanoseconds(2, kUpper)}});
  return table;
}

}  // namespace

void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  counts_table().write(folder, results);
}

void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  std::vector<PolygonRow> rows;
  for (const MeshResult& result : results)
    for (std::size_t i = 0; i < result.polygons.size(); ++i) rows.push_back({result.name, i, &result.polygons[i]});
  polygons_table().write(folder, rows);
}

void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results) {
  std::vector<TimesRow> rows;
  for (const MeshResult& result : results)
    for (const Kind kind : kKinds) rows.push_back({&result, kind, &result.measured[static_cast<std::size_t>(kind)]});
  times_table().write(folder, rows);
}

std::vector<run::TableDescription> tables() {
  return {counts_table().description(), polygons_table().description(), times_table().description()};
}

std::string table(const Settings& settings, const std::vector<MeshResult>& results) {
  std::string text = counts_lines(results);
  const bool compared =
      std::ranges::any_of(results, [](const MeshResult& result) { return result.differences.asked[0] > 0; });
  if (compared) text += costs_table(results) + differences_lines(results);
  text += kLegend;
  if (compared) text += fmt::format(fmt::runtime(kCostsLegend), settings.least, settings.repetitions);
  return text;
}

}  // namespace touchstone::merging
