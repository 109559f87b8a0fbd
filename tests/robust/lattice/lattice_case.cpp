// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/lattice/lattice_case.h"

#include <gmpxx.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "robust/exact/exact.h"

namespace touchstone::lattice_tests {
namespace {

__extension__ using Wide = __int128;
using Vector = std::array<std::int64_t, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator*(std::int64_t s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Wide dot(const Vector& a, const Vector& b) { return Wide{a[0]} * b[0] + Wide{a[1]} * b[1] + Wide{a[2]} * b[2]; }

std::size_t largest(const Vector& v) {
  std::size_t axis = 0;
  for (std::size_t k : {1U, 2U})
    if (std::abs(v[k]) > std::abs(v[axis])) axis = k;
  return axis;
}

Eigen::Vector3d doubles(const Vector& v) {
  const auto exact = [](std::int64_t x) {
    if (std::abs(x) > std::int64_t{1} << 53) throw std::logic_error("a coordinate does not fit a double");
    return static_cast<double>(x);
  };
  return {exact(v[0]), exact(v[1]), exact(v[2])};
}

mpz_class integer(Wide value) {
  mpz_class result(static_cast<unsigned long>(value >> 64));
  result <<= 64;
  return result + static_cast<unsigned long>(value);
}

Wide whole_quotient(Wide numerator, Wide denominator) {
  if (numerator % denominator != 0) throw std::logic_error("a lifted vertex is no integer");
  return numerator / denominator;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The doubles before, at and after `nearest`, the last of those not beyond the distance.
std::vector<Radius> radii_about(double nearest, Relation at_it) {
  std::vector<Radius> radii;
  if (nearest > 0) radii.push_back({std::nextafter(nearest, 0), Relation::Separate});
  radii.push_back({nearest, at_it});
  radii.push_back({std::nextafter(nearest, kInfinity), Relation::Overlapping});
  return radii;
}

}  // namespace

/// A squared distance; the denominator is positive.
struct LatticeCase::Squared {
  Wide numerator, denominator;

  friend bool operator<(const Squared& a, const Squared& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }

  /// The sign of radius - distance.
  [[nodiscard]] int compare(double radius) const {
    int exponent = 0;
    mpz_class left(std::ldexp(std::frexp(radius, &exponent), 53)), right = integer(numerator);
    exponent -= 53;
    left *= left * integer(denominator);
    if (exponent < 0)
      right <<= static_cast<mp_bitcnt_t>(-2 * exponent);
    else
      left <<= static_cast<mp_bitcnt_t>(2 * exponent);
    return cmp(left, right);
  }

  [[nodiscard]] std::vector<Radius> radii() const {
    double radius = std::sqrt(static_cast<double>(numerator) / static_cast<double>(denominator));
    while (compare(radius) > 0) radius = std::nextafter(radius, 0);
    while (compare(std::nextafter(radius, kInfinity)) <= 0) radius = std::nextafter(radius, kInfinity);
    return radii_about(radius, compare(radius) == 0 ? Relation::Touching : Relation::Separate);
  }
};

std::string_view name(PlaneKind kind) {
  switch (kind) {
    case PlaneKind::Upright: return "upright";
    case PlaneKind::Tilted: return "tilted";
    case PlaneKind::Warped: return "warped";
    case PlaneKind::Rounded: break;
  }
  return "rounded";
}

std::uint64_t mixed(std::uint64_t number, std::uint64_t subject) {
  std::uint64_t z = number * 0x9e3779b97f4a7c15 + subject * 0xd1342543de82ef95 + 0x2545f4914f6cdd1d;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

LatticeCase::LatticeCase(const std::vector<LatticeLoop>& loops, PlaneKind kind, std::uint64_t variation)
    : loops_(loops), integers_(kind != PlaneKind::Rounded) {
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    LatticeLoop& loop = loops_[i];
    for (LatticePoint& point : loop) point = {2 * point.x, 2 * point.y};
    const std::uint64_t turned = mixed(variation, i);
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(turned % loop.size()), loop.end());
    if ((turned >> 32 & 1) != 0) std::reverse(loop.begin(), loop.end());
  }
  if (integers_)
    put_into_integers(kind, mixed(variation, 100));
  else
    put_into_doubles(mixed(variation, 101));
}

void LatticeCase::put_into_doubles(std::uint64_t variation) {
  const Eigen::Vector3d axis(1, 2, static_cast<double>(variation % 7) - 3);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(static_cast<double>(variation % 11) / 3 + 0.1, axis.normalized()).toRotationMatrix();
  rounded_x_ = turned.col(0), rounded_y_ = turned.col(1);
  rounded_origin_ = static_cast<double>(variation % 3) * Eigen::Vector3d(1.1, -2.3, 0.7);
  std::vector<Loop> in_space;
  for (const LatticeLoop& loop : loops_) {
    in_space.emplace_back();
    for (const auto& [x, y] : loop) in_space.back().push_back(rounded_origin_ + x * rounded_x_ + y * rounded_y_);
  }
  polygon_.emplace(in_space[0], std::vector<Loop>(in_space.begin() + 1, in_space.end()));
}

void LatticeCase::put_into_integers(PlaneKind kind, std::uint64_t variation) {
  constexpr Vector kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr Vector kTilted[][2] = {{{1, 2, 2}, {2, 1, -2}},                          // an isometry times 3
                                   {{1, 2, 3}, {3, -1, 1}}, {{0, 1, 1}, {1, 0, 1}},  // a tie of all axes
                                   {{2, -1, 0}, {1, 2, 4}}, {{-3, 1, 0}, {1, 0, 5}}, {{0, -2, 1}, {7, 1, 1}}};
  const std::size_t axis = variation % 3;
  std::int64_t warp = 0;
  if (kind == PlaneKind::Tilted) {
    const auto& [u, v] = kTilted[variation % std::size(kTilted)];
    along_x_ = u, along_y_ = v;
  } else {
    along_x_ = kAxes[axis], along_y_ = kAxes[(axis + 1) % 3];
  }
  if (kind == PlaneKind::Warped) {
    // Heights of `warp` tilt the plane by multiples of 1 / (32 area), and the mean has the number of vertices below it.
    warp = std::int64_t{std::abs(doubled_area(loops_[0]))} * static_cast<std::int64_t>(loops_[0].size());
    along_x_ = 32 * warp * along_x_, along_y_ = 32 * warp * along_y_;
  }
  if (variation >> 40 & 1) std::swap(along_x_, along_y_);
  const auto offset = static_cast<std::int64_t>(variation >> 41 & 3);
  origin_ = {5 * offset, -3 * offset, offset};

  const Vector up = kAxes[(axis + 2) % 3];
  std::vector<Loop> in_space;
  std::uint64_t drawn = variation;
  for (const LatticeLoop& loop : loops_) {
    in_space.emplace_back();
    vertices_.emplace_back();
    for (const auto& [x, y] : loop) {
      drawn = mixed(drawn, 7);
      const std::int64_t height = warp * (static_cast<std::int64_t>(drawn % 3) - 1);
      vertices_.back().push_back(origin_ + x * along_x_ + y * along_y_ + height * up);
      in_space.back().push_back(doubles(vertices_.back().back()));
    }
  }
  polygon_.emplace(in_space[0], std::vector<Loop>(in_space.begin() + 1, in_space.end()));
  lift();
}

// As the contract has it: along the axis of the normal's largest component, onto the plane through the mean.
void LatticeCase::lift() {
  const std::vector<Vector>& outer = vertices_[0];
  Vector sum{};
  for (std::size_t i = 0; i < outer.size(); ++i) {
    normal_ = normal_ + cross(outer[i] - outer[0], outer[(i + 1) % outer.size()] - outer[0]);
    sum = sum + outer[i];
  }
  const std::int64_t common = std::gcd(std::gcd(normal_[0], normal_[1]), normal_[2]);
  for (std::int64_t& component : normal_) component /= common;
  const std::size_t k = largest(normal_);
  const auto count = static_cast<std::int64_t>(outer.size());
  for (auto& loop : vertices_)
    for (Vector& p : loop)
      p[k] -= static_cast<std::int64_t>(whole_quotient(dot(normal_, count * p - sum), Wide{count} * normal_[k]));
}

LatticeCase::Vector LatticeCase::on_plane(const LatticePoint& point) const {
  Vector p = origin_ + point.x * along_x_ + point.y * along_y_;
  const std::size_t k = largest(normal_);
  p[k] -= static_cast<std::int64_t>(whole_quotient(dot(normal_, p - vertices_[0][0]), normal_[k]));
  return p;
}

LatticeCase::Squared LatticeCase::squared_distance(const Vector& center, PointLocation place, int steps) const {
  if (place != PointLocation::Outside) return {dot(normal_, normal_) * steps * steps, 1};
  std::optional<Squared> least;
  for (const auto& loop : vertices_)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector from = center - loop[i], edge = loop[(i + 1) % loop.size()] - loop[i];
      Squared squared{dot(from, from), 1};
      const Wide along = dot(from, edge), length = dot(edge, edge);
      if (along > 0 && along < length) {
        const Vector moment = cross(from, edge);
        squared = {dot(moment, moment), length};
      }
      if (!least || squared < *least) least = squared;
    }
  return *least;
}

Questions LatticeCase::questions(const LatticePoint& foot, int steps) const {
  if (!integers_) {
    const Eigen::Vector3d center =
        rounded_origin_ + foot.x * rounded_x_ + foot.y * rounded_y_ + steps * rounded_x_.cross(rounded_y_);
    const exact::PreparedPolygon prepared(polygon());
    const double distance = exact::answer({center, 0}, prepared).distance;
    return {center, exact::foot({center, 0}, prepared),
            radii_about(distance, exact::relation({center, distance}, prepared))};
  }
  const PointLocation place = lattice_tests::place(loops_, foot);
  const Vector center = on_plane(foot) + steps * normal_;
  return {doubles(center), place, squared_distance(center, place, steps).radii()};
}

}  // namespace touchstone::lattice_tests
