// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/add_methods.h"
#include "experiments/methods/fast_method.h"

namespace touchstone::methods {

void add_fast(MethodList& list) {
  list.push_back(
      std::make_unique<Fast<double>>("fast", "double", "the three tests in plain doubles, carefully written"));
  list.push_back(std::make_unique<Fast<float>>("fast-float", "float", "the code of fast over 32-bit floats"));
  list.push_back(
      std::make_unique<Fast<long double>>("fast-long-double", "long double", "the code of fast over long doubles"));
}

}  // namespace touchstone::methods
