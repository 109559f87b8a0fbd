// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/every_state/input.h"

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/limits.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::every_state_tests {
namespace {

using namespace contact_tests;
using workloads::Random;

constexpr std::uint64_t kSeed = 2026, kStream = 71;

/// Units of length: small integers times them are subnormal, straddle the least normal number, or are near the largest.
double draw_unit(Random& random) {
  constexpr double kUnits[] = {kLeast, kLeast, 4 * kLeast, 0x1p-1040, 0x1p-1024, 0x1p-500, 1.0, 1.0, 1.0 / 3, 0x1p1019};
  return kUnits[random.integer(0, std::ssize(kUnits) - 1)];
}

/// The same with zeros of either sign.
Eigen::Vector3d with_either_zero(Eigen::Vector3d p, Random& random) {
  sign_zeros(p, random);
  return p;
}

/// Loops of small integers: a triangle, an L, a U, a square with a hole, a quadrilateral off its plane.
std::vector<Loop> draw_lattice_loops(Random& random) {
  static const std::vector<std::vector<Loop>> kShapes = {
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}},
      {{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}}},
      {{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}},
      {{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}, {{2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}}},
      {{{0, 0, 0}, {3, 0, 1}, {3, 3, 0}, {0, 3, 1}}},
  };
  std::vector<Loop> loops = kShapes[static_cast<std::size_t>(random.integer(0, std::ssize(kShapes) - 1))];
  const auto turn = static_cast<int>(random.integer(0, 2));
  const Eigen::Vector3d shift(static_cast<double>(random.integer(-1, 1)), static_cast<double>(random.integer(-1, 1)),
                              static_cast<double>(random.integer(-1, 1)));
  for (Loop& loop : loops)
    for (Eigen::Vector3d& p : loop) {
      const Eigen::Vector3d before = p + shift;
      for (int axis = 0; axis < 3; ++axis) p[axis] = before[(axis + turn) % 3];
    }
  return loops;
}

Eigen::Vector3d draw_point(double unit, Random& random) {
  Eigen::Vector3d p;
  for (double& x : p) {
    x = static_cast<double>(random.integer(-2, 6)) * unit;
    sign_zeros(x, random);
  }
  return p;
}

Ball draw_ball(double unit, Random& random) {
  constexpr double kRadii[] = {0, -0.0, 1, 2, 3};
  return {draw_point(unit, random), kRadii[random.integer(0, std::ssize(kRadii) - 1)] * unit};
}

/// Mostly the identity, with a zero or two of the other sign, and a translation of a few units.
Pose draw_pose(double unit, Random& random) {
  Pose pose;
  if (random.integer(0, 2) == 0) pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  if (random.integer(0, 3) == 0) pose.rotation(2, 0) = static_cast<double>(random.integer(1, 3)) * kLeast;
  for (double& t : pose.translation) t = random.coin() ? 0 : static_cast<double>(random.integer(-3, 3)) * unit;
  sign_zeros(pose, random);
  return pose;
}

/// One number of some is not legal everywhere.
void spoil(double& x, Random& random) {
  constexpr double kSpoilt[] = {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN(), kMax, -kMax, -kLeast};
  x = kSpoilt[random.integer(0, std::ssize(kSpoilt) - 1)];
}

Mesh mesh_of(const std::vector<Loop>& loops) {
  Mesh mesh;
  for (const Loop& loop : loops) {
    auto& face = mesh.faces.emplace_back();
    for (const Eigen::Vector3d& p : loop) {
      face.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(p);
    }
  }
  return mesh;
}

/// Two triangles that share an edge, whose vertices are told twice.
Mesh draw_mesh(double unit, Random& random) {
  const double lift = random.coin() ? unit : 0;
  std::vector<Loop> loops{{{0, 0, 0}, {4 * unit, 0, 0}, {0, 4 * unit, 0}},
                          {{4 * unit, 0, 0}, {4 * unit, 4 * unit, lift}, {0, 4 * unit, 0}}};
  Mesh mesh = mesh_of(loops);
  sign_zeros(mesh, random);
  return mesh;
}

// Decimals that are halfway between doubles, subnormal, zero, or simply no double.
constexpr const char* kDecimals[] = {"0.3",
                                     "1.1",
                                     "-0",
                                     "0",
                                     "5e-324",
                                     "-5e-324",
                                     "2.4703282292062328e-324",
                                     "2.2250738585072011e-308",
                                     "1e23",
                                     "9007199254740993",
                                     "-9007199254740993",
                                     "123456789012345678e-5",
                                     "1.7976931348623158e308"};

std::string draw_decimals(Random& random) {
  std::string line;
  for (int axis = 0; axis < 3; ++axis)
    line += std::string(" ") + kDecimals[random.integer(0, std::ssize(kDecimals) - 1)];
  return line;
}

template <class Number>
void append(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof number);
}

/// A mesh of one triangle: OBJ, OFF, STL and PLY as text, STL and PLY of subnormal floats.
Input::File draw_file(std::uint64_t index, Random& random) {
  const std::string corners[] = {draw_decimals(random), draw_decimals(random), draw_decimals(random)};
  const std::string ply =
      "ply\nformat %\nelement vertex 3\nproperty $ x\nproperty $ y\nproperty $ z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const auto header = [&](const std::string& format, const std::string& type) {
    std::string text = ply;
    text.replace(text.find('%'), 1, format);
    for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$')) text.replace(at, 1, type);
    return text;
  };
  const auto float_corner = [&](std::string& bytes) {
    for (int axis = 0; axis < 3; ++axis)
      append(bytes, static_cast<float>(random.integer(-3, 3)) * std::numeric_limits<float>::denorm_min());
  };
  std::string extension, bytes;
  switch (index % 6) {
    case 0:
      extension = ".obj";
      for (const auto& c : corners) bytes += "v" + c + "\n";
      bytes += "f 1 2 3\n";
      break;
    case 1:
      extension = ".off";
      bytes = "OFF\n3 1 0\n";
      for (const auto& c : corners) bytes += c + "\n";
      bytes += "3 0 1 2\n";
      break;
    case 2:
      extension = ".stl";
      bytes = "solid s\nfacet normal 0 0 1\nouter loop\n";
      for (const auto& c : corners) bytes += "vertex" + c + "\n";
      bytes += "endloop\nendfacet\nendsolid s\n";
      break;
    case 3:
      extension = ".ply";
      bytes = header("ascii 1.0", "double");
      for (const auto& c : corners) bytes += c + "\n";
      bytes += "3 0 1 2\n";
      break;
    case 4:
      extension = ".stl";
      bytes = std::string(80, ' ');
      append(bytes, std::uint32_t{1});
      for (int corner = 0; corner < 4; ++corner) float_corner(bytes);  // the normal, then three vertices
      append(bytes, std::uint16_t{0});
      break;
    default:
      extension = ".ply";
      bytes = header("binary_little_endian 1.0", "float");
      for (int corner = 0; corner < 3; ++corner) float_corner(bytes);
      append(bytes, std::uint8_t{3});
      for (std::int32_t i = 0; i < 3; ++i) append(bytes, i);
  }
  return {extension, bytes};
}

}  // namespace

Input draw_input(std::uint64_t index) {
  Random random(kSeed, index, kStream);
  const double unit = draw_unit(random);
  std::vector<Loop> loops = draw_lattice_loops(random);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& p : loop) p = with_either_zero(p * unit, random);
  const std::vector<Loop> holes(loops.begin() + 1, loops.end());
  const Polygon polygon(loops.front(), holes);
  if (exact::validate(polygon)) throw std::logic_error("input " + std::to_string(index) + " is not a polygon");
  const Triangle triangle{with_either_zero(Eigen::Vector3d(0, 0, 0), random),
                          with_either_zero(Eigen::Vector3d(4, 0, 0) * unit, random),
                          with_either_zero(Eigen::Vector3d(0, 4, 1) * unit, random)};

  Input input{.index = index,
              .ball = draw_ball(unit, random),
              .polygon = polygon,
              .triangle = triangle,
              .point = draw_point(unit, random),
              .pose = draw_pose(unit, random),
              .mesh = draw_mesh(unit, random),
              .any_ball = draw_ball(unit, random),
              .any_outer = loops.front(),
              .any_holes = holes,
              .any_triangle = triangle,
              .any_pose = draw_pose(unit, random),
              .any_tolerance = static_cast<double>(random.integer(-1, 3)) * unit,
              .boxes = {},
              .mesh_file = draw_file(index, random)};
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p = draw_point(unit, random), q = draw_point(unit, random);
    input.boxes.push_back({p.cwiseMin(q), p.cwiseMax(q)});
  }
  switch (random.integer(0, 11)) {
    case 0: spoil(input.any_ball.center[random.integer(0, 2)], random); break;
    case 1: spoil(input.any_ball.radius, random); break;
    case 2: spoil(input.any_outer[1][random.integer(0, 2)], random); break;
    case 3: input.any_outer[1] = input.any_outer[0]; break;
    case 4: spoil(input.any_triangle.b[random.integer(0, 2)], random); break;
    case 5: spoil(input.any_pose.translation[random.integer(0, 2)], random); break;
    case 6: spoil(input.any_pose.rotation(random.integer(0, 2), 1), random); break;
    case 7: spoil(input.any_tolerance, random); break;
    default: break;
  }
  return input;
}

}  // namespace touchstone::every_state_tests
