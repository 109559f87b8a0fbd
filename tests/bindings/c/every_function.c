/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls every function of touchstone.h from C99 and C11. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone.h>

/* The layouts on which other languages rely. */
#define SIZE(type, bytes) typedef char size_of_##type[sizeof(type) == (bytes) ? 1 : -1]
#define OFFSET(type, member, bytes) typedef char at_##type##_##member[offsetof(type, member) == (bytes) ? 1 : -1]
SIZE(touchstone_status, 4);
SIZE(touchstone_error, 512);
OFFSET(touchstone_error, message, 4);
SIZE(touchstone_ball, 32);
OFFSET(touchstone_ball, radius, 24);
SIZE(touchstone_motion, 56);
OFFSET(touchstone_motion, to, 32);
SIZE(touchstone_triangle, 72);
SIZE(touchstone_pose, 96);
OFFSET(touchstone_pose, translation, 72);
SIZE(touchstone_feature, 16);
OFFSET(touchstone_feature, kind, 8);
SIZE(touchstone_answer, 104);
OFFSET(touchstone_answer, plane_tangent, 4);
OFFSET(touchstone_answer, foot, 8);
OFFSET(touchstone_answer, relation, 12);
OFFSET(touchstone_answer, nearest, 16);
OFFSET(touchstone_answer, point, 32);
OFFSET(touchstone_answer, distance, 56);
OFFSET(touchstone_answer, contact_normal, 64);
OFFSET(touchstone_answer, depth, 88);
OFFSET(touchstone_answer, off_plane, 96);
SIZE(touchstone_closest_point, 72);
OFFSET(touchstone_closest_point, contact_normal, 48);
SIZE(touchstone_first_contact, 88);
OFFSET(touchstone_first_contact, time, 8);
OFFSET(touchstone_first_contact, feature, 16);
OFFSET(touchstone_first_contact, point, 32);
OFFSET(touchstone_first_contact, contact_normal, 56);
OFFSET(touchstone_first_contact, depth, 80);
SIZE(touchstone_face_id, 8);
SIZE(touchstone_nearest_face, 88);
OFFSET(touchstone_nearest_face, feature, 8);
OFFSET(touchstone_nearest_face, distance, 48);
SIZE(touchstone_first_face, 96);

static touchstone_error error;
static int faults = 0;

static void expect(int holds, const char *what, int line) {
  if (holds) return;
  printf("line %d: not so: %s (%s)\n", line, what, error.message);
  ++faults;
}
#define EXPECT(condition) expect((condition), #condition, __LINE__)
#define EXPECT_OK(call) expect((call) == TOUCHSTONE_OK && error.status == TOUCHSTONE_OK, #call, __LINE__)

static const double square[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0};
static const touchstone_ball balls[] = {{{1, 1, 1}, 1}, {{6, 2, 0}, 1}};
static const touchstone_motion motions[] = {{{{1, 1, 3}, 1}, {1, 1, -3}}, {{{6, 2, 0}, 1}, {7, 2, 0}}};

static touchstone_polygon *ask_polygon(void) {
  const size_t size = 4;
  touchstone_polygon *polygon;
  bool touches[2];
  touchstone_answer answers[2];
  touchstone_first_contact contacts[2];
  uint64_t edges[4];
  size_t count;
  EXPECT_OK(touchstone_polygon_create(square, &size, 1, &polygon, &error));
  EXPECT_OK(touchstone_polygon_complete(polygon, &error));
  EXPECT_OK(touchstone_polygon_contact(polygon, balls, 2, touches, &error));
  EXPECT(touches[0] && !touches[1]);
  EXPECT_OK(touchstone_polygon_answer(polygon, balls, 2, answers, &error));
  EXPECT(answers[0].relation == TOUCHSTONE_TOUCHING && answers[1].relation == TOUCHSTONE_SEPARATE);
  EXPECT(answers[0].plane == TOUCHSTONE_INTERSECTS && answers[0].plane_tangent == 1);
  EXPECT(answers[0].foot == TOUCHSTONE_INSIDE && answers[0].nearest.kind == TOUCHSTONE_FACE);
  EXPECT(answers[1].nearest.kind == TOUCHSTONE_EDGE && answers[1].nearest.index == 1 && answers[1].distance == 2);
  EXPECT(answers[1].point[0] == 4 && answers[1].contact_normal[0] == 1 && answers[1].depth == -1);
  EXPECT_OK(touchstone_polygon_edges_hit(polygon, balls, edges, 4, &count, &error));
  EXPECT(count == 0);
  EXPECT_OK(touchstone_polygon_first_contact(polygon, motions, 2, contacts, &error));
  EXPECT(contacts[0].kind == TOUCHSTONE_ON_WAY && contacts[0].time == 1.0 / 3 && contacts[0].momentary == 0);
  EXPECT(contacts[1].kind == TOUCHSTONE_NEVER && isinf(contacts[1].time));
  return polygon;
}

static void ask_triangles(void) {
  const touchstone_triangle triangle = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  bool touches;
  touchstone_closest_point closest;
  touchstone_first_contact contact;
  EXPECT_OK(touchstone_triangles_contact(&balls[0], &triangle, 1, &touches, &error));
  EXPECT(touches);
  EXPECT_OK(touchstone_triangles_closest(balls[0].center, &triangle, 1, &closest, &error));
  EXPECT(closest.distance == 1 && closest.point[0] == 1 && closest.contact_normal[2] == 1);
  EXPECT_OK(touchstone_triangles_first_contact(&motions[0], &triangle, 1, &contact, &error));
  EXPECT(contact.kind == TOUCHSTONE_ON_WAY && contact.time == 1.0 / 3);
}

static void ask_scene(const touchstone_polygon *polygon) {
  const uint32_t corners[] = {0, 1, 2, 0, 2, 3};
  const touchstone_pose lifted = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 2}};
  const touchstone_scene_options one_thread = {NULL, 0, 1};
  const touchstone_polygon *const polygons[] = {polygon};
  touchstone_faces faces;
  touchstone_scene *scene;
  touchstone_nearest_face nearest[2];
  touchstone_first_face first[2];
  touchstone_face_lists *lists;
  uint32_t object;
  bool touches[2];
  memset(&faces, 0, sizeof faces);
  faces.triangles.vertices = square;
  faces.triangles.vertex_count = 4;
  faces.triangles.corners = corners;
  faces.triangles.triangle_count = 2;
  faces.polygons = polygons;
  faces.polygon_count = 1;
  EXPECT_OK(touchstone_scene_create(&scene, &error));
  EXPECT_OK(touchstone_scene_add(scene, "table", &faces, NULL, &object, &error));
  EXPECT(object == 0);
  EXPECT_OK(touchstone_scene_add(scene, "lid", &faces, NULL, &object, &error));
  EXPECT_OK(touchstone_scene_set_pose(scene, 1, &lifted, &error));
  EXPECT(object == 1);
  EXPECT_OK(touchstone_scene_touches(scene, balls, 2, &one_thread, touches, &error));
  EXPECT(touches[0] && !touches[1]);
  EXPECT_OK(touchstone_scene_nearest(scene, balls, 2, NULL, nearest, &error));
  EXPECT(nearest[0].face.object == 0 && nearest[0].distance == 1 && nearest[1].distance == 2);
  EXPECT_OK(touchstone_scene_first_contact(scene, motions, 2, NULL, first, &error));
  EXPECT(first[0].face.object == 1 && first[0].contact.kind == TOUCHSTONE_AT_START);
  EXPECT(first[1].face.object == TOUCHSTONE_NONE && first[1].contact.kind == TOUCHSTONE_NEVER);
  EXPECT_OK(touchstone_scene_touched(scene, balls, 2, NULL, &lists, &error));
  EXPECT(touchstone_face_lists_offsets(lists)[2] > 0 && touchstone_face_lists_faces(lists)[0].object == 0);
  touchstone_face_lists_free(lists);
  EXPECT_OK(touchstone_scene_remove(scene, 0, &error));
  EXPECT(touchstone_scene_remove(scene, 0, &error) == TOUCHSTONE_NO_SUCH_OBJECT && error.message[0] != '\0');
  touchstone_scene_free(scene);
}

static void ask_solid(void) {
  const double vertices[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4};
  const uint32_t corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const double points[] = {0.5, 1, 1, 2, 1, 1, 3, 1, 1};
  touchstone_mesh mesh;
  touchstone_solid *solid;
  int32_t locations[3];
  double distances[3];
  bool touches[2];
  mesh.vertices = vertices;
  mesh.vertex_count = 4;
  mesh.corners = corners;
  mesh.triangle_count = 4;
  EXPECT_OK(touchstone_solid_create(&mesh, &solid, &error));
  EXPECT_OK(touchstone_solid_locate(solid, points, 3, 0, locations, &error));
  EXPECT(locations[0] == TOUCHSTONE_INSIDE && locations[1] == TOUCHSTONE_BOUNDARY && locations[2] == TOUCHSTONE_OUTSIDE);
  EXPECT_OK(touchstone_solid_signed_distance(solid, points, 3, 1, distances, &error));
  EXPECT(distances[0] == -0.5 && distances[1] == 0 && distances[2] > 0);
  EXPECT_OK(touchstone_solid_touches(solid, balls, 2, 0, touches, &error));
  EXPECT(touches[0] && !touches[1]);
  touchstone_solid_free(solid);
  mesh.triangle_count = 3;
  EXPECT(touchstone_solid_create(&mesh, &solid, &error) == TOUCHSTONE_NOT_CLOSED && solid == NULL);
  EXPECT(strcmp(touchstone_status_name(error.status), "not-closed") == 0);
}

int main(void) {
  touchstone_polygon *polygon = ask_polygon();
  ask_triangles();
  ask_scene(polygon);
  touchstone_polygon_free(polygon);
  ask_solid();
  printf("touchstone %s: %d faults\n", touchstone_version(), faults);
  return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
