// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

#include "experiments/methods/engines/engines.h"

namespace touchstone::methods {
namespace {

namespace bg = boost::geometry;
using Point2 = bg::model::d2::point_xy<double>;
using Polygon2 = bg::model::polygon<Point2>;

/// The test of the foot in the plane. Boost.Geometry locates the foot; plain doubles compute it.
class PreparedBoostGeometry : public PreparedMethod {
 public:
  explicit PreparedBoostGeometry(const Polygon& polygon) {
    normal_ = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
      normal_ += (polygon.vertex(i) - polygon.vertex(0)).cross(polygon.vertex(polygon.next(i)) - polygon.vertex(0));
    point_ = polygon.vertex(0);
    Eigen::Index dropped = 0;
    normal_.cwiseAbs().maxCoeff(&dropped);
    u_ = (dropped + 1) % 3;
    v_ = (dropped + 2) % 3;
    flat_.inners().resize(polygon.loop_count() - 1);
    for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
      auto& ring = loop == 0 ? flat_.outer() : flat_.inners()[loop - 1];
      for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
        ring.push_back(flat(polygon.vertex(i)));
    }
    bg::correct(flat_);
  }

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind) const override {
    const double height = normal_.dot(ball.center - point_) / normal_.squaredNorm();
    const Point2 foot = flat(ball.center - height * normal_);
    PartialAnswer answer;
    answer.stage = "boost-geometry";
    answer.foot = bg::within(foot, flat_)       ? PointLocation::Inside
                  : bg::covered_by(foot, flat_) ? PointLocation::Boundary
                                                : PointLocation::Outside;
    return answer;
  }

 private:
  [[nodiscard]] Point2 flat(const Eigen::Vector3d& v) const { return {v[u_], v[v_]}; }

  Eigen::Vector3d normal_, point_;
  Eigen::Index u_, v_;
  Polygon2 flat_;
};

}  // namespace

void add_boost_geometry(MethodList& list) {
  list.push_back(std::make_unique<Method>(
      "boost-geometry", "Boost.Geometry's point in polygon, about a foot of plain doubles: the second test alone",
      [](const Polygon& polygon) { return std::make_unique<PreparedBoostGeometry>(polygon); }));
}

}  // namespace touchstone::methods
