// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/rejection.h"

namespace touchstone {

std::string_view to_string(RejectionCode code) {
  switch (code) {
    case RejectionCode::MalformedCase: return "malformed-case";
    case RejectionCode::NotFinite: return "not-finite";
    case RejectionCode::NegativeRadius: return "negative-radius";
    case RejectionCode::TooFewVertices: return "too-few-vertices";
    case RejectionCode::RepeatedVertex: return "repeated-vertex";
    case RejectionCode::ZeroNormal: return "zero-normal";
    case RejectionCode::LoopMeetsItself: return "loop-meets-itself";
    case RejectionCode::LoopsMeet: return "loops-meet";
    case RejectionCode::HoleOutside: return "hole-outside";
  }
  return {};
}

}  // namespace touchstone
