// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/in_floats.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "experiments/cases/workloads/loops.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"

namespace touchstone::corpus {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

double nearest_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Eigen::Vector3d nearest_floats(const Eigen::Vector3d& v) { return v.cast<float>().cast<double>(); }

bool is_float(double x) { return nearest_float(x) == x; }  // exact, because both are doubles
bool are_floats(const Eigen::Vector3d& v) { return nearest_floats(v) == v; }

bool touches(const cases::Question& question, double radius, const exact::PreparedPolygon& polygon) {
  return std::visit([&](const auto& q) { return exact::contact(q, polygon); }, cases::with_radius(question, radius));
}

/// Returns the least float that is a radius with contact; nothing if none is.
std::optional<float> least_radius(const cases::Question& question, const exact::PreparedPolygon& polygon) {
  if (!touches(question, static_cast<double>(kLargest), polygon)) return std::nullopt;
  std::uint32_t below = 0, at = std::bit_cast<std::uint32_t>(kLargest);  // floats above 0 are ordered as their bits
  if (touches(question, 0, polygon)) return 0.0F;
  while (at - below > 1) {
    const std::uint32_t middle = below + (at - below) / 2;
    (touches(question, static_cast<double>(std::bit_cast<float>(middle)), polygon) ? at : below) = middle;
  }
  return std::bit_cast<float>(at);
}

bool is_at_threshold(const cases::Shapes& shapes) {
  constexpr double kNear = 0x1p-40;
  const exact::PreparedPolygon polygon(shapes.polygon);
  const double radius = shapes.ball().radius;
  return !touches(shapes.question, radius * (1 - kNear), polygon) &&
         touches(shapes.question, radius * (1 + kNear), polygon);
}

double off_plane(const Polygon& polygon) { return exact::answer({polygon.vertex(0), 0}, polygon).off_plane; }

/// Returns the polygon of the nearest floats; nothing if it is rejected.
std::optional<Polygon> rounded(const Polygon& polygon) {
  std::vector<Loop> loops = workloads::loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) vertex = nearest_floats(vertex);
  try {
    Polygon result = workloads::polygon_of(loops);
    if (exact::validate(result)) return std::nullopt;
    return result;
  } catch (const Rejected&) {
    return std::nullopt;
  }
}

cases::Question rounded(const cases::Question& question) {
  const Ball& given = cases::ball_of(question);
  const Ball ball{nearest_floats(given.center), nearest_float(given.radius)};
  if (const auto* motion = std::get_if<Motion>(&question)) return Motion(ball, nearest_floats(motion->to));
  return ball;
}

}  // namespace

bool is_in_floats(const cases::Shapes& shapes) {
  const Motion* motion = shapes.motion();
  if (!is_float(shapes.ball().radius) || !are_floats(shapes.ball().center) || (motion && !are_floats(motion->to)))
    return false;
  for (std::size_t i = 0; i < shapes.polygon.vertex_count(); ++i)
    if (!are_floats(shapes.polygon.vertex(i))) return false;
  return true;
}

std::optional<CorpusCase> in_floats(CorpusCase given) {
  const std::string id = given.id;
  given.id += "-float";
  if (is_in_floats(given.shapes)) return given;
  auto polygon = rounded(given.shapes.polygon);
  if (!polygon) return std::nullopt;
  if (off_plane(*polygon) > 0 &&
      off_plane(given.shapes.polygon) <= 0x1p-30 * workloads::extent_of(given.shapes.polygon))
    return std::nullopt;
  cases::Shapes shapes{rounded(given.shapes.question), std::move(*polygon)};
  if (is_at_threshold(given.shapes)) {
    const auto least = least_radius(shapes.question, exact::PreparedPolygon(shapes.polygon));
    if (!least) return std::nullopt;
    const float towards[] = {0, *least, kLargest};
    const auto sum = std::accumulate(id.begin(), id.end(), 0U,
                                     [](unsigned all, char c) { return all + static_cast<unsigned char>(c); });
    if (*least > 0)
      shapes.question =
          cases::with_radius(shapes.question, static_cast<double>(std::nextafter(*least, towards[sum % 3])));
  }
  const Motion* motion = shapes.motion();
  const bool is_finite = shapes.ball().center.allFinite() && std::isfinite(shapes.ball().radius) &&
                         (motion == nullptr || motion->to.allFinite());
  if (!is_finite) return std::nullopt;
  given.shapes = std::move(shapes);
  given.origin = "the nearest floats of: " + given.origin;
  return given;
}

}  // namespace touchstone::corpus
