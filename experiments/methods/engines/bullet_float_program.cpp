// SPDX-License-Identifier: GPL-3.0-or-later
// An engine of Bullet's float build, for `touchstone judge --engine`: it decides contact, of moving balls too. Its
// symbols have the names of the double build, so one program cannot link both.
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/methods/engines/bullet_mesh.h"
#include "experiments/methods/triangulate.h"

static_assert(sizeof(btScalar) == sizeof(float), "this is about Bullet's float build");

namespace touchstone {
namespace {

using nlohmann::json;

Eigen::Vector3d point_in(const json& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }

Loop loop_in(const json& points) {
  Loop loop;
  for (const json& p : points) loop.push_back(point_in(p));
  return loop;
}

Polygon polygon_in(const json& polygon) {
  std::vector<Loop> holes;
  for (const json& hole : polygon.value("holes", json::array())) holes.push_back(loop_in(hole));
  return Polygon(loop_in(polygon["outer"]), holes);
}

Ball ball_in(const json& ball) { return {point_in(ball["center"]), ball["radius"].get<double>()}; }

/// The triangles of a polygon as Bullet holds them: in floats.
class FloatMesh {
 public:
  explicit FloatMesh(const Polygon& polygon) : triangles_(methods::triangles_of(polygon)), mesh_(triangles_) {
    for (const Eigen::Vector3d& vertex : mesh_.vertices)
      for (const double x : vertex) numbers_.push_back(static_cast<float>(x));
    bullet_.emplace(numbers_.data(), mesh_.vertices.size(), mesh_.corners.data(), mesh_.corners.size());
  }

  [[nodiscard]] bool touches(const Ball& ball) const {
    bool found = false;
    bullet_->each_touched(ball, [&](std::uint32_t) { found = true; });
    return found;
  }

  /// Returns infinity without contact.
  [[nodiscard]] double first_time(const Motion& motion) { return touches(motion.ball) ? 0 : bullet_->sweep(motion); }

 private:
  std::vector<Triangle> triangles_;
  methods::Mesh mesh_;
  std::vector<float> numbers_;
  std::optional<methods::BulletMesh> bullet_;
};

/// Returns the verdict about a case, without its id.
json verdict(const json& given, FloatMesh& mesh) {
  const Ball ball = ball_in(given["ball"]);
  if (!given.contains("motion")) return {{"contact", mesh.touches(ball)}};
  const double time = mesh.first_time({ball, point_in(given["motion"]["to"])});
  const bool contact = std::isfinite(time);
  return {{"contact", contact}, {"time", contact ? json(time) : json()}};
}

}  // namespace
}  // namespace touchstone

int main() {
  nlohmann::json polygon;  // of the case before: usually that of the next
  std::optional<touchstone::FloatMesh> mesh;
  for (std::string line; std::getline(std::cin, line);) {
    nlohmann::json given = nlohmann::json::parse(line);
    if (given["polygon"] != polygon) {
      polygon = std::move(given["polygon"]);
      mesh.emplace(touchstone::polygon_in(polygon));
    }
    nlohmann::json answer = touchstone::verdict(given, *mesh);
    answer["id"] = given["id"];
    std::cout << answer << std::endl;
  }
}
