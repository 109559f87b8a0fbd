// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/answer.h"

#include "geometry/contact/first_contact.h"

namespace touchstone {

std::string_view to_string(PlaneSide side) {
  switch (side) {
    case PlaneSide::InFront: return "in_front";
    case PlaneSide::Behind: return "behind";
    case PlaneSide::Intersects: return "intersects";
  }
  return {};
}

std::string_view to_string(PointLocation place) {
  switch (place) {
    case PointLocation::Inside: return "inside";
    case PointLocation::Boundary: return "boundary";
    case PointLocation::Outside: return "outside";
  }
  return {};
}

std::string_view to_string(Relation relation) {
  switch (relation) {
    case Relation::Separate: return "separate";
    case Relation::Touching: return "touching";
    case Relation::Overlapping: return "overlapping";
  }
  return {};
}

std::string_view to_string(Feature::Kind kind) {
  switch (kind) {
    case Feature::Kind::Face: return "face";
    case Feature::Kind::Edge: return "edge";
    case Feature::Kind::Vertex: return "vertex";
  }
  return {};
}

std::string_view to_string(FirstContactKind kind) {
  switch (kind) {
    case FirstContactKind::Start: return "start";
    case FirstContactKind::Way: return "way";
    case FirstContactKind::None: return "none";
  }
  return {};
}

}  // namespace touchstone
