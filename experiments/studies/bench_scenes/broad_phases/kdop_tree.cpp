// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <numbers>

#include "experiments/studies/bench_scenes/broad_phases/volume_tree.h"

namespace touchstone::bench_scenes {
namespace {

constexpr double kOff = 1e-15;  // of the sum of coordinates: more than a projection is rounded

/// The coordinates, and their sums and differences in pairs.
std::array<double, 9> projections(const Eigen::Vector3d& p) {
  return {p.x(),         p.y(),         p.z(),         p.x() + p.y(), p.x() - p.y(),
          p.x() + p.z(), p.x() - p.z(), p.y() + p.z(), p.y() - p.z()};
}

/// A polytope of 18 faces with fixed normals. Source: [klosowski1998].
class Dop {
 public:
  struct Query {
    explicit Query(const Ball& ball) {
      const auto center = projections(ball.center);
      const double off = kOff * (ball.center.cwiseAbs().sum() + 2 * ball.radius);
      for (std::size_t i = 0; i < 9; ++i) {
        const double reach = (i < 3 ? 1 : std::numbers::sqrt2) * ball.radius + off;
        low[i] = center[i] - reach, high[i] = center[i] + reach;
      }
    }
    std::array<double, 9> low, high;
  };

  Dop(std::span<const Triangle> triangles, std::span<const std::uint32_t> numbers) {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
    double size = 0;
    for (const std::uint32_t number : numbers)
      for (const Eigen::Vector3d& vertex : {triangles[number].a, triangles[number].b, triangles[number].c}) {
        size = std::max(size, vertex.cwiseAbs().sum());
        const auto here = projections(vertex);
        for (std::size_t i = 0; i < 9; ++i)
          low_[i] = std::min(low_[i], here[i]), high_[i] = std::max(high_[i], here[i]);
      }
    for (std::size_t i = 0; i < 9; ++i) low_[i] -= kOff * size, high_[i] += kOff * size;
  }
  [[nodiscard]] bool meets(const Query& query) const {
    for (std::size_t i = 0; i < 9; ++i)
      if (low_[i] > query.high[i] || query.low[i] > high_[i]) return false;
    return true;
  }

 private:
  std::array<double, 9> low_, high_;
};

}  // namespace

Library kdop_tree_library() { return broad_phase<VolumeTree<Dop>>("18-DOP tree"); }

}  // namespace touchstone::bench_scenes
