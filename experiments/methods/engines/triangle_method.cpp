// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <limits>
#include <memory>
#include <set>
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

/// The triangles of faces, and the number of the face that each belongs to.
struct FaceTriangles {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> faces;

  explicit FaceTriangles(const std::vector<Polygon>& polygons) {
    for (std::size_t face = 0; face < polygons.size(); ++face) {
      const std::vector<Triangle> some = triangles_of(polygons[face]);
      triangles.insert(triangles.end(), some.begin(), some.end());
      faces.resize(triangles.size(), face);
    }
  }
};

class AskedScene : public PreparedMethod {
 public:
  AskedScene(std::string_view stage, std::shared_ptr<const Library> library, FaceTriangles faces, bool is_mesh)
      : stage_(stage),
        library_(std::move(library)),
        faces_(std::move(faces)),
        is_mesh_(is_mesh),
        mesh_(faces_.triangles),
        scene_(library_->build(mesh_)) {}

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    PartialAnswer found = answer(scene_->any(ball));
    if (!is_mesh_ || kind != QueryKind::Answer) return found;
    if (library_->knows_nearest) found.face = faces_.faces[scene_->nearest(ball.center)];
    if (library_->knows_all) {
      std::vector<std::uint32_t> triangles;
      scene_->all(ball, triangles);
      std::set<std::size_t> touched;
      for (const std::uint32_t triangle : triangles) touched.insert(faces_.faces[triangle]);
      found.touched = {touched.begin(), touched.end()};
    }
    return found;
  }

  [[nodiscard]] std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    if (!library_->knows_motions) return std::nullopt;
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
  std::shared_ptr<const Library> library_;
  FaceTriangles faces_;
  bool is_mesh_;
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
  const auto known = std::make_shared<const Library>(std::move(library));
  const auto prepare = [name, known](const std::vector<Polygon>& faces, bool is_mesh) {
    return std::make_unique<AskedScene>(name, known, FaceTriangles(faces), is_mesh);
  };
  return std::make_unique<Method>(
      name, summary, [prepare](const Polygon& polygon) { return prepare({polygon}, false); }, Method::Kind::Usual,
      [prepare](const PosedMesh& mesh) { return prepare(mesh.faces(), true); });
}

}  // namespace touchstone::methods
