// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <filesystem>
#include <fstream>

#include "geometry/contact/first_contact.h"
#include "geometry/shapes/motion.h"
#include "robust/exact/validate.h"
#include "robust/mesh/weld.h"
#include "robust/scene/posing.h"
#include "tests/experiments/support/scratch.h"
#include "tests/robust/every_state/public_function.h"

namespace touchstone::every_state_tests {
namespace {

/// The least double nearer to zero, or farther from it.
double neighbour(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1U); }

/// The input's pose with one number moved by one double.
Pose moved(const Input& input) {
  Pose pose = input.pose;
  const auto k = static_cast<Eigen::Index>(input.index % 12);
  double& x = k < 9 ? pose.rotation.reshaped()[k] : pose.translation[k - 9];
  x = neighbour(x);
  return pose;
}

Polygon moved_polygon(const Input& input) {
  Loop loop = input.any_outer;
  loop[2][1] = neighbour(loop[2][1]);
  return Polygon(loop);
}

/// The input's mesh as a file.
std::filesystem::path written(const Input& input) {
  static const run_tests::Scratch folder;
  const auto file = folder.path / ("mesh-" + std::to_string(input.index) + input.mesh_file.extension);
  if (!std::filesystem::exists(file)) std::ofstream(file, std::ios::binary) << input.mesh_file.bytes;
  return file;
}

Answer answer_at(double x) {
  return {PlaneSide::Behind, false, PointLocation::Inside, {}, Relation::Separate, {}, {x, 0, 0}, 1, 0};
}

}  // namespace

std::vector<PublicFunction> shape_functions() {
  return {
      gives("find_fault", [](const Input& in) { return find_fault(in.any_ball); }),
      gives("find_fault",  // of a motion
            [](const Input& in) {
              return find_fault(Motion{in.ball, in.any_ball.center});
            }),
      hands_on("Motion::Motion",
               [](const Input& in) {
                 const Motion motion(in.ball, in.any_ball.center);
                 return std::pair(motion.ball.center, motion.to);
               }),
      hands_on("Polygon::Polygon", [](const Input& in) { return Polygon(in.any_outer, in.any_holes); }),
      hands_on("Polygon::vertex", [](const Input& in) { return in.polygon.vertex(1); }),
      hands_on("Polygon::coordinates", [](const Input& in) { return in.polygon.coordinates(0)[0]; }),
      gives("Polygon::operator==",
            [](const Input& in) {
              return std::array{in.polygon == in.polygon, Polygon(in.any_outer) == moved_polygon(in)};
            }),
      gives("operator==",  // of poses
            [](const Input& in) {
              return std::array{in.pose == in.pose, in.pose == moved(in), in.pose == Pose(), in.pose == in.any_pose};
            }),
      gives("operator==",  // of answers
            [](const Input& in) {
              const double x = in.point.x();
              return std::array{answer_at(x) == answer_at(x), answer_at(x) == answer_at(neighbour(x))};
            }),
      gives("operator==",  // of first contacts
            [](const Input& in) {
              const FirstContact first{FirstContactKind::Way, in.ball.radius, false, {}, in.point};
              FirstContact other = first;
              other.point = in.ball.center;
              return std::array{first == first, first == other};
            }),
      gives("operator==",
            [](const Input& in) {
              const filtered::ClosestPoint here{{}, in.point, 0}, there{{}, in.point, neighbour(0)};
              return std::array{here == here, here == there};
            }),
      gives("same_number",
            [](const Input& in) {
              const double x = in.point.x();
              return std::array{same_number(x, x), same_number(x, neighbour(x)), same_number(0, neighbour(0))};
            }),
      gives("same_point",
            [](const Input& in) {
              Eigen::Vector3d other = in.point;
              other.z() = neighbour(other.z());
              return std::array{same_point(in.point, in.point), same_point(in.point, other)};
            }),
      hands_on("BoxTree::BoxTree", [](const Input& in) { return BoxTree(in.boxes); }),
      hands_on("BoxTree::refit",
               [](const Input& in) {
                 BoxTree tree(in.boxes);
                 tree.refit(std::vector<Box>(in.boxes.rbegin(), in.boxes.rend()));
                 return tree;
               }),
      gives("BoxTree::scale",
            [](const Input& in) {
              const BoxTree tree(in.boxes);
              return std::array{tree.scale()[0], tree.scale()[1]};
            }),
      gives("BoxTree::growth",
            [](const Input& in) {
              BoxTree tree(std::span(in.boxes).first(10));
              tree.refit(std::span(in.boxes).last(10));
              return tree.growth();
            }),
      gives("BoxTree::Node::step",
            [](const Input& in) {
              std::vector<float> steps;
              const BoxTree tree(in.boxes);
              for (const BoxTree::Node& node : tree.nodes()) steps.push_back(node.step());
              return steps;
            }),
      hands_on("BoxTree::nodes", [](const Input& in) { return BoxTree(in.boxes); }),
      hands_on("read_mesh", [](const Input& in) { return read_mesh(written(in), OnFault::Skip); }),
      hands_on("read_mesh",
               [](const Input& in) {
                 return read_mesh(in.mesh_file.bytes, std::string_view(in.mesh_file.extension).substr(1), "memory",
                                  OnFault::Skip);
               }),
      gives("exact::validate",
            [](const Input& in) {
              return exact::validate(Polygon({in.ball.center, in.point, in.any_ball.center}));
            }),
      hands_on("mesh::weld", [](const Input& in) { return mesh::weld(in.mesh); }),
      hands_on("mesh::merge_faces", [](const Input& in) { return mesh::merge_faces(in.mesh, in.any_tolerance); }),
      hands_on("mesh::merge_faces",
               [](const Input& in) {
                 const std::atomic<bool> stop = false;
                 return mesh::merge_faces(in.mesh, in.any_tolerance, stop);
               }),
      hands_on("mesh::scene_faces",
               [](const Input& in) {
                 Mesh with_segment = in.mesh;
                 with_segment.faces.push_back({0, 1, 0});
                 return std::pair(mesh::scene_faces(in.mesh, mesh::OnBadFace::LeaveOut),
                                  mesh::scene_faces(with_segment, mesh::OnBadFace::AsSegments));
               }),
      hands_on("mesh::face_polygon", [](const Input& in) { return mesh::face_polygon(in.mesh, 0); }),
      hands_on("mesh::scene_faces",
               [](const Input& in) { return mesh::scene_faces(in.mesh, mesh::merge_faces(in.mesh)); }),
      gives("scene::is_finite", [](const Input& in) { return scene::is_finite(in.any_pose); }),
      gives("scene::expect_valid",
            [](const Input& in) {
              scene::expect_valid(in.any_triangle);
              return "valid";
            }),
      gives("scene::posed", [](const Input& in) { return scene::posed(in.pose, in.point); }),
      gives("scene::posed",
            with_counts([](const Input& in, filtered::StageCounts& n) { return scene::posed(in.pose, in.point, n); })),
      gives("scene::posed",
            [](const Input& in) {
              const Degenerate degenerate = in.index % 2 == 0 ? Degenerate::Refuse : Degenerate::AsSegments;
              return scene::posed(in.any_pose, in.any_triangle, degenerate);
            }),
      gives("scene::posed", [](const Input& in) { return scene::posed(in.any_pose, in.polygon); }),
  };
}

}  // namespace touchstone::every_state_tests
