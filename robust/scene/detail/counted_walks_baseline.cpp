// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/counted_contact.h"
#include "robust/scene/detail/walks_definition.h"

namespace touchstone::scene {

const Walks<Tally>& baseline_counted_walks() { return kWalks<Tally>; }

}  // namespace touchstone::scene
