// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/face_sets.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>
#include <optional>

#include "geometry/detail/floating_point_state.h"
#include "robust/scene/detail/lifted_box.h"
#include "robust/scene/posing.h"

namespace touchstone::scene {
namespace {

/// A tree whose boxes have grown by more than this since it was built is rebuilt. Measured for terrains, spheres, boxes
/// and soups of 10 000 to 20 000 triangles, rotated about two axes by 5 to 45 degrees: up to this growth no query took
/// more than 1.3 times as long as with a new tree; beyond it contact took up to 1.5 times, `nearest` up to 2.6 times as
/// long.
constexpr double kMostGrowth = 1.2;

/// Calls f(i) for each i below `count`, on all cores. If f throws Rejected, throws FaceRejected for the lowest
/// number(i) for which it did.
template <class Number, class F>
void for_each_face(std::size_t count, const Number& number, const F& f) {
  std::atomic<std::size_t> lowest{count};
  std::optional<Rejection> reason;
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const tbb::blocked_range<std::size_t>& range) {
    const FloatingPointState nearest;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if (number(i) > lowest.load(std::memory_order_relaxed)) continue;
      try {
        f(i);
      } catch (const Rejected& rejected) {
        const std::scoped_lock lock(mutex);
        if (reason && number(i) > lowest) continue;
        lowest = number(i);
        reason = rejected.rejection();
      }
    }
  });
  if (reason) throw FaceRejected{lowest, *reason};
}

BoxTree tree_of(const std::vector<Triangle>& triangles) {
  const FloatingPointState nearest;
  for_each_face(
      triangles.size(), [](std::size_t i) { return i; }, [&](std::size_t i) { expect_valid(triangles[i]); });
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box(triangle));
  return BoxTree(boxes);
}

std::vector<Triangle> arranged(const std::vector<Triangle>& by_number, const std::vector<std::uint32_t>& order) {
  std::vector<Triangle> result;
  result.reserve(order.size());
  for (const std::uint32_t number : order) result.push_back(by_number[number]);
  return result;
}

std::vector<Triangle> by_number(const std::vector<Triangle>& by_place, const std::vector<std::uint32_t>& order) {
  std::vector<Triangle> result(by_place.size());
  for (std::size_t place = 0; place < order.size(); ++place) result[order[place]] = by_place[place];
  return result;
}

std::vector<Triangle> posed(const std::vector<Triangle>& model, const Pose& pose,
                            const std::vector<std::uint32_t>& order) {
  if (pose == Pose()) return model;
  std::vector<Triangle> result(model.size());
  for_each_face(
      model.size(), [&](std::size_t place) { return order[place]; },
      [&](std::size_t place) { result[place] = scene::posed(pose, model[place]); });
  return result;
}

std::vector<Polygon> posed(const std::vector<Polygon>& model, const Pose& pose) {
  std::vector<Polygon> result = model;
  if (pose == Pose()) return result;
  for_each_face(
      model.size(), [](std::size_t i) { return i; }, [&](std::size_t i) { result[i] = scene::posed(pose, model[i]); });
  return result;
}

std::vector<Box> boxes_of(const std::vector<Polygon>& polygons, const LazyPreparedPolygons& prepared) {
  std::vector<Box> boxes(polygons.size());
  const auto number = [](std::size_t i) { return i; };
  for_each_face(polygons.size(), number, [&](std::size_t i) {
    const auto quick = quick_lifted_box(polygons[i]);
    boxes[i] = quick ? *quick : lifted_box(polygons[i], prepared[i]);
  });
  return boxes;
}

}  // namespace

TriangleSet::TriangleSet(const std::vector<Triangle>& by_number)
    : tree(tree_of(by_number)), triangles(arranged(by_number, tree.order())) {}

TriangleSet::TriangleSet(const TriangleSet& other, const Pose& pose)
    : tree(other.tree), triangles(posed(other.model ? *other.model : other.triangles, pose, tree.order())) {
  if (!(pose == Pose()))
    model = other.model ? other.model : std::make_shared<const std::vector<Triangle>>(other.triangles);
  const FloatingPointState nearest;
  std::vector<Box> boxes(triangles.size());
  for (std::size_t place = 0; place < triangles.size(); ++place) boxes[tree.order()[place]] = box(triangles[place]);
  tree.refit(boxes);
  if (tree.growth() <= kMostGrowth) return;
  const std::vector<std::uint32_t> before = tree.order();
  tree = BoxTree(boxes);
  triangles = arranged(by_number(triangles, before), tree.order());
  if (model) model = std::make_shared<const std::vector<Triangle>>(arranged(by_number(*model, before), tree.order()));
}

std::size_t TriangleSet::memory() const {
  return tree.nodes().capacity() * sizeof(BoxTree::Node) + tree.order().capacity() * sizeof(std::uint32_t) +
         (triangles.capacity() + (model ? model->capacity() : 0)) * sizeof(Triangle);
}

PolygonSet::PolygonSet(std::vector<Polygon> by_number)
    : polygons(std::move(by_number)), prepared(polygons), tree(boxes_of(polygons, prepared)), edges(0) {
  for (const Polygon& polygon : polygons) edges += polygon.vertex_count();
}

PolygonSet::PolygonSet(const PolygonSet& other, const Pose& pose)
    : polygons(posed(other.model ? *other.model : other.polygons, pose)),
      prepared(polygons),
      tree(other.tree),
      edges(other.edges) {
  if (!(pose == Pose()))
    model = other.model ? other.model : std::make_shared<const std::vector<Polygon>>(other.polygons);
  const std::vector<Box> boxes = boxes_of(polygons, prepared);
  const FloatingPointState nearest;
  tree.refit(boxes);
  if (tree.growth() > kMostGrowth) tree = BoxTree(boxes);
}

}  // namespace touchstone::scene
