// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/add_methods.h"
#include "experiments/program/built_with.h"

namespace touchstone::methods {

#define DECLARE(name) void add_##name(MethodList& list);
TOUCHSTONE_ENGINES(DECLARE)

void add_engines(MethodList& list) {
#define ADD(name) add_##name(list);
  TOUCHSTONE_ENGINES(ADD)
}

}  // namespace touchstone::methods
