// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/polygon.h"

#include <algorithm>
#include <optional>

#include "geometry/detail/floating_point_state.h"
#include "geometry/same_number.h"

namespace touchstone {
namespace {

std::string vertex_name(std::size_t loop, std::size_t vertex) {
  return loop_name(loop) + ": vertex " + std::to_string(vertex);
}

/// Calls f(loop number, number of the loop's first vertex, loop), the outer loop first.
template <class F>
std::optional<Rejection> first_fault(const Loop& outer, const std::vector<Loop>& holes, F f) {
  std::size_t begin = 0;
  for (std::size_t number = 0; number <= holes.size(); ++number) {
    const Loop& loop = number == 0 ? outer : holes[number - 1];
    if (auto fault = f(number, begin, loop)) return fault;
    begin += loop.size();
  }
  return std::nullopt;
}

std::optional<Rejection> not_finite(std::size_t number, std::size_t begin, const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (!loop[i].allFinite())
      return Rejection{RejectionCode::NotFinite, vertex_name(number, begin + i) + " is not finite"};
  return std::nullopt;
}

std::optional<Rejection> too_few(std::size_t number, std::size_t, const Loop& loop) {
  if (loop.size() >= 3) return std::nullopt;
  return Rejection{RejectionCode::TooFewVertices,
                   loop_name(number) + " has " + std::to_string(loop.size()) + " vertices; a loop needs at least 3"};
}

std::optional<Rejection> repeated(std::size_t number, std::size_t begin, const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    if (same_point(loop[i], loop[next]))
      return Rejection{
          RejectionCode::RepeatedVertex,
          vertex_name(number, begin + i) + " equals its neighbour, vertex " + std::to_string(begin + next)};
  }
  return std::nullopt;
}

}  // namespace

std::string loop_name(std::size_t loop) { return loop == 0 ? "the outer loop" : "hole " + std::to_string(loop - 1); }

Polygon::Polygon(const Loop& outer, const std::vector<Loop>& holes) {
  const FloatingPointState nearest;
  for (const auto& fault :
       {first_fault(outer, holes, not_finite), first_fault(outer, holes, too_few), first_fault(outer, holes, repeated)})
    if (fault) throw Rejected(*fault);

  std::size_t vertex_count = outer.size();
  for (const Loop& hole : holes) vertex_count += hole.size();
  for (auto& axis : coordinates_) axis.reserve(vertex_count);
  next_.reserve(vertex_count);
  previous_.reserve(vertex_count);
  loop_ends_.reserve(holes.size() + 1);

  const auto append = [this](const Loop& loop) {
    const std::size_t begin = this->vertex_count();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) coordinates_[static_cast<std::size_t>(axis)].push_back(loop[i][axis]);
      next_.push_back(begin + (i + 1) % loop.size());
      previous_.push_back(begin + (i + loop.size() - 1) % loop.size());
    }
    loop_ends_.push_back(begin + loop.size());
  };
  append(outer);
  for (const Loop& hole : holes) append(hole);
}

bool Polygon::operator==(const Polygon& other) const {
  if (loop_ends_ != other.loop_ends_) return false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!std::ranges::equal(coordinates_[axis], other.coordinates_[axis], same_number)) return false;
  return true;
}

std::size_t Polygon::loop_of(std::size_t i) const {
  return static_cast<std::size_t>(std::upper_bound(loop_ends_.begin(), loop_ends_.end(), i) - loop_ends_.begin());
}

}  // namespace touchstone
