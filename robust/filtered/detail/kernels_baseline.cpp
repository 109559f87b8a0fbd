// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/kernels_definition.h"

namespace touchstone::filtered {

const Engine& baseline_engine() { return kEngine; }

}  // namespace touchstone::filtered
