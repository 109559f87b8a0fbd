// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/scene/solid_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

#include "experiments/cases/workloads/random.h"

namespace touchstone::scene_tests {
namespace {

using workloads::Random;

Triangle turned(const Triangle& t) { return {t.a, t.c, t.b}; }

/// The faces of a tetrahedron with positive volume are seen from outside.
std::vector<Triangle> tetrahedron(const std::array<Eigen::Vector3d, 4>& p) {
  return {{p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[2], p[0], p[3]}};
}
std::vector<Triangle> octahedron(const Eigen::Vector3d& at, const std::array<Eigen::Vector3d, 3>& axes) {
  std::vector<Triangle> faces;
  for (int signs = 0; signs < 8; ++signs) {
    const auto corner = [&](int k) -> Eigen::Vector3d {
      return at + (signs >> k & 1 ? -1.0 : 1.0) * axes[static_cast<std::size_t>(k)];
    };
    const Triangle face{corner(0), corner(1), corner(2)};
    faces.push_back(__builtin_popcount(static_cast<unsigned>(signs)) % 2 == 0 ? face : turned(face));
  }
  return faces;
}

void add(std::vector<Triangle>& all, const std::vector<Triangle>& faces, bool turn) {
  for (const Triangle& face : faces) all.push_back(turn ? turned(face) : face);
}

std::vector<Triangle> draw_faces(SolidKind kind, Random& random) {
  if (kind == SolidKind::Voxels)
    return Voxels(static_cast<int>(random.integer(1, 3)), random.bits(), 0)
        .surface(static_cast<int>(random.integer(-2, 2)));
  const bool lattice = kind == SolidKind::Lattice;
  const auto number = [&] { return lattice ? static_cast<double>(random.integer(0, 4)) : 4 * random.unit(); };
  const auto point = [&] { return Eigen::Vector3d{number(), number(), number()}; };
  std::vector<Triangle> all;
  for (auto count = random.integer(1, 4); count > 0; --count) {
    const std::array<Eigen::Vector3d, 4> p{point(), point(), point(), point()};
    const std::array<Eigen::Vector3d, 3> axes{p[1] - p[0], p[2] - p[0], p[3] - p[0]};
    if (axes[0].cross(axes[1]).dot(axes[2]) == 0) continue;
    add(all, !lattice && random.coin() ? octahedron(p[0], axes) : tetrahedron(p), random.coin());
  }
  return all;
}

}  // namespace

SolidSample draw_solid(SolidKind kind, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, static_cast<std::uint64_t>(kind));
  SolidSample sample;
  while (sample.triangles.empty()) sample.triangles = draw_faces(kind, random);

  // Coordinates are below 16. A power of two changes nothing but the size, as long as no bits are lost.
  const bool whole = kind != SolidKind::Round;
  constexpr int kExponents[] = {0, 0, 0, 40, -60, 300, -300, 1018, -1000, -1074};
  const int exponent = kExponents[random.integer(0, whole ? 9 : 8)];
  const Eigen::Vector3d shift = random.coin() && whole ? Eigen::Vector3d{-2, 1, -1} : Eigen::Vector3d{0, 0, 0};
  const auto placed = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return (p + shift).unaryExpr([&](double x) { return std::ldexp(x, exponent); });
  };
  for (Triangle& t : sample.triangles) t = {placed(t.a), placed(t.b), placed(t.c)};

  const auto vertex = [&]() -> Eigen::Vector3d {
    const Triangle& t = sample.triangles[static_cast<std::size_t>(
        random.integer(0, static_cast<std::int64_t>(sample.triangles.size()) - 1))];
    const auto corner = random.integer(0, 2);
    return corner == 0 ? t.a : corner == 1 ? t.b : t.c;
  };
  for (int i = 0; i < 40; ++i) {
    Eigen::Vector3d p = vertex();
    const Triangle& t = sample.triangles[static_cast<std::size_t>(
        random.integer(0, static_cast<std::int64_t>(sample.triangles.size()) - 1))];
    switch (random.integer(0, 5)) {
      case 0: break;
      case 1: p = t.a / 2 + t.b / 2; break;
      case 2: p = t.a / 2 + t.b / 4 + t.c / 4; break;
      case 3: p = {p.x(), vertex().y(), vertex().z()}; break;  // level with vertices
      case 4: p = placed(Eigen::Vector3d{6 * random.unit() - 1, 6 * random.unit() - 1, 6 * random.unit() - 1}); break;
      default: {
        const double u = random.unit(), v = (1 - u) * random.unit();
        p = (1 - u - v) * t.a + u * t.b + v * t.c;
      }
    }
    if (random.integer(0, 3) == 0) {
      double& coordinate = p[static_cast<Eigen::Index>(random.integer(0, 2))];
      coordinate = std::nextafter(coordinate, random.coin() ? 1e308 : -1e308);
    }
    sample.points.push_back(p);
  }
  return sample;
}

Voxels::Voxels(int size, std::uint64_t seed, std::uint64_t index)
    : size_(size), filled_(static_cast<std::size_t>(size * size * size)) {
  Random random(seed, index, 7);
  for (auto&& cube : filled_) cube = random.coin();
  filled_[0] = true;
}

bool Voxels::filled(int x, int y, int z) const {
  const auto in = [this](int k) { return k >= 0 && k < size_; };
  return in(x) && in(y) && in(z) && filled_[static_cast<std::size_t>((x * size_ + y) * size_ + z)];
}

std::vector<Triangle> Voxels::surface(int shear) const {
  std::vector<Triangle> faces;
  const auto at = [shear](const std::array<int, 3>& p) -> Eigen::Vector3d {
    return Eigen::Vector3i{p[0] + shear * p[2], p[1], p[2]}.cast<double>();
  };
  for (int x = 0; x < size_; ++x)
    for (int y = 0; y < size_; ++y)
      for (int z = 0; z < size_; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            std::array<int, 3> next{x, y, z};
            next[axis] += side == 1 ? 1 : -1;
            if (!filled(x, y, z) || filled(next[0], next[1], next[2])) continue;
            // Counter-clockwise as seen against the axis.
            std::array<std::array<int, 3>, 4> corners;
            for (std::size_t i = 0; i < 4; ++i) {
              corners[i] = {x, y, z};
              corners[i][axis] += side;
              corners[i][(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
              corners[i][(axis + 2) % 3] += i >= 2 ? 1 : 0;
            }
            const std::size_t first = static_cast<std::size_t>(x + y + z) % 2;
            const auto corner = [&](std::size_t i) { return at(corners[(first + i) % 4]); };
            for (const Triangle& face :
                 {Triangle{corner(0), corner(1), corner(2)}, Triangle{corner(0), corner(2), corner(3)}})
              faces.push_back(side == 1 ? face : turned(face));
          }
  return faces;
}

PointLocation Voxels::locate(const std::array<int, 3>& halves) const {
  // The closed cubes that contain the point are all filled, all empty, or both; then a face between two contains it.
  bool some = false, all = true;
  for (int neighbour = 0; neighbour < 8; ++neighbour) {
    int cube[3];
    for (int k = 0; k < 3; ++k) {
      const int half = halves[static_cast<std::size_t>(k)], floor = half >= 0 ? half / 2 : (half - 1) / 2;
      cube[k] = half % 2 == 0 ? floor - (neighbour >> k & 1) : floor;
    }
    const bool here = filled(cube[0], cube[1], cube[2]);
    some = some || here, all = all && here;
  }
  return all ? PointLocation::Inside : some ? PointLocation::Boundary : PointLocation::Outside;
}

namespace {

using IntegerPoint = std::array<mpz_class, 3>;

/// The exponent of the lowest bit of a coordinate that is not 0.
int lowest_bit(const Eigen::Vector3d& p) {
  int lowest = 1024;
  for (const double x : p) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    if (mantissa != 0)
      lowest = std::min(lowest, exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa)));
  }
  return lowest;
}

/// A point in units of 2^unit, which is not above its lowest bit.
IntegerPoint integers(const Eigen::Vector3d& p, int unit) {
  const auto integer = [unit](double x) -> mpz_class {
    int exponent = 0;
    mpz_class result(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 - unit;
    mpz_class shifted;
    if (shift >= 0)
      mpz_mul_2exp(shifted.get_mpz_t(), result.get_mpz_t(), static_cast<unsigned>(shift));
    else
      mpz_tdiv_q_2exp(shifted.get_mpz_t(), result.get_mpz_t(), static_cast<unsigned>(-shift));  // exact
    return shifted;
  };
  return {integer(p.x()), integer(p.y()), integer(p.z())};
}

IntegerPoint operator-(const IntegerPoint& a, const IntegerPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
IntegerPoint cross(const IntegerPoint& a, const IntegerPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int dot_sign(const IntegerPoint& a, const IntegerPoint& b) {
  return sgn(mpz_class(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
}

bool is_on(const IntegerPoint& p, const std::array<IntegerPoint, 3>& t) {
  const IntegerPoint normal = cross(t[1] - t[0], t[2] - t[0]);
  if (dot_sign(normal, p - t[0]) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot_sign(normal, cross(t[(i + 1) % 3] - t[i], p - t[i])) < 0) return false;
  return true;
}

/// How a ray goes through a triangle: +1 out, -1 in, 0 not at all; nothing if it meets an edge or lies in the plane.
std::optional<int> passage(const IntegerPoint& p, const IntegerPoint& way, const std::array<IntegerPoint, 3>& t) {
  const IntegerPoint a = t[0] - p, b = t[1] - p, c = t[2] - p, normal = cross(t[1] - t[0], t[2] - t[0]);
  if (dot_sign(normal, a) == 0) return dot_sign(normal, way) != 0 ? std::optional(0) : std::nullopt;  // not on it
  const int sides[] = {dot_sign(way, cross(a, b)), dot_sign(way, cross(b, c)), dot_sign(way, cross(c, a))};
  if (sides[0] == 0 || sides[1] == 0 || sides[2] == 0) return std::nullopt;
  if (sides[0] != sides[1] || sides[1] != sides[2]) return 0;
  // The line passes; it leaves in the direction of the normal if the sides are positive.
  return dot_sign(normal, a) == sides[0] ? sides[0] : 0;
}

}  // namespace

IntegerSolid::IntegerSolid(const std::vector<Triangle>& triangles) : given_(triangles) {
  for (const Triangle& t : given_) unit_ = std::min({unit_, lowest_bit(t.a), lowest_bit(t.b), lowest_bit(t.c)});
  in_units(unit_, triangles_);
}

void IntegerSolid::in_units(int unit, std::vector<std::array<Point, 3>>& triangles) const {
  for (const Triangle& t : given_) triangles.push_back({integers(t.a, unit), integers(t.b, unit), integers(t.c, unit)});
}

PointLocation IntegerSolid::locate(const Eigen::Vector3d& point) const {
  const int unit = std::min(unit_, lowest_bit(point));
  const IntegerPoint p = integers(point, unit);
  std::vector<std::array<Point, 3>> finer;
  if (unit < unit_) in_units(unit, finer);
  const auto& triangles = unit < unit_ ? finer : triangles_;
  for (const auto& t : triangles)
    if (is_on(p, t)) return PointLocation::Boundary;
  for (std::uint64_t attempt = 0;; ++attempt) {
    Random random(2026, attempt, 11);
    IntegerPoint way;
    for (mpz_class& part : way) part = static_cast<long>(random.integer(-1'000'000, 1'000'000));
    int winding_number = 0;
    bool certain = true;
    for (const auto& t : triangles) {
      const std::optional<int> here = passage(p, way, t);
      certain = certain && here;
      winding_number += here.value_or(0);
    }
    if (certain) return winding_number != 0 ? PointLocation::Inside : PointLocation::Outside;
  }
}

}  // namespace touchstone::scene_tests
