// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <map>
#include <set>
#include <tuple>

#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/program/output.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/studies/near_edge/faces.h"
#include "geometry/io/detail/legible.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::near_edge::faces {
namespace {

/// A query of the study, and which methods fail which tests in it.
struct FailedQuery {
  std::set<std::size_t> methods;
  std::array<bool, kTests.size()> wrong{};
};

std::string case_line(const Settings& settings, const NamedMesh& mesh, std::uint64_t face, std::size_t ball,
                      const FailedQuery& failed) {
  const auto crossing = draw_face_crossing(mesh::face_polygon(mesh.mesh, face), settings.seed, mesh.name, face);
  const std::string_view place = place_name(kPlaces[crossing.place(ball)]);
  std::vector<cases::Key> keys;
  for (std::size_t test = 0; test < kTests.size(); ++test)
    if (failed.wrong[test]) keys.push_back(cases::key_of(kTests[test]));
  std::vector<std::string> tags{fmt::format("near-{}", place)};
  for (const std::size_t method : failed.methods)
    tags.push_back(fmt::format("fails-{}", settings.methods[method]->name()));
  const std::string id =
      fmt::format("{}:{}:{}{:+}:seed-{}", mesh.name, face, place, FaceCrossing::steps(ball), settings.seed);
  return cases::case_line(id, cases::Shapes{crossing.balls[ball], crossing.polygon}, tags,
                          cases::only(crossing.truths[ball], keys));
}

struct MeshRow {
  std::string_view mesh;
  const MeshCounts* counts;
  std::string_view method;
  std::string_view place;
  Test test;
  const Failures* answers;
};

const program::Table<MeshRow>& meshes_table() {
  using program::path;
  static const program::Table<MeshRow> table(
      "meshes.csv", "a mesh, method, place and test",
      {{"mesh", "the mesh", &MeshRow::mesh},
       {"faces", "its faces", path(&MeshRow::counts, &MeshCounts::faces)},
       {"rejected", "faces that are not polygons", path(&MeshRow::counts, &MeshCounts::rejected)},
       {"method", "the method", &MeshRow::method},
       {"place", "what the balls are near", &MeshRow::place},
       {"test", "the decision that is compared", &MeshRow::test},
       {"trials", "answers", path(&MeshRow::answers, &Failures::trials)},
       {"wrong", "wrong answers", path(&MeshRow::answers, &Failures::wrong)},
       {"wrongly_in", "answers that wrongly say inside, or contact", path(&MeshRow::answers, &Failures::wrongly_in)},
       {"wrongly_out", "answers that wrongly say outside, or no contact",
        path(&MeshRow::answers, &Failures::wrongly_out)},
       {"boundary_missed", "answers that miss a boundary", path(&MeshRow::answers, &Failures::boundary_missed)}});
  return table;
}

struct RejectedRow {
  std::string_view mesh;
  const RejectedFace* face;
};

const program::Table<RejectedRow>& rejected_table() {
  static const program::Table<RejectedRow> table(
      "rejected.csv", "a face that is not a polygon",
      {{"mesh", "the mesh", &RejectedRow::mesh},
       {"face", "the number of the face in its file", program::path(&RejectedRow::face, &RejectedFace::face)},
       {"code", "the code of the rejection", [](const RejectedRow& row) { return row.face->rejection.code; }},
       {"message", "what is wrong", [](const RejectedRow& row) { return row.face->rejection.message; }}});
  return table;
}

std::string failures_jsonl(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result) {
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
  return text;
}

/// Wrong answers and their percentage.
std::string cell(const Failures& answers) {
  if (answers.trials == 0) return "-";
  return fmt::format("{} ({} %)", answers.wrong, statistics::percent_to_places(answers.share(), 2));
}

constexpr const char* kLegend = R"(
Queries: 20 a face. 5 near the face, 5 near an edge, 5 near a vertex: the radius is the double nearest to the exact
distance, moved by -2 to 2 doubles. 5 with an ample radius and the foot at an edge, the centre moved by -2 to 2 doubles.
missed: contacts denied; false: ones reported wrongly; touching is contact. faces: those with a wrong final answer, and
the Clopper-Pearson limits of their share, as if drawn at random. exact is the truth. Undecided answers are not counted.
)";

}  // namespace

void write(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
           const Result& result) {
  std::vector<MeshRow> rows;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const MeshCounts& counts = result.meshes[mesh];
    for (std::size_t method = 0; method < settings.methods.size(); ++method)
      for (std::size_t place = 0; place < kPlaces.size(); ++place)
        for (std::size_t test = 0; test < kTests.size(); ++test)
          rows.push_back({meshes[mesh].name, &counts, settings.methods[method]->name(), place_name(kPlaces[place]),
                          kTests[test], &counts.methods[method].at[place][test]});
  }
  meshes_table().write(folder, rows);
  std::vector<RejectedRow> rejected;
  for (const RejectedFace& face : result.rejected) rejected.push_back({meshes[face.mesh].name, &face});
  rejected_table().write(folder, rejected);
  program::write_file(folder / "failures.jsonl", failures_jsonl(settings, meshes, result));
}

std::vector<program::TableDescription> tables() {
  return {meshes_table().description(), rejected_table().description()};
}

std::string table(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result) {
  const MeshCounts sum = cases::total(result.meshes);
  std::vector<std::vector<std::string>> by_method{
      {"wrong answers", "plane", "foot", "edges", "contact", "missed", "false", "faces", "95 % limits"}};
  for (std::size_t m = 0; m < sum.methods.size(); ++m) {
    const MethodCounts& counts = sum.methods[m];
    auto& line = by_method.emplace_back(1, std::string(settings.methods[m]->name()));
    for (const Test test : kTests) line.push_back(cell(counts.total(test)));
    const Failures contact = counts.total(Test::Contact);
    const auto limits = statistics::clopper_pearson(counts.faces_wrong, sum.faces - sum.rejected);
    for (const std::uint64_t count : {contact.wrongly_out, contact.wrongly_in, counts.faces_wrong})
      line.push_back(std::to_string(count));
    line.push_back(fmt::format("{} to {} %", statistics::percent_to_digits(limits.lower, 2),
                               statistics::percent_to_digits(limits.upper, 2)));
  }
  std::string text = program::aligned(by_method) + "\n";
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
    text += fmt::format("{}: {} faces, {} bad, {} queries\n", io::legible(meshes[mesh].name), result.meshes[mesh].faces,
                        result.meshes[mesh].rejected, result.meshes[mesh].queries);
  std::map<RejectionCode, std::vector<const RejectedFace*>> by_code;
  for (const RejectedFace& face : result.rejected) by_code[face.rejection.code].push_back(&face);
  text += fmt::format("\n{} of {} faces are bad: the contract rejects them, no method was asked\n", sum.rejected,
                      sum.faces);
  for (const auto& [code, faces] : by_code)
    text += fmt::format("  {:<18} {:>6}  first {} face {}: {}\n", to_string(code), faces.size(),
                        io::legible(meshes[faces[0]->mesh].name), faces[0]->face, faces[0]->rejection.message);
  for (std::size_t place = 0; place < kPlaces.size(); ++place)
    if (sum.missing[place] > 0)
      text += fmt::format("{} faces have no ball near \"{}\": none drawn had it nearest\n", sum.missing[place],
                          place_name(kPlaces[place]));
  return text + kLegend;
}

}  // namespace touchstone::near_edge::faces
