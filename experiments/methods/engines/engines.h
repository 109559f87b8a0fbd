// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/engines/library.h"

// Third-party engines: one file each, built if its library was found. As methods they decide contact as their users
// would ask: engines for triangles get those of a triangulation, whose vertices are not lifted.
namespace touchstone::methods {

using MethodList = std::vector<std::unique_ptr<Method>>;

void add_boost_geometry(MethodList& list);
void add_bullet(MethodList& list);
void add_cgal_triangles(MethodList& list);
void add_embree(MethodList& list);
void add_fcl(MethodList& list);
void add_libccd(MethodList& list);
void add_ode(MethodList& list);

/// Adds the engines of this build.
void add_engines(MethodList& list);

/// @{
/// Those that know every query about a mesh, with the same answers.
[[nodiscard]] Library bullet_library();  ///< with libbullet-dev
[[nodiscard]] Library embree_library();  ///< with libembree-dev
[[nodiscard]] Library fcl_library();     ///< with libfcl-dev
/// @}

/// The name of Embree's.
inline constexpr const char* kEmbree = "Embree 3";

}  // namespace touchstone::methods
