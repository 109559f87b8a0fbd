// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/kernels_definition.h"

namespace touchstone::filtered {

const Kernels& baseline_kernels() { return kKernels; }

}  // namespace touchstone::filtered
