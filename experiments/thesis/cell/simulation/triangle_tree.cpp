// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/triangle_tree.h"

#include <algorithm>
#include <utility>

namespace touchstone::cell {
namespace {

constexpr std::uint32_t kMostInLeaf = 4;

}  // namespace

TriangleTree::TriangleTree(std::vector<NamedTriangle> triangles) : triangles_(std::move(triangles)) {
  if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  touchstone::Box whole;
  for (std::uint32_t i = begin; i < end; ++i) whole = whole.joined(box(triangles_[i].triangle));
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({whole, begin, end, {0, 0}});
  if (end - begin <= kMostInLeaf) return number;
  Eigen::Index longest = 0;
  (whole.high - whole.low).maxCoeff(&longest);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const NamedTriangle& a, const NamedTriangle& b) {
    return a.triangle.a[longest] + a.triangle.b[longest] + a.triangle.c[longest] <
           b.triangle.a[longest] + b.triangle.b[longest] + b.triangle.c[longest];
  });
  const std::uint32_t low = build(begin, middle), high = build(middle, end);
  nodes_[number].children[0] = low;
  nodes_[number].children[1] = high;
  return number;
}

}  // namespace touchstone::cell
