// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/engine_definition.h"

namespace touchstone::scene {

const Engine& baseline_engine() { return kEngine; }

}  // namespace touchstone::scene
