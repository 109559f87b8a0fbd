// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/engine.h"
#include "robust/filtered/triangle_contact.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// The engine of the target that this is compiled for.
inline constexpr Engine kEngine{
    .triangle_contact = [](const TriangleQuestion& question) {
      NoCounts counts;
      return contact(question, counts);
    },
    .counted_triangle_contact = [](const TriangleQuestion& question, StageCounts& counts) {
      return contact(question, counts);
    },
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered
