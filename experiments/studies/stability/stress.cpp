// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/stress.h"

#include <algorithm>
#include <cmath>

namespace touchstone::stability {
namespace {

/// The step of that number.
Level step(const char* number, std::uint64_t one_in = 1) { return {number, std::stod(number), one_in}; }

std::vector<Level> steps(std::initializer_list<const char*> numbers) {
  std::vector<Level> list;
  for (const char* number : numbers) list.push_back(step(number));
  return list;
}

std::vector<Level> modes(std::initializer_list<const char*> names) {
  std::vector<Level> list;
  for (const char* name : names) list.push_back({name, static_cast<double>(list.size()), 1});
  return list;
}

struct AxisRow {
  std::string_view name;
  std::vector<Level> levels;
};

/// Returns the axes in the order of their enumerators.
const std::vector<AxisRow>& axis_rows() {
  static const std::vector<Level> collinear{step("1"), step("10"), step("100", 4), step("1000", 20), step("10000", 40)};
  static const std::vector<Level> motions{step("1"),   step("1e1"),    step("1e2"),    step("1e3"),
                                          step("1e4"), step("1e5", 2), step("1e6", 10)};
  static const std::vector<AxisRow> list = [] {
    std::vector<Level> distances = steps({"1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "1e-14"});
    distances.push_back({"4 ulps", 0x1p-50, 1});
    return std::vector<AxisRow>{
        {"aspect", steps({"1", "1e2", "1e4", "1e6", "1e8", "1e10", "1e12", "1e14", "1e16"})},
        {"parallel", steps({"1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "1e-14", "1e-16"})},
        {"duplicate", distances},
        {"collinear-exact", collinear},
        {"collinear-rounded", collinear},
        {"origin", steps({"1", "1e3", "1e6", "1e9", "1e12", "1e13", "1e14", "1e15"})},
        {"small", steps({"0", "-64", "-128", "-160", "-176", "-192", "-256", "-340", "-400", "-512", "-700", "-1000",
                         "-1030", "-1064"})},
        {"large", steps({"0", "64", "128", "160", "170", "192", "256", "340", "400", "512", "700", "1000", "1023"})},
        {"mixed", steps({"0", "16", "32", "64", "128", "256", "512", "1024", "1600"})},
        {"off-plane",
         {step("1"), step("16"), step("256"), {"2^12", 0x1p12, 1}, {"2^16", 0x1p16, 1}, {"2^20", 0x1p20, 1}}},
        {"vertices", {step("10"), step("100", 2), step("1e3", 10), step("1e4", 40), step("1e5", 40), step("1e6", 80)}},
        {"chain-input", motions},
        {"chain-motion", motions},
        {"pose-input", motions},
        {"pose-motion", motions},
        {"rounding", modes({"nearest", "up", "down", "zero"})},
        {"flush", modes({"kept", "FTZ", "DAZ", "FTZ+DAZ"})}};
  }();
  return list;
}

const AxisRow& row_of(Axis axis) { return axis_rows()[static_cast<std::size_t>(axis)]; }

}  // namespace

std::string_view to_string(Axis axis) { return row_of(axis).name; }

const std::vector<Level>& levels(Axis axis) { return row_of(axis).levels; }

const std::vector<Axis>& all_axes() {
  static const std::vector<Axis> axes = [] {
    std::vector<Axis> list;
    for (std::size_t i = 0; i < axis_rows().size(); ++i) list.push_back(static_cast<Axis>(i));
    return list;
  }();
  return axes;
}

bool is_drawn(Axis axis, std::size_t level, std::uint64_t sample) {
  const std::uint64_t one_in = levels(axis)[level].one_in;
  const std::uint64_t group = sample / one_in;
  return sample % one_in == (one_in / 2 + 7 * group) % one_in;
}

bool against_motion(Axis axis) { return axis == Axis::ChainMotion || axis == Axis::PoseMotion; }

namespace {

using filtered::detail::cross;
using filtered::detail::dot;

double root(const Rational& number) { return mpf_class(sqrt(real(number))).get_d(); }

RationalVector vertex(const Polygon& polygon, std::size_t i) { return exactly(polygon.vertex(i)); }

/// The square of the longest side of the box.
Rational box_side_squared(const Polygon& polygon) {
  mpq_class longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
    longest = std::max<mpq_class>(longest, mpq_class(*high) - mpq_class(*low));
  }
  return {mpq_class(longest * longest)};
}

}  // namespace

double aspect_ratio(const Polygon& polygon) {
  const std::size_t count = polygon.vertex_count();
  std::vector<RationalVector> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(vertex(polygon, i) - vertex(polygon, 0));
  RationalVector normal{exactly(0), exactly(0), exactly(0)};
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) normal = normal + cross(points[i], points[polygon.next(i)]);
  RationalVector longest{exactly(0), exactly(0), exactly(0)};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + 1; k < count; ++k) {
      const RationalVector between = points[k] - points[i];
      if (dot(between, between).value > dot(longest, longest).value) longest = between;
    }
  const RationalVector across = cross(normal, longest);
  mpq_class low = 0, high = 0;
  for (const RationalVector& point : points) {
    const mpq_class height = dot(across, point).value;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  // |D| over (high - low) / (|N| |D|), for |across| = |N| |D|.
  const Rational width{mpq_class(high - low)};
  const Rational length2 = dot(longest, longest);
  return root(length2 * length2 * dot(normal, normal) / (width * width));
}

double sine_at(const Polygon& polygon, std::size_t i) {
  const RationalVector a = vertex(polygon, polygon.previous(i)) - vertex(polygon, i);
  const RationalVector b = vertex(polygon, polygon.next(i)) - vertex(polygon, i);
  const RationalVector moment = cross(a, b);
  return root(dot(moment, moment) / (dot(a, a) * dot(b, b)));
}

double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second) {
  const RationalVector between = vertex(polygon, second) - vertex(polygon, first);
  return root(dot(between, between) / box_side_squared(polygon));
}

double relative_origin_distance(const Polygon& polygon) {
  const RationalVector first = vertex(polygon, 0);
  return root(dot(first, first) / box_side_squared(polygon));
}

int largest_exponent(const Polygon& polygon) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double x : polygon.coordinates(axis)) largest = std::max(largest, std::abs(x));
  return std::ilogb(largest);
}

}  // namespace touchstone::stability
