// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "experiments/cases/method.h"
#include "geometry/shapes/rejection.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/posing.h"

namespace touchstone::cases {

PosedMesh::PosedMesh(Mesh mesh, const Pose& pose) : mesh_(std::move(mesh)), pose_(pose), order_(mesh_.faces.size()) {
  assert(!mesh_.faces.empty());
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i)
    if (!mesh_.vertices[i].allFinite())
      throw Rejected({RejectionCode::NotFinite, fmt::format("vertex {} of the mesh is not finite", i)});
  if (!scene::is_finite(pose_)) throw Rejected({RejectionCode::NotFinite, "the pose is not finite"});
  for (std::size_t face = 0; face < mesh_.faces.size(); ++face) try {
      faces_.push_back(scene::posed(pose_, mesh::face_polygon(mesh_, face)));
    } catch (const Rejected& rejected) {
      const auto& [code, message] = rejected.rejection();
      throw Rejected({code, fmt::format("face {} of the mesh: {}", face, message)});
    }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_partition(order_.begin(), order_.end(),
                        [this](std::size_t face) { return faces_[face].vertex_count() == 3; });
}

namespace {

/// Asks a method about every face of a mesh.
class EachFace final : public PreparedMethod {
 public:
  EachFace(const Method& method, const PosedMesh& mesh) : order_(mesh.order()) {
    for (const Polygon& face : mesh.faces()) faces_.push_back(method.prepare(face));
  }

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    std::vector<PartialAnswer> answers;
    for (const auto& face : faces_) answers.push_back(face->ask(ball, kind));
    return combined(answers, &PartialAnswer::distance);
  }

  [[nodiscard]] std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    std::vector<PartialAnswer> answers;
    for (const auto& face : faces_) {
      std::optional<PartialAnswer> answer = face->ask_moving(motion);
      if (!answer) return std::nullopt;
      answers.push_back(std::move(*answer));
    }
    return combined(answers, &PartialAnswer::time);
  }

 private:
  /// Returns the answer about the mesh, of which the least value of `by` decides which face is nearest or first. A key
  /// that the answer about a face lacks is absent.
  [[nodiscard]] PartialAnswer combined(const std::vector<PartialAnswer>& answers,
                                       std::optional<double> PartialAnswer::*by) const {
    const auto all_have = [&](auto member) {
      return std::ranges::all_of(answers, [&](const PartialAnswer& answer) { return (answer.*member).has_value(); });
    };
    std::vector<std::size_t> touched;
    for (std::size_t face = 0; face < answers.size(); ++face)
      if (answers[face].contact == true) touched.push_back(face);
    PartialAnswer all;
    if (all_have(by)) {
      const auto value = [&](std::size_t face) {
        const double number = *(answers[face].*by);
        return std::isnan(number) ? std::numeric_limits<double>::infinity() : number;
      };
      const std::size_t least = *std::ranges::min_element(order_, {}, value);
      all = PartialAnswer::of_mesh(answers[least], least, {});
    }
    all.contact.reset();
    all.touched.reset();
    all.relation.reset();
    if (!touched.empty()) all.contact = true;
    if (all_have(&PartialAnswer::contact)) all.contact = !touched.empty(), all.touched = std::move(touched);
    if (all_have(&PartialAnswer::relation))
      all.relation = std::ranges::max(answers, {}, &PartialAnswer::relation).relation;
    all.unsure = !all.contact.has_value();
    all.stage = answers.front().stage;
    return all;
  }

  std::vector<std::unique_ptr<PreparedMethod>> faces_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::unique_ptr<PreparedMethod> Method::prepare(const PosedMesh& mesh) const {
  return prepare_mesh_ ? prepare_mesh_(mesh) : std::make_unique<EachFace>(*this, mesh);
}

}  // namespace touchstone::cases
