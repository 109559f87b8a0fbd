// SPDX-License-Identifier: GPL-3.0-or-later
#define CGAL_NO_DEPRECATION_WARNINGS  // CGAL 6 says AABB_traits_3, but keeps AABB_traits, the name in CGAL 5
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/iterator/function_output_iterator.hpp>

#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A triangle of ours where it lies; CGAL's is made when it is asked about.
class Primitive {
 public:
  using Id = const Triangle*;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;

  Primitive() = default;
  explicit Primitive(const Triangle* triangle) : triangle_(triangle) {}

  [[nodiscard]] Id id() const { return triangle_; }
  [[nodiscard]] Datum datum() const { return {point(triangle_->a), point(triangle_->b), point(triangle_->c)}; }
  [[nodiscard]] Point reference_point() const { return point(triangle_->a); }

 private:
  const Triangle* triangle_ = nullptr;
};

using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// CGAL means the surface of a ball, whose squared radius it rounds: balls that triangles lie wholly inside of are
/// missed. So do CGAL 5.5 and 6.0; 6.2 changes what a sphere means beside boxes, among which the tree searches.
class AabbTreeScene : public BuiltScene {
 public:
  explicit AabbTreeScene(std::span<const Triangle> triangles) : first_(triangles.data()) {
    tree_.insert(triangles.data(), triangles.data() + triangles.size());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  [[nodiscard]] bool any(const Ball& ball) const override { return tree_.do_intersect(sphere(ball)); }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    const auto meet = [&](const Triangle* triangle) { triangles.push_back(number(triangle)); };
    tree_.all_intersected_primitives(sphere(ball), boost::make_function_output_iterator(meet));
  }

  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& center) const override {
    return number(tree_.closest_point_and_primitive(point(center)).second);
  }

 private:
  static Kernel::Sphere_3 sphere(const Ball& ball) { return {point(ball.center), ball.radius * ball.radius}; }
  [[nodiscard]] std::uint32_t number(const Triangle* triangle) const {
    return static_cast<std::uint32_t>(triangle - first_);
  }

  const Triangle* first_;
  AabbTree tree_;
};

}  // namespace

std::vector<bool> inside_by_cgal(std::span<const Triangle> triangles, std::span<const Eigen::Vector3d> points) {
  AabbTree tree;
  tree.insert(triangles.data(), triangles.data() + triangles.size());
  tree.build();
  std::vector<bool> inside;
  for (const Eigen::Vector3d& p : points) {
    const Kernel::Ray_3 ray(point(p), Kernel::Vector_3(0.3125, 0.59, 0.75));
    inside.push_back(tree.number_of_intersected_primitives(ray) % 2 == 1);
  }
  return inside;
}

Library cgal_aabb_tree_library() {
  return {"CGAL AABB_tree", [](const Mesh& mesh) { return std::make_unique<AabbTreeScene>(mesh.triangles); }};
}

}  // namespace touchstone::bench_scenes
