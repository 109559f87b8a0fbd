// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "experiments/studies/bench_scenes/broad_phases/broad_phase.h"

namespace touchstone::bench_scenes {
namespace {

/// A binary tree of bounding volumes, halved at the median along the longest side. A volume has a constructor of
/// triangles and their numbers, a type `Query` that is built of a ball, and a member `meets(query)`, which is true if
/// the ball touches one of these triangles.
template <class Volume>
class VolumeTree {
 public:
  explicit VolumeTree(std::span<const Triangle> triangles) : numbers_(triangles.size()) {
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    if (!triangles.empty()) build(triangles, 0, static_cast<std::uint32_t>(triangles.size()));
  }

  template <class Test>
  void find(const Ball& ball, const Test& test) const {
    if (!nodes_.empty()) find(typename Volume::Query(ball), test, 0);
  }

 private:
  static constexpr std::uint32_t kMostInLeaf = 2;
  struct Node {
    Volume volume;
    std::uint32_t begin, end, right;  // the left child is the next node; right is 0 for a leaf
  };

  std::uint32_t build(std::span<const Triangle> triangles, std::uint32_t begin, std::uint32_t end) {
    const std::span<std::uint32_t> own(numbers_.data() + begin, end - begin);
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({Volume(triangles, own), begin, end, 0});
    if (end - begin <= kMostInLeaf) return number;
    Box centers;
    const auto middle_of = [&](std::uint32_t i) -> Eigen::Vector3d {
      const Box its = box(triangles[i]);
      return its.low / 2 + its.high / 2;
    };
    for (const std::uint32_t i : own) centers = centers.joined({middle_of(i), middle_of(i)});
    Eigen::Index axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    const std::uint32_t half = (end - begin) / 2;
    std::ranges::nth_element(own, own.begin() + half, {}, [&](std::uint32_t i) { return middle_of(i)[axis]; });
    build(triangles, begin, begin + half);
    nodes_[number].right = build(triangles, begin + half, end);
    return number;
  }

  template <class Test>
  bool find(const typename Volume::Query& query, const Test& test, std::uint32_t number) const {
    const Node& node = nodes_[number];
    if (!node.volume.meets(query)) return false;
    if (node.right != 0) return find(query, test, number + 1) || find(query, test, node.right);
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (test(numbers_[i])) return true;
    return false;
  }

  std::vector<std::uint32_t> numbers_;
  std::vector<Node> nodes_;
};

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

constexpr double kGenerous = 1 + 1e-14;  // with kOff: more than the roundings of a distance, relative to coordinates

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

Library kdop_tree_library() { return broad_phase<VolumeTree<Dop>>("18-DOP tree"); }
Library sphere_tree_library() { return broad_phase<VolumeTree<BoundingSphere>>("Sphere tree"); }

}  // namespace touchstone::bench_scenes
