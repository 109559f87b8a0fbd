// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "experiments/methods/add_methods.h"

// Third-party engines as methods: one file each, built if its library was found. They decide contact as their users
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

}  // namespace touchstone::methods
