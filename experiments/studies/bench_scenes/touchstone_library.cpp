// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench_scenes/library.h"
#include "robust/scene/scene.h"

namespace touchstone::bench_scenes {
namespace {

class ExactScene : public BuiltScene {
 public:
  explicit ExactScene(std::span<const Triangle> triangles) {
    scene_.add("scene", {.triangles = {triangles.begin(), triangles.end()}, .polygons = {}});
  }

  [[nodiscard]] bool any(const Ball& ball) const override { return scene_.touches(ball); }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    for (const scene::FaceId& id : scene_.touched(ball)) triangles.push_back(id.face);
  }

  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& center) const override {
    return scene_.nearest({center, 0})->face.face;
  }

  [[nodiscard]] std::optional<double> first_contact(const Motion& motion) const override {
    const auto first = scene_.first_contact(motion);
    return first ? std::optional(first->contact.time) : std::nullopt;
  }

 private:
  scene::Scene scene_;
};

}  // namespace

Library touchstone_library() {
  return {.name = "Scene",
          .build = [](const Mesh& mesh) { return std::make_unique<ExactScene>(mesh.triangles); },
          .exact = true,
          .knows_motions = true};
}

}  // namespace touchstone::bench_scenes
