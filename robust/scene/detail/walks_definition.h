// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/scene/detail/crowd.h"
#include "robust/scene/detail/nearest_in_crowd.h"
#include "robust/scene/detail/walks.h"
#include "robust/scene/detail/walks_alone.h"

namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The walks of the target that this is compiled for.
template <class Query>
inline constexpr ContactWalks<Query> kContactWalks{touches_triangle<Query>, touches_polygon<Query>,
                                                   touched_triangles<Query>, touched_polygons<Query>};
inline constexpr CrowdWalks kCrowdWalks{touches_triangle_each, touched_triangles_each, nearest_triangles_each};
inline constexpr Walks kWalks{kContactWalks<Ball>, kContactWalks<Motion>, nearest_triangle, nearest_polygon,
                              first_triangle,      first_polygon,         crossings_of,     kCrowdWalks};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET
