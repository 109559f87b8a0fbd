// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons with holes in a plane, and the faces of graphs as objects of scenes.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/cgal/cgal.h"
#include "robust/scene/posing.h"

namespace touchstone::cgal {
namespace {

using K = CGAL::Epick;
using SurfaceMesh = CGAL::Surface_mesh<K::Point_3>;

CGAL::Polygon_with_holes_2<K> frame() {
  const std::vector<K::Point_2> outer{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}};
  CGAL::Polygon_with_holes_2<K> result(CGAL::Polygon_2<K>(outer.begin(), outer.end()));
  result.add_hole(CGAL::Polygon_2<K>(hole.begin(), hole.end()));
  return result;
}

TEST(CgalShapes, PolygonWithHolesHasThePointsThatTheLiftGives) {
  const Loop outer{{0, 0, 7}, {4, 0, 7}, {4, 4, 7}, {0, 4, 7}}, hole{{1, 1, 7}, {1, 3, 7}, {3, 3, 7}, {3, 1, 7}};
  EXPECT_EQ(polygon(frame(), [](const K::Point_2& p) { return K::Point_3(p.x(), p.y(), 7); }), Polygon(outer, {hole}));
  const K::Plane_3 plane(0, 0, 1, -7);
  const Polygon in_plane = polygon(frame(), plane);
  ASSERT_EQ(in_plane.vertex_count(), 8U);
  EXPECT_EQ(in_plane.loop_count(), 2U);
  EXPECT_EQ(in_plane.vertex(4), point(plane.to_3d(K::Point_2(1, 1))));
}

TEST(CgalShapes, BallInTheHoleTouchesByItsSquaredRadius) {
  const PreparedPolygon prepared(polygon(frame(), [](const K::Point_2& p) { return K::Point_3(p.x(), p.y(), 7); }));
  // From (2, 2, 8) to the hole's edges: 1 + 1 = 2, whose root is irrational.
  const K::Point_3 center(2, 2, 8);
  EXPECT_EQ(relation(K::Sphere_3(center, 2), prepared), Relation::Touching);
  EXPECT_FALSE(contact(K::Sphere_3(center, std::nextafter(2, 0)), prepared));
}

TEST(CgalShapes, PolygonWithoutOuterBoundaryIsRejected) {
  const CGAL::Polygon_with_holes_2<K> unbounded;
  EXPECT_THROW((void)polygon(unbounded, K::Plane_3(0, 0, 1, 0)), Rejected);
}

/// A roof: a quadrilateral and two triangles, with a removed face among them.
struct Roof {
  SurfaceMesh mesh;
  SurfaceMesh::Face_index square, left, right;

  Roof() {
    std::vector<SurfaceMesh::Vertex_index> v;
    for (const K::Point_3& p : {K::Point_3(9, 9, 9), K::Point_3(0, 0, 0), K::Point_3(1, 0, 0), K::Point_3(1, 1, 0),
                                K::Point_3(0, 1, 0), K::Point_3(0.5, 0, 1), K::Point_3(0.5, 1, 1)})
      v.push_back(mesh.add_vertex(p));
    mesh.remove_vertex(v[0]);
    square = mesh.add_face(v[1], v[2], v[3], v[4]);
    const auto removed = mesh.add_face(v[3], v[2], v[6]);
    left = mesh.add_face(v[1], v[4], v[5]);
    CGAL::Euler::remove_face(halfedge(removed, mesh), mesh);
    right = mesh.add_face(v[3], v[2], v[5]);
  }
};

TEST(CgalShapes, TouchedFacesOfASceneAreFacesOfTheGraph) {
  Roof roof;
  scene::Scene scene;
  scene.add("other", {{Triangle{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}}}, {}});
  const auto added = add(scene, "roof", roof.mesh, roof.mesh.points());
  EXPECT_EQ(added.object, scene.find("roof"));
  ASSERT_EQ(added.faces.size(), 3U);
  const auto touched_at = [&](const Eigen::Vector3d& center, double r) {
    std::vector<SurfaceMesh::Face_index> result;
    for (const scene::FaceId& id : scene.touched(Ball{center, r})) {
      EXPECT_EQ(id.object, added.object);
      result.push_back(added.faces[id.face]);
    }
    return result;
  };
  EXPECT_EQ(touched_at({0.5, 0.5, 0}, 0.125), std::vector{roof.square});
  for (const auto face : {roof.square, roof.left, roof.right}) {
    // A ball at the middle of three corners of a face touches it.
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    int corners = 0;
    for (const auto v : CGAL::vertices_around_face(roof.mesh.halfedge(face), roof.mesh)) {
      middle += point(roof.mesh.point(v));
      ++corners;
    }
    EXPECT_EQ(touched_at(middle / corners, 0x1p-20), std::vector{face});
  }
}

TEST(CgalShapes, PoseMovesTheGraph) {
  const Roof roof;
  scene::Scene scene;
  Pose pose;
  pose.translation = {0, 0, 100};
  add(scene, "roof", roof.mesh, roof.mesh.points(), pose);
  EXPECT_FALSE(scene.touches(Ball{{0.5, 0.5, 0}, 0.125}));
  EXPECT_TRUE(scene.touches(Ball{{0.5, 0.5, 100}, 0.125}));
}

TEST(CgalShapes, AnyFaceGraphWillDo) {
  CGAL::Polyhedron_3<K> tetrahedron;
  tetrahedron.make_tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  scene::Scene scene;
  const auto added = add(scene, "tetrahedron", tetrahedron, get(CGAL::vertex_point, tetrahedron));
  ASSERT_EQ(added.faces.size(), 4U);
  const auto nearest = scene.nearest(Ball{{1, 1, 1}, 0});
  ASSERT_TRUE(nearest.has_value());
  // The slanted face alone lacks the corner at the origin.
  for (const auto v : CGAL::vertices_around_face(added.faces[nearest->face.face]->halfedge(), tetrahedron))
    EXPECT_NE(v->point(), K::Point_3(0, 0, 0));
}

TEST(CgalShapes, RefusesAFaceThatItNamesAndLeavesTheSceneAlone) {
  Roof roof;
  roof.mesh.point(target(roof.mesh.halfedge(roof.left), roof.mesh)) =
      roof.mesh.point(source(roof.mesh.halfedge(roof.left), roof.mesh));
  scene::Scene scene;
  try {
    add(scene, "roof", roof.mesh, roof.mesh.points());
    ADD_FAILURE();
  } catch (const Rejected& rejected) {
    EXPECT_NE(std::string(rejected.what()).find("face "), std::string::npos) << rejected.what();
  }
  EXPECT_EQ(scene.object_count(), 0U);
}

/// Heights over a lattice of 7 by 7 points: level squares, and pairs of triangles where corners are at other heights.
SurfaceMesh landscape() {
  SurfaceMesh mesh;
  for (int i = 0; i < 49; ++i) mesh.add_vertex({i / 7, i % 7, (i / 7) < 3 ? 0 : (i * i) % 5});
  for (unsigned i = 0; i < 42; ++i) {
    if (i % 7 == 6) continue;
    const SurfaceMesh::Vertex_index a(i), b(i + 7), c(i + 8), d(i + 1);
    if (i < 14) {
      mesh.add_face(a, b, c, d);
    } else {
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
  }
  return mesh;
}

/// Returns the square of the distance from the point to the convex planar face under the pose, by CGAL's exact kernel.
CGAL::Epeck::FT exact_squared_distance(const K::Point_3& from, const SurfaceMesh& mesh, SurfaceMesh::Face_index face,
                                       const Pose& pose) {
  const auto exactly = [](const Eigen::Vector3d& p) { return CGAL::Epeck::Point_3(p.x(), p.y(), p.z()); };
  std::vector<CGAL::Epeck::Point_3> corners;
  for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    corners.push_back(exactly(scene::posed(pose, point(mesh.point(v)))));
  std::optional<CGAL::Epeck::FT> least;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const CGAL::Epeck::Triangle_3 part(corners[0], corners[i - 1], corners[i]);
    const CGAL::Epeck::FT squared = CGAL::squared_distance(exactly(point(from)), part);
    if (!least || squared < *least) least = squared;
  }
  return *least;
}

TEST(CgalShapes, FacesTouchedByASquaredRadiusAreThoseOfCgalsExactKernel) {
  const SurfaceMesh mesh = landscape();
  Pose turned;  // two thirds, rounded: the vertices are rounded, so that no face has a level plane
  turned.rotation << 2 / 3.0, -1 / 3.0, 2 / 3.0, 2 / 3.0, 2 / 3.0, -1 / 3.0, -1 / 3.0, 2 / 3.0, 2 / 3.0;
  turned.translation = {0.1, 0.2, 0.3};
  int between = 0;
  for (const bool posed : {false, true}) {
    scene::Scene scene;
    scene.add("other", {{Triangle{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}}, {}});
    SurfaceMesh used = mesh;
    if (posed)  // rounding bends squares
      for (const auto face : mesh.faces())
        if (mesh.degree(face) == 4)
          CGAL::Euler::split_face(used.halfedge(face), used.next(used.next(used.halfedge(face))), used);
    const Pose pose = posed ? turned : Pose();
    const auto added = add(scene, "landscape", used, used.points(), pose);
    for (const K::Point_3& center :
         {K::Point_3(1, 1, 1), K::Point_3(2.5, 1.5, 1), K::Point_3(4, 4, 7), K::Point_3(3, 2, 5)}) {
      std::vector<CGAL::Epeck::FT> squared;
      for (const auto face : added.faces) squared.push_back(exact_squared_distance(center, used, face, pose));
      for (const CGAL::Epeck::FT& of_face : squared) {
        const double s = CGAL::to_double(of_face);
        for (const double near :
             {std::nextafter(s, 0), s, std::nextafter(s, std::numeric_limits<double>::infinity())}) {
          std::vector<SurfaceMesh::Face_index> expected;
          for (std::size_t i = 0; i < squared.size(); ++i)
            if (squared[i] <= near) expected.push_back(added.faces[i]);
          const K::Sphere_3 sphere(center, near);
          EXPECT_EQ(touched(sphere, scene, added, used, used.points()), expected) << center << ", " << near;
          EXPECT_EQ(touches(sphere, scene, added, used, used.points()), !expected.empty()) << center << ", " << near;
          if (!ball(sphere)) ++between;
        }
      }
    }
  }
  EXPECT_GT(between, 500);
}

TEST(CgalShapes, GraphThatWasRemovedFromItsSceneIsRefused) {
  const Roof roof;
  scene::Scene scene;
  const auto added = add(scene, "roof", roof.mesh, roof.mesh.points());
  scene.remove(added.object);
  for (const double s : {1.0, 2.0})
    EXPECT_THROW((void)touched(K::Sphere_3(CGAL::ORIGIN, s), scene, added, roof.mesh, roof.mesh.points()),
                 std::out_of_range);
  EXPECT_THROW((void)touches(K::Sphere_3(CGAL::ORIGIN, std::numeric_limits<double>::infinity()), scene, added,
                             roof.mesh, roof.mesh.points()),
               Rejected);
}

}  // namespace
}  // namespace touchstone::cgal
