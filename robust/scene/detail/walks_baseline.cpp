// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/walks_definition.h"

namespace touchstone::scene {

const Walks& baseline_walks() { return kWalks; }

}  // namespace touchstone::scene
