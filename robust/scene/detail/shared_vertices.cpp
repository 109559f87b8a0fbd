// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/shared_vertices.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <utility>

#include "geometry/bvh/box_tree.h"
#include "geometry/detail/parts_in_parallel.h"

namespace touchstone::scene::detail {
namespace {

/// Numbers points in the order in which they first come; equal bits get equal numbers. It has room for a part's points.
class PointNumbers {
 public:
  PointNumbers() : table_(kRoom, kFree) {}

  [[nodiscard]] std::uint16_t of(const Eigen::Vector3d& point) {
    for (std::size_t at = hash(point);; at = (at + 1) % kRoom) {
      if (table_[at] == kFree) {
        table_[at] = static_cast<std::uint16_t>(points_.size());
        points_.push_back(point);
      } else if (std::memcmp(points_[table_[at]].data(), point.data(),  // NOLINT: bits are compared, not numbers
                             3 * sizeof(double)) != 0) {
        continue;
      }
      return table_[at];
    }
  }
  [[nodiscard]] std::vector<Eigen::Vector3d>&& points() && { return std::move(points_); }

 private:
  /// More than twice the points of a part, so that searches are short.
  static constexpr std::size_t kRoom = std::size_t{1} << 16;
  static constexpr std::uint16_t kFree = std::numeric_limits<std::uint16_t>::max();

  [[nodiscard]] static std::size_t hash(const Eigen::Vector3d& point) {
    std::uint64_t mixed = 0;
    for (const double coordinate : point)
      mixed = (std::rotl(mixed, 29) ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e37'79b9'7f4a'7c15U;
    return mixed >> 48;
  }

  std::vector<std::uint16_t> table_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace

TrianglesOfSharedVertices::TrianglesOfSharedVertices(std::span<const Triangle> by_number,
                                                     std::span<const std::uint32_t> order)
    : corners_(order.size()) {
  static_assert(3 * kPart < std::size_t{1} << 15, "PointNumbers has more than twice the room for a part");
  std::vector<std::vector<Eigen::Vector3d>> parts((order.size() + kPart - 1) / kPart);
  parts_in_parallel(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      PointNumbers numbers;
      for (std::size_t place = part * kPart; place < std::min((part + 1) * kPart, order.size()); ++place) {
        if (order[place] == BoxTree::kNone) continue;
        const Triangle& triangle = by_number[order[place]];
        corners_[place] = {numbers.of(triangle.a), numbers.of(triangle.b), numbers.of(triangle.c)};
      }
      parts[part] = std::move(numbers).points();
    }
  });
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  vertices_.reserve(count);
  for (const auto& part : parts) {
    first_vertex_.push_back(vertices_.size());
    vertices_.insert(vertices_.end(), part.begin(), part.end());
  }
}

std::size_t TrianglesOfSharedVertices::memory() const {
  return corners_.capacity() * sizeof(Corners) + vertices_.capacity() * sizeof(Eigen::Vector3d) +
         first_vertex_.capacity() * sizeof(std::size_t);
}

}  // namespace touchstone::scene::detail
