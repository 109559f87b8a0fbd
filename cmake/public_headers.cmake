# SPDX-License-Identifier: Apache-2.0
# The front door: the headers <touchstone/NAME.h> that users include. Each is written into the build folder from its line
# below (name; meaning; headers that it includes, by their paths from the root), and installed. A compiler of an older C++
# would complain of a hundred lines of ours; it reads one sentence instead.
set(public_headers
  "answer" "What an answer consists of: sides, places, relations, features, distances." "geometry/contact/answer.h"
  "ball" "touchstone::Ball." "geometry/shapes/ball.h"
  "exact" "touchstone::exact: the answers of exact real arithmetic." "robust/exact/exact.h robust/exact/motion.h"
  "fast" "touchstone::fast: answers in plain doubles, for polygons and triangles, and for balls that move."
         "geometry/contact/fast.h geometry/contact/fast_error.h geometry/contact/fast_motion.h geometry/contact/fast_triangle.h"
  "filtered" "touchstone::filtered: the answers of `exact` at about the price of `fast`, and for sets of triangles at less."
             "robust/filtered/filtered.h robust/filtered/motion.h robust/filtered/triangle_set.h"
  "first_contact" "touchstone::FirstContact." "geometry/contact/first_contact.h"
  "merge" "touchstone::mesh::merge_faces: polygons with holes from the coplanar faces of a mesh." "robust/mesh/merge.h"
  "mesh" "touchstone::Mesh: vertices and faces." "geometry/shapes/mesh.h"
  "motion" "touchstone::Motion." "geometry/shapes/motion.h"
  "polygon" "touchstone::Polygon: one outer loop and any number of holes." "geometry/shapes/polygon.h"
  "pose" "touchstone::Pose: a rotation matrix and a translation." "geometry/shapes/pose.h"
  "posing" "touchstone::scene::posed: points, triangles and polygons under a pose, correctly rounded." "robust/scene/posing.h"
  "read_mesh" "touchstone::read_mesh: meshes from OBJ, OFF, STL and PLY files." "geometry/io/read_mesh.h"
  "rejection" "touchstone::Rejection: why an input is not a ball or not a polygon." "geometry/shapes/rejection.h"
  "scene" "touchstone::scene::Scene: exact contact with many posed objects." "robust/scene/scene.h"
  "scene_faces" "touchstone::mesh::scene_faces: a merged mesh as an object of a scene." "robust/mesh/scene_faces.h"
  "segment" "touchstone::Segment." "geometry/shapes/segment.h"
  "solid" "touchstone::scene::Solid: whether points and balls are in a solid, and signed distances." "robust/scene/solid.h"
  "thesis" "touchstone::thesis: the method of a 2008 thesis, errors included." "geometry/contact/thesis.h"
  "triangle" "touchstone::Triangle." "geometry/shapes/triangle.h"
  "validate" "touchstone::exact::validate: decides whether loops bound a region." "robust/exact/validate.h"
  "weld" "touchstone::mesh::weld: one vertex for every point of a mesh." "robust/mesh/weld.h")

set(public_folder ${PROJECT_BINARY_DIR}/include/touchstone)
function(write_public_header name meaning)
  list(TRANSFORM ARGN REPLACE "(.+)" "#include \"\\1\"\n")
  string(JOIN "" includes ${ARGN})
  file(CONFIGURE OUTPUT ${public_folder}/${name}.h @ONLY
       CONTENT "// SPDX-License-Identifier: Apache-2.0\n// @meaning@\n#pragma once\n
#if __cplusplus < 202002L
#error \"Touchstone needs C++20: compile with -std=c++20\"
#else\n
@includes@
#endif\n")
  if(TOUCHSTONE_INSTALL)
    install(FILES ${public_folder}/${name}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/touchstone)
  endif()
endfunction()

set(everything "")
while(public_headers)
  list(POP_FRONT public_headers name meaning paths)
  if(name STREQUAL exact AND NOT TOUCHSTONE_EXACT)
    continue()
  endif()
  separate_arguments(paths)
  write_public_header(${name} "${meaning}" ${paths})
  list(APPEND everything ${name}.h)
endwhile()
write_public_header(touchstone "All of Touchstone for C++. <touchstone.h> is for C." ${everything})

# Not part of <touchstone/touchstone.h>: users bring CGAL.
write_public_header(cgal "touchstone::cgal: the shapes and face graphs of CGAL, and balls with a squared radius."
                    bindings/cgal/cgal.h)
install_headers(bindings/cgal/cgal.h)
