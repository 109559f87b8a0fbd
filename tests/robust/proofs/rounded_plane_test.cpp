// SPDX-License-Identifier: GPL-3.0-or-later
// What the boxes of lifted polygons allow for the rounding of plane and heights, in rationals over the functions that
// are compiled.
//
// The polygon's size is 1: errors scale with it, and underflow counts most where it is kSmallestSize. Up to 64 vertices
// the calculus runs over every loop. Beyond, sums are taken as a whole; what is needed grows with n, so that what
// 2 n vertices need is enough for n to 2 n of them if n vertices are allowed it.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "robust/proofs/error_bound.h"
#include "robust/scene/detail/lifted_box.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::rounded_plane {
namespace {

using scene::detail::rounded_plane::Plane;

/// Against the smallest product of lengths, of three.
const mpq_class kUnderflow = kSmallestDouble / power(mpq_class(scene::detail::rounded_plane::kSmallestSize), 3);
const ErrorModel kNearest{kU, kUnderflow, true};
const ErrorBound kZero{&kNearest, 0, 0, 0};

Vector3<ErrorBound> vertex() {
  const ErrorBound coordinate = known_within(kNearest, 1, kU);
  return {coordinate, coordinate, coordinate};
}

Plane<ErrorBound> plane_as_compiled(std::size_t n) {
  return scene::detail::rounded_plane::plane_of(n, kZero, [](std::size_t) { return vertex(); });
}

Plane<ErrorBound> plane_as_a_whole(std::size_t n) {
  const ErrorBound normal = total(n, cross(vertex(), vertex()).x);
  const ErrorBound mean = total(n, vertex().x) / static_cast<double>(n);
  return {{normal, normal, normal}, {mean, mean, mean}};
}

/// What the normal and a height need, in units of n^2 u for `of` vertices, and what they are allowed.
struct Needs {
  mpq_class normal, height;

  Needs(const Plane<ErrorBound>& plane, std::size_t of) {
    const mpq_class unit = mpq_class(of * of) * kU;
    // largest - error is rounded, and so is largest - 2 error, from which on axes may be the dropped one.
    normal = (plane.normal.x.error + kU * plane.normal.x.magnitude()) / unit;
    // (height + height_error) / (largest - error) is rounded twice.
    const ErrorBound off_plane = scene::detail::rounded_plane::height(plane, vertex());
    height = (off_plane.error + 2 * kU * off_plane.magnitude()) / unit;
  }
};

/// The least that kNormal unit size^2 and kHeight unit size^3 may be as computed, where two roundings more pay for
/// those above of the errors themselves.
mpq_class as_computed(double constant) { return mpq_class(constant) * power(1 - kU, 6); }
const mpq_class kNormal = as_computed(scene::detail::rounded_plane::kNormal),
                kHeight = as_computed(scene::detail::rounded_plane::kHeight);

TEST(RoundedPlane, IsKnownForLoopsOfFewVertices) {
  for (std::size_t n = 3; n <= 64; ++n) {
    const Needs needs(plane_as_compiled(n), n);
    EXPECT_LE(needs.normal, kNormal) << n << " vertices";
    EXPECT_LE(needs.height, kHeight) << n << " vertices";
  }
}

TEST(RoundedPlane, IsAllowedNotMuchMoreThanTrianglesNeed) {
  const Needs needs(plane_as_compiled(3), 3);
  EXPECT_GT(needs.normal, kNormal * 3 / 4);
  EXPECT_GT(needs.height, kHeight / 2);
}

TEST(RoundedPlane, IsKnownForLoopsOfManyVertices) {
  constexpr auto kMost = static_cast<std::size_t>(scene::detail::rounded_plane::kMostVertices);
  for (std::size_t n = 64; n < kMost; n *= 2) {
    const Needs needs(plane_as_a_whole(2 * n), n);
    EXPECT_LE(needs.normal, kNormal) << n << " vertices";
    EXPECT_LE(needs.height, kHeight) << n << " vertices";
  }
}

TEST(RoundedPlane, HasSumsThatAreNoWorseThanTheyAreAsAWhole) {
  for (std::size_t n = 3; n <= 64; ++n) {
    const Plane<ErrorBound> compiled = plane_as_compiled(n), whole = plane_as_a_whole(n);
    EXPECT_LE(compiled.normal.x.error, whole.normal.x.error) << n << " vertices";
    EXPECT_LE(compiled.normal.x.magnitude(), whole.normal.x.magnitude()) << n << " vertices";
    EXPECT_LE(compiled.mean.x.error, whole.mean.x.error) << n << " vertices";
    EXPECT_LE(compiled.mean.x.magnitude(), whole.mean.x.magnitude()) << n << " vertices";
  }
}

}  // namespace
}  // namespace touchstone::proofs::rounded_plane
