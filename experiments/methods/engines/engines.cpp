// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/engines/engines.h"

#include "experiments/methods/process/engine.h"
#include "experiments/run/data.h"
#include "experiments/run/run_record.h"

namespace touchstone::methods {

void add_engines(MethodList& list) {
  add_cgal_triangles(list);
  add_boost_geometry(list);
#ifdef TOUCHSTONE_FCL
  add_fcl(list);
#endif
#ifdef TOUCHSTONE_LIBCCD
  add_libccd(list);
#endif
#ifdef TOUCHSTONE_BULLET
  add_bullet(list);
#endif
#ifdef TOUCHSTONE_BULLET_FLOAT
  list.push_back(external_method(
      "bullet-float", "Bullet's sphere against triangle, its float build, which runs as a program of its own",
      "exec " + run::shell_quoted(run::helper_program("touchstone_bullet_float").string())));
#endif
#ifdef TOUCHSTONE_ODE
  add_ode(list);
#endif
#ifdef TOUCHSTONE_EMBREE
  add_embree(list);
#endif
}

}  // namespace touchstone::methods
