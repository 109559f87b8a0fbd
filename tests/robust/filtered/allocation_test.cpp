// SPDX-License-Identifier: GPL-3.0-or-later
// What filtered questions allocate: nothing up to the last stage, in batches or one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace {

thread_local std::size_t allocations = 0;

void* allocated(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* const memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All that `new` gives in this program; arrays come from these, too. Compilers that inlined them would see `free` meet
// what came from `new`.
[[gnu::noinline]] void* operator new(std::size_t size) { return allocated(size, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocated(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size);  // what asks for this way of failing is not filtered
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace touchstone::filtered_tests {
namespace {

using filtered::Stage;

/// A gear of many edges, tilted and off its plane by what its corners are rounded.
Polygon gear(std::size_t edges) {
  Loop loop;
  for (std::size_t i = 0; i < edges; ++i) {
    const double turn = 2 * M_PI * static_cast<double>(i) / static_cast<double>(edges), radius = i % 2 == 0 ? 1 : 0.9;
    loop.emplace_back(radius * std::cos(turn), 0.8 * radius * std::sin(turn), 0.6 * radius * std::sin(turn));
  }
  return Polygon(loop);
}

/// Balls about the gear, half of them within a double of touching it, none so near that integers are asked. Batches ask
/// four at once, and two are left over.
std::vector<Ball> balls_about(const Polygon& polygon) {
  std::vector<Ball> balls;
  const exact::PreparedPolygon truth(polygon);
  const filtered::PreparedPolygon prepared(polygon);
  for (int i = 0; balls.size() < 102; ++i) {
    const double t = 0.1 * i;
    Ball ball{{1.2 * std::cos(t), std::sin(3 * t), 0.7 * std::sin(t)}, 0.3};
    if (i % 2 == 0) ball.radius = workloads::move_by_doubles(exact::answer(ball, truth).distance, i % 4 - 1);
    filtered::StageCounts counts;
    (void)filtered::contact(ball, prepared, counts);
    if (counts.last() < Stage::BigInteger) balls.push_back(ball);
  }
  return balls;
}

template <class Call>
std::size_t allocations_of(const Call& call) {
  const std::size_t before = allocations;
  call();
  return allocations - before;
}

TEST(Allocations, AreCounted) {
  EXPECT_EQ(allocations_of([] { ::operator delete(::operator new(7)); }), 1U);  // may not be left out, unlike `new int`
  EXPECT_GT(allocations_of([] { const filtered::PreparedPolygon prepared(gear(64)); }), 10U);
}

TEST(Allocations, AreMadeByCompleteOrByTheFirstQueryThatNeedsThem) {
  const Polygon polygon = gear(64);
  const std::vector<Ball> balls = balls_about(polygon);
  const filtered::PreparedPolygon prepared(polygon), completed(polygon);
  completed.complete();
  const auto ask = [&balls](const filtered::PreparedPolygon& about) {
    for (const Ball& ball : balls) (void)filtered::contact(ball, about);
  };
  EXPECT_EQ(allocations_of([&] { completed.complete(); }), 0U);
  EXPECT_EQ(allocations_of([&] { ask(completed); }), 0U);
  EXPECT_GT(allocations_of([&] { ask(prepared); }), 0U);
  EXPECT_EQ(allocations_of([&] { ask(prepared); }), 0U);
}

TEST(Allocations, NoBatchOfBallsMakesAny) {
  for (const std::size_t edges : {3U, 64U, 5000U}) {
    const Polygon polygon = gear(edges);
    const filtered::PreparedPolygon prepared(polygon);
    prepared.complete();
    const std::vector<Ball> balls = balls_about(polygon);
    const auto touches = std::make_unique<bool[]>(balls.size());
    EXPECT_EQ(allocations_of([&] { filtered::contact(balls, prepared, {touches.get(), balls.size()}); }), 0U) << edges;
  }
}

TEST(Allocations, NoBatchOfTrianglesMakesAny) {
  const Polygon polygon = gear(3);
  for (const Ball& ball : balls_about(polygon)) {
    const Triangle whole{polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)};
    const Triangle triangles[] = {whole, whole, {whole.b, whole.c, whole.a}};
    bool touches[3];
    EXPECT_EQ(allocations_of([&] { filtered::contact(ball, triangles, touches); }), 0U);
  }
}

TEST(Allocations, NoSingleQuestionMakesAnyButTheListOfEdges) {
  const Polygon polygon = gear(64);
  const filtered::PreparedPolygon prepared(polygon);
  prepared.complete();
  for (const Ball& ball : balls_about(polygon)) {
    EXPECT_EQ(allocations_of([&] { (void)filtered::contact(ball, prepared); }), 0U);
    EXPECT_EQ(allocations_of([&] { (void)filtered::relation(ball, prepared); }), 0U);
    EXPECT_EQ(allocations_of([&] { (void)filtered::plane_side(ball, prepared); }), 0U);
    EXPECT_EQ(allocations_of([&] { (void)filtered::foot(ball, prepared); }), 0U);
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests
