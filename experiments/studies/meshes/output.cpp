// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/meshes/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "experiments/cases/verdict.h"
#include "experiments/harness/write_file.h"
#include "experiments/workloads/meshes/face_polygon.h"

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
  const auto whole = cases::object_of(cases::PartialAnswer::of(exact::answer(drawn.ball, exact), ""));
  constexpr std::array<const char*, kTests.size()> kKeys{"plane", "foot", "edges_hit", "contact"};
  cases::Verdict expected = cases::Verdict::object();
  for (std::size_t test = 0; test < kTests.size(); ++test)
    if (failed.wrong[test]) expected[kKeys[test]] = whole[kKeys[test]];
  std::vector<std::string> tags{std::string("near-") + std::string(word(drawn.place))};
  for (const std::size_t method : failed.methods)
    tags.push_back("fails-" + std::string(settings.methods[method]->name()));
  const std::string id =
      fmt::format("{}:{}:{}{:+}:seed-{}", mesh.name, face, word(drawn.place), drawn.steps, settings.seed);
  return cases::to_line(cases::case_of(id, drawn.ball, polygon, tags, expected));
}

}  // namespace

void write_meshes(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                  const Result& result) {
  std::string text = "mesh,faces,rejected,method,place,test,trials,wrong,wrongly_in,wrongly_out,boundary_missed\n";
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const MeshCounts& counts = result.meshes[mesh];
    for (std::size_t method = 0; method < settings.methods.size(); ++method)
      for (std::size_t place = 0; place < kPlaces.size(); ++place)
        for (std::size_t test = 0; test < kTests.size(); ++test) {
          const Count& count = counts.methods[method].at[place][test];
          text +=
              fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", harness::csv_field(meshes[mesh].name), counts.faces,
                          counts.rejected, settings.methods[method]->name(), word(kPlaces[place]), word(kTests[test]),
                          count.trials, count.wrong(), count.wrongly_in, count.wrongly_out, count.boundary_missed);
        }
  }
  harness::write_file(folder / "meshes.csv", text);
}

void write_rejected(const std::filesystem::path& folder, const std::vector<NamedMesh>& meshes, const Result& result) {
  std::string text = "mesh,face,code,message\n";
  for (const RejectedFace& face : result.rejected)
    text += fmt::format("{},{},{},{}\n", harness::csv_field(meshes[face.mesh].name), face.face,
                        word(face.rejection.code), harness::csv_field(face.rejection.message));
  harness::write_file(folder / "rejected.csv", text);
}

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
  harness::write_file(folder / "failures.jsonl", text);
}

}  // namespace touchstone::meshes
