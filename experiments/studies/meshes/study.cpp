// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/meshes/study.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"

namespace touchstone::meshes {
namespace {

constexpr std::uint64_t kBlock = 32;  // faces

struct Block {
  std::size_t mesh;
  std::uint64_t first, last;
};

std::uint64_t face_count(const Settings& settings, const NamedMesh& mesh) {
  return std::min<std::uint64_t>(settings.faces, mesh.mesh.faces.size());
}

std::vector<Block> all_blocks(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  std::vector<Block> blocks;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const std::uint64_t faces = face_count(settings, meshes[mesh]);
    for (std::uint64_t first = 0; first < faces; first += kBlock)
      blocks.push_back({mesh, first, std::min(first + kBlock, faces)});
  }
  return blocks;
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

/// The results of one thread.
class Tally {
 public:
  Tally(const Settings& settings, const std::vector<NamedMesh>& meshes, const std::vector<bool>& knows_boundary)
      : settings_(settings), meshes_(meshes), knows_boundary_(knows_boundary) {
    result_.meshes.resize(meshes.size());
    for (MeshCounts& counts : result_.meshes) counts.methods.resize(settings.methods.size());
  }

  void ask(const Block& block) {
    for (std::uint64_t face = block.first; face < block.last; ++face) {
      ++result_.meshes[block.mesh].faces;
      try {
        ask(block.mesh, face, workloads::face_polygon(meshes_[block.mesh].mesh, face));
      } catch (const Rejected& rejected) {
        ++result_.meshes[block.mesh].rejected;
        result_.rejected.push_back({block.mesh, face, rejected.rejection()});
      }
    }
    constexpr std::size_t kMany = 10'000;
    if (result_.failures.size() > kMany) keep_worst(result_.failures);
  }

  [[nodiscard]] const Result& result() const { return result_; }

 private:
  void ask(std::size_t mesh, std::uint64_t face, const Polygon& polygon) {
    const exact::PreparedPolygon exact(polygon);
    const MeshBalls drawn = draw_mesh_balls(polygon, exact, settings_.seed, meshes_[mesh].name, face);
    std::vector<cases::PartialAnswer> truths;
    for (const MeshBall& ball : drawn.balls)
      truths.push_back(cases::PartialAnswer::of(exact::answer(ball.ball, exact), ""));

    MeshCounts& counts = result_.meshes[mesh];
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
        if (failure.wrong != decltype(failure.wrong){}) keep(failure);
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

  void keep(Failure failure) {
    failure.lot = workloads::Random(failure.mesh, failure.face, failure.ball).bits();
    result_.failures.push_back(failure);
  }

  const Settings& settings_;
  const std::vector<NamedMesh>& meshes_;
  const std::vector<bool>& knows_boundary_;
  Result result_;
};

}  // namespace

Failures MethodCounts::total(Test test) const {
  Failures sum;
  for (const auto& tests : at) run::add(sum, tests[static_cast<std::size_t>(test)]);
  return sum;
}

std::uint64_t block_count(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  return all_blocks(settings, meshes).size();
}

Result run_study(const Settings& settings, const std::vector<NamedMesh>& meshes, const std::atomic<bool>& stop,
                 const run::Progress& progress) {
  const std::vector<Block> blocks = all_blocks(settings, meshes);
  std::vector<bool> knows_boundary;
  for (const auto* method : settings.methods) knows_boundary.push_back(cases::knows_boundary(*method));
  std::vector<Tally> tallies(settings.threads, Tally(settings, meshes, knows_boundary));
  run::run_blocks(blocks.size(), settings.threads, stop, progress,
                  [&](unsigned thread, std::uint64_t block) { tallies[thread].ask(blocks[block]); });

  Result result = Tally(settings, meshes, knows_boundary).result();
  for (const NamedMesh& mesh : meshes) result.faces += face_count(settings, mesh);
  for (const Tally& tally : tallies) {
    const Result& part = tally.result();
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) run::add(result.meshes[mesh], part.meshes[mesh]);
    result.rejected.insert(result.rejected.end(), part.rejected.begin(), part.rejected.end());
    result.failures.insert(result.failures.end(), part.failures.begin(), part.failures.end());
  }
  keep_worst(result.failures);
  std::sort(result.rejected.begin(), result.rejected.end(), [](const RejectedFace& a, const RejectedFace& b) {
    return std::tie(a.mesh, a.face) < std::tie(b.mesh, b.face);
  });
  return result;
}

}  // namespace touchstone::meshes
