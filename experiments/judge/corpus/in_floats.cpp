// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/loops.h"
#include "experiments/judge/corpus/corpus.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"
#include "robust/scene/posing.h"

namespace touchstone::corpus {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

double nearest_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Eigen::Vector3d nearest_floats(const Eigen::Vector3d& v) { return v.cast<float>().cast<double>(); }

bool is_float(double x) { return nearest_float(x) == x; }  // exact, because both are doubles
bool are_floats(const Eigen::Vector3d& v) { return nearest_floats(v) == v; }

using Faces = std::vector<exact::PreparedPolygon>;

bool touches(const cases::Question& question, double radius, const Faces& faces) {
  return std::visit(
      [&](const auto& asked) {
        return std::ranges::any_of(faces, [&](const auto& face) { return exact::contact(asked, face); });
      },
      cases::with_radius(question, radius));
}

/// Returns the least float that is a radius with contact; nothing if none is.
std::optional<float> least_radius(const cases::Question& question, const Faces& faces) {
  if (!touches(question, static_cast<double>(kLargest), faces)) return std::nullopt;
  std::uint32_t below = 0, at = std::bit_cast<std::uint32_t>(kLargest);  // floats above 0 are ordered as their bits
  if (touches(question, 0, faces)) return 0.0F;
  while (at - below > 1) {
    const std::uint32_t middle = below + (at - below) / 2;
    (touches(question, static_cast<double>(std::bit_cast<float>(middle)), faces) ? at : below) = middle;
  }
  return std::bit_cast<float>(at);
}

Faces prepared(const cases::AnyShapes& shapes) {
  const auto faces = faces_of(shapes);
  return {faces.begin(), faces.end()};
}

bool is_at_threshold(const cases::AnyShapes& shapes) {
  constexpr double kNear = 0x1p-40;
  const Faces faces = prepared(shapes);
  const cases::Question& question = question_of(shapes);
  const double radius = cases::ball_of(question).radius;
  return !touches(question, radius * (1 - kNear), faces) && touches(question, radius * (1 + kNear), faces);
}

double off_plane(const Polygon& polygon) { return exact::answer({polygon.vertex(0), 0}, polygon).off_plane; }

/// Returns whether rounding moved vertices off a plane.
bool bends(const Polygon& polygon, const Polygon& rounded) {
  return off_plane(rounded) > 0 && off_plane(polygon) <= 0x1p-30 * workloads::extent_of(polygon);
}

/// Returns the polygon of the nearest floats; nothing if it bends. Throws Rejected.
std::optional<Polygon> rounded(const Polygon& polygon) {
  std::vector<Loop> loops = workloads::loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) vertex = nearest_floats(vertex);
  Polygon result = workloads::polygon_of(loops);
  if (const auto rejection = exact::validate(result)) throw Rejected(*rejection);
  return bends(polygon, result) ? std::nullopt : std::optional(std::move(result));
}

/// Returns the mesh of the nearest floats of its posed vertices, likewise.
std::optional<cases::PosedMesh> rounded(const cases::PosedMesh& mesh) {
  Mesh posed = mesh.mesh();
  for (Eigen::Vector3d& vertex : posed.vertices) vertex = nearest_floats(scene::posed(mesh.pose(), vertex));
  cases::PosedMesh result(std::move(posed));
  for (std::size_t i = 0; i < result.faces().size(); ++i)
    if (bends(mesh.faces()[i], result.faces()[i])) return std::nullopt;
  return result;
}

cases::Question rounded(const cases::Question& question) {
  const Ball& given = cases::ball_of(question);
  const Ball ball{nearest_floats(given.center), nearest_float(given.radius)};
  if (const auto* motion = std::get_if<Motion>(&question)) return Motion(ball, nearest_floats(motion->to));
  return ball;
}

bool are_in_floats(const cases::Question& question) {
  const Ball& ball = cases::ball_of(question);
  const auto* motion = std::get_if<Motion>(&question);
  return is_float(ball.radius) && are_floats(ball.center) && (motion == nullptr || are_floats(motion->to));
}

bool is_valid(const cases::Question& question) {
  return !std::visit([](const auto& asked) { return find_fault(asked); }, question);
}

/// Returns the case in floats, its radius the nearest one; nothing if it bends. Throws Rejected.
std::optional<cases::AnyShapes> rounded(const cases::AnyShapes& shapes) {
  cases::Question question = rounded(question_of(shapes));
  if (!is_valid(question)) return std::nullopt;
  if (const auto* one = std::get_if<cases::Shapes>(&shapes)) {
    if (auto polygon = rounded(one->polygon)) return cases::Shapes{question, std::move(*polygon)};
  } else if (auto mesh = rounded(std::get<cases::MeshShapes>(shapes).mesh)) {
    return cases::MeshShapes{question, std::move(*mesh)};
  }
  return std::nullopt;
}

}  // namespace

bool is_in_floats(const cases::AnyShapes& shapes) {
  if (!are_in_floats(question_of(shapes))) return false;
  if (const auto* one = std::get_if<cases::Shapes>(&shapes)) {
    for (std::size_t i = 0; i < one->polygon.vertex_count(); ++i)
      if (!are_floats(one->polygon.vertex(i))) return false;
    return true;
  }
  const cases::PosedMesh& mesh = std::get<cases::MeshShapes>(shapes).mesh;
  return mesh.pose() == Pose() && std::ranges::all_of(mesh.mesh().vertices, are_floats);
}

std::optional<CorpusCase> in_floats(CorpusCase given) try {
  const std::string id = given.id;
  given.id += "-float";
  if (is_in_floats(given.shapes)) return given;
  auto shapes = rounded(given.shapes);
  if (!shapes) return std::nullopt;
  if (is_at_threshold(given.shapes)) {
    const auto least = least_radius(question_of(*shapes), prepared(*shapes));
    if (!least) return std::nullopt;
    const float towards[] = {0, *least, kLargest};
    const auto sum = std::accumulate(id.begin(), id.end(), 0U,
                                     [](unsigned all, char c) { return all + static_cast<unsigned char>(c); });
    if (*least > 0)
      shapes = with_radius(std::move(*shapes), static_cast<double>(std::nextafter(*least, towards[sum % 3])));
  }
  if (!is_valid(question_of(*shapes))) return std::nullopt;
  given.shapes = std::move(*shapes);
  given.origin = "the nearest floats of: " + given.origin;
  return given;
} catch (const Rejected&) {
  return std::nullopt;
}

}  // namespace touchstone::corpus
