// SPDX-License-Identifier: GPL-3.0-or-later
// Whichever allocation of the caller's thread fails, the status says so, and the objects are as before.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>

#include "bindings/c/touchstone.h"
#include "tests/bindings/c/in_c.h"

namespace {

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
thread_local std::size_t until_failure = kNever;  ///< allocations that succeed before one fails

void* allocated(std::size_t size, std::size_t alignment) {
  if (until_failure != kNever && until_failure-- == 0) {
    until_failure = kNever;
    throw std::bad_alloc();
  }
  void* const memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) { return allocated(size, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocated(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace touchstone::c_tests {
namespace {

/// Calls again and again, each time with a later allocation failing, until it succeeds. Returns how many calls failed.
int failures_of(const std::function<touchstone_status(touchstone_error*)>& call) {
  for (int failures = 0;; ++failures) {
    touchstone_error error{-1, "unwritten"};
    until_failure = static_cast<std::size_t>(failures);
    const touchstone_status status = call(&error);
    until_failure = kNever;
    EXPECT_EQ(error.status, status);
    if (status == TOUCHSTONE_OK || failures == 10000) return failures;
    EXPECT_EQ(status, TOUCHSTONE_OUT_OF_MEMORY) << error.message;
    EXPECT_STREQ(error.message, "there is not enough memory");
  }
}

TEST(OutOfMemory, IsAStatusAndChangesNothing) {
  const double vertices[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 1, 1, 0, 2, 1, 0, 1, 2, 0};
  const std::size_t sizes[] = {4, 3};
  Owned<touchstone_polygon> polygon;
  EXPECT_GT(failures_of([&](touchstone_error* error) {
              const auto status = touchstone_polygon_create(vertices, sizes, 2, polygon.out(), error);
              EXPECT_EQ(polygon.get() == nullptr, status != TOUCHSTONE_OK);
              return status;
            }),
            5);
  Owned<touchstone_scene> scene;
  EXPECT_GT(failures_of([&](touchstone_error* error) { return touchstone_scene_create(scene.out(), error); }), 0);
  const touchstone_polygon* const polygons[] = {polygon.get()};
  const std::uint32_t corners[] = {0, 1, 2, 0, 2, 3};
  const touchstone_faces faces{{vertices, 4, corners, 2}, polygons, 1, TOUCHSTONE_REFUSE_DEGENERATE};
  std::uint32_t object = 7;
  const auto add = [&](touchstone_error* error) {
    return touchstone_scene_add(scene.get(), "a name that is too long for a string to hold by itself", &faces, nullptr,
                                &object, error);
  };
  EXPECT_GT(failures_of(add), 5);
  EXPECT_EQ(object, 0U);

  const touchstone_ball balls[] = {{{1, 1, 2}, 2}, {{3, 3, 2}, 2}};
  const touchstone_scene_options one{&object, 1, 0};
  Owned<touchstone_face_lists> lists;
  const auto touched = [&](touchstone_error* error) {
    return touchstone_scene_touched(scene.get(), balls, 1, &one, lists.out(), error);
  };
  EXPECT_GT(failures_of(touched), 3);
  EXPECT_EQ(touchstone_face_lists_offsets(lists.get())[1], 3U);
  touchstone_nearest_face nearest;
  EXPECT_GT(failures_of([&](touchstone_error* error) {
              return touchstone_scene_nearest(scene.get(), balls, 1, &one, &nearest, error);
            }),
            0);
  EXPECT_EQ(nearest.distance, 2);
}

TEST(OutOfMemory, IsWhatMoreThanMemoryCanHoldEndsIn) {
  const double vertices[] = {0, 0, 0};
  const std::size_t size = std::numeric_limits<std::size_t>::max() / 2;
  touchstone_polygon* polygon = nullptr;
  EXPECT_EQ(touchstone_polygon_create(vertices, &size, 1, &polygon, nullptr), TOUCHSTONE_OUT_OF_MEMORY);
}

}  // namespace
}  // namespace touchstone::c_tests
