// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/scene/faces_on_way.h"

#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::scene_tests {

using scene::FaceId;
using scene::FirstFace;

FacesOnWay::FacesOnWay(const std::vector<scene::Faces>& objects) {
  for (std::uint32_t object = 0; object < objects.size(); ++object) {
    std::uint32_t face = 0;
    for (const Triangle& t : objects[object].triangles)
      faces_.push_back({{object, face++}, t, exact::PreparedPolygon(Polygon({t.a, t.b, t.c}))});
    for (const Polygon& polygon : objects[object].polygons)
      faces_.push_back({{object, face++}, filtered::PreparedPolygon(polygon), exact::PreparedPolygon(polygon)});
  }
}

std::vector<FaceId> FacesOnWay::touched(const Motion& motion) const {
  std::vector<FaceId> result;
  for (const Face& face : faces_)
    if (std::visit([&](const auto& f) { return filtered::contact(motion, f); }, face.filtered))
      result.push_back(face.id);
  return result;
}

std::optional<FirstFace> FacesOnWay::first(const Motion& motion) const {
  std::optional<FirstFace> best;
  const Face* best_face = nullptr;
  for (const Face& face : faces_) {
    const FirstContact contact =
        std::visit([&](const auto& f) { return filtered::first_contact(motion, f); }, face.filtered);
    if (!contact.contact()) continue;
    if (best) {
      if (best->contact.kind == FirstContactKind::Start) break;
      const bool starts = contact.kind == FirstContactKind::Start;
      if (!starts && contact.time > best->contact.time) continue;
      if (!starts && contact.time == best->contact.time &&
          exact::compare_times(motion, face.exact, best_face->exact) >= 0)
        continue;
    }
    best = FirstFace{face.id, contact};
    best_face = &face;
  }
  return best;
}

std::vector<FaceId> FacesOnWay::touched_by_exact(const Motion& motion) const {
  std::vector<FaceId> result;
  for (const Face& face : faces_)
    if (exact::contact(motion, face.exact)) result.push_back(face.id);
  return result;
}

std::optional<FirstFace> FacesOnWay::first_by_exact(const Motion& motion) const {
  const Face* best = nullptr;
  for (const Face& face : faces_)
    if (best == nullptr || exact::compare_times(motion, face.exact, best->exact) < 0) best = &face;
  if (best == nullptr) return std::nullopt;
  const FirstContact contact = exact::first_contact(motion, best->exact);
  if (!contact.contact()) return std::nullopt;
  return FirstFace{best->id, contact};
}

}  // namespace touchstone::scene_tests
