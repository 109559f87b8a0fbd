// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons with holes in a plane, and the faces of graphs as objects of scenes.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bindings/cgal/cgal.h"

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

}  // namespace
}  // namespace touchstone::cgal
