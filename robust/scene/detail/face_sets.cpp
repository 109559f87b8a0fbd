// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/face_sets.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"
#include "robust/scene/detail/lifted_box.h"
#include "robust/scene/detail/object_boxes.h"
#include "robust/scene/detail/own_frame.h"
#include "robust/scene/posing.h"

namespace touchstone::scene::detail {

LazyPreparedPolygons::~LazyPreparedPolygons() {
  for (std::size_t i = 0; i < polygons_.size(); ++i) delete prepared_[i].load(std::memory_order_relaxed);
}

// Several threads may prepare the polygon at the same time; the first result is kept.
const filtered::PreparedPolygon& LazyPreparedPolygons::prepare(std::size_t number) const {
  auto made = std::make_unique<const filtered::PreparedPolygon>(polygons_[number]);
  const filtered::PreparedPolygon* known = nullptr;
  if (prepared_[number].compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) return *made.release();
  return *known;
}

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
  parts_in_parallel(count, 256, [&](std::size_t begin, std::size_t end) {
    const FloatingPointState nearest;
    for (std::size_t i = begin; i < end; ++i) {
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

void expect_valid(const std::vector<Triangle>& triangles, Degenerate degenerate) {
  const auto number = [](std::size_t i) { return i; };
  for_each_face(triangles.size(), number, [&](std::size_t i) { scene::expect_valid(triangles[i], degenerate); });
}

Box joined(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all = all.joined(box);
  return all;
}

std::vector<Box> boxes_of(const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes(triangles.size());
  each_in_parallel(triangles.size(), 4096, [&](std::size_t i) { boxes[i] = box(triangles[i]); });
  return boxes;
}

/// What OwnFrame has to know about triangles.
struct Lengths {
  double reach = 0, thinnest = std::numeric_limits<double>::infinity();

  void add(const Triangle& t) {
    reach = std::max({reach, distance_from_origin(t.a), distance_from_origin(t.b), distance_from_origin(t.c)});
    thinnest = std::min(thinnest, least_altitude(t));
  }
  [[nodiscard]] Lengths joined(const Lengths& other) const {
    return {std::max(reach, other.reach), std::min(thinnest, other.thinnest)};
  }
};

Lengths lengths_of(const std::vector<Triangle>& triangles) {
  return parts_joined(
      triangles.size(), 4096, Lengths(),
      [&triangles](std::size_t begin, std::size_t end, Lengths lengths) {
        const FloatingPointState nearest;
        for (std::size_t i = begin; i < end; ++i) lengths.add(triangles[i]);
        return lengths;
      },
      [](const Lengths& a, const Lengths& b) {
        const FloatingPointState nearest;
        return pinned(a.joined(b));
      });
}

/// Returns all triangles of the model posed, in a tree of the same shape if its boxes do not grow too much.
PlacedTriangles posed(const PlacedTriangles& model, const Pose& pose, Degenerate degenerate) {
  const std::vector<std::uint32_t>& order = model.tree.order();
  std::vector<Triangle> by_number(model.tree.size());
  for_each_face(
      order.size(), [&](std::size_t place) { return order[place]; },
      [&](std::size_t place) {
        if (order[place] != BoxTree::kNone)
          by_number[order[place]] = scene::posed(pose, model.triangles[place].copy(), degenerate);
      });
  const std::vector<Box> boxes = boxes_of(by_number);
  BoxTree tree = model.tree;
  tree.refit(boxes);
  if (tree.growth() > kMostGrowth) tree = BoxTree(boxes);
  return {std::move(tree), boxes, by_number};
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

PlacedTriangles::PlacedTriangles(BoxTree tree_, const std::vector<Box>& boxes, const std::vector<Triangle>& by_number)
    : tree(std::move(tree_)), box(joined(boxes)), triangles(by_number, tree.order()), groups(tree.leaf_count()) {
  each_in_parallel(groups.size(), 256, [&](std::size_t i) {
    std::array<Triangle, BoxTree::kMostInLeaf> leaf;
    std::size_t count = 0;
    for (std::size_t place = i * BoxTree::kMostInLeaf; count < leaf.size(); ++place, ++count) {
      if (tree.order()[place] == BoxTree::kNone) break;
      leaf[count] = triangles[place].copy();
    }
    groups[i] = filtered::detail::group_of(std::span(leaf).first(count));
  });
}

TriangleSet::TriangleSet(const std::vector<Triangle>& by_number, Degenerate degenerate_) : degenerate(degenerate_) {
  const FloatingPointState nearest;
  expect_valid(by_number, degenerate);
  const std::vector<Box> boxes = boxes_of(by_number);
  model = std::make_shared<const PlacedTriangles>(BoxTree(boxes), boxes, by_number);
  placed = model;
  const Lengths lengths = lengths_of(by_number);
  reach = lengths.reach;
  thinnest = degenerate == Degenerate::Refuse ? lengths.thinnest : std::numeric_limits<double>::infinity();
}

TriangleSet::TriangleSet(const TriangleSet& other, const Pose& pose)
    : model(other.model),
      placed(other.model),
      reach(other.reach),
      thinnest(other.thinnest),
      degenerate(other.degenerate) {
  if (pose == Pose()) return;
  const FloatingPointState nearest;
  frame = OwnFrame::of(pose, reach, thinnest);
  if (!frame) placed = std::make_shared<const PlacedTriangles>(posed(*model, pose, degenerate));
}

Box TriangleSet::box() const { return frame ? posed(frame->pose(), placed->box) : placed->box; }

Triangle TriangleSet::triangle(std::uint32_t place) const {
  const Triangle triangle = placed->triangles[place].copy();
  return frame ? posed_vertices(frame->pose(), triangle) : triangle;
}

std::size_t TriangleSet::memory() const {
  const auto memory = [](const PlacedTriangles& p) {
    return p.tree.nodes().capacity() * sizeof(BoxTree::Node) + p.tree.order().capacity() * sizeof(std::uint32_t) +
           p.triangles.memory() + p.groups.capacity() * sizeof(filtered::detail::TriangleGroup);
  };
  return memory(*model) + (placed == model ? 0 : memory(*placed));
}

PolygonSet::PolygonSet(std::vector<Polygon> by_number)
    : polygons(std::move(by_number)), prepared(polygons), tree(std::span<const Box>()) {
  const std::vector<Box> boxes = boxes_of(polygons, prepared);
  tree = BoxTree(boxes);
  box = joined(boxes);
}

PolygonSet::PolygonSet(const PolygonSet& other, const Pose& pose)
    : polygons(posed(other.model ? *other.model : other.polygons, pose)), prepared(polygons), tree(other.tree) {
  if (!(pose == Pose()))
    model = other.model ? other.model : std::make_shared<const std::vector<Polygon>>(other.polygons);
  const std::vector<Box> boxes = boxes_of(polygons, prepared);
  const FloatingPointState nearest;
  tree.refit(boxes);
  if (tree.growth() > kMostGrowth) tree = BoxTree(boxes);
  box = joined(boxes);
}

}  // namespace touchstone::scene::detail
