// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/workloads/adversarial/case.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/program/input.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"

namespace touchstone::corpus {
namespace {

using cases::PartialAnswer;
using Eigen::Vector3d;
using workloads::BallPlace;
using workloads::Placement;
using workloads::Workload;

/// Throws std::runtime_error with the fault of the line.
std::string completed(const std::string& text, const std::string& name, Numbers numbers) {
  const cases::Case read = cases::read_case(text);
  if (const auto* rejection = std::get_if<Rejection>(&read.content)) {
    const auto code = std::string(to_string(rejection->code));
    if (!read.expected || !read.expected->rejects())
      throw std::runtime_error(fmt::format("rejected: {}: {}", code, rejection->message));
    if (!cases::differences(*read.expected, cases::stated(*rejection)).empty())
      throw std::runtime_error(fmt::format("rejected with {}, not with {}", code, read.expected->texts.at("error")));
    return numbers == Numbers::Doubles ? text + "\n" : "";
  }
  const cases::AnyShapes shapes = read.shapes();
  const cases::PartialAnswer truth = exact_answer(shapes);
  if (read.expected)
    for (const cases::Difference& difference : cases::differences(*read.expected, truth))
      throw std::runtime_error(to_string(difference));
  Labels labels = labels_of(text);
  if (std::ranges::find(labels.tags, name) == labels.tags.end()) labels.tags.insert(labels.tags.begin(), name);
  CorpusCase whole{*read.id, shapes, labels.tags, labels.origin.empty() ? "by hand" : labels.origin};
  if (numbers == Numbers::Doubles) return line_of(whole, truth);
  const auto rounded = in_floats(std::move(whole));
  return rounded ? line_of(*rounded, exact_answer(rounded->shapes)) : "";
}

/// Returns the cases of experiments/judge/corpus/given/NAME.jsonl, each with its whole answer. They were made by hand,
/// or found once and cannot be drawn again: in files that are not part of the sources, or in programs with planted
/// bugs. A line with an expected rejection is kept byte for byte; every expectation of a line must hold. Throws
/// std::runtime_error, which names file and line.
std::string given_text(const std::string& name, Numbers numbers) {
  const auto file = program::data("experiments/judge/corpus/given/" + name + ".jsonl");
  std::ifstream stream = program::open_file(file);
  std::string text, line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) try {
      text += completed(line, name, numbers);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", file.string(), number, error.what()));
    }
  return text;
}

/// A sequence of cases to draw.
struct Stream {
  /// Draws case number `index`; nothing if it does not belong to this stream.
  std::function<std::optional<CorpusCase>(std::uint64_t index)> draw;
  std::size_t count;            ///< the number of cases wanted
  std::uint64_t most = 20'000;  ///< the maximal number of indices to try
};

/// A predicate: whether the case, given its answer, is of the kind of the family.
using Kind = std::function<bool(const CorpusCase&, const cases::PartialAnswer& truth)>;

bool any_kind(const CorpusCase&, const PartialAnswer&) { return true; }

constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kLongestLine = 2'400;

std::string command_of(const workloads::Workload& w, std::uint64_t index) {
  std::string command =
      fmt::format("touchstone cases --family {} --placement {} --ball {} --vertices {} --holes {}", to_string(w.family),
                  to_string(w.placement), to_string(w.ball), w.vertices, w.holes);
  if (w.doubles != 0) command += fmt::format(" --ulps {}", w.doubles);
  if (w.way != workloads::Way::Static) command += fmt::format(" --way {}", to_string(w.way));
  if (w.origin_distance != 0) command += fmt::format(" --origin-distance {}", w.origin_distance);
  return command + fmt::format(" --seed {} --first {} --samples 1", kSeed, index);
}

/// Returns the cases of a workload, seed 1.
Stream workload_stream(const workloads::Workload& workload, std::size_t count) {
  return {.draw =
              [workload](std::uint64_t index) {
                workloads::Sample sample = workloads::sample(workload, kSeed, index);
                return CorpusCase{std::move(sample.id), cases::Shapes{sample.question(), std::move(sample.polygon)},
                                  std::move(sample.tags), command_of(workload, index)};
              },
          .count = count};
}

/// Returns the cases of one family of `soak`, seed 1.
Stream soak_stream(workloads::adversarial::Family family, std::size_t count) {
  return {.draw = [family](std::uint64_t index) -> std::optional<CorpusCase> {
            workloads::adversarial::Case drawn = workloads::adversarial::draw_case(kSeed, index);
            if (drawn.family != family) return std::nullopt;
            return CorpusCase{workloads::adversarial::name_of_case(kSeed, index),
                              cases::Shapes{drawn.ball, std::move(drawn.polygon)},
                              {std::string(to_string(family))},
                              fmt::format("touchstone soak --seed {} --from {} --samples 1 --print", kSeed, index)};
          },
          .count = count};
}

/// Returns, one per line, the first cases of each stream that are of that kind and that a witness gets wrong. Skips
/// long lines, because people read the cases. Of floats it takes some more, because few outlines have any.
std::string drawn_text(const std::vector<Stream>& streams, Numbers numbers, const Kind& kind = any_kind) {
  std::string text;
  for (const Stream& stream : streams) {
    std::size_t found = 0;
    const bool floats = numbers == Numbers::Floats;
    const std::size_t count = floats ? std::max(stream.count + 1, 6 * stream.count / 5) : stream.count;
    const std::uint64_t most = floats ? std::min(stream.most, 100 * count) : stream.most;
    for (std::uint64_t index = 0; found < count && index < most; ++index) {
      auto drawn = stream.draw(index);
      if (drawn && floats) drawn = in_floats(std::move(*drawn));
      if (!drawn) continue;
      const cases::PartialAnswer truth = exact_answer(drawn->shapes);
      if (!kind(*drawn, truth) || failing_witnesses(drawn->shapes, truth).empty()) continue;
      const std::string line = line_of(*drawn, truth);
      if (line.size() > kLongestLine) continue;
      text += line;
      ++found;
    }
  }
  return text;
}

/// Returns a stream for each family of outlines and each placement.
void add_outlines(std::vector<Stream>& streams, const Workload& pattern, std::size_t count) {
  for (const auto family : workloads::all_families())
    for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated}) {
      if (pattern.ball == BallPlace::LatticeTangent && placement == Placement::Rotated) continue;
      Workload workload = pattern;
      workload.family = family;
      workload.placement = placement;
      streams.push_back(workload_stream(workload, count));
    }
}

/// Returns the first streams of the corpus, and smaller outlines whose radius is some doubles beside the distance.
std::vector<Stream> outlines_near(BallPlace place, std::size_t count) {
  std::vector<Stream> streams;
  for (const std::size_t holes : {std::size_t{0}, std::size_t{1}})
    add_outlines(streams, {.ball = place, .vertices = 12, .holes = holes}, 1);
  for (const int doubles : {-1, 0, 1}) add_outlines(streams, {.ball = place, .vertices = 6, .doubles = doubles}, count);
  return streams;
}

/// Returns such cases in which a feature of that kind is nearest.
std::string nearest(BallPlace place, Feature::Kind kind, Numbers numbers) {
  auto streams = outlines_near(place, 2);
  streams.push_back(soak_stream(workloads::adversarial::Family::General, 60));
  return drawn_text(streams, numbers,
                    [kind](const CorpusCase&, const PartialAnswer& truth) { return truth.nearest->kind == kind; });
}

/// Returns whether the interior angle at the vertex nearest to the foot is greater than 180 degrees. In doubles.
bool is_reflex_near_foot(const CorpusCase& drawn, const PartialAnswer&) {
  const auto& [question, polygon] = std::get<cases::Shapes>(drawn.shapes);
  const Vector3d normal = workloads::normal_of(polygon, 0), center = cases::ball_of(question).center;
  const Vector3d from = center - polygon.vertex(0);
  const Vector3d foot = center - from.dot(normal) / normal.squaredNorm() * normal;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i)
    if ((polygon.vertex(i) - foot).squaredNorm() < (polygon.vertex(nearest) - foot).squaredNorm()) nearest = i;
  const std::size_t loop = polygon.loop_of(nearest);
  const Vector3d corner = polygon.vertex(nearest);
  const Vector3d turn =
      (corner - polygon.vertex(polygon.previous(nearest))).cross(polygon.vertex(polygon.next(nearest)) - corner);
  const bool convex_in_loop = turn.dot(workloads::normal_of(polygon, loop)) > 0;
  return convex_in_loop == (loop != 0);  // a convex corner of a hole is a reflex corner of the face
}

std::string reflex_vertex(Numbers numbers) {
  std::vector<Stream> streams;
  for (const std::size_t holes : {std::size_t{0}, std::size_t{1}})
    add_outlines(streams, {.ball = BallPlace::FootNearVertex, .vertices = 9, .holes = holes}, holes == 0 ? 8 : 4);
  return drawn_text(streams, numbers, is_reflex_near_foot);
}

/// Returns outlines with the foot near a feature: `count` of each of the small ones.
std::vector<Stream> outlines_with_foot(BallPlace place, std::size_t count) {
  std::vector<Stream> streams;
  for (const std::size_t vertices : {std::size_t{12}, std::size_t{6}})
    for (const std::size_t holes : {std::size_t{0}, std::size_t{1}})
      add_outlines(streams, {.ball = place, .vertices = vertices, .holes = holes}, vertices == 12 ? 1 : count);
  return streams;
}

std::string foot_on_edge(Numbers numbers) {
  auto streams = outlines_with_foot(BallPlace::FootNearEdge, 3);
  streams.push_back(soak_stream(workloads::adversarial::Family::Foot, 100));
  return drawn_text(streams, numbers);
}

std::string foot_on_vertex(Numbers numbers) {
  return drawn_text(outlines_with_foot(BallPlace::FootNearVertex, 4), numbers);
}

std::string tangent_lattice(Numbers numbers) {
  auto streams = outlines_near(BallPlace::LatticeTangent, 3);
  streams.push_back(soak_stream(workloads::adversarial::Family::Lattice, 80));
  streams.push_back(soak_stream(workloads::adversarial::Family::Tangent, 80));
  return drawn_text(streams, numbers);
}

std::string sliver(Numbers numbers) {
  return drawn_text({soak_stream(workloads::adversarial::Family::Needle, 320)}, numbers);
}

std::string far(Numbers numbers) {
  std::vector<Stream> streams;
  for (const double distance : {0x1p10, 0x1p18, 0x1p25})
    for (const BallPlace place : {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::FootNearEdge})
      add_outlines(streams, {.ball = place, .vertices = 5, .origin_distance = distance}, 1);
  streams.push_back(soak_stream(workloads::adversarial::Family::FarAway, 60));
  streams.push_back(soak_stream(workloads::adversarial::Family::Grazing, 60));
  return drawn_text(streams, numbers);
}

std::string exponents(Numbers numbers) {
  return drawn_text({soak_stream(workloads::adversarial::Family::Exponents, 110),
                     soak_stream(workloads::adversarial::Family::Scaled, 110),
                     soak_stream(workloads::adversarial::Family::Close, 60)},
                    numbers);
}

std::string point(Numbers numbers) {
  return drawn_text({soak_stream(workloads::adversarial::Family::Point, 250)}, numbers);
}

std::string off_plane(Numbers numbers) {
  return drawn_text({soak_stream(workloads::adversarial::Family::Outline, 190)}, numbers,
                    [](const CorpusCase& drawn, const PartialAnswer& truth) {
                      const double off = *truth.off_plane;
                      return std::isfinite(off) &&
                             off > 0x1p-30 * workloads::extent_of(std::get<cases::Shapes>(drawn.shapes).polygon);
                    });
}

std::string holes(Numbers numbers) {
  std::vector<Stream> streams;
  for (const BallPlace place : {BallPlace::NearEdge, BallPlace::NearVertex, BallPlace::FootNearEdge})
    for (const std::size_t holes : {std::size_t{1}, std::size_t{2}})
      add_outlines(streams, {.ball = place, .vertices = 7, .holes = holes}, holes == 1 ? 2 : 1);
  return drawn_text(streams, numbers, [](const CorpusCase& drawn, const PartialAnswer& truth) {
    return truth.nearest->kind != Feature::Kind::Face &&
           truth.nearest->index >= std::get<cases::Shapes>(drawn.shapes).polygon.loop_end(0);
  });
}

/// Integer vectors, pairwise orthogonal and of one length.
struct IntegerFrame {
  Vector3d u, v, w;
};
const IntegerFrame kFrames[] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 2, 2}, {2, 1, -2}, {-2, 2, -1}}, {{2, 3, 6}, {3, -6, 2}, {6, 2, -3}}};

/// A loop that visits a point twice, or a hole with a vertex on an edge or a vertex of the outline; and a ball near
/// that point. Nothing if the loops cross.
std::optional<CorpusCase> draw_touching(std::uint64_t index) {
  workloads::Random random(kSeed, index, 'T');
  const IntegerFrame& frame = kFrames[index % 3];
  const auto at = [&](std::int64_t x, std::int64_t y) -> Vector3d {
    return static_cast<double>(x) * frame.u + static_cast<double>(y) * frame.v;
  };
  const auto fan = [&](Loop& loop, std::int64_t lowest) {
    loop.push_back(at(0, 0));
    for (std::int64_t count = random.integer(2, 3); count > 0; --count) {
      const std::int64_t y = random.integer(lowest, 7), x = random.integer(-7, 7);
      loop.push_back(at(x, y));
    }
  };
  std::vector<Loop> loops(1);
  if (random.coin()) {
    fan(loops[0], -7);
    fan(loops[0], -7);
  } else {
    loops[0] = {at(-8, 0), at(8, 0), at(8, 8), at(-8, 8)};
    if (random.coin()) loops[0].insert(loops[0].begin() + 1, at(0, 0));
    fan(loops.emplace_back(), 1);
  }
  try {
    Polygon polygon(loops[0], {loops.begin() + 1, loops.end()});
    if (exact::validate(polygon)) return std::nullopt;
    const double height = static_cast<double>(random.integer(0, 2)), quarter = 0.25;
    const std::int64_t y = random.integer(-6, 6), x = random.integer(-6, 6);
    const Vector3d beside = quarter * at(x, y), above = height * frame.w;
    cases::Shapes shapes{Ball{beside + above, 0}, polygon};
    double radius = exact::answer(shapes.ball(), polygon).distance;
    if (random.coin()) radius = std::nextafter(radius, random.coin() ? 0.0 : 100.0);
    shapes.question = Ball{shapes.ball().center, radius};
    return CorpusCase{fmt::format("touching-{}", index), std::move(shapes), {"touching"}, "touchstone corpus make"};
  } catch (const Rejected&) {
    return std::nullopt;  // two neighbours are equal, or the normal is zero
  }
}

/// A disc and a polygon in the plane z = 0, as engines for two dimensions see them: a drawn polygon without one of its
/// coordinates, and a ball whose radius is the distance or a double beside it. Nothing if the ball's centre is on it.
std::optional<CorpusCase> draw_flat(std::uint64_t index) {
  const auto& outlines = workloads::all_families();
  const Workload workload{.family = outlines[index % outlines.size()],
                          .placement = Placement::LatticeFrame,
                          .ball = index % 2 == 0 ? BallPlace::NearEdge : BallPlace::NearVertex,
                          .vertices = 8,
                          .holes = index % 5 == 0 ? 1U : 0U};
  const workloads::Sample sample = workloads::sample(workload, kSeed, index);
  std::vector<Loop> loops = workloads::loops_of(sample.polygon);
  for (Loop& loop : loops)
    for (Vector3d& vertex : loop) vertex.z() = 0;
  Vector3d center = cases::ball_of(sample.question()).center;
  center.z() = 0;
  try {
    Polygon polygon = workloads::polygon_of(loops);
    if (exact::validate(polygon)) return std::nullopt;
    const double distance = exact::answer({center, 0}, polygon).distance;
    if (distance == 0) return std::nullopt;  // equal to 0 only where the centre is on the polygon, or next to it
    const double towards[] = {0, distance, 2 * distance};
    return CorpusCase{fmt::format("flat-{}", index),
                      cases::Shapes{Ball{center, std::nextafter(distance, towards[index % 3])}, std::move(polygon)},
                      {std::string(to_string(workload.family))},
                      "touchstone corpus make"};
  } catch (const Rejected&) {
    return std::nullopt;  // the plane of the drawn polygon is upright
  }
}

std::string flat(Numbers numbers) { return drawn_text({{.draw = draw_flat, .count = 200}}, numbers); }

/// Returns the stream of those drawn meshes whose ball moves, or is at a place.
Stream mesh_stream(bool moves, std::size_t count) {
  return {.draw = [moves](std::uint64_t index) { return draw_mesh_case(kSeed, index, moves); }, .count = count};
}

std::string meshes_at_rest(Numbers numbers) { return drawn_text({mesh_stream(false, 160)}, numbers); }
std::string meshes_moving(Numbers numbers) { return drawn_text({mesh_stream(true, 80)}, numbers); }

std::string touching(Numbers numbers) { return drawn_text({{.draw = draw_touching, .count = 240}}, numbers); }

std::string moving(Numbers numbers) {
  using workloads::Way;
  std::vector<Stream> streams;
  const auto add = [&](Way way, BallPlace place, std::size_t holes) {
    add_outlines(streams, {.ball = place, .vertices = 5, .holes = holes, .way = way}, 1);
  };
  for (const BallPlace place : {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex})
    add(Way::Across, place, 0);
  for (const Way way : {Way::Across, Way::Along, Way::Start, Way::End}) add(way, BallPlace::LatticeTangent, 0);
  add(Way::Along, BallPlace::NearFace, 0);
  add(Way::Through, BallPlace::NearEdge, 1);
  add(Way::Through, BallPlace::FootNearVertex, 0);
  add(Way::End, BallPlace::NearEdge, 0);
  add(Way::Rest, BallPlace::NearVertex, 0);
  add(Way::Anywhere, BallPlace::Anywhere, 0);
  return given_text("moving", numbers) + drawn_text(streams, numbers);
}

}  // namespace

const std::vector<Family>& all_families() {
  static const std::vector<Family> families{
      {"rejections", "each error code, and which comes first where several apply",
       [](Numbers numbers) { return given_text("rejections", numbers); }},
      {"features", "each key of an answer, ties, the lift, holes and islands, extreme exponents, in small numbers",
       [](Numbers numbers) { return given_text("features", numbers); }},
      {"face", "the radius is the double nearest to the distance, or next to it; the face is nearest",
       [](Numbers numbers) { return nearest(BallPlace::NearFace, Feature::Kind::Face, numbers); }},
      {"edge", "the same, an edge is nearest",
       [](Numbers numbers) { return nearest(BallPlace::NearEdge, Feature::Kind::Edge, numbers); }},
      {"vertex", "the same, a vertex is nearest",
       [](Numbers numbers) { return nearest(BallPlace::NearVertex, Feature::Kind::Vertex, numbers); }},
      {"reflex-vertex", "the foot is within a few doubles of a vertex at which the face bends inwards", reflex_vertex},
      {"foot-on-edge", "the foot is on an edge, or within a few doubles of it", foot_on_edge},
      {"foot-on-vertex", "the foot is on a vertex, or within a few doubles of it", foot_on_vertex},
      {"tangent-lattice", "exactly tangent in integers, ties of every kind, and radii a double beside them",
       tangent_lattice},
      {"sliver", "triangles whose vertices are nearly on a line, or nearly equal", sliver},
      {"far", "shapes up to 2^50 sizes from the origin, and radii up to 2^60 sizes", far},
      {"exponents", "numbers from the least double to the largest, alone and mixed; centres next to the origin",
       exponents},
      {"point", "radius zero or nearly so, centres on the triangle or within some doubles of it", point},
      {"off-plane", "loops that are off their plane: the lift matters", off_plane},
      {"holes", "an edge or a vertex of a hole is nearest", holes},
      {"touching", "loops that touch: a point visited twice, a hole with a vertex on the outline", touching},
      {"flat", "a disc and a polygon in the plane z = 0, as in two dimensions", flat},
      {"moving", "moving balls: grazing, sliding, starting or ending in contact, passing through holes, at rest",
       moving},
      {"meshes/at-rest", "whole meshes: ties of faces, folds and seams; poses", meshes_at_rest},
      {"meshes/moving", "moving balls that come to whole meshes", meshes_moving},
      {"real-meshes", "faces of third-party models of robots and a milling centre, on which methods err the most",
       [](Numbers numbers) { return given_text("real-meshes", numbers); }},
      {"gripper", "the sphere of the thesis's gripper and the faces that it comes near to in its cell",
       [](Numbers numbers) { return given_text("gripper", numbers); }},
      {"planted-bugs", "found for planted bugs that no other case detects; the tags name the bugs",
       [](Numbers numbers) { return numbers == Numbers::Doubles ? given_text("planted-bugs", numbers) : ""; }},
  };
  return families;
}

}  // namespace touchstone::corpus
