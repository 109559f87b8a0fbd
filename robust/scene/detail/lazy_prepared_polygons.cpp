// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/lazy_prepared_polygons.h"

namespace touchstone::scene {

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

}  // namespace touchstone::scene
