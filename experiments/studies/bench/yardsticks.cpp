// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/yardsticks.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "experiments/studies/bench/yardsticks_definition.h"

namespace touchstone::bench {

detail::Yardsticks detail::baseline_yardsticks() { return {without_floats, tree_contact}; }

namespace {

/// Truth values as wide as the numbers, so that loops of both are vectorised.
template <class Real>
using Truth = std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>;

template <class Real>
struct Vector {
  Real x, y, z;
};
template <class Real>
__attribute__((always_inline)) inline Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
__attribute__((always_inline)) inline Real dot(const Vector<Real>& a, const Vector<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
__attribute__((always_inline)) inline Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
struct Query {
  const Real* coordinates[9];
  Vector<Real> center;
  Real radius_squared;
};

constexpr std::size_t kBlock = 256;

/// Answers at most kBlock of them.
template <class Real>
__attribute__((always_inline)) inline void ask(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  const Real *ax = query.coordinates[0], *ay = query.coordinates[1], *az = query.coordinates[2];
  const Real *bx = query.coordinates[3], *by = query.coordinates[4], *bz = query.coordinates[5];
  const Real *cx = query.coordinates[6], *cy = query.coordinates[7], *cz = query.coordinates[8];
  const Vector<Real> center = query.center;
  const Real radius_squared = query.radius_squared;
  for (std::size_t i = 0; i < count; ++i) {
    using T = Truth<Real>;
    const Vector<Real> a{ax[i], ay[i], az[i]}, b{bx[i], by[i], bz[i]}, c{cx[i], cy[i], cz[i]};
    const Vector<Real> normal = cross(b - a, a - c);
    T inside = 1, touched = 0;
    const auto edge = [&](const Vector<Real>& start, const Vector<Real>& end) __attribute__((always_inline)) {
      const Vector<Real> from_start = center - start, direction = end - start, moment = cross(from_start, direction);
      const Real along = dot(from_start, direction), length_squared = dot(direction, direction);
      const T line =
          T{dot(moment, moment) <= radius_squared * length_squared} & T{along >= 0} & T{along <= length_squared};
      touched |= line | T{dot(from_start, from_start) <= radius_squared};
      inside &= T{dot(normal, moment) >= 0};
    };
    edge(a, b);
    edge(b, c);
    edge(c, a);
    const Real height = dot(normal, center - c);
    truths[i] = touched | (inside & T{height * height <= radius_squared * dot(normal, normal)});
  }
}

#if defined(__x86_64__)
template <class Real>
__attribute__((target("avx2"))) void ask_with_avx2(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  ask(query, count, truths);
}
#endif
template <class Real>
void ask_with_any(const Query<Real>& query, std::size_t count, Truth<Real>* truths) {
  ask(query, count, truths);
}

}  // namespace

template <class Real>
FastBatch<Real>::FastBatch(std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    std::size_t next = 0;
    for (const Eigen::Vector3d* vertex : {&t.a, &t.b, &t.c})
      for (const double x : *vertex) coordinates_[next++].push_back(static_cast<Real>(x));
  }
}

template <class Real>
void FastBatch<Real>::contact(const Ball& ball, std::span<bool> touches) const {
  auto asked = &ask_with_any<Real>;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) asked = &ask_with_avx2<Real>;
#endif
  const auto radius = static_cast<Real>(ball.radius);
  Truth<Real> truths[kBlock];
  for (std::size_t first = 0; first < touches.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, touches.size() - first);
    Query<Real> query{
        {},
        {static_cast<Real>(ball.center.x()), static_cast<Real>(ball.center.y()), static_cast<Real>(ball.center.z())},
        radius * radius};
    for (std::size_t i = 0; i < coordinates_.size(); ++i) query.coordinates[i] = coordinates_[i].data() + first;
    asked(query, count, truths);
    for (std::size_t i = 0; i < count; ++i) touches[first + i] = truths[i] != 0;
  }
}

template class FastBatch<double>;
template class FastBatch<float>;

namespace {

const detail::Yardsticks& yardsticks() {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  static const detail::Yardsticks table = avx2 ? detail::avx2_yardsticks() : detail::baseline_yardsticks();
#else
  static const detail::Yardsticks table = detail::baseline_yardsticks();
#endif
  return table;
}

}  // namespace

void set_contact_without_floats(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches) {
  yardsticks().set_contact(ball, set, touches);
}

bool contact(const Ball& ball, const FastTree& polygon) { return yardsticks().tree_contact(ball, polygon.prepared_); }

}  // namespace touchstone::bench
