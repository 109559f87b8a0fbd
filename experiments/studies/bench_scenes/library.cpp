// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/library.h"

#include <algorithm>
#include <limits>

#include "experiments/methods/triangle_contacts.h"
#include "experiments/program/built_with.h"
#include "geometry/bvh/box.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/scene/scene.h"

namespace touchstone::bench_scenes {

std::vector<Library> all_libraries() {
  std::vector<Library> libraries{touchstone_library(), touchstone_library_of_objects()};
#if TOUCHSTONE_HAS_EMBREE
  libraries.push_back(methods::embree_library());
#endif
  libraries.push_back(cgal_aabb_tree_library());
  for (const auto& broad_phase :
       {grid_library, octree_library, kd_tree_library, sphere_tree_library, kdop_tree_library})
    libraries.push_back(broad_phase());
#if TOUCHSTONE_HAS_FCL
  libraries.push_back(methods::fcl_library());
#endif
#if TOUCHSTONE_HAS_BULLET
  libraries.push_back(methods::bullet_library());
#endif
  return libraries;
}

std::vector<std::string> absent_libraries() {
  std::vector<std::string> absent;
#if !TOUCHSTONE_HAS_EMBREE
  absent.emplace_back("Embree 3 (libembree-dev)");
#endif
#if !TOUCHSTONE_HAS_FCL
  absent.emplace_back("FCL (libfcl-dev)");
#endif
#if !TOUCHSTONE_HAS_BULLET
  absent.emplace_back("Bullet (libbullet-dev)");
#endif
  return absent;
}

namespace {

/// Objects of up to that many triangles, in the order of the mesh.
class ExactScene : public BuiltScene {
 public:
  ExactScene(std::span<const Triangle> triangles, std::size_t of_object) : of_object_(of_object) {
    for (std::size_t first = 0; first < triangles.size(); first += of_object) {
      const auto own = triangles.subspan(first, std::min(of_object, triangles.size() - first));
      scene_.add(std::to_string(first), {.triangles = {own.begin(), own.end()}, .polygons = {}});
    }
  }

  [[nodiscard]] bool any(const Ball& ball) const override { return scene_.touches(ball); }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    for (const scene::FaceId& id : scene_.touched(ball)) triangles.push_back(number(id));
  }

  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& center) const override {
    return number(*scene_.nearest_face(center));
  }

  [[nodiscard]] std::optional<double> first_contact(const Motion& motion) const override {
    const auto first = scene_.first_contact(motion);
    return first ? std::optional(first->contact.time) : std::nullopt;
  }

  [[nodiscard]] const scene::Scene* own_scene() const override {
    return scene_.object_count() == 1 ? &scene_ : nullptr;
  }

 private:
  [[nodiscard]] std::uint32_t number(const scene::FaceId& id) const {
    return static_cast<std::uint32_t>(id.object * of_object_ + id.face);
  }

  std::size_t of_object_;
  scene::Scene scene_;
};

}  // namespace

Library touchstone_library() {
  return {.name = "Scene",
          .build = [](const Mesh& mesh) { return std::make_unique<ExactScene>(mesh.triangles, mesh.triangles.size()); },
          .exact = true,
          .knows_motions = true};
}
Library touchstone_library_of_objects() {
  static constexpr std::size_t kOfObject = 100;
  return {.name = kObjects,
          .build = [](const Mesh& mesh) { return std::make_unique<ExactScene>(mesh.triangles, kOfObject); }};
}

namespace {

Polygon polygon(const Triangle& t) { return Polygon({t.a, t.b, t.c}); }

/// The largest of the distances along the axes, rounded by 2^-53 at most: the triangle is not nearer.
double axis_distance(const Triangle& t, const Eigen::Vector3d& center) {
  const Box around = box(t);
  return std::max(0.0, (around.low - center).cwiseMax(center - around.high).maxCoeff());
}

}  // namespace

std::vector<std::uint32_t> touched_by_brute_force(std::span<const Triangle> triangles, const Ball& ball) {
  constexpr std::size_t kAskAll = 2000;
  std::vector<std::uint32_t> touched;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (triangles.size() > kAskAll && axis_distance(t, ball.center) > 1.5 * ball.radius) continue;
    if (exact::contact(ball, polygon(t))) touched.push_back(i);
  }
  return touched;
}

std::optional<double> first_contact_by_brute_force(std::span<const Triangle> triangles, const Motion& motion) {
  const Eigen::Array3d low = motion.ball.center.cwiseMin(motion.to).array() - 1.5 * motion.ball.radius,
                       high = motion.ball.center.cwiseMax(motion.to).array() + 1.5 * motion.ball.radius;
  std::optional<double> first;
  for (const Triangle& t : triangles) {
    const Box around = box(t);
    if ((around.low.array() > high).any() || (around.high.array() < low).any()) continue;
    const FirstContact contact = exact::first_contact(motion, polygon(t));
    if (contact.contact() && (!first || contact.time < *first)) first = contact.time;
  }
  return first;
}

double least_distance_by_brute_force(std::span<const Triangle> triangles, const Eigen::Vector3d& center) {
  const auto squared = [&](const Triangle& t) { return methods::ericson_squared_distance(center, t); };
  const auto near = std::ranges::min_element(triangles, {}, squared);
  double least = exact_distance(*near, center);
  const double enough = least * (1 + 0x1p-40);
  for (const Triangle& t : triangles)
    if (axis_distance(t, center) <= enough) least = std::min(least, exact_distance(t, center));
  return least;
}

double exact_distance(const Triangle& triangle, const Eigen::Vector3d& center) {
  return exact::answer({center, 0}, polygon(triangle)).distance;
}

}  // namespace touchstone::bench_scenes
