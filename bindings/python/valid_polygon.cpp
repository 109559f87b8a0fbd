// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/valid_polygon.h"

#include <algorithm>
#include <string>

#include "robust/exact/validate.h"

namespace touchstone::python {
namespace {

Loop loop_of(const Doubles& rows, std::size_t number) {
  if (rows.size() == 0) return {};  // has no shape that could be wrong
  if (rows.ndim() != 2 || rows.shape(1) != 3)
    throw Rejected({RejectionCode::MalformedCase, loop_name(number) + " must be an array of n x 3 numbers"});
  const auto points = rows.unchecked<2>();
  Loop loop;
  loop.reserve(static_cast<std::size_t>(points.shape(0)));
  for (pybind11::ssize_t i = 0; i < points.shape(0); ++i) loop.emplace_back(points(i, 0), points(i, 1), points(i, 2));
  return loop;
}

std::vector<Loop> loops_of(pybind11::handle outer, const std::vector<pybind11::object>& holes) {
  std::vector<Loop> loops{loop_of(doubles_of(outer), 0)};
  for (const auto& hole : holes) loops.push_back(loop_of(doubles_of(hole), loops.size()));
  return loops;
}

/// Returns the loops without the last points, which repeat the first ones.
std::vector<Loop> opened(std::vector<Loop> loops) {
  for (std::size_t number = 0; number < loops.size(); ++number) {
    Loop& loop = loops[number];
    if (loop.size() < 2)
      throw Rejected({RejectionCode::MalformedCase,
                      loop_name(number) + " is not closed: it has " + (loop.empty() ? "no" : "only one") + " point"});
    // A point that is not finite is refused by its own name.
    if (loop.front().allFinite() && loop.back().allFinite() && loop.front() != loop.back())
      throw Rejected(
          {RejectionCode::MalformedCase, loop_name(number) + " is not closed: its last point is not its first"});
    loop.pop_back();
  }
  return loops;
}

Polygon polygon_of(const std::vector<Loop>& loops) { return Polygon(loops.front(), {loops.begin() + 1, loops.end()}); }

}  // namespace

Polygon validated(Polygon polygon) {
  if (const auto fault = exact::validate(polygon)) throw Rejected(*fault);
  return polygon;
}

ValidPolygon::ValidPolygon(pybind11::handle outer, const std::vector<pybind11::object>& holes, bool closed)
    : polygon_(validated(polygon_of(closed ? opened(loops_of(outer, holes)) : loops_of(outer, holes)))) {}

ValidPolygon::ValidPolygon(const std::vector<Loop>& closed_loops)
    : polygon_(validated(polygon_of(opened(closed_loops)))) {}

Doubles ValidPolygon::loop(std::size_t number) const {
  const std::size_t begin = polygon_.loop_begin(number), count = polygon_.loop_end(number) - begin;
  Doubles rows({static_cast<pybind11::ssize_t>(count), pybind11::ssize_t{3}});
  auto points = rows.mutable_unchecked<2>();
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = polygon_.coordinates(axis).subspan(begin, count);
    for (std::size_t i = 0; i < count; ++i) points(static_cast<pybind11::ssize_t>(i), axis) = from[i];
  }
  return rows;
}

}  // namespace touchstone::python
