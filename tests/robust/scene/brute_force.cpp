// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/scene/brute_force.h"

#include <algorithm>
#include <utility>

#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"
#include "tests/robust/support/moving.h"

namespace touchstone::scene {

bool operator==(const NearestFace& a, const NearestFace& b) {
  return a.face == b.face && a.feature == b.feature && a.point == b.point && a.distance == b.distance &&
         a.contact_normal == b.contact_normal && a.depth == b.depth;
}
bool operator==(const FirstFace& a, const FirstFace& b) { return a.face == b.face && a.contact == b.contact; }

void PrintTo(const NearestFace& nearest, std::ostream* out) {
  *out << "object " << nearest.face.object << ", face " << nearest.face.face << ": " << to_string(nearest.feature.kind)
       << ' ' << nearest.feature.index << ", point (" << nearest.point.transpose() << "), distance " << nearest.distance
       << ", contact_normal (" << nearest.contact_normal.transpose() << "), depth " << nearest.depth;
}
void PrintTo(const FirstFace& first, std::ostream* out) {
  *out << "object " << first.face.object << ", face " << first.face.face << ": ";
  touchstone::PrintTo(first.contact, out);
}

}  // namespace touchstone::scene

namespace touchstone::scene_tests {
namespace {

/// The identities of the faces of which this holds.
template <class Faces, class Touches>
std::vector<scene::FaceId> faces_where(const Faces& faces, const Touches& touches) {
  std::vector<scene::FaceId> result;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (touches(i)) result.push_back(faces[i].id);
  return result;
}

}  // namespace

using scene::FaceId;
using scene::FirstFace;

BruteForce::BruteForce(const std::vector<scene::Faces>& objects) : polygons_(all_polygons(objects)) {
  for (std::uint32_t object = 0; object < objects.size(); ++object) {
    std::uint32_t face = 0;
    for (const Triangle& triangle : objects[object].triangles) faces_.push_back({{object, face++}, triangle, {}});
    for (const Polygon& polygon : objects[object].polygons)
      faces_.push_back({{object, face++}, filtered::PreparedPolygon(polygon), {}});
  }
}

const exact::PreparedPolygon& BruteForce::exact_of(std::size_t face) const {
  auto& prepared = faces_[face].prepared;
  if (!prepared) prepared.emplace(polygons_[face]);
  return *prepared;
}

const exact::PreparedPolygon& BruteForce::exact_of(const FaceId& id) const {
  return exact_of(static_cast<std::size_t>(std::ranges::find(faces_, id, &Face::id) - faces_.begin()));
}
FirstContact BruteForce::first_by_exact(const Motion& motion, const FaceId& face) const {
  return exact::first_contact(motion, exact_of(face));
}
int BruteForce::compare_exactly(const Motion& motion, const FaceId& a, const FaceId& b) const {
  return exact::compare_times(motion, exact_of(a), exact_of(b));
}

std::vector<FaceId> BruteForce::touched(const Ball& ball) const {
  return faces_where(faces_, [&](std::size_t i) {
    return std::visit([&](const auto& face) { return filtered::contact(ball, face); }, faces_[i].filtered);
  });
}
std::vector<FaceId> BruteForce::touched(const Motion& motion) const {
  return faces_where(faces_, [&](std::size_t i) {
    return std::visit([&](const auto& face) { return filtered::contact(motion, face); }, faces_[i].filtered);
  });
}
std::vector<FaceId> BruteForce::touched_by_exact(const Ball& ball) const {
  return faces_where(faces_, [&](std::size_t i) { return exact::contact(ball, exact_of(i)); });
}
std::vector<FaceId> BruteForce::touched_by_exact(const Motion& motion) const {
  return faces_where(faces_, [&](std::size_t i) { return exact::contact(motion, exact_of(i)); });
}

std::optional<FirstFace> BruteForce::first(const Motion& motion) const {
  std::optional<FirstFace> best;
  std::size_t best_face = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const FirstContact contact =
        std::visit([&](const auto& f) { return filtered::first_contact(motion, f); }, faces_[i].filtered);
    if (!contact.contact()) continue;
    if (best) {
      if (best->contact.kind == FirstContactKind::Start) break;
      const bool starts = contact.kind == FirstContactKind::Start;
      if (!starts && contact.time > best->contact.time) continue;
      if (!starts && contact.time == best->contact.time &&
          exact::compare_times(motion, exact_of(i), exact_of(best_face)) >= 0)
        continue;
    }
    best = FirstFace{faces_[i].id, contact};
    best_face = i;
  }
  return best;
}

std::optional<FirstFace> BruteForce::first_by_exact(const Motion& motion) const {
  if (faces_.empty()) return std::nullopt;
  std::size_t best = 0;
  for (std::size_t i = 1; i < faces_.size(); ++i)
    if (exact::compare_times(motion, exact_of(i), exact_of(best)) < 0) best = i;
  const FirstContact contact = exact::first_contact(motion, exact_of(best));
  if (!contact.contact()) return std::nullopt;
  return FirstFace{faces_[best].id, contact};
}

scene::NearestFace BruteForce::nearest_by_exact(const Ball& ball) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < faces_.size(); ++i)
    if (exact::compare_distances(ball, exact_of(i), exact_of(best)) < 0) best = i;
  const Answer answer = exact::answer(ball, exact_of(best));
  return {faces_[best].id, answer.nearest, answer.point, answer.distance, answer.contact_normal, answer.depth};
}

Subject::Subject(const std::vector<scene::Faces>& objects, std::string words) : what(std::move(words)), faces(objects) {
  for (std::size_t i = 0; i < objects.size(); ++i) built.add("object " + std::to_string(i), objects[i]);
}

}  // namespace touchstone::scene_tests
