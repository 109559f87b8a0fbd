// SPDX-License-Identifier: GPL-3.0-or-later
// Balls with a squared radius: the answers are those of CGAL's exact kernel, and of exact::relation where they agree.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "bindings/cgal/cgal.h"
#include "experiments/cases/case.h"
#include "robust/exact/exact.h"

namespace touchstone::cgal {
namespace {

using K = CGAL::Epick;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

K::Point_3 of_cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
CGAL::Epeck::Point_3 exactly(const K::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Relation relation_of(CGAL::Comparison_result distance_to_radius) {
  if (distance_to_radius == CGAL::EQUAL) return Relation::Touching;
  return distance_to_radius == CGAL::LARGER ? Relation::Separate : Relation::Overlapping;
}

/// The squared radii at which an answer may change, and those beside them.
std::vector<double> hard_squares(const CGAL::Exact_rational& squared_distance, double radius) {
  std::vector<double> result{0};
  for (const double s : {CGAL::to_double(squared_distance), radius * radius})
    for (const double near : {std::nextafter(s, 0), s, std::nextafter(s, kInfinity)})
      if (std::isfinite(near)) result.push_back(near);
  return result;
}

/// Calls f(ball, polygon) for the valid polygons of the corpus whose balls are at a place.
template <class F>
void for_each_case(const F& f) {
  const std::filesystem::path corpus = std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "tests/corpus";
  std::vector<std::string> files;
  for (const auto& folder : {corpus, corpus / "floats"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".jsonl") files.push_back(entry.path().string());
  for (cases::LineReader reader(files); const auto line = reader.next_case();) {
    const auto* shapes = line->read ? std::get_if<cases::Shapes>(&line->read->content) : nullptr;
    if (shapes == nullptr || shapes->motion() != nullptr) continue;
    SCOPED_TRACE(line->place);
    f(shapes->ball(), shapes->polygon);
    if (testing::Test::HasFailure()) break;
  }
}

TEST(SquaredRadius, AgreesWithExactKernelOfCgalOnTrianglesOfCorpus) {
  std::array<int, 3> seen{};
  for_each_case([&](const Ball& ball, const Polygon& polygon) {
    if (polygon.vertex_count() != 3) return;
    const K::Point_3 center = of_cgal(ball.center);
    const K::Triangle_3 triangle(of_cgal(polygon.vertex(0)), of_cgal(polygon.vertex(1)), of_cgal(polygon.vertex(2)));
    const CGAL::Epeck::Triangle_3 exact_triangle(exactly(triangle[0]), exactly(triangle[1]), exactly(triangle[2]));
    const auto squared = CGAL::squared_distance(exactly(center), exact_triangle);
    EXPECT_EQ(CGAL::Epeck::FT(squared_distance(center, triangle)), squared);
    for (const double s : hard_squares(squared_distance(center, triangle), ball.radius)) {
      const K::Sphere_3 sphere(center, s);
      const Relation expected = relation_of(CGAL::compare(squared, CGAL::Epeck::FT(s)));
      EXPECT_EQ(relation(sphere, triangle), expected) << s;
      EXPECT_EQ(contact(sphere, triangle), expected != Relation::Separate) << s;
      // CGAL asks about the sphere without its inside.
      const CGAL::Epeck::Sphere_3 exact_sphere(exactly(center), s);
      EXPECT_EQ(contact(sphere, triangle),
                CGAL::do_intersect(exact_sphere, exact_triangle) || exact_sphere.has_on_bounded_side(exact_triangle[0]))
          << s;
      ++seen[static_cast<std::size_t>(expected)];
    }
  });
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(SquaredRadius, SquaredDistanceComparesWithRadiusAsExactRelationOnCorpus) {
  int off_plane = 0;
  for_each_case([&](const Ball& ball, const Polygon& polygon) {
    const PreparedPolygon prepared(polygon);
    const auto squared = squared_distance(of_cgal(ball.center), prepared);
    const CGAL::Exact_rational radius(ball.radius);
    EXPECT_EQ(relation_of(CGAL::compare(squared, radius * radius)), exact::relation(ball, polygon));
    for (const double s : hard_squares(squared, ball.radius)) {
      const K::Sphere_3 sphere(of_cgal(ball.center), s);
      const Relation expected = relation_of(CGAL::compare(squared, CGAL::Exact_rational(s)));
      EXPECT_EQ(relation(sphere, prepared), expected) << s;
      EXPECT_EQ(contact(sphere, prepared), expected != Relation::Separate) << s;
    }
    if (exact::answer(ball, polygon).off_plane > 0) ++off_plane;
  });
  EXPECT_GT(off_plane, 100);
}

TEST(SquaredRadius, TouchesWhereNoRadiusIsDouble) {
  const K::Triangle_3 triangle({1, 1, 1}, {3, 1, 1}, {1, 3, 1});
  const PreparedPolygon polygon(Polygon({{1, 1, 1}, {3, 1, 1}, {1, 3, 1}}));
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const auto relations = [&](double s) {
      std::fesetround(mode);
      const K::Sphere_3 sphere(CGAL::ORIGIN, s);
      const std::array result{relation(sphere, triangle), relation(sphere, polygon)};
      EXPECT_EQ(std::fegetround(), mode);
      std::fesetround(FE_TONEAREST);
      return result;
    };
    const auto both = [](Relation expected) { return std::array{expected, expected}; };
    EXPECT_EQ(relations(3), both(Relation::Touching));
    EXPECT_EQ(relations(std::nextafter(3, 0)), both(Relation::Separate));
    EXPECT_EQ(relations(std::nextafter(3, 4)), both(Relation::Overlapping));
  }
}

TEST(SquaredRadius, DegenerateTrianglesAreSegmentsAndPoints) {
  for (const Triangle& t : {Triangle{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, Triangle{{1, 1, 0}, {2, 2, 0}, {1, 1, 0}},
                            Triangle{{3, 3, 0}, {1, 1, 0}, {2, 2, 0}}}) {
    const K::Triangle_3 triangle(of_cgal(t.a), of_cgal(t.b), of_cgal(t.c));
    EXPECT_EQ(relation(K::Sphere_3(CGAL::ORIGIN, 2), triangle), Relation::Touching);
    EXPECT_EQ(relation(K::Sphere_3(K::Point_3(0, 0, 1), std::nextafter(3, 0)), triangle), Relation::Separate);
  }
}

TEST(SquaredRadius, BallIsThereIfAndOnlyIfRadiusIsDouble) {
  const auto radius = [](double s) {
    const auto found = ball(K::Sphere_3(K::Point_3(1, 2, 3), s));
    return found ? found->radius : -1;
  };
  for (const double r : {0.0, 1.0, 1.5, 0x1.8p-300, 0x1p511, 67108863.0}) EXPECT_EQ(radius(r * r), r);
  for (const double s : {2.0, 3.0, std::nextafter(4, 0), std::nextafter(4, 5), 1.5e-323, std::nextafter(0x1p-900, 1),
                         std::numeric_limits<double>::max()})
    EXPECT_EQ(radius(s), -1) << s;
}

TEST(SquaredRadius, RefusesWhatIsNoBall) {
  const auto code = [](double x, double s) {
    try {
      const K::Triangle_3 triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      (void)relation(K::Sphere_3(K::Point_3(x, 0, 0), s), triangle);
    } catch (const Rejected& rejected) {
      return to_string(rejected.rejection().code);
    }
    return std::string_view("none");
  };
  EXPECT_EQ(code(0, kInfinity), "not-finite");
  EXPECT_EQ(code(kInfinity, 1), "not-finite");
  EXPECT_EQ(code(0, 1), "none");
}

}  // namespace
}  // namespace touchstone::cgal
