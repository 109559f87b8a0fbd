// SPDX-License-Identifier: GPL-3.0-or-later
// Prints one hash of the answers of `exact` and `filtered` to many questions, most of them near a boundary, in all four
// rounding modes. The same for every compiler and every flag, or some answer is not.

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"

namespace {

using namespace touchstone;

/// SplitMix64: sample after sample, a function of the seed alone.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; }  // exact
  Eigen::Vector3d vector() {
    const double x = unit(), y = unit();
    return {x, y, unit()};
  }

 private:
  std::uint64_t state_;
};

class Hash {
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3; }
  void add(double number) {
    const double value = number + 0.0;  // one zero
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    add(word);
  }
  void add(const filtered::ClosestPoint& p) {
    for (const auto word : {static_cast<std::uint64_t>(p.feature.kind), std::uint64_t{p.feature.index}}) add(word);
    for (int axis = 0; axis < 3; ++axis) add(p.point[axis]);
    add(p.distance);
  }
  void add(const FirstContact& f) {
    for (const auto word : {static_cast<std::uint64_t>(f.kind), static_cast<std::uint64_t>(f.momentary),
                            static_cast<std::uint64_t>(f.feature.kind), std::uint64_t{f.feature.index}})
      add(word);
    add(f.time);
    for (int axis = 0; axis < 3; ++axis) add(f.point[axis]);
  }
  void add(const Answer& a) {
    for (const auto word : {static_cast<std::uint64_t>(a.plane), static_cast<std::uint64_t>(a.plane_tangent),
                            static_cast<std::uint64_t>(a.foot), static_cast<std::uint64_t>(a.relation)})
      add(word);
    for (const std::size_t edge : a.edges_hit) add(std::uint64_t{edge});
    add({a.nearest, a.point, a.distance});
    add(a.off_plane);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

/// A star about the origin in the plane of two random vectors, its corners rounded; or a triangle.
Loop outline(Random& random) {
  const std::size_t corners = 3 + random.below(9);
  if (corners == 3) return {random.vector(), random.vector(), random.vector()};
  const Eigen::Vector3d u = random.vector(), v = random.vector();
  Loop loop;
  for (std::size_t i = 0; i < corners; ++i) {
    // A rational point of the circle, by its half-angle tangent in each half of the turn.
    const double turn = 4 * static_cast<double>(i) / static_cast<double>(corners) - 1;
    const double t = turn < 1 ? turn : turn - 2, sign = turn < 1 ? 1 : -1;
    const double x = sign * (1 - t * t) / (1 + t * t), y = sign * 2 * t / (1 + t * t);
    const double radius = 0.6 + 0.3 * random.unit();
    loop.push_back(radius * x * u + radius * y * v);
  }
  return loop;
}

constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

struct Question {
  Loop loop;
  exact::PreparedPolygon truth;
  filtered::PreparedPolygon prepared;
  Ball ball;
  Motion motion;  ///< of the same radius; half of them pass the point at which the ball touches
  int mode;
};

std::vector<Question> draw(int count) {
  std::vector<Question> questions;
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    Loop loop = outline(random);
    const double scale = std::ldexp(1.0, random.below(4) == 0 ? static_cast<int>(random.below(1600)) - 800 : 0);
    for (Eigen::Vector3d& p : loop) p *= scale;
    const Polygon polygon(loop);
    if (exact::validate(polygon)) continue;
    exact::PreparedPolygon truth(polygon);
    Ball ball{random.vector() * scale, 0};
    if (random.below(2) == 0) ball.center = (loop[0] + loop[1]) / 2;
    ball.radius = exact::answer(ball, truth).distance;
    if (random.below(2) == 0) ball.radius = std::nextafter(ball.radius, random.below(2) == 0 ? 0.0 : HUGE_VAL);
    const Eigen::Vector3d way = random.vector() * scale;
    const Motion motion = random.below(2) == 0 ? Motion{{ball.center - way, ball.radius}, ball.center + way}
                                               : Motion{{random.vector() * (4 * scale), ball.radius / 4}, way};
    questions.push_back({loop, std::move(truth), filtered::PreparedPolygon(polygon), ball, motion, kModes[i % 4]});
  }
  return questions;
}

struct Hashes {
  Hash exact, filtered;
};

Hashes ask(const std::vector<Question>& questions) {
  Hashes hashes;
  for (const auto& [loop, truth, prepared, ball, motion, mode] : questions) {
    std::fesetround(mode);
    const Answer exact = exact::answer(ball, truth), certified = filtered::answer(ball, prepared);
    const FirstContact first = exact::first_contact(motion, truth);
    FirstContact certified_first = filtered::first_contact(motion, prepared);
    bool contact = false, way_contact = false;
    filtered::ClosestPoint closest{certified.nearest, certified.point, certified.distance};
    if (loop.size() == 3) {
      const Triangle triangle{loop[0], loop[1], loop[2]};
      const filtered::TriangleSet set({&triangle, 1});
      contact = filtered::contact(ball, triangle);
      if (filtered::any_contact(ball, set) != contact) contact = !exact.contact();
      closest = filtered::closest(ball.center, triangle);
      way_contact = filtered::contact(motion, triangle);
      if (filtered::first_contact(motion, triangle) != certified_first) certified_first = {};
    } else {
      contact = filtered::contact(ball, prepared);
      way_contact = filtered::contact(motion, prepared);
    }
    std::fesetround(FE_TONEAREST);
    hashes.exact.add(exact);
    hashes.exact.add(std::uint64_t{exact.contact()});
    hashes.exact.add({exact.nearest, exact.point, exact.distance});
    hashes.exact.add(first);
    hashes.exact.add(std::uint64_t{first.contact()});
    hashes.filtered.add(certified);
    hashes.filtered.add(std::uint64_t{contact});
    hashes.filtered.add(closest);
    hashes.filtered.add(certified_first);
    hashes.filtered.add(std::uint64_t{way_contact});
  }
  return hashes;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Question> questions = draw(argc > 1 ? std::atoi(argv[1]) : 2000);
  const Hashes hashes = ask(questions);
  std::printf("%zu questions, exact %016llx, filtered %016llx\n", questions.size(),
              static_cast<unsigned long long>(hashes.exact.value()),
              static_cast<unsigned long long>(hashes.filtered.value()));
  return hashes.exact.value() == hashes.filtered.value() ? 0 : 1;
}
