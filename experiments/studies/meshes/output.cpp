// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/meshes/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/meshes/face_polygon.h"
#include "experiments/run/table.h"
#include "experiments/run/write_file.h"

namespace touchstone::meshes {
namespace {

/// A query of the study, and which methods fail which tests in it.
struct FailedQuery {
  std::set<std::size_t> methods;
  std::array<bool, kTests.size()> wrong{};
};

std::string case_line(const Settings& settings, const NamedMesh& mesh, std::uint64_t face, std::size_t ball,
                      const FailedQuery& failed) {
  const Polygon polygon = workloads::face_polygon(mesh.mesh, face);
  const exact::PreparedPolygon exact(polygon);
  const MeshBall drawn = draw_mesh_balls(polygon, exact, settings.seed, mesh.name, face).balls[ball];
  const auto whole = cases::PartialAnswer::of(exact::answer(drawn.ball, exact), "");
  std::vector<cases::Key> keys;
  for (std::size_t test = 0; test < kTests.size(); ++test)
    if (failed.wrong[test]) keys.push_back(cases::key_of(kTests[test]));
  std::vector<std::string> tags{std::string("near-") + std::string(to_string(drawn.place))};
  for (const std::size_t method : failed.methods)
    tags.push_back("fails-" + std::string(settings.methods[method]->name()));
  const std::string id =
      fmt::format("{}:{}:{}{:+}:seed-{}", mesh.name, face, to_string(drawn.place), drawn.steps, settings.seed);
  return cases::case_line(id, drawn.ball, polygon, tags, cases::only(whole, keys));
}

struct MeshRow {
  std::string_view mesh;
  const MeshCounts* counts;
  std::string_view method;
  BallRegion place;
  Test test;
  const Count* count;
};

const run::Table<MeshRow>& meshes_table() {
  using run::path;
  static const run::Table<MeshRow> table(
      "meshes.csv", "a mesh, method, place and test",
      {{"mesh", "the mesh", &MeshRow::mesh},
       {"faces", "its faces", path(&MeshRow::counts, &MeshCounts::faces)},
       {"rejected", "faces that are not polygons", path(&MeshRow::counts, &MeshCounts::rejected)},
       {"method", "the method", &MeshRow::method},
       {"place", "what the balls are near", &MeshRow::place},
       {"test", "the decision that is compared", &MeshRow::test},
       {"trials", "answers", path(&MeshRow::count, &Count::trials)},
       {"wrong", "wrong answers", path(&MeshRow::count, &Count::wrong)},
       {"wrongly_in", "answers that wrongly say inside, or contact", path(&MeshRow::count, &Count::wrongly_in)},
       {"wrongly_out", "answers that wrongly say outside, or no contact", path(&MeshRow::count, &Count::wrongly_out)},
       {"boundary_missed", "answers that miss a boundary", path(&MeshRow::count, &Count::boundary_missed)}});
  return table;
}

struct RejectedRow {
  std::string_view mesh;
  const RejectedFace* face;
};

const run::Table<RejectedRow>& rejected_table() {
  static const run::Table<RejectedRow> table(
      "rejected.csv", "a face that is not a polygon",
      {{"mesh", "the mesh", &RejectedRow::mesh},
       {"face", "the number of the face in its file", run::path(&RejectedRow::face, &RejectedFace::face)},
       {"code", "the code of the rejection", [](const RejectedRow& row) { return row.face->rejection.code; }},
       {"message", "what is wrong", [](const RejectedRow& row) { return row.face->rejection.message; }}});
  return table;
}

}  // namespace

void write_meshes(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                  const Result& result) {
  std::vector<MeshRow> rows;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const MeshCounts& counts = result.meshes[mesh];
    for (std::size_t method = 0; method < settings.methods.size(); ++method)
      for (std::size_t place = 0; place < kPlaces.size(); ++place)
        for (std::size_t test = 0; test < kTests.size(); ++test)
          rows.push_back({meshes[mesh].name, &counts, settings.methods[method]->name(), kPlaces[place], kTests[test],
                          &counts.methods[method].at[place][test]});
  }
  meshes_table().write(folder, rows);
}

void write_rejected(const std::filesystem::path& folder, const std::vector<NamedMesh>& meshes, const Result& result) {
  std::vector<RejectedRow> rows;
  for (const RejectedFace& face : result.rejected) rows.push_back({meshes[face.mesh].name, &face});
  rejected_table().write(folder, rows);
}

std::vector<run::TableDescription> tables() { return {meshes_table().description(), rejected_table().description()}; }

void write_failures(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                    const Result& result) {
  std::map<std::tuple<std::size_t, std::uint64_t, std::size_t>, FailedQuery> queries;
  for (const Failure& failure : result.failures) {
    FailedQuery& query = queries[{failure.mesh, failure.face, failure.ball}];
    query.methods.insert(failure.method);
    for (std::size_t test = 0; test < kTests.size(); ++test) query.wrong[test] |= failure.wrong[test];
  }
  std::string text;
  for (const auto& [key, failed] : queries) {
    const auto& [mesh, face, ball] = key;
    text += case_line(settings, meshes[mesh], face, ball, failed);
  }
  run::write_file(folder / "failures.jsonl", text);
}

}  // namespace touchstone::meshes
