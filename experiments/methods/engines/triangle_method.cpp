// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/triangulate.h"

namespace touchstone::methods {
namespace {

/// Tests each triangle separately.
class EachTriangle : public PreparedMethod {
 public:
  EachTriangle(std::string_view stage, std::vector<Triangle> triangles, TriangleContact touches, TriangleSweep sweeps,
               TrianglesFilter answers)
      : stage_(stage),
        triangles_(std::move(triangles)),
        touches_(touches),
        sweeps_(sweeps),
        answers_(answers == nullptr || answers(triangles_)) {}

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind) const override { return any(ball, touches_); }

  [[nodiscard]] std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    if (sweeps_ == nullptr) return std::nullopt;
    return any(motion, sweeps_);
  }

 private:
  template <class Asked, class Test>
  [[nodiscard]] PartialAnswer any(const Asked& asked, Test test) const {
    PartialAnswer answer;
    answer.stage = stage_;
    answer.unsure = !answers_;
    if (!answers_) return answer;
    for (const Triangle& triangle : triangles_) {
      const std::optional<bool> touched = test(asked, triangle);
      if (!touched) answer.unsure = true;
      if (touched != true) continue;
      answer.contact = true;
      answer.unsure = false;
      return answer;
    }
    if (!answer.unsure) answer.contact = false;
    return answer;
  }

  std::string_view stage_;
  std::vector<Triangle> triangles_;
  TriangleContact touches_;
  TriangleSweep sweeps_;
  bool answers_;
};

class AskedScene : public PreparedMethod {
 public:
  AskedScene(std::string_view stage, const Library& library, std::vector<Triangle> triangles)
      : stage_(stage),
        knows_motions_(library.knows_motions),
        triangles_(std::move(triangles)),
        mesh_(triangles_),
        scene_(library.build(mesh_)) {}

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind) const override { return answer(scene_->any(ball)); }

  [[nodiscard]] std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    if (!knows_motions_) return std::nullopt;
    const auto time = scene_->any(motion.ball) ? std::optional(0.0) : scene_->first_contact(motion);
    PartialAnswer found = answer(time.has_value());
    found.time = time.value_or(std::numeric_limits<double>::infinity());
    return found;
  }

 private:
  [[nodiscard]] PartialAnswer answer(bool contact) const {
    PartialAnswer answer;
    answer.contact = contact;
    answer.stage = stage_;
    return answer;
  }

  std::string_view stage_;
  bool knows_motions_;
  std::vector<Triangle> triangles_;
  Mesh mesh_;
  std::unique_ptr<BuiltScene> scene_;
};

}  // namespace

void BuiltScene::all(const Ball&, std::vector<std::uint32_t>&) const {
  throw std::logic_error("a library without `all`");
}

std::uint32_t BuiltScene::nearest(const Eigen::Vector3d&) const {
  throw std::logic_error("a library without `nearest`");
}

std::optional<double> BuiltScene::first_contact(const Motion&) const {
  throw std::logic_error("a library without `first_contact`");
}

std::unique_ptr<Method> triangle_method(const char* name, const char* summary, TriangleContact contact,
                                        TriangleSweep sweep, TrianglesFilter answers) {
  return std::make_unique<Method>(name, summary, [=](const Polygon& polygon) {
    return std::make_unique<EachTriangle>(name, triangles_of(polygon), contact, sweep, answers);
  });
}

std::unique_ptr<Method> mesh_method(const char* name, const char* summary, Library library) {
  return std::make_unique<Method>(name, summary, [name, library = std::move(library)](const Polygon& polygon) {
    return std::make_unique<AskedScene>(name, library, triangles_of(polygon));
  });
}

}  // namespace touchstone::methods
