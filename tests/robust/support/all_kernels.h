// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robust/filtered/detail/kernels.h"

namespace touchstone::contact_tests {

/// Those compiled for any processor, then the fastest ones that this machine can run, if they are others.
[[nodiscard]] inline std::vector<const filtered::detail::Kernels*> all_kernels() {
  std::vector<const filtered::detail::Kernels*> list{&filtered::detail::baseline_kernels()};
  if (&filtered::detail::kernels() != list.front()) list.push_back(&filtered::detail::kernels());
  return list;
}

}  // namespace touchstone::contact_tests
