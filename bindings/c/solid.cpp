// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/solid.h"

#include <memory>
#include <vector>

#include "bindings/c/calls.h"
#include "bindings/c/shapes.h"

using namespace touchstone;
using namespace touchstone::c;

struct touchstone_solid {
  explicit touchstone_solid(const std::vector<Triangle>& closed) : held(closed) {}

  scene::Solid held;
};

touchstone_status touchstone_solid_create(const touchstone_mesh* triangles, touchstone_solid** solid,
                                          touchstone_error* error) {
  return created(solid, error, [&] {
    const std::vector<Triangle> all = triangles_of(given(triangles, "the mesh"));
    expect_valid("face ", all, Degenerate::Refuse);
    return std::make_unique<touchstone_solid>(all);
  });
}

void touchstone_solid_free(touchstone_solid* solid) { delete solid; }

touchstone_status touchstone_solid_locate(const touchstone_solid* solid, const double* points, size_t count,
                                          uint32_t threads, int32_t* locations, touchstone_error* error) {
  return guarded(error, [&] {
    const auto& held = given(solid, "the solid").held;
    const auto asking = points_of(points, count);
    std::vector<PointLocation> found(count);
    on_threads(threads, count, [&] { held.locate(asking, found); });
    answer_each(found, locations, [](PointLocation location) { return in_c(location); });
  });
}

touchstone_status touchstone_solid_touches(const touchstone_solid* solid, const touchstone_ball* balls, size_t count,
                                           uint32_t threads, bool* touches, touchstone_error* error) {
  return guarded(error, [&] {
    const auto& held = given(solid, "the solid").held;
    const auto asking = balls_of(balls, count);
    const auto out = given(touches, count, "the array of answers");
    on_threads(threads, count, [&] { held.touches(asking, out); });
  });
}

touchstone_status touchstone_solid_signed_distance(const touchstone_solid* solid, const double* points, size_t count,
                                                   uint32_t threads, double* distances, touchstone_error* error) {
  return guarded(error, [&] {
    const auto& held = given(solid, "the solid").held;
    const auto asking = points_of(points, count);
    const auto out = given(distances, count, "the array of answers");
    on_threads(threads, count, [&] { held.signed_distance(asking, out); });
  });
}
