// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/merging/measure.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/run/sweep.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::merging {
namespace {

using Eigen::Vector3d;
using workloads::finite;
using workloads::Random;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Bytes that are allocated.
std::size_t allocated() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

Counts count(const Mesh& mesh, const mesh::MergedMesh& merged) {
  Counts counts{.faces = mesh.faces.size(),
                .rejected = merged.rejected.size(),
                .polygons = merged.faces.size(),
                .splits = merged.splits,
                .edges = merged.edges};
  for (const auto& face : merged.faces) {
    counts.single += face.faces.size() == 1 ? 1 : 0;
    counts.holes += face.polygon.loop_count() - 1;
    counts.vertices += face.polygon.vertex_count();
    counts.largest += face.polygon.vertex_count();
    counts.off_plane += face.off_plane;
  }
  return counts;
}

/// The answer of a scene, in a form that all kinds share.
struct Answers {
  bool any;
  std::vector<std::uint32_t> all;  ///< merged faces
};

class Contender {
 public:
  Contender(const Mesh& mesh, const mesh::MergedMesh& merged, std::size_t least) {
    mesh::SceneFaces faces = mesh::scene_faces(mesh, merged, least);
    merged_ = std::move(faces.merged);
    measured_.triangles = faces.faces.triangles.size();
    measured_.polygons = faces.faces.polygons.size();
    (void)built(faces.faces);  // so that what is allocated once, by the first scene, is not counted
    const std::size_t before = allocated();
    auto copy = faces.faces;
    const auto begin = std::chrono::steady_clock::now();
    scene_ = built(std::move(copy));
    measured_.seconds = seconds_since(begin);
    measured_.memory = allocated() - before;
  }

  [[nodiscard]] std::uint64_t ask(Question question, const Ball& ball) const {
    switch (question) {
      case Question::Any: return scene_.touches(ball) ? 1 : 0;
      case Question::All: return scene_.touched(ball).size();
      case Question::Nearest: return scene_.nearest(ball)->face.face;
    }
    return 0;
  }
  [[nodiscard]] Answers answers(const Ball& ball) const {
    Answers answers{scene_.touches(ball), {}};
    for (const scene::FaceId& id : scene_.touched(ball)) answers.all.push_back(merged_[id.face]);
    std::ranges::sort(answers.all);
    answers.all.erase(std::unique(answers.all.begin(), answers.all.end()), answers.all.end());
    return answers;
  }
  [[nodiscard]] double distance(const Ball& ball) const { return scene_.nearest(ball)->distance; }

  [[nodiscard]] Measured& measured() { return measured_; }

 private:
  static scene::Scene built(scene::Faces faces) {
    scene::Scene scene;
    scene.add("mesh", std::move(faces));
    return scene;
  }

  scene::Scene scene_;
  std::vector<std::uint32_t> merged_;
  Measured measured_;
};

/// Written to, so that answers are computed.
volatile std::uint64_t sink;

/// All contenders in turn, so that the machine's moods meet all alike. Where it is stopped, there are no times.
void time_question(Question question, std::vector<Contender>& contenders, const std::vector<Ball>& balls,
                   unsigned repetitions, const std::atomic<bool>& stop) {
  std::vector<std::vector<double>> times(contenders.size());
  for (unsigned repetition = 0; repetition < repetitions; ++repetition)
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::size_t turn = (k + repetition) % contenders.size();
      const auto begin = std::chrono::steady_clock::now();
      std::uint64_t sum = 0;
      for (const Ball& ball : balls) {
        if (stop) return;
        sum += contenders[turn].ask(question, ball);
      }
      times[turn].push_back(1e9 * seconds_since(begin) / static_cast<double>(balls.size()));
      sink = sum;
    }
  for (std::size_t k = 0; k < contenders.size(); ++k)
    contenders[k].measured().nanoseconds[static_cast<std::size_t>(question)] = timing::quartiles(std::move(times[k]));
}

/// Compares answers that name faces of the mesh, for which cases::differing_keys has no keys.
Differences differences(const std::vector<Contender>& contenders, const std::vector<Ball>& balls,
                        const std::vector<Ball>& few, unsigned threads, const std::atomic<bool>& stop) {
  constexpr std::uint64_t kBlock = 64;
  Differences result;
  const auto compare = [&](const std::vector<Ball>& asked, const auto& ask) {
    const run::Sweep sweep{asked.size(), kBlock, threads, stop, [](std::uint64_t) {}};
    const auto save_nothing = [](std::uint64_t, const Differences&) {};
    run::run_sweep(
        sweep, [&](std::uint64_t ball, Differences& part) { ask(asked[ball], part); }, save_nothing, Differences(), 0,
        result);
  };
  compare(balls, [&](const Ball& ball, Differences& part) {
    const Answers expected = contenders[0].answers(ball);
    for (std::size_t k = 1; k < contenders.size(); ++k) {
      const Answers found = contenders[k].answers(ball);
      part.note(Question::Any, found.any != expected.any);
      part.note(Question::All, found.all != expected.all);
    }
  });
  compare(few, [&](const Ball& ball, Differences& part) {
    const double expected = contenders[0].distance(ball);
    for (std::size_t k = 1; k < contenders.size(); ++k) {
      const double found = contenders[k].distance(ball);
      part.note(Question::Nearest, found != expected);
      part.distance += std::abs(found - expected);
    }
  });
  return result;
}

}  // namespace

std::string_view to_string(Kind kind) {
  switch (kind) {
    case Kind::Faces: return "faces";
    case Kind::Merged: return "merged";
    case Kind::Mixed: return "mixed";
  }
  return "";
}

std::string_view to_string(Question question) {
  switch (question) {
    case Question::Any: return "any";
    case Question::All: return "all";
    case Question::Nearest: return "nearest";
  }
  return "";
}

Ball draw_ball(const Mesh& mesh, const mesh::MergedMesh& merged, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  const auto draw = [&random](std::size_t count) {
    return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(count) - 1));
  };
  Vector3d low = mesh.vertices[0], high = low;
  for (const Vector3d& vertex : mesh.vertices) low = low.cwiseMin(vertex), high = high.cwiseMax(vertex);
  const double size = finite((high - low).maxCoeff());

  // A merged face is drawn as often as it has faces.
  std::uint32_t face = 0;
  const auto rejected = [&] {
    return std::ranges::binary_search(merged.rejected, face, {}, &mesh::RejectedFace::face);
  };
  do face = static_cast<std::uint32_t>(draw(mesh.faces.size()));
  while (rejected());
  const auto& corners = mesh.faces[face];
  const Vector3d &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
  const double s = random.unit(), t = (1 - s) * random.unit();

  Vector3d direction;
  do
    for (int k = 0; k < 3; ++k) direction[k] = 2 * random.unit() - 1;
  while (!(direction.squaredNorm() <= 1 && direction.squaredNorm() > 0));
  const double length = size * std::abs(random.log_uniform(-11, -2));
  const Vector3d point = a + s * finite(b - a) + t * finite(c - a);
  return {finite(point + finite(length / direction.norm()) * direction), length * (0.5 + random.unit())};
}

std::optional<MeshResult> study(const Settings& settings, std::string name, const Mesh& mesh,
                                const std::atomic<bool>& stop) {
  MeshResult result{.name = std::move(name), .counts = {}, .polygons = {}, .rejected = {}, .differences = {}};
  const auto begin = std::chrono::steady_clock::now();
  const std::optional<mesh::MergedMesh> merged = mesh::merge_faces(mesh, settings.tolerance, stop);
  if (!merged) return std::nullopt;
  result.merge_seconds = seconds_since(begin);
  result.counts = count(mesh, *merged);
  for (const mesh::MergedFace& face : merged->faces)
    result.polygons.push_back(
        {face.faces.size(), face.polygon.vertex_count(), face.polygon.loop_count() - 1, face.off_plane});
  result.rejected = merged->rejected;
  if (settings.balls == 0 || merged->faces.empty()) return result;

  std::vector<Ball> balls, few;
  for (std::uint64_t i = 0; i < settings.balls; ++i) {
    if (stop) return std::nullopt;
    balls.push_back(draw_ball(mesh, *merged, settings.seed, i));
    if (i % 10 == 0) few.push_back(balls.back());
  }
  std::vector<Contender> contenders;
  for (const std::size_t least : {std::numeric_limits<std::size_t>::max(), std::size_t{2}, settings.least}) {
    if (stop) return std::nullopt;
    contenders.emplace_back(mesh, *merged, least);
  }
  for (const Question question : kQuestions)
    time_question(question, contenders, question == Question::Nearest ? few : balls, settings.repetitions, stop);
  result.differences = differences(contenders, balls, few, settings.threads, stop);
  if (stop) return std::nullopt;
  for (std::size_t k = 0; k < contenders.size(); ++k) result.measured[k] = contenders[k].measured();
  return result;
}

}  // namespace touchstone::merging
