// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "experiments/cases/case.h"
#include "experiments/methods/own_functions.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::methods {
namespace {

/// Names the stage that decided last.
class PreparedFiltered final : public PreparedMethod {
 public:
  explicit PreparedFiltered(const Polygon& polygon) : polygon_(polygon) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    filtered::StageCounts counts;
    PartialAnswer answer = answer_of(ball, kind, polygon_, counts);
    answer.stage = to_string(counts.last());
    return answer;
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    filtered::StageCounts counts;
    PartialAnswer answer = answer_of(motion, polygon_, counts);
    answer.stage = to_string(counts.last());
    return answer;
  }

 private:
  filtered::PreparedPolygon polygon_;
};

class ExactMesh final : public PreparedMethod {
 public:
  explicit ExactMesh(const PosedMesh& mesh) : mesh_(mesh) {}

  PartialAnswer ask(const Ball& ball, QueryKind) const override { return answer(ball); }
  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override { return answer(motion); }

 private:
  [[nodiscard]] PartialAnswer answer(const cases::Question& question) const {
    PartialAnswer answer = cases::exact_answer(cases::MeshShapes{question, mesh_});
    answer.stage = "exact";
    return answer;
  }

  PosedMesh mesh_;
};

/// A scene of the mesh alone, which its pose moves. The face that it names is asked for what a scene does not say.
class FilteredMesh final : public PreparedMethod {
 public:
  explicit FilteredMesh(const PosedMesh& mesh) : mesh_(mesh) {
    mesh::MeshFaces faces = mesh::scene_faces(mesh.mesh());
    numbers_ = std::move(faces.numbers);
    scene_.add("mesh", std::move(faces.faces), mesh.pose());
  }

  PartialAnswer ask(const Ball& ball, QueryKind) const override {
    const auto nearest = scene_.nearest(ball);
    const std::size_t face = numbers_[nearest->face.face];
    PartialAnswer of_face;
    of_face.relation = filtered::relation(ball, mesh_.faces()[face]);
    of_face.contact = scene_.touches(ball);
    of_face.nearest = nearest->feature;
    of_face.point = nearest->point;
    of_face.distance = nearest->distance;
    of_face.contact_normal = nearest->contact_normal;
    of_face.depth = nearest->depth;
    of_face.stage = kStage;
    return PartialAnswer::of_mesh(std::move(of_face), face, mesh_numbers(scene_.touched(ball)));
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    const auto first = scene_.first_contact(motion);
    const FirstContact contact = first ? first->contact : FirstContact{.kind = FirstContactKind::None};
    return PartialAnswer::of_mesh(PartialAnswer::of(contact, 0, kStage), first ? numbers_[first->face.face] : 0,
                                  mesh_numbers(scene_.touched(motion)));
  }

 private:
  static constexpr std::string_view kStage = "scene";

  [[nodiscard]] std::vector<std::size_t> mesh_numbers(const std::vector<scene::FaceId>& faces) const {
    std::vector<std::size_t> found;
    for (const scene::FaceId& id : faces) found.push_back(numbers_[id.face]);
    std::ranges::sort(found);
    return found;
  }

  PosedMesh mesh_;
  std::vector<std::uint32_t> numbers_;
  scene::Scene scene_;
};

template <class Prepared>
std::unique_ptr<PreparedMethod> prepared_mesh(const PosedMesh& mesh) {
  return std::make_unique<Prepared>(mesh);
}

}  // namespace

void add_exact(MethodList& list) {
  list.push_back(own_method<exact::PreparedPolygon>(
      "exact", "exact", "the truth: CGAL exact arithmetic, correctly rounded point and distance", Method::Kind::Slow,
      prepared_mesh<ExactMesh>));
}

void add_filtered(MethodList& list) {
  list.push_back(std::make_unique<Method>(
      "filtered", "certified: the answers of exact, at the cost of fast except near the boundary",
      [](const Polygon& polygon) { return std::make_unique<PreparedFiltered>(polygon); }, Method::Kind::Usual,
      prepared_mesh<FilteredMesh>));
}

void add_fast(MethodList& list) {
  list.push_back(own_method<fast::PreparedPolygon<double>>("fast", "double",
                                                           "the three tests in plain doubles, carefully written"));
  list.push_back(
      own_method<fast::PreparedPolygon<float>>("fast-float", "float", "the code of fast over 32-bit floats"));
  list.push_back(own_method<fast::PreparedPolygon<long double>>("fast-long-double", "long double",
                                                                "the code of fast over long doubles"));
}

}  // namespace touchstone::methods
