// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/axis.h"

#include <fmt/core.h>

namespace touchstone::stability {
namespace {

/// A power of ten.
Level decimal(int exponent, std::uint64_t one_in = 1) {
  const std::string name = exponent == 0 ? "1" : fmt::format("1e{}", exponent);
  return {name, std::stod(name), one_in};
}
Level whole(int value, std::uint64_t one_in = 1) { return {std::to_string(value), static_cast<double>(value), one_in}; }

std::vector<Level> decades(std::initializer_list<int> exponents) {
  std::vector<Level> list;
  for (const int exponent : exponents) list.push_back(decimal(exponent));
  return list;
}

std::vector<Level> wholes(std::initializer_list<int> values) {
  std::vector<Level> list;
  for (const int value : values) list.push_back(whole(value));
  return list;
}

std::vector<Level> named(std::initializer_list<const char*> names) {
  std::vector<Level> list;
  for (const char* name : names) list.push_back({name, static_cast<double>(list.size()), 1});
  return list;
}

struct AxisRow {
  std::string_view name, meaning;
  std::vector<Level> levels;
};

/// Returns the axes in the order of their enumerators.
const std::vector<AxisRow>& axis_rows() {
  static const std::vector<Level> collinear{whole(1), whole(10), whole(100, 4), whole(1000, 20), whole(10000, 40)};
  static const std::vector<Level> steps{decimal(0), decimal(1),    decimal(2),    decimal(3),
                                        decimal(4), decimal(5, 2), decimal(6, 10)};
  static const std::vector<AxisRow> list = [] {
    std::vector<Level> distances = decades({0, -2, -4, -6, -8, -10, -12, -14});
    distances.push_back({"4 ulps", 0x1p-50, 1});
    return std::vector<AxisRow>{
        {"aspect", "length over width of a squeezed outline", decades({0, 2, 4, 6, 8, 10, 12, 14, 16})},
        {"parallel", "angle between neighbouring edges (a crack, or a bend), radians",
         decades({0, -2, -4, -6, -8, -10, -12, -14, -16})},
        {"duplicate", "distance of two vertices, in sizes", distances},
        {"collinear-exact", "vertices on one straight side, exactly (lattice)", collinear},
        {"collinear-rounded", "vertices on one straight side, rounded to doubles", collinear},
        {"origin", "distance from the origin, in sizes", decades({0, 3, 6, 9, 12, 13, 14, 15})},
        {"small", "binary exponent of the largest coordinate, downwards",
         wholes({0, -64, -128, -160, -176, -192, -256, -340, -400, -512, -700, -1000, -1030, -1064})},
        {"large", "binary exponent of the largest coordinate, upwards",
         wholes({0, 64, 128, 160, 170, 192, 256, 340, 400, 512, 700, 1000, 1023})},
        {"mixed", "binary orders of magnitude between the axes", wholes({0, 16, 32, 64, 128, 256, 512, 1024, 1600})},
        {"off-plane",
         "one vertex off the others' plane, in ulps",
         {whole(1), whole(16), whole(256), {"2^12", 0x1p12, 1}, {"2^16", 0x1p16, 1}, {"2^20", 0x1p20, 1}}},
        {"vertices",
         "vertices of the polygon",
         {whole(10), whole(100, 2), decimal(3, 10), decimal(4, 40), decimal(5, 40), decimal(6, 80)}},
        {"chain-input", "rotations of all points in doubles; against exact on the doubles at the end", steps},
        {"chain-motion", "the same; against exact of the motion that was meant", steps},
        {"pose-input", "products of the pose in doubles; against exact on the doubles at the end", steps},
        {"pose-motion", "the same; against exact of the motion that was meant", steps},
        {"rounding", "rounding direction while a method works", named({"nearest", "up", "down", "zero"})},
        {"flush", "subnormals flushed to zero while a method works", named({"kept", "FTZ", "DAZ", "FTZ+DAZ"})}};
  }();
  return list;
}

const AxisRow& row_of(Axis axis) { return axis_rows()[static_cast<std::size_t>(axis)]; }

}  // namespace

std::string_view to_string(Axis axis) { return row_of(axis).name; }

std::string_view meaning(Axis axis) { return row_of(axis).meaning; }

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

}  // namespace touchstone::stability
