// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Filtered_predicate.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

#include <array>

#include "experiments/studies/bench/variants.h"
#include "robust/filtered/detail/signs/signs.h"

namespace touchstone::bench {
namespace {

using filtered::detail::Vector3;

/// The numbers of a question.
template <class Number>
struct Question {
  std::array<Vector3<Number>, 3> vertex;
  Vector3<Number> center;
  Number radius;
};

template <class Number>
struct To {
  template <class Vector>
  static Vector3<Number> vector(const Vector& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
  }
  Question<Number> operator()(const Question<double>& q) const {
    return {{vector(q.vertex[0]), vector(q.vertex[1]), vector(q.vertex[2])}, vector(q.center), Number(q.radius)};
  }
};

template <class Number>
Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// The predicate, once for every number type. Over intervals, a sign that is not certain is an exception.
template <class Number>
struct Contact {
  using result_type = bool;
  static int sign(const Number& value) { return static_cast<CGAL::Sign>(CGAL::sign(value)); }

  bool operator()(const Question<Number>& q) const {
    namespace signs = filtered::detail::signs;
    Vector3<Number> to_center[3], edge[3];
    for (std::size_t i = 0; i < 3; ++i) {
      to_center[i] = q.center - q.vertex[i];
      edge[i] = q.vertex[(i + 1) % 3] - q.vertex[i];
    }
    const Vector3<Number> normal = signs::normal(edge[0], edge[1]);
    bool outside = false;
    for (std::size_t i = 0; i < 3 && !outside; ++i) outside = sign(signs::side(normal, edge[i], to_center[i])) < 0;
    if (!outside) return sign(signs::plane(normal, to_center[0], q.radius)) <= 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (sign(signs::vertex(to_center[i], q.radius)) <= 0) return true;
      if (sign(signs::along(to_center[i], edge[i])) > 0 && sign(signs::beyond(to_center[i], edge[i])) < 0 &&
          sign(signs::line(to_center[i], edge[i], q.radius)) <= 0)
        return true;
    }
    return false;
  }
};

using Interval = CGAL::Interval_nt<false>;
using Predicate = CGAL::Filtered_predicate<Contact<CGAL::Mpzf>, Contact<Interval>, To<CGAL::Mpzf>, To<Interval>>;

Vector3<double> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

bool generated_filter_contact(const Ball& ball, const Triangle& t) {
  return Predicate()(
      Question<double>{{numbers_of(t.a), numbers_of(t.b), numbers_of(t.c)}, numbers_of(ball.center), ball.radius});
}

}  // namespace touchstone::bench
