// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {

std::vector<Library> all_libraries() {
  std::vector<Library> libraries{touchstone_library()};
#ifdef TOUCHSTONE_EMBREE
  libraries.push_back(methods::embree_library());
#endif
  libraries.push_back(boost_rtree_library());
  libraries.push_back(cgal_aabb_tree_library());
  for (const auto& broad_phase :
       {grid_library, octree_library, kd_tree_library, sphere_tree_library, kdop_tree_library})
    libraries.push_back(broad_phase());
#ifdef TOUCHSTONE_FCL
  libraries.push_back(methods::fcl_library());
#endif
#ifdef TOUCHSTONE_BULLET
  libraries.push_back(methods::bullet_library());
#endif
  return libraries;
}

std::vector<std::string> absent_libraries() {
  std::vector<std::string> absent;
#ifndef TOUCHSTONE_EMBREE
  absent.emplace_back("Embree 3 (libembree-dev)");
#endif
#ifndef TOUCHSTONE_FCL
  absent.emplace_back("FCL (libfcl-dev)");
#endif
#ifndef TOUCHSTONE_BULLET
  absent.emplace_back("Bullet (libbullet-dev)");
#endif
  return absent;
}

}  // namespace touchstone::bench_scenes
