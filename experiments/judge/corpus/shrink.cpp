// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>

#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/program/table.h"
#include "geometry/shapes/rejection.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/motion.h"
#include "robust/scene/posing.h"

namespace touchstone::corpus {
namespace {

using cases::AnyShapes;
using cases::Key;
using cases::key_of;
using cases::MeshShapes;
using cases::PartialAnswer;
using cases::PosedMesh;
using cases::Shapes;
using Eigen::Vector3d;

/// A number |x| = significand 2^exponent with an odd significand; both are 0 for 0.
struct Parts {
  std::uint64_t significand = 0;
  int exponent = 0;
};

Parts parts_of(double x) {
  if (x == 0) return {};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t whole = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const int zeros = std::countr_zero(whole);
  return {whole >> zeros, std::max(field, 1) - 1075 + zeros};
}

std::size_t bits_of(double x) {
  const Parts parts = parts_of(x);
  return static_cast<std::size_t>(std::bit_width(parts.significand)) +
         static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(std::abs(parts.exponent)))) + (x < 0 ? 1 : 0);
}

std::size_t bits_of(const Vector3d& v) { return bits_of(v.x()) + bits_of(v.y()) + bits_of(v.z()); }

/// Rounds to the nearest multiple of 2^exponent.
double on_grid(double x, int exponent) { return std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent); }

/// Returns simpler numbers of the same sign, the simplest first.
std::vector<double> simpler(double x) {
  const Parts parts = parts_of(x);
  const int width = static_cast<int>(std::bit_width(parts.significand)), top = parts.exponent + width;
  std::vector<double> numbers{0, std::copysign(1.0, x)};
  for (const int keep : {1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 32, 40, 48})
    if (keep < width) numbers.push_back(on_grid(x, top - keep));
  if (width > 1) numbers.push_back(on_grid(x, parts.exponent + 1));
  const auto odd = std::copysign(static_cast<double>(parts.significand), x);
  for (const int exponent : {0, parts.exponent / 2, parts.exponent - (parts.exponent > 0 ? 1 : -1)})
    numbers.push_back(std::ldexp(odd, exponent));
  return numbers;
}

bool is_usable(const AnyShapes& shapes) {
  if (std::visit([](const auto& asked) { return find_fault(asked); }, question_of(shapes))) return false;
  const auto* one = std::get_if<Shapes>(&shapes);  // the faces of a mesh are valid
  return one == nullptr || !exact::validate(one->polygon);
}

/// Returns the radius from which on the ball touches, rounded. Requires usable shapes.
double threshold_of(const AnyShapes& shapes) {
  const auto* motion = std::get_if<Motion>(&question_of(shapes));
  if (!motion) return *exact_answer(shapes).distance;
  const auto polygons = faces_of(shapes);
  const std::vector<filtered::PreparedPolygon> faces(polygons.begin(), polygons.end());
  return workloads::grazing_radius(*motion, [&faces](const Motion& asked) {
    return std::ranges::any_of(faces, [&](const auto& face) { return filtered::contact(asked, face); });
  });
}

std::string word(bool value) { return program::yes_or_no(value); }
std::string word(const Feature& value) { return std::string(to_string(value.kind)); }
template <class Value>
std::string word(const Value& value) {
  if constexpr (std::is_enum_v<Value>) return std::string(to_string(value));
  return {};
}

/// Returns the part of an answer that is a word, yes or no: the kind of a feature; an empty text for edges
/// and numbers, and for a key that the answer lacks.
std::string words_of(const PartialAnswer& answer, const Key& key) {
  return key.visit([&](auto member) { return answer.*member ? word(*(answer.*member)) : ""; });
}

/// A case while it is being reduced.
class Shrinker {
 public:
  Shrinker(const SameFailure& failure, const AnyShapes& shapes, const std::atomic<bool>& stop)
      : failure_(failure), stop_(stop) {
    accept(shapes);
  }

  AnyShapes run() {
    do {
      changed_ = false;
      if (now_.faces.empty()) {
        leave_out_loops();
        for (std::size_t loop = 0; loop < now_.loops.size(); ++loop)
          leave_out(
              [loop](Candidate & candidate) -> auto& { return candidate.loops[loop]; }, 4);
      } else {
        leave_out_pose();
        leave_out(
            [](Candidate & candidate) -> auto& { return candidate.faces; }, 2);
        for (std::size_t face = 0; face < now_.faces.size(); ++face)
          leave_out(
              [face](Candidate & candidate) -> auto& { return candidate.faces[face]; }, 4);
      }
      stand_still();
      translate();
      scale();
      mirror();
      coarsen();
      for (std::size_t i = 0; i < 3 * (size_.vertices + (now_.to ? 1 : 0)) + 4; ++i) simplify(i);
    } while (changed_ && !stop_);
    return shapes_of(now_);
  }

 private:
  struct Candidate {
    Ball ball;
    std::optional<Vector3d> to;
    std::vector<Loop> loops;                        // one with the vertices of a mesh
    std::vector<std::vector<std::uint32_t>> faces;  // of a mesh; else empty
    Pose pose;                                      // of a mesh
  };

  static AnyShapes shapes_of(const Candidate& candidate) {
    cases::Question question = candidate.ball;
    if (candidate.to) question = Motion{candidate.ball, *candidate.to};
    if (candidate.faces.empty()) return Shapes{std::move(question), workloads::polygon_of(candidate.loops)};
    return MeshShapes{std::move(question), PosedMesh({candidate.loops.front(), candidate.faces}, candidate.pose)};
  }

  void accept(const AnyShapes& shapes) {
    const cases::Question& question = question_of(shapes);
    const auto* motion = std::get_if<Motion>(&question);
    now_ = {cases::ball_of(question), motion ? std::optional(motion->to) : std::nullopt, {}, {}, {}};
    if (const auto* one = std::get_if<Shapes>(&shapes)) {
      now_.loops = workloads::loops_of(one->polygon);
    } else {
      const PosedMesh& mesh = std::get<MeshShapes>(shapes).mesh;
      now_.loops = {mesh.mesh().vertices};
      now_.faces = mesh.mesh().faces;
      now_.pose = mesh.pose();
    }
    size_ = size_of(shapes);
    margin_ = workloads::doubles_between(threshold_of(shapes), now_.ball.radius);
  }

  /// Accepts the candidate if it is smaller and fails in the same way, if necessary with the radius as near to the
  /// distance as before.
  bool take(const Candidate& candidate) try {
    if (stop_ || !candidate.ball.center.allFinite()) return false;
    AnyShapes shapes = shapes_of(candidate);
    if (take(shapes)) return true;
    if (std::abs(margin_) > kMostMargin || !is_usable(shapes)) return false;
    const double threshold = threshold_of(shapes);
    if (!std::isfinite(threshold)) return false;
    return take(with_radius(std::move(shapes), workloads::move_by_doubles(threshold, margin_)));
  } catch (const Rejected&) {
    return false;
  }

  bool take(const AnyShapes& shapes) {
    if (size_of(shapes) >= size_ || !failure_.holds(shapes)) return false;
    accept(shapes);
    return changed_ = true;
  }

  void leave_out_loops() {
    for (std::size_t loop = now_.loops.size(); loop-- > 1;)  // a hole by itself
      if (loop < now_.loops.size() && take({now_.ball, now_.to, {now_.loops[loop]}, {}, {}})) return;
    leave_out(
        [](Candidate & candidate) -> auto& { return candidate.loops; }, 1, 1);
  }

  /// Poses the vertices instead.
  void leave_out_pose() {
    if (now_.pose == Pose()) return;
    Candidate candidate = now_;
    for (Vector3d& vertex : candidate.loops.front()) vertex = scene::posed(now_.pose, vertex);
    candidate.pose = {};
    (void)take(candidate);
  }

  /// Leaves out the vertices that no face uses.
  static void leave_out_unused(Candidate& candidate) {
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const auto& face : candidate.faces)
      for (const std::uint32_t vertex : face) numbers[vertex] = 0;
    Loop vertices;
    for (auto& [before, after] : numbers) {
      after = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(candidate.loops.front()[before]);
    }
    for (auto& face : candidate.faces)
      for (std::uint32_t& vertex : face) vertex = numbers[vertex];
    candidate.loops.front() = std::move(vertices);
  }

  /// Tries to leave out parts of a list from `first` on, halves first, as long as it has `least` of them.
  template <class List>
  void leave_out(const List& list, std::size_t least, std::size_t first = 0) {
    const auto count = [&] { return list(now_).size() - first; };
    for (std::size_t part = count() / 2 + count() % 2; part > 0; part /= 2)
      for (std::size_t begin = 0; begin < count() && count() >= least;) {
        const std::size_t end = std::min(begin + part, count());
        Candidate candidate = now_;
        auto& parts = list(candidate);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(first + begin),
                    parts.begin() + static_cast<std::ptrdiff_t>(first + end));
        if (!candidate.faces.empty()) leave_out_unused(candidate);
        if (!take(candidate)) begin = end;
      }
  }

  void stand_still() {
    if (!now_.to || *now_.to == now_.ball.center) return;
    Candidate candidate = now_;
    candidate.to = now_.ball.center;
    (void)take(candidate);
  }

  /// Applies one function to every coordinate: f(x, axis).
  template <class Map>
  [[nodiscard]] Candidate mapped(const Map& f) const {
    Candidate candidate = now_;
    const auto map = [&f](Vector3d& v) {
      for (int axis = 0; axis < 3; ++axis) v[axis] = f(v[axis], axis);
    };
    map(candidate.ball.center);
    if (candidate.to) map(*candidate.to);
    for (Loop& loop : candidate.loops)
      for (Vector3d& v : loop) map(v);
    return candidate;
  }

  [[nodiscard]] std::vector<Vector3d> points() const {
    std::vector<Vector3d> points{now_.ball.center};
    if (now_.to) points.push_back(*now_.to);
    for (const Loop& loop : now_.loops) points.insert(points.end(), loop.begin(), loop.end());
    return points;
  }

  void translate() {
    for (const Vector3d& origin : points())
      if (take(mapped([&](double x, int axis) { return x - origin[axis]; }))) break;
    for (int moved = 0; moved < 3; ++moved)
      for (const Vector3d& origin : points())
        if (take(mapped([&](double x, int axis) { return axis == moved ? x - origin[axis] : x; }))) break;
  }

  void scale() {
    std::set<int> exponents;
    for (const Vector3d& v : points())
      for (const double x : v)
        if (x != 0) exponents.insert(parts_of(x).exponent), exponents.insert(std::ilogb(x));
    if (now_.ball.radius != 0) exponents.insert(parts_of(now_.ball.radius).exponent);
    for (const int exponent : exponents) {
      Candidate candidate = mapped([&](double x, int) { return std::ldexp(x, -exponent); });
      candidate.ball.radius = std::ldexp(now_.ball.radius, -exponent);
      if (std::isfinite(candidate.ball.radius) && take(candidate)) return;
    }
  }

  void mirror() {
    for (int mirrored = 0; mirrored < 3; ++mirrored)
      (void)take(mapped([&](double x, int axis) { return axis == mirrored ? 0.0 - x : x; }));
  }

  /// Rounds all coordinates to the coarsest grid that keeps the failure; then those of the polygon, then of the ball.
  void coarsen() {
    int finest = 1024, coarsest = -1075;
    for (const Vector3d& v : points())
      for (const double x : v)
        if (x != 0) finest = std::min(finest, parts_of(x).exponent), coarsest = std::max(coarsest, std::ilogb(x) + 1);
    const int step = std::max(1, (coarsest - finest) / 128);
    for (const int what : {0, 1, 2})
      for (int exponent = coarsest; exponent > finest; exponent -= step) {
        Candidate candidate = mapped([&](double x, int) { return on_grid(x, exponent); });
        if (what == 1) candidate.ball = now_.ball, candidate.to = now_.to;
        if (what == 2) candidate.loops = now_.loops;
        if (take(candidate)) break;
      }
  }

  /// Finds the radius, the coordinates of the centre and of a moving ball's end, then those of the vertices.
  static double& number(Candidate& candidate, std::size_t i) {
    if (i == 0) return candidate.ball.radius;
    if (i < 4) return candidate.ball.center[static_cast<Eigen::Index>(i - 1)];
    if (candidate.to && i < 7) return (*candidate.to)[static_cast<Eigen::Index>(i - 4)];
    if (candidate.to) i -= 3;
    std::size_t vertex = (i - 4) / 3;
    auto loop = candidate.loops.begin();
    for (; vertex >= loop->size(); ++loop) vertex -= loop->size();
    return (*loop)[vertex][static_cast<Eigen::Index>((i - 4) % 3)];
  }

  void simplify(std::size_t i) {
    for (bool again = true; again;) {
      again = false;
      Candidate candidate = now_;
      double& changed = number(candidate, i);
      const std::size_t before = bits_of(changed);
      for (const double x : simpler(changed)) {
        if (bits_of(x) >= before) continue;
        changed = x;
        if ((again = take(candidate))) break;
      }
    }
  }

  static constexpr std::int64_t kMostMargin = 1'000;

  const SameFailure& failure_;
  const std::atomic<bool>& stop_;
  Candidate now_;
  Size size_;
  std::int64_t margin_ = 0;  // how many doubles the radius lies above its threshold
  bool changed_ = false;
};

}  // namespace

Size size_of(const AnyShapes& shapes) {
  const cases::Question& question = question_of(shapes);
  Size size{.bits = bits_of(cases::ball_of(question).radius) + bits_of(cases::ball_of(question).center)};
  if (const auto* motion = std::get_if<Motion>(&question)) size.bits += bits_of(motion->to);
  if (const auto* one = std::get_if<Shapes>(&shapes)) {
    size.loops = one->polygon.loop_count();
    size.vertices = one->polygon.vertex_count();
    for (std::size_t i = 0; i < size.vertices; ++i) size.bits += bits_of(one->polygon.vertex(i));
    return size;
  }
  const auto& [vertices, faces] = std::get<MeshShapes>(shapes).mesh.mesh();
  size.loops = faces.size() + (std::get<MeshShapes>(shapes).mesh.pose() == Pose() ? 0 : 1);
  size.vertices = vertices.size();
  for (const auto& face : faces) size.corners += face.size();
  for (const Vector3d& vertex : vertices) size.bits += bits_of(vertex);
  return size;
}

SameFailure::SameFailure(const cases::Method& method, const AnyShapes& shapes, const std::optional<std::string>& key)
    : method_(method) {
  const PartialAnswer truth = exact_answer(shapes);
  const auto [wrong, given] = wrong_answer(method, shapes, truth);
  if (wrong.empty()) throw std::invalid_argument(std::string(method.name()) + " is not wrong about it");
  if (key && std::ranges::find(wrong, std::string_view(*key), &Key::name) == wrong.end())
    throw std::invalid_argument(std::string(method.name()) + " is not wrong about its " + *key);
  nothing_decisive_ = !key && !any_decisive(wrong);
  true_first_ = words_of(truth, key_of(&PartialAnswer::first));
  for (const Key& each : wrong) {
    if (key ? each.name != *key : !is_decisive(each) && !nothing_decisive_) continue;
    keys_.push_back(each);
    true_words_.push_back(words_of(truth, each));
    given_words_.push_back(words_of(given, each));
  }
}

bool SameFailure::holds(const AnyShapes& shapes) const {
  if (!is_usable(shapes)) return false;
  const PartialAnswer truth = exact_answer(shapes);
  const auto [wrong, given] = wrong_answer(method_, shapes, truth);
  if (nothing_decisive_ && any_decisive(wrong)) return false;
  if (words_of(truth, key_of(&PartialAnswer::first)) != true_first_) return false;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (std::ranges::find(wrong, keys_[i]) == wrong.end() || words_of(given, keys_[i]) != given_words_[i] ||
        words_of(truth, keys_[i]) != true_words_[i])
      return false;
  return true;
}

AnyShapes shrink(const SameFailure& failure, const AnyShapes& shapes, const std::atomic<bool>& stop) {
  return Shrinker(failure, shapes, stop).run();
}

}  // namespace touchstone::corpus
