// SPDX-License-Identifier: GPL-3.0-or-later
// All of CGAL's kernels in one file, because each file that includes them takes 6 s longer to compile.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

/// The queries as a user of a CGAL kernel writes them: with the planes, segments, distances and predicates of the
/// kernel.
///
/// If the kernel constructs exactly, loops are lifted onto their plane as the contract requires. Otherwise they are
/// used as given (lifting would move the vertices of planar loops by rounding errors), and the plane passes through the
/// first vertex. `Numbers` provides nearest_double(x) and nearest_root(x), for the point and the distance. Source:
/// [cgal2022].
template <class Kernel, class Numbers>
class KernelPolygon {
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Segment = typename Kernel::Segment_3;
  static constexpr bool kConstructsExactly = !std::is_floating_point_v<FT>;

 public:
  explicit KernelPolygon(const Polygon& polygon) {
    std::vector<Point> vertices;
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i) vertices.push_back(point(polygon.vertex(i)));
    Vector normal = CGAL::NULL_VECTOR, sum = CGAL::NULL_VECTOR;
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i) {
      normal = normal + CGAL::cross_product(vertices[i] - vertices[0], vertices[polygon.next(i)] - vertices[0]);
      sum = sum + (vertices[i] - vertices[0]);
    }
    for (const int k : {1, 2})
      if (CGAL::abs(normal[k]) > CGAL::abs(normal[axis_])) axis_ = k;
    if constexpr (kConstructsExactly) {
      plane_ = typename Kernel::Plane_3(vertices[0] + sum / FT(static_cast<int>(polygon.loop_end(0))), normal);
      off_plane_ = lift(vertices, normal);
    } else {
      plane_ = typename Kernel::Plane_3(vertices[0], normal);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) edges_.emplace_back(vertices[i], vertices[polygon.next(i)]);
    for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
      loops_.emplace_back();
      for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
        loops_.back().push_back(dropped(vertices[i]));
    }
  }

  [[nodiscard]] PlaneSide plane_side(const Ball& ball) const {
    if (against_radius(ball, plane_) != CGAL::LARGER) return PlaneSide::Intersects;
    return plane_.has_on_positive_side(point(ball.center)) ? PlaneSide::InFront : PlaneSide::Behind;
  }
  [[nodiscard]] bool plane_tangent(const Ball& ball) const { return against_radius(ball, plane_) == CGAL::EQUAL; }

  [[nodiscard]] PointLocation foot(const Ball& ball) const {
    const auto foot = dropped(plane_.projection(point(ball.center)));
    bool inside = false;
    for (const auto& loop : loops_) {
      switch (CGAL::bounded_side_2(loop.begin(), loop.end(), foot, Kernel())) {
        case CGAL::ON_BOUNDARY: return PointLocation::Boundary;
        case CGAL::ON_BOUNDED_SIDE: inside = !inside; break;
        case CGAL::ON_UNBOUNDED_SIDE: break;
      }
    }
    return inside ? PointLocation::Inside : PointLocation::Outside;
  }

  [[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball) const {
    std::vector<std::size_t> hit;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (against_radius(ball, edges_[i]) != CGAL::LARGER) hit.push_back(i);
    return hit;
  }

  /// Returns whether the kernel can handle the ball. The exact predicates of EPICK end the program for a number that is
  /// not finite; planes, feet and squares of large doubles may be infinite.
  [[nodiscard]] bool can_be_asked(const Ball& ball) const {
    if constexpr (Kernel::Has_filtered_predicates && !kConstructsExactly) {
      const Point foot = plane_.projection(point(ball.center));
      for (const FT& x : {plane_.a(), plane_.b(), plane_.c(), plane_.d(), foot.x(), foot.y(), foot.z(),
                          CGAL::square(FT(ball.radius))})
        if (!std::isfinite(x)) return false;
    }
    return true;
  }

  [[nodiscard]] bool contact(const Ball& ball) const {
    if (plane_side(ball) != PlaneSide::Intersects) return false;
    if (foot(ball) != PointLocation::Outside) return true;
    for (const Segment& edge : edges_)
      if (against_radius(ball, edge) != CGAL::LARGER) return true;
    return false;
  }

  [[nodiscard]] Relation relation(const Ball& ball) const {
    CGAL::Comparison_result least = CGAL::LARGER;
    if (foot(ball) == PointLocation::Inside)
      least = against_radius(ball, plane_);
    else
      for (const Segment& edge : edges_) least = (CGAL::min)(least, against_radius(ball, edge));
    if (least == CGAL::SMALLER) return Relation::Overlapping;
    return least == CGAL::EQUAL ? Relation::Touching : Relation::Separate;
  }

  [[nodiscard]] Answer answer(const Ball& ball) const {
    const PointLocation place = foot(ball);
    const auto [feature, nearest] = nearest_point(ball, place);
    return {.plane = plane_side(ball),
            .plane_tangent = plane_tangent(ball),
            .foot = place,
            .edges_hit = edges_hit(ball),
            .relation = relation(ball),
            .nearest = feature,
            .point = {Numbers::nearest_double(nearest.x()), Numbers::nearest_double(nearest.y()),
                      Numbers::nearest_double(nearest.z())},
            .distance = Numbers::nearest_root(CGAL::squared_distance(point(ball.center), nearest)),
            .off_plane = Numbers::nearest_double(off_plane_)};
  }
  /// Returns whether `off_plane` of an answer is more than a placeholder.
  [[nodiscard]] static constexpr bool knows_off_plane() { return kConstructsExactly; }

 private:
  static Point point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
  [[nodiscard]] typename Kernel::Point_2 dropped(const Point& p) const {
    return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]};
  }

  /// Compares the distance to a plane or a segment with the radius. Inexact kernels use the rounded square of r.
  template <class Object>
  static CGAL::Comparison_result against_radius(const Ball& ball, const Object& object) {
    return Kernel().compare_squared_distance_3_object()(point(ball.center), object, CGAL::square(FT(ball.radius)));
  }

  /// Lifts the vertices onto the plane. Returns the largest move.
  [[nodiscard]] FT lift(std::vector<Point>& vertices, const Vector& normal) const {
    FT farthest(0);
    for (Point& vertex : vertices) {
      if (plane_.has_on(vertex)) continue;
      const FT move = -(normal * (vertex - plane_.point())) / normal[axis_];
      vertex = vertex + Vector(axis_ == 0 ? move : FT(0), axis_ == 1 ? move : FT(0), axis_ == 2 ? move : FT(0));
      farthest = (CGAL::max)(farthest, FT(CGAL::abs(move)));
    }
    return farthest;
  }

  [[nodiscard]] std::pair<Feature, Point> nearest_point(const Ball& ball, PointLocation place) const {
    const Point center = point(ball.center);
    if (place == PointLocation::Inside) return {{Feature::Kind::Face, 0}, plane_.projection(center)};
    Feature nearest{Feature::Kind::Vertex, 0};
    std::optional<FT> least;
    const auto consider = [&](Feature::Kind kind, std::size_t i, const FT& distance) {
      if (least && distance >= *least) return;
      least = distance;
      nearest = {kind, i};
    };
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Point &a = edges_[i].source(), &b = edges_[i].target();
      if (CGAL::is_positive((center - a) * (b - a)) && CGAL::is_positive((center - b) * (a - b)))
        consider(Feature::Kind::Edge, i, CGAL::squared_distance(center, edges_[i]));
    }
    for (std::size_t i = 0; i < edges_.size(); ++i)
      consider(Feature::Kind::Vertex, i, CGAL::squared_distance(center, edges_[i].source()));
    const Segment& edge = edges_[nearest.index];
    if (nearest.kind == Feature::Kind::Vertex) return {nearest, edge.source()};
    return {nearest, edge.supporting_line().projection(center)};
  }

  typename Kernel::Plane_3 plane_;
  int axis_ = 0;
  FT off_plane_ = FT(0);
  std::vector<Segment> edges_;                                // edge i starts at vertex i
  std::vector<std::vector<typename Kernel::Point_2>> loops_;  // without the dropped axis
};

/// KernelPolygon as a method.
template <class Kernel, class Numbers>
class PreparedKernel final : public PreparedMethod {
 public:
  PreparedKernel(const Polygon& polygon, std::string_view stage) : polygon_(polygon), stage_(stage) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    PartialAnswer answer;
    answer.stage = stage_;
    answer.unsure = !polygon_.can_be_asked(ball);
    if (answer.unsure) return answer;
    switch (kind) {
      case QueryKind::Contact: answer.contact = polygon_.contact(ball); break;
      case QueryKind::Relation: answer.relation = polygon_.relation(ball); break;
      case QueryKind::PlaneSide: answer.plane = polygon_.plane_side(ball); break;
      case QueryKind::Foot: answer.foot = polygon_.foot(ball); break;
      case QueryKind::EdgesHit: answer.edges_hit = polygon_.edges_hit(ball); break;
      case QueryKind::Answer:
        answer = PartialAnswer::of(polygon_.answer(ball), "");
        answer.stage = stage_;
        answer.contact_normal.reset(), answer.depth.reset();  // a kernel has no root of a quotient
        if (!polygon_.knows_off_plane()) answer.off_plane.reset();
        break;
    }
    return answer;
  }

 private:
  KernelPolygon<Kernel, Numbers> polygon_;
  std::string_view stage_;
};

template <class Kernel, class Numbers>
std::unique_ptr<Method> kernel_method(const char* name, const char* stage, const char* summary) {
  return std::make_unique<Method>(
      name, summary,
      [stage](const Polygon& polygon) { return std::make_unique<PreparedKernel<Kernel, Numbers>>(polygon, stage); },
      std::is_floating_point_v<typename Kernel::FT> ? Method::Kind::Usual : Method::Kind::Slow);
}

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

struct Doubles {
  static double nearest_double(double x) { return x; }
  static double nearest_root(double x) { return std::sqrt(x); }
};

/// CGAL::to_double guarantees only five digits of a lazy number.
struct ExactNumbers {
  static mpq_class rational(const Epeck::FT& x) { return mpq_class(x.exact().backend().data()); }
  static double nearest_double(const Epeck::FT& x) {
    const mpq_class value = rational(x);
    return exact::detail::nearest_double(value.get_num(), value.get_den());
  }
  static double nearest_root(const Epeck::FT& x) {
    const mpq_class value = rational(x);
    return exact::detail::nearest_root(value.get_num(), value.get_den());
  }
};

}  // namespace

void add_cgal_kernels(MethodList& list) {
  list.push_back(kernel_method<CGAL::Simple_cartesian<double>, Doubles>(
      "cgal-double", "double", "CGAL's kernel of plain doubles, as its users write; loops are not lifted"));
  list.push_back(kernel_method<Epick, Doubles>(
      "cgal-epick", "epick", "the same over EPICK: exact predicates of rounded planes, feet and squared radii"));
  list.push_back(kernel_method<Epeck, ExactNumbers>(
      "cgal-epeck", "epeck", "the same over EPECK: exact, and lifted; its numbers are lazy rationals"));
}

}  // namespace touchstone::methods
