// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/bvh/box_tree.h"
#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "geometry/io/read_mesh.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "robust/mesh/merge.h"
#include "robust/mesh/scene_faces.h"
#include "robust/scene/scene.h"

namespace touchstone::every_state_tests {

/// A result, member by member: equal texts mean equal bits.
class Bytes {
 public:
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Does the result hold a -0.0?
  [[nodiscard]] bool negative_zero() const { return negative_zero_; }

  void add(const std::string& s) { text_ += s + ' '; }
  void add(double x) {
    text_ += std::to_string(std::bit_cast<std::uint64_t>(x)) + ' ';
    negative_zero_ = negative_zero_ || std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(-0.0);
  }
  void add(float x) { add(static_cast<double>(x)); }
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T x) { text_ += std::to_string(static_cast<std::int64_t>(x)) + ' '; }
  void add(const Eigen::Vector3d& p) {
    for (const double x : p) add(x);
  }
  void add(const Pose& pose) {
    for (const double x : pose.rotation.reshaped()) add(x);
    add(pose.translation);
  }
  void add(const Feature& f) { add(f.kind), add(f.index); }
  void add(const Answer& a) {
    add(a.plane), add(a.plane_tangent), add(a.foot), add(a.edges_hit), add(a.relation), add(a.nearest), add(a.point);
    add(a.distance), add(a.contact_normal), add(a.depth), add(a.off_plane);
  }
  void add(const FirstContact& f) {
    add(f.kind), add(f.time), add(f.momentary), add(f.feature), add(f.point), add(f.contact_normal), add(f.depth);
  }
  void add(const filtered::ClosestPoint& p) { add(p.feature), add(p.point), add(p.distance), add(p.contact_normal); }
  void add(const scene::FaceId& id) { add(id.object), add(id.face); }
  void add(const scene::NearestFace& n) {
    add(n.face), add(n.feature), add(n.point), add(n.distance), add(n.contact_normal), add(n.depth);
  }
  void add(const scene::FirstFace& f) { add(f.face), add(f.contact); }
  void add(const Rejection& r) { add(r.code), add(r.message); }
  void add(const Triangle& t) { add(t.a), add(t.b), add(t.c); }
  void add(const Polygon& p) {
    for (int axis = 0; axis < 3; ++axis)
      for (const double x : p.coordinates(axis)) add(x);
    for (std::size_t loop = 0; loop < p.loop_count(); ++loop) add(p.loop_end(loop));
  }
  void add(const BoxTree& tree) {
    for (const BoxTree::Node& node : tree.nodes()) {
      for (int axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < BoxTree::kWidth; ++i) add(node.low[axis][i]), add(node.high[axis][i]);
      for (const float origin : node.origin) add(origin);
      for (const std::uint8_t count : node.count) add(count);
      add(node.first_node), add(node.first_leaf), add(node.exponent), add(node.leaf_count), add(node.child_count);
    }
    add(tree.order()), add(tree.scale()[0]), add(tree.scale()[1]);
  }
  void add(const Mesh& m) { add(m.vertices), add(m.faces); }
  void add(const ReadMesh& m) { add(m.mesh), add(m.left_out), add(m.parts_left_out), add(m.warnings); }
  void add(const mesh::MergedFace& f) { add(f.polygon), add(f.faces), add(f.off_plane); }
  void add(const scene::Faces& f) { add(f.triangles), add(f.polygons); }
  void add(const mesh::MeshFaces& f) { add(f.faces), add(f.numbers), add(f.left_out), add(f.segments); }
  void add(const mesh::SegmentFace& f) { add(f.face), add(f.corners); }
  void add(const mesh::RejectedFace& f) { add(f.face), add(f.rejection); }
  void add(const mesh::MergedMesh& m) { add(m.faces), add(m.rejected), add(m.edges.merged), add(m.splits); }
  void add(const mesh::SceneFaces& f) { add(f.faces.triangles), add(f.faces.polygons), add(f.merged); }
  template <class T>
  void add(const std::vector<T>& all) {
    add(all.size());
    for (const auto& each : all) add(each);
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& all) {
    for (const auto& each : all) add(each);
  }
  template <class T>
  void add(const std::optional<T>& maybe) {
    add(maybe.has_value());
    if (maybe) add(*maybe);
  }
  template <class First, class Second>
  void add(const std::pair<First, Second>& both) {
    add(both.first), add(both.second);
  }

 private:
  std::string text_;
  bool negative_zero_ = false;
};

}  // namespace touchstone::every_state_tests
