// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/shapes/rejection.h"

namespace touchstone::contact_tests {

/// The word of the code with which a call is rejected, or "accepted".
template <class Call>
std::string rejection_code(const Call& call) {
  try {
    call();
  } catch (const Rejected& rejected) {
    return std::string(to_string(rejected.rejection().code));
  }
  return "accepted";
}

}  // namespace touchstone::contact_tests
