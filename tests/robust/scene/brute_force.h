// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "geometry/shapes/motion.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/scene.h"
#include "tests/robust/scene/adversarial_scenes.h"

namespace touchstone::scene {

/// @{
/// How GoogleTest compares and shows the faces that scenes name.
bool operator==(const NearestFace& a, const NearestFace& b);
bool operator==(const FirstFace& a, const FirstFace& b);
void PrintTo(const NearestFace& nearest, std::ostream* out);
void PrintTo(const FirstFace& first, std::ostream* out);
/// @}

}  // namespace touchstone::scene

namespace touchstone::scene_tests {

/// The faces of objects without any hierarchy, to ask each of them.
class BruteForce {
 public:
  explicit BruteForce(const std::vector<scene::Faces>& objects);

  /// The faces, object by object.
  [[nodiscard]] const std::vector<Polygon>& polygons() const { return polygons_; }

  /// @{
  /// Returns the faces that a ball touches, or a moving ball on its way: each asked by `filtered`.
  [[nodiscard]] std::vector<scene::FaceId> touched(const Ball& ball) const;
  [[nodiscard]] std::vector<scene::FaceId> touched(const Motion& motion) const;
  /// @}
  /// Returns the first face. Single faces are asked by `filtered`, equal rounded times are compared by `exact`.
  [[nodiscard]] std::optional<scene::FirstFace> first(const Motion& motion) const;

  /// @{
  /// By `exact` alone. Each face is prepared when it is first asked. There must be one for a nearest.
  [[nodiscard]] std::vector<scene::FaceId> touched_by_exact(const Ball& ball) const;
  [[nodiscard]] std::vector<scene::FaceId> touched_by_exact(const Motion& motion) const;
  [[nodiscard]] std::optional<scene::FirstFace> first_by_exact(const Motion& motion) const;
  [[nodiscard]] FirstContact first_by_exact(const Motion& motion, const scene::FaceId& face) const;
  [[nodiscard]] scene::NearestFace nearest_by_exact(const Ball& ball) const;
  /// Returns which face the ball touches first, as exact::compare_times does.
  [[nodiscard]] int compare_exactly(const Motion& motion, const scene::FaceId& a, const scene::FaceId& b) const;
  /// @}

 private:
  struct Face {
    scene::FaceId id;
    std::variant<Triangle, filtered::PreparedPolygon> filtered;
    mutable std::optional<exact::PreparedPolygon> prepared;
  };
  [[nodiscard]] const exact::PreparedPolygon& exact_of(std::size_t face) const;
  [[nodiscard]] const exact::PreparedPolygon& exact_of(const scene::FaceId& face) const;

  std::vector<Polygon> polygons_;
  std::vector<Face> faces_;
};

/// A scene and the same without it.
struct Subject {
  Subject(const std::vector<scene::Faces>& objects, std::string words);

  std::string what;
  BruteForce faces;
  scene::Scene built;
};

/// Calls f(subject, query, number, words) for scenes of each kind; `draw` draws balls or motions.
template <class Draw, class F>
void for_each_query(const Draw& draw, std::uint64_t queries, const F& f) {
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < 2; ++index) {
      const Subject subject(draw_objects(kind, 2026, index), name(kind));
      for (std::uint64_t i = 0; i < queries; ++i) {
        const std::uint64_t number = 1000 * index + i;
        f(subject, draw(subject.faces.polygons(), 2026, number), number,
          subject.what + ", query " + std::to_string(number));
      }
    }
}

}  // namespace touchstone::scene_tests
