// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <stdexcept>

#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSS<double>>;

/// FCL's own narrow phase throughout.
class FclScene : public BuiltScene {
 public:
  explicit FclScene(std::span<const Triangle> triangles) : count_(triangles.size()) {
    const auto count = static_cast<int>(triangles.size());
    model_.beginModel(count, 3 * count);
    for (const Triangle& t : triangles) model_.addTriangle(t.a, t.b, t.c);
    if (model_.endModel() != fcl::BVH_OK) throw std::runtime_error("FCL: no model of these triangles");
  }

  bool any(const Ball& ball) override { return collide(ball, 1, false).isCollision(); }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) override {
    triangles.clear();
    const auto result = collide(ball, count_, true);
    for (std::size_t i = 0; i < result.numContacts(); ++i)
      triangles.push_back(static_cast<std::uint32_t>(result.getContact(i).b1));
  }

  std::uint32_t nearest(const Eigen::Vector3d& center) override {
    const fcl::Sphere<double> sphere(0);
    fcl::DistanceRequest<double> request;
    fcl::DistanceResult<double> result;
    fcl::distance(&model_, Pose::Identity(), &sphere, at(center), request, result);
    return static_cast<std::uint32_t>(result.b1);
  }

  // Its default solver asks at kMostSteps places of the way. Its conservative advancement of a mesh and a sphere never
  // finds a contact (version 0.7).
  std::optional<double> first_contact(const Motion& motion) override {
    constexpr std::size_t kMostSteps = 100;
    constexpr double kTolerance = 1e-4;
    const fcl::Sphere<double> sphere(motion.ball.radius);
    const fcl::ContinuousCollisionRequest<double> request(kMostSteps, kTolerance, fcl::CCDM_TRANS, fcl::GST_INDEP,
                                                          fcl::CCDC_NAIVE);
    fcl::ContinuousCollisionResult<double> result;
    fcl::continuousCollide(&model_, Pose::Identity(), Pose::Identity(), &sphere, at(motion.ball.center), at(motion.to),
                           request, result);
    return result.is_collide ? std::optional(result.time_of_contact) : std::nullopt;
  }

 private:
  using Pose = fcl::Transform3<double>;

  static Pose at(const Eigen::Vector3d& center) {
    Pose pose = Pose::Identity();
    pose.translation() = center;
    return pose;
  }

  [[nodiscard]] fcl::CollisionResult<double> collide(const Ball& ball, std::size_t most, bool contacts) const {
    const fcl::Sphere<double> sphere(ball.radius);
    const fcl::CollisionRequest<double> request(most, contacts);
    fcl::CollisionResult<double> result;
    fcl::collide(&model_, Pose::Identity(), &sphere, at(ball.center), request, result);
    return result;
  }

  std::size_t count_;
  Model model_;
};

}  // namespace

Library fcl_library() {
  return {.name = "FCL BVHModel",
          .build = [](std::span<const Triangle> triangles) { return std::make_unique<FclScene>(triangles); },
          .knows_motions = true};
}

}  // namespace touchstone::bench_scenes
