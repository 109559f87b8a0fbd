// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/first_contact.h"

namespace touchstone {

std::string_view to_string(FirstContactKind kind) {
  switch (kind) {
    case FirstContactKind::Start: return "start";
    case FirstContactKind::Way: return "way";
    case FirstContactKind::None: return "none";
  }
  return {};
}

}  // namespace touchstone
