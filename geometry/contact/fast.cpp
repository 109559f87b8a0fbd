// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <array>

#include "geometry/contact/detail/fast_motion_definitions.h"
#include "geometry/contact/fast_triangle.h"

namespace touchstone::fast {
namespace {

/// A triangle with the members of a prepared polygon that passages need.
class TriangleFace {
 public:
  using Edge = PreparedPolygon<double>::Edge;

  explicit TriangleFace(const Triangle& triangle)
      : edges_{edge(required(triangle).a, triangle.b), edge(triangle.b, triangle.c), edge(triangle.c, triangle.a)},
        plane_{edges_[0].direction.cross(edges_[1].direction), triangle.a},
        normal_squared_(plane_.normal.squaredNorm()) {}

  [[nodiscard]] const Plane<double>& plane() const { return plane_; }
  [[nodiscard]] double normal_squared() const { return normal_squared_; }
  [[nodiscard]] int dropped_axis() const { return touchstone::dropped_axis(plane_.normal); }
  [[nodiscard]] const std::array<Edge, 3>& edges() const { return edges_; }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i == 2 ? 0 : i + 1; }

 private:
  static Edge edge(const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
    const Eigen::Vector3d direction = end - start;
    return {start, direction, direction.squaredNorm()};
  }

  std::array<Edge, 3> edges_;
  Plane<double> plane_;
  double normal_squared_;
};

using TrianglePassage = detail::Passage<double, TriangleFace>;

}  // namespace

TOUCHSTONE_FAST_OVER(float, )
TOUCHSTONE_FAST_OVER(double, )
TOUCHSTONE_FAST_OVER(long double, )

bool contact(const Ball& ball, const Polygon& polygon) { return contact(ball, PreparedPolygon<>(polygon)); }
Relation relation(const Ball& ball, const Polygon& polygon) { return relation(ball, PreparedPolygon<>(polygon)); }
PlaneSide plane_side(const Ball& ball, const Polygon& polygon) { return plane_side(ball, PreparedPolygon<>(polygon)); }
PointLocation foot(const Ball& ball, const Polygon& polygon) { return foot(ball, PreparedPolygon<>(polygon)); }
std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon) {
  return edges_hit(ball, PreparedPolygon<>(polygon));
}
Answer answer(const Ball& ball, const Polygon& polygon) { return answer(ball, PreparedPolygon<>(polygon)); }

bool contact(const Motion& motion, const Polygon& polygon) { return contact(motion, PreparedPolygon<>(polygon)); }
FirstContact first_contact(const Motion& motion, const Polygon& polygon) {
  return first_contact(motion, PreparedPolygon<>(polygon));
}

bool contact(const Motion& motion, const Triangle& triangle) {
  const TriangleFace face(triangle);
  const TrianglePassage passage(motion, face);
  return contact(motion.ball, triangle) || (!passage.misses_plane() && passage.touches_on_way());
}

FirstContact first_contact(const Motion& motion, const Triangle& triangle) {
  const TriangleFace face(triangle);
  const TrianglePassage passage(motion, face);
  if (contact(motion.ball, triangle)) return passage.start();
  return passage.misses_plane() ? FirstContact{} : passage.way();
}

}  // namespace touchstone::fast
