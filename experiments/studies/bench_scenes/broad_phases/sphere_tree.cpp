// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/broad_phases/volume_tree.h"

namespace touchstone::bench_scenes {
namespace {

constexpr double kGenerous = 1 + 1e-14, kOff = 1e-15;  // more than the roundings of a distance, relative to coordinates

/// A ball around triangles. Source: [hubbard1996], with the middle of their box as its centre.
class BoundingSphere {
 public:
  struct Query {
    explicit Query(const Ball& asked) : ball(asked), size(asked.center.cwiseAbs().sum()) {}
    Ball ball;
    double size;
  };

  BoundingSphere(std::span<const Triangle> triangles, std::span<const std::uint32_t> numbers) {
    Box whole;
    for (const std::uint32_t i : numbers) whole = whole.joined(box(triangles[i]));
    center_ = whole.low / 2 + whole.high / 2;
    for (const std::uint32_t i : numbers)
      for (const Eigen::Vector3d& vertex : {triangles[i].a, triangles[i].b, triangles[i].c})
        radius_ = std::max(radius_, (vertex - center_).norm());
    radius_ = radius_ * kGenerous + kOff * center_.cwiseAbs().sum();
  }
  [[nodiscard]] bool meets(const Query& query) const {
    const double reach = (query.ball.radius + radius_) * kGenerous + kOff * (query.size + center_.cwiseAbs().sum());
    return (query.ball.center - center_).squaredNorm() <= reach * reach * kGenerous;
  }

 private:
  Eigen::Vector3d center_;
  double radius_ = 0;
};

}  // namespace

Library sphere_tree_library() { return broad_phase<VolumeTree<BoundingSphere>>("Sphere tree"); }

}  // namespace touchstone::bench_scenes
