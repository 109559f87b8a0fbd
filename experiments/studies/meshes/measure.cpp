// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/meshes/measure.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::meshes {
namespace {

std::uint64_t face_count(const Settings& settings, const NamedMesh& mesh) {
  return std::min<std::uint64_t>(settings.faces, mesh.mesh.faces.size());
}

bool is_worse(const Failure& a, const Failure& b) {
  const auto rank = [](const Failure& f) {
    return std::make_tuple(f.method, !f.wrong[static_cast<std::size_t>(Test::Contact)], -std::abs(f.steps), f.lot,
                           f.mesh, f.face, f.ball);
  };
  return rank(a) < rank(b);
}

/// Keeps the worst of each method, in order.
void keep_worst(std::vector<Failure>& failures) {
  std::sort(failures.begin(), failures.end(), is_worse);
  std::size_t method = 0, of_method = 0;
  std::erase_if(failures, [&](const Failure& failure) {
    of_method = failure.method == method ? of_method + 1 : 1;
    method = failure.method;
    return of_method > kKeptFailures;
  });
}

class Study {
 public:
  Study(const Settings& settings, const std::vector<NamedMesh>& meshes) : settings_(settings), meshes_(meshes) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
    std::uint64_t end = 0;
    for (const NamedMesh& mesh : meshes) ends_.push_back(end += face_count(settings, mesh));
  }

  /// Asks about the n-th face of all meshes.
  void ask(std::uint64_t n, Result& result) const {
    const auto mesh = static_cast<std::size_t>(std::ranges::upper_bound(ends_, n) - ends_.begin());
    const std::uint64_t face = mesh == 0 ? n : n - ends_[mesh - 1];
    ++result.meshes[mesh].faces;
    try {
      ask(mesh, face, mesh::face_polygon(meshes_[mesh].mesh, face), result);
    } catch (const Rejected& rejected) {
      ++result.meshes[mesh].rejected;
      result.rejected.push_back({mesh, face, rejected.rejection()});
    }
    constexpr std::size_t kMany = 10'000;
    if (result.failures.size() > kMany) keep_worst(result.failures);
  }

 private:
  void ask(std::size_t mesh, std::uint64_t face, const Polygon& polygon, Result& result) const {
    const exact::PreparedPolygon exact(polygon);
    const MeshBalls drawn = draw_mesh_balls(polygon, exact, settings_.seed, meshes_[mesh].name, face);
    std::vector<cases::PartialAnswer> truths;
    for (const MeshBall& ball : drawn.balls)
      truths.push_back(cases::PartialAnswer::of(exact::answer(ball.ball, exact), ""));

    MeshCounts& counts = result.meshes[mesh];
    counts.queries += drawn.balls.size();
    for (const BallRegion place : drawn.missing) ++counts.missing[static_cast<std::size_t>(place)];
    for (std::size_t method = 0; method < settings_.methods.size(); ++method) {
      const auto prepared = settings_.methods[method]->prepare(polygon);
      bool face_wrong = false;
      for (std::size_t i = 0; i < drawn.balls.size(); ++i) {
        const auto answer = prepared->ask(drawn.balls[i].ball, cases::QueryKind::Answer);
        auto& at = counts.methods[method].at[static_cast<std::size_t>(drawn.balls[i].place)];
        Failure failure{method, mesh, face, i, {}, drawn.balls[i].steps, 0};
        for (std::size_t test = 0; test < kTests.size(); ++test)
          failure.wrong[test] = add(at[test], compare(kTests[test], answer, truths[i], knows_boundary_[method]));
        face_wrong |= failure.wrong[static_cast<std::size_t>(Test::Contact)];
        if (failure.wrong != decltype(failure.wrong){}) keep(failure, result);
      }
      counts.methods[method].faces_wrong += face_wrong ? 1 : 0;
    }
  }

  /// Is it wrong?
  static bool add(Failures& answers, std::optional<cases::Outcome> verdict) {
    if (!verdict) return false;
    answers.add(verdict);
    return *verdict != cases::Outcome::Right;
  }

  static void keep(Failure failure, Result& result) {
    failure.lot = workloads::Random(failure.mesh, failure.face, failure.ball).bits();
    result.failures.push_back(failure);
  }

  const Settings& settings_;
  const std::vector<NamedMesh>& meshes_;
  std::vector<bool> knows_boundary_;
  std::vector<std::uint64_t> ends_;  // of the faces of each mesh
};

}  // namespace

Failures MethodCounts::total(Test test) const {
  Failures sum;
  for (const auto& tests : at) run::add(sum, tests[static_cast<std::size_t>(test)]);
  return sum;
}

Result& Result::operator+=(const Result& other) {
  run::add(meshes, other.meshes);
  rejected.insert(rejected.end(), other.rejected.begin(), other.rejected.end());
  std::ranges::sort(rejected, {}, [](const RejectedFace& face) { return std::tie(face.mesh, face.face); });
  failures.insert(failures.end(), other.failures.begin(), other.failures.end());
  keep_worst(failures);
  return *this;
}

std::uint64_t items_done(const Result& result) {
  std::uint64_t faces = 0;
  for (const MeshCounts& counts : result.meshes) faces += counts.faces;
  return faces;
}

std::uint64_t face_count(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  std::uint64_t faces = 0;
  for (const NamedMesh& mesh : meshes) faces += face_count(settings, mesh);
  return faces;
}

Result no_result(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  Result result;
  result.meshes.resize(meshes.size());
  for (MeshCounts& counts : result.meshes) counts.methods.resize(settings.methods.size());
  return result;
}

void measure(const Settings& settings, const std::vector<NamedMesh>& meshes, const run::RunControl& control,
             Result& result) {
  constexpr std::uint64_t kBlock = 32;
  const Study study(settings, meshes);
  run_sweep(
      face_count(settings, meshes), settings.threads, control, no_result(settings, meshes), result,
      [&](std::uint64_t face, Result& part) { study.ask(face, part); }, kBlock);
}

}  // namespace touchstone::meshes
