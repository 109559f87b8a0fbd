// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <utility>

#include "experiments/methods/ericson.h"
#include "experiments/studies/bench_scenes/library.h"
#include "geometry/bvh/box.h"
#include "geometry/contact/fast_triangle.h"

namespace touchstone::bench_scenes {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;
using Entry = std::pair<BoostBox, std::uint32_t>;
using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

BoostPoint boost_point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

BoostBox boost_box_around(const Ball& ball) {
  const Eigen::Vector3d radius = Eigen::Vector3d::Constant(ball.radius);
  return {boost_point(ball.center - radius), boost_point(ball.center + radius)};
}

std::vector<Entry> entries(std::span<const Triangle> triangles) {
  std::vector<Entry> entries;
  entries.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Box box = touchstone::box(t);
    entries.emplace_back(BoostBox(boost_point(box.low), boost_point(box.high)),
                         static_cast<std::uint32_t>(entries.size()));
  }
  return entries;
}

/// Boxes in doubles, packed at once.
class RTreeScene : public BuiltScene {
 public:
  explicit RTreeScene(std::span<const Triangle> triangles) : triangles_(triangles), tree_(entries(triangles)) {}

  [[nodiscard]] bool any(const Ball& ball) const override {
    const auto touches = [&](const Entry& entry) { return fast::contact(ball, triangles_[entry.second]); };
    return tree_.qbegin(bg::index::intersects(boost_box_around(ball)) && bg::index::satisfies(touches)) != tree_.qend();
  }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    const auto meet = [&](const Entry& entry) {
      if (fast::contact(ball, triangles_[entry.second])) triangles.push_back(entry.second);
    };
    tree_.query(bg::index::intersects(boost_box_around(ball)), boost::make_function_output_iterator(meet));
  }

  /// The triangle of the nearest box says how far others may be.
  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& center) const override {
    const auto squared = [&](std::uint32_t triangle) {
      return methods::ericson_squared_distance(center, triangles_[triangle]);
    };
    std::uint32_t nearest = tree_.qbegin(bg::index::nearest(boost_point(center), 1))->second;
    double least = squared(nearest);
    const auto meet = [&](const Entry& entry) {
      const double distance = squared(entry.second);
      if (distance >= least) return;
      least = distance;
      nearest = entry.second;
    };
    tree_.query(bg::index::intersects(boost_box_around({center, std::sqrt(least)})),
                boost::make_function_output_iterator(meet));
    return nearest;
  }

 private:
  std::span<const Triangle> triangles_;
  Tree tree_;
};

}  // namespace

Library boost_rtree_library() {
  return {"Boost R-tree", [](const Mesh& mesh) { return std::make_unique<RTreeScene>(mesh.triangles); }};
}

}  // namespace touchstone::bench_scenes
