// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/triangle_set.h"

#include <algorithm>
#include <string>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"

namespace touchstone::filtered {

using namespace detail;

namespace {

/// Throws Rejected, naming the triangle, if it is not accepted.
void expect_valid(const Triangle& triangle, std::size_t number, Degenerate degenerate) {
  try {
    detail::expect_valid(triangle, degenerate);
  } catch (const Rejected& rejected) {
    const auto& [code, message] = rejected.rejection();
    throw Rejected({code, "triangle " + std::to_string(number) + ": " + message});
  }
}

NoCounts uncounted;

}  // namespace

TriangleSet::Parts::Parts(std::span<const Triangle> given, Degenerate degenerate)
    : triangles(given.begin(), given.end()) {
  for (std::size_t i = 0; i < given.size(); ++i) expect_valid(given[i], i, degenerate);
  for (std::size_t first = 0; first < given.size(); first += TriangleGroup::kWidth)
    groups.push_back(group_of(given.subspan(first, std::min(TriangleGroup::kWidth, given.size() - first))));
}

TriangleSet::TriangleSet(std::span<const Triangle> triangles, Degenerate degenerate) {
  const FloatingPointState nearest;
  parts_ = std::make_unique<const Parts>(triangles, degenerate);
}
TriangleSet::TriangleSet(TriangleSet&&) noexcept = default;
TriangleSet& TriangleSet::operator=(TriangleSet&&) noexcept = default;
TriangleSet::~TriangleSet() = default;

std::size_t TriangleSet::size() const { return parts_->triangles.size(); }
std::span<const Triangle> TriangleSet::triangles() const { return parts_->triangles; }

void contact(const Ball& ball, const TriangleSet& set, std::span<bool> touches) {
  expect_equal_lengths("triangles", set.size(), "answers", touches.size());
  kernels().plain.set_contact(required(ball), parts_of(set), touches, uncounted);
}
void contact(const Ball& ball, const TriangleSet& set, std::span<bool> touches, StageCounts& counts) {
  expect_equal_lengths("triangles", set.size(), "answers", touches.size());
  kernels().counted.set_contact(required(ball), parts_of(set), touches, counts);
}

bool any_contact(const Ball& ball, const TriangleSet& set) {
  return kernels().plain.set_any_contact(required(ball), parts_of(set), uncounted);
}
bool any_contact(const Ball& ball, const TriangleSet& set, StageCounts& counts) {
  return kernels().counted.set_any_contact(required(ball), parts_of(set), counts);
}

std::vector<std::size_t> triangles_hit(const Ball& ball, const TriangleSet& set) {
  return kernels().plain.set_triangles_hit(required(ball), parts_of(set), uncounted);
}
std::vector<std::size_t> triangles_hit(const Ball& ball, const TriangleSet& set, StageCounts& counts) {
  return kernels().counted.set_triangles_hit(required(ball), parts_of(set), counts);
}

}  // namespace touchstone::filtered
