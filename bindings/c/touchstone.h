/* SPDX-License-Identifier: Apache-2.0 */
/* Touchstone for C. <touchstone/touchstone.h> is for C++. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/// @file
/// Touchstone for C: whether a ball touches polygons, where, and when on its way. The answers are those of
/// `touchstone::filtered`, `touchstone::scene::Scene` and `touchstone::scene::Solid` in C++, as the contract defines
/// them (CONTRACT.md in the documentation), so exact. For C99 and later.
///
/// Guarantees, for all arguments that are NULL or point to what the function says:
///  (1) every answer has the bits of the one in C++;
///  (2) every function that can fail returns a status: TOUCHSTONE_OK if and only if it did what it says. No exception
///      leaves a function, and nothing is printed;
///  (3) every number is checked, except vertices that no face uses: a coordinate that is NaN or infinite, a negative
///      radius, and loops that bound no region are refused with the code of the contract, by a message that names the
///      loop and the vertex or edge. A batch is refused whole, by a message that names the first faulty element;
///  (4) a batch gives the answers of its elements alone, in their order, whatever the number of threads;
///  (5) after an error the objects in the arguments are as before, a handle that was to be made is NULL, and other
///      results mean nothing;
///  (6) several threads may ask one object at once. While one adds to a scene, moves or removes an object, or frees
///      what is asked, no other may use it;
///  (7) the caller's rounding mode, flush-to-zero setting and INVALID, OVERFLOW and DIVBYZERO flags are left as found.
///
/// Lengths are in the unit of the input. Vertices and points are three doubles each, one after the other. Arrays of
/// `count` elements may be NULL if count is 0. Enumerations are `int32_t` with the constants below, so that structures
/// have the same layout for every compiler; new constants may be added. Costs are those of C++, and a few ns to check;
/// a batch of several on fewer threads than cores costs 1 us more, and a single point of a solid 0.1 us.
/// The caller frees each handle once. Functions that free accept NULL.

/// The way in which a function ended. The first eight after TOUCHSTONE_OK are the contract's codes of rejection.
typedef int32_t touchstone_status;
enum {
  TOUCHSTONE_OK = 0,
  TOUCHSTONE_NOT_FINITE = 1,         ///< a number is NaN or infinite
  TOUCHSTONE_NEGATIVE_RADIUS = 2,    ///< r < 0
  TOUCHSTONE_TOO_FEW_VERTICES = 3,   ///< a loop has fewer than three vertices
  TOUCHSTONE_REPEATED_VERTEX = 4,    ///< two neighbouring vertices of a loop are equal
  TOUCHSTONE_ZERO_NORMAL = 5,        ///< the outer loop has no normal
  TOUCHSTONE_LOOP_MEETS_ITSELF = 6,  ///< a loop crosses or overlaps itself
  TOUCHSTONE_LOOPS_MEET = 7,         ///< two loops cross or overlap
  TOUCHSTONE_HOLE_OUTSIDE = 8,       ///< a hole is not inside the outer loop
  TOUCHSTONE_NOT_CLOSED = 16,        ///< the triangles of a solid are not closed
  TOUCHSTONE_INVALID_ARGUMENT = 17,  ///< NULL, a name that is taken, a vertex that a mesh does not have
  TOUCHSTONE_NO_SUCH_OBJECT = 18,    ///< no object of the scene has this number
  TOUCHSTONE_OUT_OF_MEMORY = 19,     ///< memory was refused
  TOUCHSTONE_INTERNAL_ERROR = 20     ///< the system refused a thread; else a defect of the library or its compilation
};

/// Why a function failed. It belongs to the caller, and a function that takes one writes to it, also on success. Pass
/// NULL if the status is enough.
typedef struct touchstone_error {
  touchstone_status status;  ///< what the function returned
  /// The sentence of the exception in C++, in UTF-8 and ending in 0; empty on success. One that is longer ends with
  /// "...", after a whole character, as that about an object with a name of 400 bytes.
  char message[508];
} touchstone_error;

/// Returns the word of a status, such as `zero-normal` or `out-of-memory`; `unknown` for other numbers.
const char *touchstone_status_name(touchstone_status status);
const char *touchstone_version(void);  ///< returns the version of the library, such as `0.3.0`

/// A closed ball. A radius of 0 makes it a point.
typedef struct touchstone_ball {
  double center[3];  ///< c
  double radius;     ///< r
} touchstone_ball;

/// A ball whose centre moves along a segment, at time t in [0, 1] to center + t (to - center).
typedef struct touchstone_motion {
  touchstone_ball ball;  ///< at t = 0
  double to[3];          ///< the centre at t = 1
} touchstone_motion;

/// A triangle. One whose vertices lie on a line is the segment or the point that they span.
typedef struct touchstone_triangle {
  double vertices[3][3];  ///< vertex 0, 1 and 2
} touchstone_triangle;

/// Rotation and translation: the point p of an object lies at R p + t, each coordinate rounded once.
typedef struct touchstone_pose {
  double rotation[3][3];  ///< R, row by row
  double translation[3];  ///< t
} touchstone_pose;

/// Triangles that share vertices, or, with corners = NULL, triangles that follow each other in `vertices`.
typedef struct touchstone_mesh {
  const double *vertices;   ///< 3 * vertex_count numbers
  size_t vertex_count;      ///< 3 * triangle_count if corners is NULL
  const uint32_t *corners;  ///< 3 * triangle_count vertex numbers, from 0; or NULL
  size_t triangle_count;    ///< the number of faces
} touchstone_mesh;

/// A side of the supporting plane on which a ball lies. One that touches the plane intersects it.
enum { TOUCHSTONE_IN_FRONT = 0, TOUCHSTONE_BEHIND = 1, TOUCHSTONE_INTERSECTS = 2 };
enum { TOUCHSTONE_INSIDE = 0, TOUCHSTONE_BOUNDARY = 1, TOUCHSTONE_OUTSIDE = 2 };  ///< where a point is
/// The distance against the radius: greater, equal, less.
enum { TOUCHSTONE_SEPARATE = 0, TOUCHSTONE_TOUCHING = 1, TOUCHSTONE_OVERLAPPING = 2 };
enum { TOUCHSTONE_FACE = 0, TOUCHSTONE_EDGE = 1, TOUCHSTONE_VERTEX = 2 };  ///< kinds of features
/// When a moving ball first touches: at t = 0, later on its way, or never.
enum { TOUCHSTONE_AT_START = 0, TOUCHSTONE_ON_WAY = 1, TOUCHSTONE_NEVER = 2 };
/// Stands for no object and no face.
#define TOUCHSTONE_NONE UINT32_MAX

/// The face, an edge or a vertex. Edges and vertices are numbered through all loops; edge i starts at vertex i.
typedef struct touchstone_feature {
  uint64_t index;    ///< 0 for the face
  int32_t kind;      ///< TOUCHSTONE_FACE, _EDGE or _VERTEX
  int32_t reserved;  ///< 0
} touchstone_feature;

/// The full answer about a ball and a polygon, except the edges that are hit.
typedef struct touchstone_answer {
  int32_t plane;               ///< TOUCHSTONE_IN_FRONT, _BEHIND or _INTERSECTS
  int32_t plane_tangent;       ///< 1 if the plane touches the ball in one point, else 0
  int32_t foot;                ///< TOUCHSTONE_INSIDE, _BOUNDARY or _OUTSIDE
  int32_t relation;            ///< TOUCHSTONE_SEPARATE, _TOUCHING or _OVERLAPPING
  touchstone_feature nearest;  ///< the feature that contains the closest point
  double point[3];             ///< the closest point of the polygon
  double distance;             ///< from the centre to the polygon
  double contact_normal[3];    ///< of length 1, from `point` to the centre, or to the front if they are equal
  double depth;                ///< the radius less the distance
  double off_plane;            ///< the largest move of a vertex onto the supporting plane; 0 for planar loops
} touchstone_answer;

/// The point of a triangle that is closest to a centre.
typedef struct touchstone_closest_point {
  touchstone_feature feature;  ///< contains that point
  double point[3];             ///< as in touchstone_answer
  double distance;             ///< as in touchstone_answer
  double contact_normal[3];    ///< as in touchstone_answer; 0 where the centre is on a triangle without a front
} touchstone_closest_point;

/// The first contact of a moving ball. For TOUCHSTONE_NEVER time is infinite and all other members are 0.
typedef struct touchstone_first_contact {
  int32_t kind;                ///< TOUCHSTONE_AT_START, _ON_WAY or _NEVER
  int32_t momentary;           ///< 1 if the ball, on its way, leaves again at once, else 0
  double time;                 ///< the least t at which the ball touches
  touchstone_feature feature;  ///< contains the closest point at that time
  double point[3];             ///< the closest point at that time
  double contact_normal[3];    ///< at that time
  double depth;                ///< at the start
} touchstone_first_contact;

/// A face of an object of a scene; lower by object, then by face. Both are TOUCHSTONE_NONE where there is none.
typedef struct touchstone_face_id {
  uint32_t object;  ///< its number in the scene
  uint32_t face;    ///< its number in the object
} touchstone_face_id;

/// The face of a scene nearest to a ball's centre. Without any face, distance is infinite, depth is minus infinity, and
/// all other members after `face` are 0.
typedef struct touchstone_nearest_face {
  touchstone_face_id face;     ///< the lowest of several at the same distance
  touchstone_feature feature;  ///< contains the closest point
  double point[3];             ///< as in touchstone_answer
  double distance;             ///< as in touchstone_answer
  double contact_normal[3];    ///< as in touchstone_answer
  double depth;                ///< as in touchstone_answer
} touchstone_nearest_face;

/// The face of a scene that a moving ball touches first.
typedef struct touchstone_first_face {
  touchstone_face_id face;           ///< the lowest of several that are touched at the same time
  touchstone_first_contact contact;  ///< with that face
} touchstone_first_face;

// Polygons

/// A valid polygon, prepared for questions.
typedef struct touchstone_polygon touchstone_polygon;

/// Makes a polygon of loop_count loops, of which loop i has loop_sizes[i] vertices: first the outer loop, then the
/// holes. They may run either way, need not be convex, and do not repeat their first vertex at the end. Vertices are
/// numbered from 0 through all loops. Those off the supporting plane are lifted onto it, as the contract says;
/// `off_plane` of an answer tells by how much. Fails with a code of rejection.
touchstone_status touchstone_polygon_create(const double *vertices, const size_t *loop_sizes, size_t loop_count,
                                            touchstone_polygon **polygon, touchstone_error *error);
void touchstone_polygon_free(touchstone_polygon *polygon);  ///< frees it
/// Precomputes what questions would otherwise build on demand, for a caller with little time later.
touchstone_status touchstone_polygon_complete(const touchstone_polygon *polygon, touchstone_error *error);

/// Writes to touches[i] whether balls[i] touches the polygon.
touchstone_status touchstone_polygon_contact(const touchstone_polygon *polygon, const touchstone_ball *balls,
                                             size_t count, bool *touches, touchstone_error *error);
/// Writes to answers[i] the full answer about balls[i].
touchstone_status touchstone_polygon_answer(const touchstone_polygon *polygon, const touchstone_ball *balls,
                                            size_t count, touchstone_answer *answers, touchstone_error *error);
/// Writes to *count how many edges the ball hits, and to `edges` the first `capacity` of them, ascending. With as much
/// capacity as the polygon has vertices all are written; with a capacity of 0 `edges` may be NULL.
touchstone_status touchstone_polygon_edges_hit(const touchstone_polygon *polygon, const touchstone_ball *ball,
                                               uint64_t *edges, size_t capacity, size_t *count,
                                               touchstone_error *error);
/// Writes to contacts[i] the first contact of motions[i].
touchstone_status touchstone_polygon_first_contact(const touchstone_polygon *polygon, const touchstone_motion *motions,
                                                   size_t count, touchstone_first_contact *contacts,
                                                   touchstone_error *error);

// Triangles, which need no preparation and may be degenerate

/// Writes to touches[i] whether the ball touches triangles[i].
touchstone_status touchstone_triangles_contact(const touchstone_ball *ball, const touchstone_triangle *triangles,
                                               size_t count, bool *touches, touchstone_error *error);
/// Writes to points[i] the point of triangles[i] closest to the centre, which is three numbers.
touchstone_status touchstone_triangles_closest(const double *center, const touchstone_triangle *triangles, size_t count,
                                               touchstone_closest_point *points, touchstone_error *error);
/// Writes to contacts[i] the first contact of the moving ball with triangles[i].
touchstone_status touchstone_triangles_first_contact(const touchstone_motion *motion,
                                                     const touchstone_triangle *triangles, size_t count,
                                                     touchstone_first_contact *contacts, touchstone_error *error);

// Scenes

/// Named objects of many faces, each under a pose. The faces are a surface: a ball inside touches nothing.
typedef struct touchstone_scene touchstone_scene;

/// How triangles are taken whose vertices lie on a line: refused, or as segments and points.
enum { TOUCHSTONE_REFUSE_DEGENERATE = 0, TOUCHSTONE_DEGENERATE_AS_SEGMENTS = 1 };

/// The faces of an object, numbered together from 0: first the triangles, then the polygons. All are copied.
typedef struct touchstone_faces {
  touchstone_mesh triangles;                  ///< may be of 0 triangles
  const touchstone_polygon *const *polygons;  ///< may be NULL if there are none
  size_t polygon_count;                       ///< the number of polygons
  int32_t degenerate;                         ///< TOUCHSTONE_REFUSE_DEGENERATE or TOUCHSTONE_DEGENERATE_AS_SEGMENTS
} touchstone_faces;

/// How a scene is asked. NULL instead of one: about all objects, on all cores.
typedef struct touchstone_scene_options {
  const uint32_t *objects;  ///< the numbers of the objects that take part; NULL for all
  size_t object_count;      ///< 0 if objects is NULL
  uint32_t threads;         ///< a batch runs on at most this many; 0 for all cores of the machine
} touchstone_scene_options;

touchstone_status touchstone_scene_create(touchstone_scene **scene, touchstone_error *error);  ///< without objects
void touchstone_scene_free(touchstone_scene *scene);                                           ///< frees it

/// Adds an object under a pose, NULL for the identity, and writes its number to *object: 0, 1 and so on. Fails with
/// TOUCHSTONE_INVALID_ARGUMENT if the name is taken, and with a code of rejection, by a message that names the object
/// and the face, for a face that is not valid as given or as posed. `name` is UTF-8.
touchstone_status touchstone_scene_add(touchstone_scene *scene, const char *name, const touchstone_faces *faces,
                                       const touchstone_pose *pose, uint32_t *object, touchstone_error *error);
/// Removes an object. Its number is not given again, and its name is free.
touchstone_status touchstone_scene_remove(touchstone_scene *scene, uint32_t object, touchstone_error *error);
/// Sets the pose of an object. Its vertices are computed from those that were added, so errors do not accumulate.
touchstone_status touchstone_scene_set_pose(touchstone_scene *scene, uint32_t object, const touchstone_pose *pose,
                                            touchstone_error *error);

/// Writes to touches[i] whether balls[i] touches any face.
touchstone_status touchstone_scene_touches(const touchstone_scene *scene, const touchstone_ball *balls, size_t count,
                                           const touchstone_scene_options *options, bool *touches,
                                           touchstone_error *error);
/// Writes to faces[i] the face nearest to the centre of balls[i], and its closest point.
touchstone_status touchstone_scene_nearest(const touchstone_scene *scene, const touchstone_ball *balls, size_t count,
                                           const touchstone_scene_options *options, touchstone_nearest_face *faces,
                                           touchstone_error *error);
/// Writes to faces[i] the face that motions[i] touches first.
touchstone_status touchstone_scene_first_contact(const touchstone_scene *scene, const touchstone_motion *motions,
                                                 size_t count, const touchstone_scene_options *options,
                                                 touchstone_first_face *faces, touchstone_error *error);

/// A list of faces for each ball of a batch, with all lists in one array.
typedef struct touchstone_face_lists touchstone_face_lists;

/// Makes the lists of the faces that each ball touches, ascending by object and face.
touchstone_status touchstone_scene_touched(const touchstone_scene *scene, const touchstone_ball *balls, size_t count,
                                           const touchstone_scene_options *options, touchstone_face_lists **lists,
                                           touchstone_error *error);
/// Returns count + 1 numbers: list i has the elements offsets[i] to offsets[i + 1] - 1 of the array. NULL for NULL.
const uint64_t *touchstone_face_lists_offsets(const touchstone_face_lists *lists);
/// Returns the faces of all lists. NULL for NULL, and perhaps if all lists are empty.
const touchstone_face_id *touchstone_face_lists_faces(const touchstone_face_lists *lists);
void touchstone_face_lists_free(touchstone_face_lists *lists);  ///< frees it

// Solids

/// The solid that closed triangles bound, together with them.
typedef struct touchstone_solid touchstone_solid;

/// Makes the solid of these triangles; vertices need not be shared. Fails with TOUCHSTONE_NOT_CLOSED, by a message that
/// names the first face with an edge that too few edges run back, and with a code of rejection.
touchstone_status touchstone_solid_create(const touchstone_mesh *triangles, touchstone_solid **solid,
                                          touchstone_error *error);
void touchstone_solid_free(touchstone_solid *solid);  ///< frees it

/// Writes to locations[i] TOUCHSTONE_INSIDE, _BOUNDARY or _OUTSIDE. Threads as in touchstone_scene_options.
touchstone_status touchstone_solid_locate(const touchstone_solid *solid, const double *points, size_t count,
                                          uint32_t threads, int32_t *locations, touchstone_error *error);
/// Writes to touches[i] whether balls[i] touches the solid: a triangle, or by its centre inside.
touchstone_status touchstone_solid_touches(const touchstone_solid *solid, const touchstone_ball *balls, size_t count,
                                           uint32_t threads, bool *touches, touchstone_error *error);
/// Writes to distances[i] the distance of point i from the surface, negative inside, +0 if it rounds to 0.
touchstone_status touchstone_solid_signed_distance(const touchstone_solid *solid, const double *points, size_t count,
                                                   uint32_t threads, double *distances, touchstone_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
