// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/filtered.h"

namespace touchstone::scene {

/// Polygons by number, each of which is prepared when it is first accessed. Several threads may access them at once.
class LazyPreparedPolygons {
 public:
  /// Keeps a reference. Requires polygons that have a normal.
  explicit LazyPreparedPolygons(const std::vector<Polygon>& polygons)
      : polygons_(polygons), prepared_(new std::atomic<const filtered::PreparedPolygon*>[polygons.size()]()) {}
  ~LazyPreparedPolygons();
  LazyPreparedPolygons(const LazyPreparedPolygons&) = delete;
  LazyPreparedPolygons& operator=(const LazyPreparedPolygons&) = delete;

  // Always inlined: a compiled function that was built for AVX2 could be linked into code for other machines.
  __attribute__((always_inline)) const filtered::PreparedPolygon& operator[](std::size_t number) const {
    const filtered::PreparedPolygon* known = prepared_[number].load(std::memory_order_acquire);
    return known != nullptr ? *known : prepare(number);
  }

 private:
  const filtered::PreparedPolygon& prepare(std::size_t number) const;

  const std::vector<Polygon>& polygons_;
  std::unique_ptr<std::atomic<const filtered::PreparedPolygon*>[]> prepared_;
};

}  // namespace touchstone::scene
