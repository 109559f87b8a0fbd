// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "bindings/c/touchstone.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

/// The call, whose last argument is &error, does what it says.
#define EXPECT_OK(call)                                              \
  do {                                                               \
    touchstone_error error{-1, "unwritten"};                         \
    const touchstone_status status = call;                           \
    EXPECT_EQ(status, TOUCHSTONE_OK) << #call ": " << error.message; \
    EXPECT_EQ(error.status, status);                                 \
    EXPECT_STREQ(error.message, "");                                 \
  } while (false)

namespace touchstone::c_tests {

/// @{
/// Shapes of C++ for C, member by member.
inline void copy(const Eigen::Vector3d& from, double (&to)[3]) { to[0] = from.x(), to[1] = from.y(), to[2] = from.z(); }
[[nodiscard]] inline touchstone_ball in_c(const Ball& ball) {
  touchstone_ball result{{}, ball.radius};
  copy(ball.center, result.center);
  return result;
}
[[nodiscard]] inline touchstone_motion in_c(const Motion& motion) {
  touchstone_motion result{in_c(motion.ball), {}};
  copy(motion.to, result.to);
  return result;
}
[[nodiscard]] inline touchstone_triangle in_c(const Triangle& triangle) {
  touchstone_triangle result;
  copy(triangle.a, result.vertices[0]), copy(triangle.b, result.vertices[1]), copy(triangle.c, result.vertices[2]);
  return result;
}
[[nodiscard]] inline touchstone_pose in_c(const Pose& pose) {
  touchstone_pose result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result.rotation[row][column] = pose.rotation(row, column);
  copy(pose.translation, result.translation);
  return result;
}
/// @}

inline void free_handle(touchstone_polygon* polygon) { touchstone_polygon_free(polygon); }
inline void free_handle(touchstone_scene* scene) { touchstone_scene_free(scene); }
inline void free_handle(touchstone_face_lists* lists) { touchstone_face_lists_free(lists); }
inline void free_handle(touchstone_solid* solid) { touchstone_solid_free(solid); }

/// A handle that is freed.
template <class Handle>
class Owned {
 public:
  Owned() = default;
  Owned(Owned&& other) noexcept : handle_(other.handle_) { other.handle_ = nullptr; }
  Owned& operator=(Owned&&) = delete;
  ~Owned() { free_handle(handle_); }

  [[nodiscard]] Handle* get() const { return handle_; }
  /// For the function that makes it; frees the one before.
  [[nodiscard]] Handle** out() {
    free_handle(handle_);
    handle_ = nullptr;
    return &handle_;
  }

 private:
  Handle* handle_ = nullptr;
};

[[nodiscard]] inline Owned<touchstone_polygon> polygon_in_c(const Polygon& polygon) {
  std::vector<double> vertices;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    for (const double coordinate : polygon.vertex(i)) vertices.push_back(coordinate);
  std::vector<std::size_t> sizes;
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop)
    sizes.push_back(polygon.loop_end(loop) - polygon.loop_begin(loop));
  Owned<touchstone_polygon> result;
  EXPECT_OK(touchstone_polygon_create(vertices.data(), sizes.data(), sizes.size(), result.out(), &error));
  return result;
}

[[nodiscard]] inline Owned<touchstone_scene> scene_in_c() {
  Owned<touchstone_scene> scene;
  EXPECT_OK(touchstone_scene_create(scene.out(), &error));
  return scene;
}

}  // namespace touchstone::c_tests
