// SPDX-License-Identifier: GPL-3.0-or-later
// The contract's formulas over numbers that are sure: intervals and rationals.
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

/// The formulas of the contract, literally, with their divisions, over a field of numbers.
///
/// Comparisons of numbers may be uncertain (CGAL::Uncertain), as those of intervals are. An answer is given only if it
/// follows from certain comparisons. The class filters nothing, caches nothing between queries, and uses no shortcuts.
/// Arithmetic provides its Number, a Guard that lives during computations, `nearest_double(x)` and `nearest_root(x)`
/// (the double nearest to x, or to its root, if that is known), and kStage, which names it.
template <class Arithmetic>
class PlainPolygon {
 public:
  using Number = typename Arithmetic::Number;
  using Vector = typename CGAL::Simple_cartesian<Number>::Vector_3;
  using Unsure = CGAL::Uncertain<bool>;

  explicit PlainPolygon(const Polygon& polygon) {
    const std::size_t count = polygon.vertex_count(), outer = polygon.loop_end(0);
    for (std::size_t i = 0; i < count; ++i) {
      vertices_.push_back(vector(polygon.vertex(i)));
      next_.push_back(polygon.next(i));
    }
    const Vector origin = vertices_[0];
    normal_ = Vector(Number(0), Number(0), Number(0));
    Vector sum = normal_;
    for (std::size_t i = 0; i < outer; ++i) {
      normal_ = normal_ + CGAL::cross_product(vertices_[i] - origin, vertices_[next_[i]] - origin);
      sum = sum + (vertices_[i] - origin);
    }
    normal_squared_ = normal_ * normal_;
    point_ = origin + sum / Number(static_cast<int>(outer));
    axis_ = largest_component();
    lift();
  }

  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] const Number& off_plane() const { return off_plane_; }

  /// A query: a ball and the polygon.
  class Query {
   public:
    Query(const Ball& ball, const PlainPolygon& polygon)
        : p_(polygon),
          center_(vector(ball.center)),
          radius_squared_(CGAL::square(Number(ball.radius))),
          height_(p_.normal_ * (center_ - p_.point_)),
          foot_(center_ - height_ / p_.normal_squared_ * p_.normal_) {}

    [[nodiscard]] std::optional<PlaneSide> plane_side() const {
      const Unsure intersects = plane_distance() <= radius_squared_;
      if (CGAL::certainly(intersects)) return PlaneSide::Intersects;
      if (CGAL::possibly(intersects)) return std::nullopt;
      if (CGAL::certainly(height_ > Number(0))) return PlaneSide::InFront;
      if (CGAL::certainly(height_ < Number(0))) return PlaneSide::Behind;
      return std::nullopt;
    }
    [[nodiscard]] std::optional<bool> plane_tangent() const { return known(plane_distance() == radius_squared_); }

    /// Counts the crossings of a ray from the foot along u.
    [[nodiscard]] std::optional<PointLocation> foot() const {
      const int u = (p_.axis_ + 1) % 3, v = (p_.axis_ + 2) % 3;
      const Number zero(0);
      bool inside = false;
      for (std::size_t i = 0; i < p_.vertices_.size(); ++i) {
        const Vector start = p_.vertices_[i] - foot_, end = p_.vertices_[p_.next_[i]] - foot_;
        const auto both = [&](int axis, auto beyond) {
          return CGAL::certainly(beyond(start[axis])) && CGAL::certainly(beyond(end[axis]));
        };
        const auto positive = [&](const Number& x) { return x > zero; };
        const auto negative = [&](const Number& x) { return x < zero; };
        if (both(v, positive) || both(v, negative) || both(u, negative))
          continue;  // neither on the boundary nor a crossing
        const Number side = start[u] * end[v] - start[v] * end[u];
        if (CGAL::certainly(side == zero)) {
          const auto on_edge = known(start * end <= zero);  // the foot lies between the ends
          if (!on_edge) return std::nullopt;
          if (*on_edge) return PointLocation::Boundary;
          continue;
        }
        if (CGAL::possibly(side == zero)) return std::nullopt;
        const auto start_above = known(start[v] > zero), end_above = known(end[v] > zero);
        if (!start_above || !end_above) return std::nullopt;
        if (*start_above != *end_above && CGAL::certainly(side > zero) == *end_above) inside = !inside;
      }
      return inside ? PointLocation::Inside : PointLocation::Outside;
    }

    [[nodiscard]] std::optional<std::vector<std::size_t>> edges_hit() const {
      std::vector<std::size_t> hit;
      for (std::size_t i = 0; i < p_.vertices_.size(); ++i) {
        const auto sure = known(touches_edge(i, true));
        if (!sure) return std::nullopt;
        if (*sure) hit.push_back(i);
      }
      return hit;
    }

    [[nodiscard]] std::optional<bool> contact() const { return known(touches(true)); }

    [[nodiscard]] std::optional<Relation> relation() const {
      const Unsure closed = touches(true);
      if (!CGAL::possibly(closed)) return Relation::Separate;
      const Unsure open = touches(false);
      if (CGAL::certainly(open)) return Relation::Overlapping;
      if (CGAL::certainly(closed) && !CGAL::possibly(open)) return Relation::Touching;
      return std::nullopt;
    }

    struct Candidate {
      Feature feature;
      Number distance_squared;
    };
    [[nodiscard]] std::optional<Candidate> nearest() const {
      const auto place = foot();
      if (!place) return std::nullopt;
      if (*place == PointLocation::Inside) return Candidate{{Feature::Kind::Face, 0}, plane_distance()};
      return nearest_on_boundary();
    }
    [[nodiscard]] Vector closest_point(const Feature& feature) const {
      if (feature.kind == Feature::Kind::Face) return foot_;
      if (feature.kind == Feature::Kind::Vertex) return p_.vertices_[feature.index];
      const Edge edge(*this, feature.index);
      return p_.vertices_[feature.index] + edge.along / edge.length_squared * edge.direction;
    }

    /// Returns a vector along the contact normal. Requires certain comparisons.
    [[nodiscard]] Vector away_from(const Feature& feature) const {
      const Vector away = center_ - closest_point(feature);
      return away == CGAL::NULL_VECTOR ? p_.normal_ : away;
    }

   private:
    struct Edge {
      Edge(const Query& query, std::size_t i)
          : direction(query.p_.vertices_[query.p_.next_[i]] - query.p_.vertices_[i]),
            from_start(query.center_ - query.p_.vertices_[i]),
            along(from_start * direction),
            length_squared(direction * direction) {}
      Vector direction, from_start;
      Number along, length_squared;
      [[nodiscard]] Unsure between() const { return Unsure(along > Number(0)) & Unsure(along < length_squared); }
      [[nodiscard]] Number line_distance() const {
        return CGAL::cross_product(from_start, direction).squared_length() / length_squared;
      }
    };

    static std::optional<bool> known(Unsure answer) {
      if (CGAL::certainly(answer)) return true;
      if (CGAL::possibly(answer)) return std::nullopt;
      return false;
    }

    [[nodiscard]] Number plane_distance() const { return CGAL::square(height_) / p_.normal_squared_; }
    [[nodiscard]] Number vertex_distance(std::size_t i) const { return (center_ - p_.vertices_[i]).squared_length(); }
    /// Returns whether the point lies within the closed or the open ball.
    [[nodiscard]] Unsure within(const Number& distance_squared, bool closed) const {
      return closed ? Unsure(distance_squared <= radius_squared_) : Unsure(distance_squared < radius_squared_);
    }

    [[nodiscard]] Unsure touches_edge(std::size_t i, bool closed) const {
      const Unsure ends = within(vertex_distance(i), closed) | within(vertex_distance(p_.next_[i]), closed);
      if (CGAL::certainly(ends)) return true;
      const Edge edge(*this, i);
      return ends | (edge.between() & within(edge.line_distance(), closed));
    }

    [[nodiscard]] Unsure touches(bool closed) const {
      const Unsure plane = within(plane_distance(), closed);
      if (!CGAL::possibly(plane)) return false;
      const auto place = foot();
      const Unsure face = place ? Unsure(*place != PointLocation::Outside) : Unsure::indeterminate();
      Unsure any = plane & face;
      for (std::size_t i = 0; i < p_.vertices_.size() && !CGAL::certainly(any); ++i)
        any = any | touches_edge(i, closed);
      return any;
    }

    /// Returns the nearest candidate; certain if no other candidate may be nearer.
    [[nodiscard]] std::optional<Candidate> nearest_on_boundary() const {
      std::vector<Candidate> candidates;  // in the order of the contract: edges first
      for (std::size_t i = 0; i < p_.vertices_.size(); ++i)
        if (const Edge edge(*this, i); CGAL::possibly(edge.between()))
          candidates.push_back({{Feature::Kind::Edge, i}, edge.line_distance()});
      for (std::size_t i = 0; i < p_.vertices_.size(); ++i)
        candidates.push_back({{Feature::Kind::Vertex, i}, vertex_distance(i)});
      std::size_t best = 0;
      for (std::size_t i = 1; i < candidates.size(); ++i)
        if (CGAL::certainly(candidates[i].distance_squared < candidates[best].distance_squared)) best = i;
      const auto& [feature, distance] = candidates[best];
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Unsure nearer = i < best ? Unsure(candidates[i].distance_squared <= distance)
                                       : Unsure(candidates[i].distance_squared < distance);
        if (i != best && CGAL::possibly(nearer)) return std::nullopt;
      }
      if (feature.kind == Feature::Kind::Edge && !CGAL::certainly(Edge(*this, feature.index).between()))
        return std::nullopt;
      return candidates[best];
    }

    const PlainPolygon& p_;
    Vector center_;
    Number radius_squared_, height_;
    Vector foot_;
  };

 private:
  static Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

  /// The dropped axis, if certain; otherwise nothing is known about the polygon.
  int largest_component() {
    for (int axis = 0; axis < 3; ++axis) {
      bool largest = true;
      for (int other = 0; other < 3; ++other) {
        const Number mine = CGAL::abs(normal_[axis]), its = CGAL::abs(normal_[other]);
        if (other != axis)
          largest = largest && (other < axis ? CGAL::certainly(mine > its) : CGAL::certainly(mine >= its));
      }
      if (largest && CGAL::certainly(normal_[axis] != Number(0))) return axis;
    }
    known_ = false;
    return 0;
  }

  void lift() {
    off_plane_ = Number(0);
    if (!known_) return;
    for (Vector& vertex : vertices_) {
      const Number move = -(normal_ * (vertex - point_)) / normal_[axis_];
      vertex =
          vertex + Vector(axis_ == 0 ? move : Number(0), axis_ == 1 ? move : Number(0), axis_ == 2 ? move : Number(0));
      off_plane_ = (CGAL::max)(off_plane_, Number(CGAL::abs(move)));
    }
  }

  Vector normal_, point_;
  Number normal_squared_, off_plane_;
  int axis_ = 0;
  bool known_ = true;
  std::vector<Vector> vertices_;
  std::vector<std::size_t> next_;
};

/// PlainPolygon as a method.
template <class Arithmetic>
class PreparedPlain final : public PreparedMethod {
 public:
  explicit PreparedPlain(const Polygon& polygon) : polygon_(prepare(polygon)) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    [[maybe_unused]] const typename Arithmetic::Guard guard;
    PartialAnswer answer;
    answer.stage = Arithmetic::kStage;
    if (!polygon_.known()) {
      answer.unsure = true;
      return answer;
    }
    const typename PlainPolygon<Arithmetic>::Query query(ball, polygon_);
    const auto give = [&answer](auto& key, auto value) {
      if (!value) answer.unsure = true;
      key = std::move(value);
    };
    const bool all = kind == QueryKind::Answer;
    if (all || kind == QueryKind::Contact) give(answer.contact, query.contact());
    if (all || kind == QueryKind::Relation) give(answer.relation, query.relation());
    if (all || kind == QueryKind::PlaneSide) give(answer.plane, query.plane_side());
    if (all || kind == QueryKind::Foot) give(answer.foot, query.foot());
    if (all || kind == QueryKind::EdgesHit) give(answer.edges_hit, query.edges_hit());
    if (!all) return answer;

    give(answer.plane_tangent, query.plane_tangent());
    give(answer.off_plane, Arithmetic::nearest_double(polygon_.off_plane()));
    if (const auto nearest = query.nearest()) {
      answer.nearest = nearest->feature;
      give(answer.distance, Arithmetic::nearest_root(nearest->distance_squared));
      const auto point = query.closest_point(nearest->feature);
      const auto x = Arithmetic::nearest_double(point.x()), y = Arithmetic::nearest_double(point.y()),
                 z = Arithmetic::nearest_double(point.z());
      give(answer.point, x && y && z ? std::optional(Eigen::Vector3d(*x, *y, *z)) : std::nullopt);
    } else {
      answer.unsure = true;
    }
    return answer;
  }

 private:
  static PlainPolygon<Arithmetic> prepare(const Polygon& polygon) {
    [[maybe_unused]] const typename Arithmetic::Guard guard;
    return PlainPolygon<Arithmetic>(polygon);
  }

  PlainPolygon<Arithmetic> polygon_;
};

struct Intervals {
  using Number = CGAL::Interval_nt_advanced;  // rounds upwards only within a Guard
  using Guard = Number::Protector;
  static constexpr std::string_view kStage = "interval";

  static std::optional<double> nearest_double(const Number& x) {
    return x.is_point() ? std::optional(x.inf()) : std::nullopt;
  }
  static std::optional<double> nearest_root(const Number& x) { return nearest_double(CGAL::sqrt(x)); }
};

struct Rationals {
  using Number = CGAL::Gmpq;
  struct Guard {};
  static constexpr std::string_view kStage = "rational";

  static std::optional<double> nearest_double(const Number& x) {
    return exact::detail::nearest_double(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
  static std::optional<double> nearest_root(const Number& x) {
    return exact::detail::nearest_root(mpz_class(x.numerator().mpz()), mpz_class(x.denominator().mpz()));
  }
};

}  // namespace

void add_plain(MethodList& list) {
  list.push_back(std::make_unique<Method>(
      "interval", "the contract's formulas over intervals of doubles: sure, or don't know",
      [](const Polygon& polygon) { return std::make_unique<PreparedPlain<Intervals>>(polygon); }));
  list.push_back(std::make_unique<Method>(
      "rational", "the contract's formulas over GMP's rationals: exact by construction",
      [](const Polygon& polygon) { return std::make_unique<PreparedPlain<Rationals>>(polygon); }, Method::Kind::Slow));
}

}  // namespace touchstone::methods
