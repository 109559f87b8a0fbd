// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet's float build has the names of the double build, so it runs as a program: bullet_float_program.cpp.
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_BULLET_FLOAT
#include "experiments/methods/engines/engines.h"
#include "experiments/methods/process/engine.h"
#include "experiments/program/input.h"
#include "experiments/program/words.h"

namespace touchstone::methods {

void add_bullet_float(MethodList& list) {
  list.push_back(external_method(
      "bullet-float", "Bullet's sphere against triangle, its float build, which runs as a program of its own",
      "exec " + program::shell_quoted(program::helper_program("touchstone_bullet_float").string())));
}

}  // namespace touchstone::methods
#endif
