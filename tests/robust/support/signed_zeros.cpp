// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/signed_zeros.h"

#include <cmath>

#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

bool is_negative_zero(double x) { return x == 0 && std::signbit(x); }
bool has_negative_zero(const Eigen::Vector3d& p) {
  return is_negative_zero(p.x()) || is_negative_zero(p.y()) || is_negative_zero(p.z());
}

}  // namespace

void sign_zeros(double& x, workloads::Random& random) {
  if (x == 0) x = random.coin() ? -0.0 : 0.0;
}
void sign_zeros(Eigen::Vector3d& p, workloads::Random& random) {
  for (double& x : p) sign_zeros(x, random);
}
void sign_zeros(Ball& ball, workloads::Random& random) {
  sign_zeros(ball.center, random);
  sign_zeros(ball.radius, random);
}
void sign_zeros(Triangle& triangle, workloads::Random& random) {
  for (Eigen::Vector3d* vertex : {&triangle.a, &triangle.b, &triangle.c}) sign_zeros(*vertex, random);
}
void sign_zeros(Polygon& polygon, workloads::Random& random) {
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) sign_zeros(vertex, random);
  polygon = polygon_of(loops);
}
void sign_zeros(Pose& pose, workloads::Random& random) {
  for (double& x : pose.rotation.reshaped()) sign_zeros(x, random);
  sign_zeros(pose.translation, random);
}
void sign_zeros(Mesh& mesh, workloads::Random& random) {
  for (Eigen::Vector3d& vertex : mesh.vertices) sign_zeros(vertex, random);
}

void NegativeZeros::look_at(const Ball& ball) {
  center = center || has_negative_zero(ball.center);
  radius = radius || is_negative_zero(ball.radius);
}
void NegativeZeros::look_at(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) vertex = vertex || has_negative_zero(polygon.vertex(i));
}
void NegativeZeros::look_at(const Triangle& t) {
  vertex = vertex || has_negative_zero(t.a) || has_negative_zero(t.b) || has_negative_zero(t.c);
}

}  // namespace touchstone::contact_tests
