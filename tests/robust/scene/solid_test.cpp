// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/scene/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <thread>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/exact.h"
#include "tests/robust/scene/solid_samples.h"
#include "tests/robust/support/environment.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::Environment;
using contact_tests::kStates;
using Eigen::Vector3d;
using scene::NotClosed;
using scene::Solid;
using workloads::Random;

constexpr SolidKind kSolidKinds[] = {SolidKind::Lattice, SolidKind::Round, SolidKind::Voxels};

std::vector<PointLocation> located(const Solid& solid, const std::vector<Vector3d>& points) {
  std::vector<PointLocation> locations(points.size());
  solid.locate(points, locations);
  return locations;
}

/// A cube from `low` to `low + size`, turned inside out or not.
std::vector<Triangle> cube(double low, double size, bool turned = false) {
  std::vector<Triangle> faces;
  for (const Triangle& t : Voxels(1, 1, 1).surface(0)) {
    const auto placed = [&](const Vector3d& p) -> Vector3d { return Vector3d::Constant(low) + size * p; };
    faces.push_back(turned ? Triangle{placed(t.a), placed(t.c), placed(t.b)}
                           : Triangle{placed(t.a), placed(t.b), placed(t.c)});
  }
  return faces;
}
std::vector<Triangle> joined(std::vector<Triangle> a, const std::vector<Triangle>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Where the centre lies, along the diagonal.
PointLocation at(const Solid& solid, double x) { return solid.locate({x, x, x}); }

constexpr auto kInside = PointLocation::Inside, kBoundary = PointLocation::Boundary, kOutside = PointLocation::Outside;

TEST(Solid, LocatesPointsAsIntegersDo) {
  int counts[3] = {0, 0, 0};
  for (std::uint64_t index = 0; index < 2 * TOUCHSTONE_SAMPLES; ++index)
    for (const SolidKind kind : kSolidKinds) {
      const SolidSample sample = draw_solid(kind, 2026, index);
      const Solid solid(sample.triangles);
      const IntegerSolid expected(sample.triangles);
      const std::vector<PointLocation> locations = located(solid, sample.points);
      for (std::size_t i = 0; i < sample.points.size(); ++i) {
        const PointLocation where = expected.locate(sample.points[i]);
        ++counts[static_cast<int>(where)];
        ASSERT_EQ(locations[i], where) << "kind " << static_cast<int>(kind) << ", sample " << index << ", point " << i
                                       << ": " << sample.points[i].transpose();
      }
    }
  for (const int count : counts) EXPECT_GT(count, 20 * TOUCHSTONE_SAMPLES) << "the samples do not tell";
}

// Rays from these points meet vertices, edges and diagonals of many faces.
TEST(Solid, LocatesEveryPointOfALatticeOfCubes) {
  constexpr int size = 12;
  for (std::uint64_t index = 0; index < 3; ++index) {
    const Voxels voxels(size, 2026, index);
    const Solid solid(voxels.surface(0));
    for (int x = -1; x <= 2 * size + 1; ++x)
      for (int y = -1; y <= 2 * size + 1; ++y)
        for (int z = -1; z <= 2 * size + 1; ++z)
          ASSERT_EQ(solid.locate(Vector3d(x, y, z) / 2), voxels.locate({x, y, z}))
              << "sample " << index << ": " << x << ' ' << y << ' ' << z << " halves";
  }
}

TEST(Solid, AnswersAlikeInEveryState) {
  for (const SolidKind kind : kSolidKinds)
    for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES / 10; ++index) {
      const SolidSample sample = draw_solid(kind, 2027, index);
      const Solid solid(sample.triangles);
      const std::vector<PointLocation> locations = located(solid, sample.points);
      for (const auto& state : kStates) {
        std::unique_ptr<const Solid> built;
        std::vector<PointLocation> here(sample.points.size()), batch;
        bool left_as_found = false;
        {
          const Environment changed(state);
          built = std::make_unique<const Solid>(sample.triangles);
          for (std::size_t i = 0; i < sample.points.size(); ++i) here[i] = built->locate(sample.points[i]);
          batch = located(solid, sample.points);
          left_as_found = changed.left_as_found();
        }
        EXPECT_EQ(here, locations) << "sample " << index << ", " << state;
        EXPECT_EQ(batch, locations) << "sample " << index << ", " << state;
        EXPECT_TRUE(left_as_found) << state;
      }
    }
}

TEST(Solid, IsWhereTheWindingNumberIsNotZero) {
  const std::vector<Triangle> outer = cube(0, 8), inner = cube(2, 4), inner_turned = cube(2, 4, true);
  const Solid cavity(joined(outer, inner_turned)), twice(joined(outer, inner)), turned(cube(0, 8, true));
  EXPECT_EQ(at(cavity, 1), kInside);
  EXPECT_EQ(at(cavity, 2), kBoundary);
  EXPECT_EQ(at(cavity, 4), kOutside);
  EXPECT_EQ(at(twice, 4), kInside);
  EXPECT_EQ(at(twice, 2), kBoundary);
  EXPECT_EQ(at(turned, 4), kInside);
  EXPECT_EQ(at(turned, 9), kOutside);
  // A cube and its image turned inside out enclose nothing.
  const Solid nothing(joined(outer, cube(0, 8, true)));
  EXPECT_EQ(at(nothing, 4), kOutside);
  EXPECT_EQ(at(nothing, 8), kBoundary);
  // Cubes that cross.
  const Solid crossing(joined(outer, cube(4, 8)));
  for (const double x : {2, 6, 10}) EXPECT_EQ(at(crossing, x), kInside) << x;
  EXPECT_EQ(at(crossing, 8), kBoundary);
  EXPECT_EQ(at(crossing, 13), kOutside);
}

TEST(Solid, ReachesFromTheLeastToTheLargestDouble) {
  constexpr double least = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();
  const Solid tiny(cube(0, 2 * least)), huge(joined(cube(-largest, largest), cube(0, largest)));
  EXPECT_EQ(at(tiny, least), kInside);
  EXPECT_EQ(at(tiny, 0), kBoundary);
  EXPECT_EQ(at(tiny, -0.0), kBoundary);
  EXPECT_EQ(at(tiny, -least), kOutside);
  EXPECT_EQ(at(tiny, 3 * least), kOutside);
  EXPECT_EQ(at(huge, least), kInside);
  EXPECT_EQ(at(huge, -largest / 2), kInside);
  EXPECT_EQ(at(huge, largest), kBoundary);
  EXPECT_EQ(huge.locate({-1, -1, 1}), kOutside);
  EXPECT_EQ(huge.locate({-1, -1, 0}), kBoundary);
}

/// The message of what the constructor throws.
template <class Error>
std::string message(const std::vector<Triangle>& triangles) {
  try {
    const Solid solid(triangles, "part");
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Solid, NamesTheFirstEdgeThatIsOpen) {
  std::vector<Triangle> open = cube(0, 1);
  open.pop_back();
  std::pair<std::uint32_t, std::uint32_t> named;
  try {
    const Solid solid(open);
  } catch (const NotClosed& error) {
    named = {error.face(), error.edge()};
  }
  const auto corner = [](const Triangle& t, std::uint32_t i) { return i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c; };
  const auto runs_back = [&](std::uint32_t face, std::uint32_t edge) {
    for (const Triangle& t : open)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (corner(t, i) == corner(open[face], edge + 1) && corner(t, i + 1) == corner(open[face], edge)) return true;
    return false;
  };
  std::pair<std::uint32_t, std::uint32_t> first{0, 0};
  while (runs_back(first.first, first.second))
    first = first.second < 2 ? std::pair(first.first, first.second + 1) : std::pair(first.first + 1, 0U);
  EXPECT_EQ(named, first);
  EXPECT_EQ(message<NotClosed>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
            "object \"part\", face 0, edge 0: the faces are not closed: between its ends 1 edge runs this way and 0 "
            "back");
  std::vector<Triangle> turned = cube(0, 1);
  std::swap(turned[5].b, turned[5].c);
  EXPECT_NE(message<NotClosed>(turned).find("2 edges run this way and 0 back"), std::string::npos);
  // The same edge of another face is closed by the corner's other zero.
  std::vector<Triangle> zeros = cube(0, 1);
  for (double* x : {&zeros[0].a.x(), &zeros[3].b.y(), &zeros[7].c.z()})
    if (*x == 0) *x = -0.0;
  EXPECT_EQ(message<NotClosed>(zeros), "nothing was thrown");
}

TEST(Solid, RefusesWhatIsNoSurface) {
  EXPECT_EQ(message<std::invalid_argument>({}), "object \"part\" has no faces");
  std::vector<Triangle> flat = cube(0, 1);
  flat.push_back({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  EXPECT_NE(message<Rejected>(flat).find("object \"part\", face 12: "), std::string::npos);
  const Mesh squares{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}}};
  try {
    const Solid solid(squares, "part");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "object \"part\", face 0 has 4 vertices: the faces of a solid must be triangles");
  }
}

TEST(Solid, TouchesWhatReachesItsSurfaceOrIsInside) {
  for (const SolidKind kind : kSolidKinds)
    for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES; ++index) {
      const SolidSample sample = draw_solid(kind, 2028, index);
      const Solid solid(sample.triangles);
      const IntegerSolid expected(sample.triangles);
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector3d& point = sample.points[i];
        double distance = std::numeric_limits<double>::infinity();
        for (const Triangle& t : sample.triangles)
          distance = std::min(distance, exact::answer({point, 0}, Polygon({t.a, t.b, t.c})).distance);
        const bool inside = expected.locate(point) == kInside;
        const double given = solid.signed_distance(point);
        EXPECT_EQ(given, inside ? -distance : distance) << "sample " << index << ", point " << i;
        EXPECT_FALSE(given == 0 && std::signbit(given));
        if (!std::isfinite(distance)) continue;
        const double radius = i % 2 == 0 ? distance : distance / 2;
        bool touched = expected.locate(point) != kOutside;
        for (const Triangle& t : sample.triangles)
          touched = touched || exact::contact({point, radius}, Polygon({t.a, t.b, t.c}));
        EXPECT_EQ(solid.touches({point, radius}), touched) << "sample " << index << ", point " << i;
      }
    }
}

TEST(Solid, AnswersManyAsOne) {
  const SolidSample sample = draw_solid(SolidKind::Voxels, 2029, 1);
  const Solid solid(sample.triangles);
  std::vector<Ball> balls;
  for (const Vector3d& point : sample.points) balls.push_back({point, 0.25});
  const auto touches = std::make_unique<bool[]>(balls.size());
  std::vector<double> distances(balls.size());
  solid.touches(balls, std::span(touches.get(), balls.size()));
  solid.signed_distance(sample.points, distances);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(touches[i], solid.touches(balls[i]));
    EXPECT_EQ(distances[i], solid.signed_distance(sample.points[i]));
  }
  std::vector<PointLocation> too_few(balls.size() - 1);
  EXPECT_THROW(solid.locate(sample.points, too_few), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::scene_tests
