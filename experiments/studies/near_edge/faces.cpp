// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "experiments/cases/truth_as_given.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::near_edge::faces {
namespace {

using Eigen::Vector3d;
using workloads::Random;

/// FNV-1a: the same on every machine.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 14695981039346656037U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return value;
}

/// The outer loop about its first vertex, scaled by a power of two so that its size is between 1 and 2.
struct Shape {
  Vector3d origin;
  int exponent;
  Loop loop;
  Vector3d normal;  ///< of length 1, or NaN

  explicit Shape(const Polygon& polygon) : origin(polygon.vertex(0)) {
    double size = 0;
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
      size = std::max(size, (polygon.vertex(i) - origin).cwiseAbs().maxCoeff());
    exponent = std::ilogb(size);
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
      const Vector3d offset = polygon.vertex(i) - origin;
      loop.emplace_back(std::ldexp(offset.x(), -exponent), std::ldexp(offset.y(), -exponent),
                        std::ldexp(offset.z(), -exponent));
    }
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) sum += loop[i].cross(loop[next(i)]);
    normal = sum / sum.norm();
  }

  std::size_t next(std::size_t i) const { return i + 1 == loop.size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? loop.size() - 1 : i - 1; }
  /// In the plane, away from the region, of length 1: the normal is the one about which the loop turns left.
  Vector3d outward(std::size_t edge) const { return (loop[next(edge)] - loop[edge]).cross(normal).normalized(); }
  Vector3d in_space(const Vector3d& p) const {
    return origin + Vector3d(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
  }
  std::size_t draw_vertex(Random& random) const {
    return static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(loop.size()) - 1));
  }
};

/// From 2^-7 to 4 at the first attempt, then smaller and smaller.
double draw_length(Random& random, int attempt) {
  const auto exponent = static_cast<int>(random.integer(-7, 1)) - 3 * attempt;
  return std::ldexp(1 + random.unit(), exponent);
}

/// `length` along a direction between `out`, in the plane, and the normal or its opposite; sometimes in the plane.
Vector3d away(Random& random, const Vector3d& out, const Vector3d& normal, double length) {
  const double t = random.integer(0, 7) == 0 ? 0 : 2 * random.unit() - 1;  // rational points of the half circle
  return length * ((1 - t * t) / (1 + t * t)) * out + length * (2 * t / (1 + t * t)) * normal;
}

Vector3d draw_above_face(Random& random, const Shape& shape, double length) {
  const std::size_t i = shape.draw_vertex(random);
  double a = random.unit(), b = random.unit();
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const Vector3d& corner = shape.loop[i];
  const Vector3d point =
      corner + a * (shape.loop[shape.next(i)] - corner) + b * (shape.loop[shape.previous(i)] - corner);
  return point + (random.coin() ? length : -length) * shape.normal;
}

Vector3d draw_on_edge(Random& random, const Shape& shape, std::size_t edge) {
  return shape.loop[edge] + random.unit() * (shape.loop[shape.next(edge)] - shape.loop[edge]);
}

Vector3d draw_off_edge(Random& random, const Shape& shape, double length) {
  const std::size_t edge = shape.draw_vertex(random);
  const Vector3d offset = away(random, shape.outward(edge), shape.normal, length);
  return draw_on_edge(random, shape, edge) + offset;
}

Vector3d draw_off_vertex(Random& random, const Shape& shape, double length) {
  const std::size_t i = shape.draw_vertex(random);
  const double share = random.unit();
  const Vector3d out = share * shape.outward(i) + (1 - share) * shape.outward(shape.previous(i));
  return shape.loop[i] + away(random, out.normalized(), shape.normal, length);
}

/// Can every number of the ball be moved by some doubles and stay finite, and no radius become negative?
bool can_be_moved(const Ball& ball) {
  return ball.center.cwiseAbs().maxCoeff() < 1e308 && ball.radius < 1e308 && std::isnormal(ball.radius);
}

/// A centre whose nearest feature is of that kind, with the double nearest to its distance.
std::optional<Ball> draw_near(Random& random, const Shape& shape, const exact::PreparedPolygon& exact,
                              Threshold place) {
  constexpr int kAttempts = 16;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const double length = draw_length(random, attempt / 2);
    const auto [kind, drawn] =
        place == Threshold::Face   ? std::pair(Feature::Kind::Face, draw_above_face(random, shape, length))
        : place == Threshold::Edge ? std::pair(Feature::Kind::Edge, draw_off_edge(random, shape, length))
                                   : std::pair(Feature::Kind::Vertex, draw_off_vertex(random, shape, length));
    const Vector3d center = shape.in_space(drawn);
    if (!center.allFinite()) continue;
    const Answer answer = exact::answer({center, 0}, exact);
    const Ball ball{center, answer.distance};
    if (answer.nearest.kind == kind && can_be_moved(ball)) return ball;
  }
  return std::nullopt;
}

/// Straight above or below a point of an edge, except for roundings; twice as large as the height.
std::optional<Ball> draw_foot(Random& random, const Shape& shape) {
  const std::size_t edge = shape.draw_vertex(random);
  const double length = draw_length(random, 0);
  const Vector3d height = (random.coin() ? length : -length) * shape.normal;
  const Ball ball{shape.in_space(draw_on_edge(random, shape, edge) + height), std::ldexp(2 * length, shape.exponent)};
  if (!ball.center.allFinite() || !can_be_moved(ball)) return std::nullopt;
  return ball;
}

std::uint64_t faces_of(const Settings& settings, const NamedMesh& mesh) {
  return std::min<std::uint64_t>(settings.faces, mesh.mesh.faces.size());
}

/// Keeps the worst of each method, in order.
void keep_worst(std::vector<Failure>& failures) {
  std::ranges::sort(failures, {}, [](const Failure& f) {
    return std::tuple(f.method, !f.wrong[static_cast<std::size_t>(Test::Contact)],
                      -std::abs(FaceCrossing::steps(f.ball)), f.lot, f.mesh, f.face, f.ball);
  });
  std::size_t method = 0, of_method = 0;
  std::erase_if(failures, [&](const Failure& failure) {
    of_method = failure.method == method ? of_method + 1 : 1;
    method = failure.method;
    return of_method > kKeptFailures;
  });
}

/// Counts the answers of a method about one face.
void count(Result& result, const FaceCrossing& crossing, std::size_t method, const cases::Asked& asked) {
  MethodCounts& counts = result.meshes[crossing.mesh].methods[method];
  std::vector<std::array<bool, kTests.size()>> wrong(crossing.balls.size());
  bool face_wrong = false;
  for (std::size_t test = 0; test < kTests.size(); ++test)
    asked.compare(kTests[test], [&](std::size_t ball, const cases::Outcomes& outcomes) {
      const auto outcome = asked.lifts() ? outcomes.contract : outcomes.as_given;
      if (!outcome) return;
      counts.at[crossing.place(ball)][test].add(outcome);
      // Cases that are kept expect the contract's answers.
      wrong[ball][test] = *outcome != cases::Outcome::Right && *outcomes.contract != cases::Outcome::Right;
      face_wrong |= wrong[ball][test] && kTests[test] == Test::Contact;
    });
  counts.faces_wrong += face_wrong ? 1 : 0;
  for (std::size_t ball = 0; ball < wrong.size(); ++ball)
    if (std::ranges::find(wrong[ball], true) != wrong[ball].end())
      result.failures.push_back(
          {method, crossing.mesh, crossing.face, ball, wrong[ball], Random(crossing.mesh, crossing.face, ball).bits()});
  constexpr std::size_t kMany = 10'000;
  if (result.failures.size() > kMany) keep_worst(result.failures);
}

}  // namespace

std::string_view place_name(Threshold place) { return place == Threshold::FootEdge ? "foot" : to_string(place); }

FaceCrossing draw_face_crossing(const Polygon& polygon, std::uint64_t seed, std::string_view mesh, std::uint64_t face) {
  const exact::PreparedPolygon exact(polygon);
  const Shape shape(polygon);
  FaceCrossing crossing{{polygon, {}, {}, {}, {}}, {}, {}};
  for (std::size_t place = 0; place < kPlaces.size(); ++place) {
    const bool foot = kPlaces[place] == Threshold::FootEdge;
    Random random(seed, face, hash(mesh) + place);
    const auto axis = static_cast<int>(random.integer(0, 2));
    const auto ball = foot ? draw_foot(random, shape) : draw_near(random, shape, exact, kPlaces[place]);
    (ball ? crossing.places : crossing.missing).push_back(place);
    for (const int steps : kSteps) {
      if (!ball) break;
      Ball& moved = crossing.balls.emplace_back(*ball);
      double& coordinate = foot ? moved.center[axis] : moved.radius;
      coordinate = workloads::move_by_doubles(coordinate, steps);
      crossing.truths.push_back(cases::PartialAnswer::of(exact::answer(moved, exact), ""));
    }
  }
  if (polygon.vertex_count() == 3) return crossing;  // no vertex is lifted
  const auto contract = methods::find_method("exact")->prepare(polygon);
  const cases::TruthAsGiven as_given(*contract, polygon);
  crossing.as_given = crossing.truths;
  for (std::size_t ball = 0; ball < crossing.balls.size(); ++ball) {
    const auto truth = as_given.ask(crossing.balls[ball], cases::QueryKind::Contact);
    crossing.as_given[ball].edges_hit = truth.edges_hit;
    crossing.as_given[ball].contact = truth.contact;
  }
  return crossing;
}

Failures MethodCounts::total(Test test) const {
  Failures sum;
  for (const auto& tests : at) program::add(sum, tests[static_cast<std::size_t>(test)]);
  return sum;
}

Result& Result::operator+=(const Result& other) {
  program::add(meshes, other.meshes);
  rejected.insert(rejected.end(), other.rejected.begin(), other.rejected.end());
  std::ranges::sort(rejected, {}, [](const RejectedFace& face) { return std::tie(face.mesh, face.face); });
  failures.insert(failures.end(), other.failures.begin(), other.failures.end());
  keep_worst(failures);
  return *this;
}

std::uint64_t items_done(const Result& result) { return cases::total(result.meshes).faces; }

std::uint64_t face_count(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  std::uint64_t faces = 0;
  for (const NamedMesh& mesh : meshes) faces += faces_of(settings, mesh);
  return faces;
}

Result no_result(const Settings& settings, const std::vector<NamedMesh>& meshes) {
  Result result;
  result.meshes.resize(meshes.size());
  for (MeshCounts& counts : result.meshes) counts.methods.resize(settings.methods.size());
  return result;
}

void measure(const Settings& settings, const std::vector<NamedMesh>& meshes, const program::RunControl& control,
             Result& result) {
  constexpr std::uint64_t kBlock = 32;
  std::vector<std::uint64_t> ends;  // of the faces of each mesh
  for (const NamedMesh& mesh : meshes) ends.push_back((ends.empty() ? 0 : ends.back()) + faces_of(settings, mesh));
  const std::uint64_t all = ends.empty() ? 0 : ends.back();
  cases::walk(
      {.methods = settings.methods, .samples = all, .threads = settings.threads, .whole = true, .block = kBlock},
      control, no_result(settings, meshes), result,
      [&](std::uint64_t n, Result& part, const auto& visit) {
        const auto mesh = static_cast<std::size_t>(std::ranges::upper_bound(ends, n) - ends.begin());
        const std::uint64_t face = mesh == 0 ? n : n - ends[mesh - 1];
        MeshCounts& counts = part.meshes[mesh];
        ++counts.faces;
        try {
          auto crossing =
              draw_face_crossing(mesh::face_polygon(meshes[mesh].mesh, face), settings.seed, meshes[mesh].name, face);
          crossing.mesh = mesh;
          crossing.face = face;
          counts.queries += crossing.balls.size();
          for (const std::size_t place : crossing.missing) ++counts.missing[place];
          visit(crossing);
        } catch (const Rejected& rejected) {
          ++counts.rejected;
          part.rejected.push_back({mesh, face, rejected.rejection()});
        }
      },
      count);
}

}  // namespace touchstone::near_edge::faces
