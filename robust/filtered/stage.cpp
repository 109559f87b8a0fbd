// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/stage.h"

namespace touchstone::filtered {

std::string_view to_string(Stage stage) {
  switch (stage) {
    case Stage::Double: return "double";
    case Stage::Permanent: return "permanent";
    case Stage::DoubleDouble: return "double-double";
    case Stage::FixedInteger: return "fixed-integer";
    case Stage::BigInteger: break;
  }
  return "unlimited";
}

}  // namespace touchstone::filtered
