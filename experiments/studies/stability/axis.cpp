// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/axis.h"

#include <fmt/core.h>

#include <map>

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

std::vector<Level> make_levels(Axis axis) {
  switch (axis) {
    case Axis::Aspect: return decades({0, 2, 4, 6, 8, 10, 12, 14, 16});
    case Axis::Parallel: return decades({0, -2, -4, -6, -8, -10, -12, -14, -16});
    case Axis::Duplicate: {
      auto list = decades({0, -2, -4, -6, -8, -10, -12, -14});
      list.push_back({"4 ulps", 0x1p-50, 1});
      return list;
    }
    case Axis::CollinearExact:
    case Axis::CollinearRounded: return {whole(1), whole(10), whole(100, 4), whole(1000, 20), whole(10000, 40)};
    case Axis::Origin: return decades({0, 3, 6, 9, 12, 13, 14, 15});
    case Axis::Small:
      return wholes({0, -64, -128, -160, -176, -192, -256, -340, -400, -512, -700, -1000, -1030, -1064});
    case Axis::Large: return wholes({0, 64, 128, 160, 170, 192, 256, 340, 400, 512, 700, 1000, 1023});
    case Axis::Mixed: return wholes({0, 16, 32, 64, 128, 256, 512, 1024, 1600});
    case Axis::OffPlane:
      return {whole(1), whole(16), whole(256), {"2^12", 0x1p12, 1}, {"2^16", 0x1p16, 1}, {"2^20", 0x1p20, 1}};
    case Axis::Vertices:
      return {whole(10), whole(100, 2), decimal(3, 10), decimal(4, 40), decimal(5, 40), decimal(6, 80)};
    case Axis::ChainInput:
    case Axis::ChainMotion:
    case Axis::PoseInput:
    case Axis::PoseMotion:
      return {decimal(0), decimal(1), decimal(2), decimal(3), decimal(4), decimal(5, 2), decimal(6, 10)};
    case Axis::Rounding: return named({"nearest", "up", "down", "zero"});
    case Axis::Flush: return named({"kept", "FTZ", "DAZ", "FTZ+DAZ"});
  }
  return {};
}

}  // namespace

std::string_view to_string(Axis axis) {
  switch (axis) {
    case Axis::Aspect: return "aspect";
    case Axis::Parallel: return "parallel";
    case Axis::Duplicate: return "duplicate";
    case Axis::CollinearExact: return "collinear-exact";
    case Axis::CollinearRounded: return "collinear-rounded";
    case Axis::Origin: return "origin";
    case Axis::Small: return "small";
    case Axis::Large: return "large";
    case Axis::Mixed: return "mixed";
    case Axis::OffPlane: return "off-plane";
    case Axis::Vertices: return "vertices";
    case Axis::ChainInput: return "chain-input";
    case Axis::ChainMotion: return "chain-motion";
    case Axis::PoseInput: return "pose-input";
    case Axis::PoseMotion: return "pose-motion";
    case Axis::Rounding: return "rounding";
    case Axis::Flush: return "flush";
  }
  return "";
}

std::string_view meaning(Axis axis) {
  switch (axis) {
    case Axis::Aspect: return "length over width of a squeezed outline";
    case Axis::Parallel: return "angle between neighbouring edges (a crack, or a bend), radians";
    case Axis::Duplicate: return "distance of two vertices, in sizes";
    case Axis::CollinearExact: return "vertices on one straight side, exactly (lattice)";
    case Axis::CollinearRounded: return "vertices on one straight side, rounded to doubles";
    case Axis::Origin: return "distance from the origin, in sizes";
    case Axis::Small: return "binary exponent of the largest coordinate, downwards";
    case Axis::Large: return "binary exponent of the largest coordinate, upwards";
    case Axis::Mixed: return "binary orders of magnitude between the axes";
    case Axis::OffPlane: return "one vertex off the others' plane, in ulps";
    case Axis::Vertices: return "vertices of the polygon";
    case Axis::ChainInput: return "rotations of all points in doubles; against exact on the doubles at the end";
    case Axis::ChainMotion: return "the same; against exact of the motion that was meant";
    case Axis::PoseInput: return "products of the pose in doubles; against exact on the doubles at the end";
    case Axis::PoseMotion: return "the same; against exact of the motion that was meant";
    case Axis::Rounding: return "rounding direction while a method works";
    case Axis::Flush: return "subnormals flushed to zero while a method works";
  }
  return "";
}

const std::vector<Axis>& all_axes() {
  static const std::vector<Axis> axes{
      Axis::Aspect,   Axis::Parallel,   Axis::Duplicate,   Axis::CollinearExact, Axis::CollinearRounded,
      Axis::Origin,   Axis::Small,      Axis::Large,       Axis::Mixed,          Axis::OffPlane,
      Axis::Vertices, Axis::ChainInput, Axis::ChainMotion, Axis::PoseInput,      Axis::PoseMotion,
      Axis::Rounding, Axis::Flush};
  return axes;
}

const std::vector<Level>& levels(Axis axis) {
  static const std::map<Axis, std::vector<Level>> all = [] {
    std::map<Axis, std::vector<Level>> map;
    for (const Axis a : all_axes()) map.emplace(a, make_levels(a));
    return map;
  }();
  return all.at(axis);
}

bool is_drawn(Axis axis, std::size_t level, std::uint64_t sample) {
  const std::uint64_t one_in = levels(axis)[level].one_in;
  const std::uint64_t group = sample / one_in;
  return sample % one_in == (one_in / 2 + 7 * group) % one_in;
}

bool against_motion(Axis axis) { return axis == Axis::ChainMotion || axis == Axis::PoseMotion; }

}  // namespace touchstone::stability
