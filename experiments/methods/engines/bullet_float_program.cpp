// SPDX-License-Identifier: GPL-3.0-or-later
// An engine of Bullet's float build, for `touchstone judge --engine`: it decides contact. Its symbols have the names of
// the double build, so one program cannot link both.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/methods/engines/bullet_contact.h"
#include "experiments/methods/triangulate.h"

static_assert(sizeof(btScalar) == sizeof(float), "this is about Bullet's float build");

namespace touchstone {
namespace {

using nlohmann::json;

Loop loop_in(const json& points) {
  Loop loop;
  for (const json& p : points) loop.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
  return loop;
}

Polygon polygon_in(const json& polygon) {
  std::vector<Loop> holes;
  for (const json& hole : polygon.value("holes", json::array())) holes.push_back(loop_in(hole));
  return Polygon(loop_in(polygon["outer"]), holes);
}

bool touches(const json& ball, const std::vector<Triangle>& triangles) {
  const json& center = ball["center"];
  const double sphere[]{center[0].get<double>(), center[1].get<double>(), center[2].get<double>(),
                        ball["radius"].get<double>()};
  return std::ranges::any_of(triangles, [&](const Triangle& t) {
    const double corners[]{t.a.x(), t.a.y(), t.a.z(), t.b.x(), t.b.y(), t.b.z(), t.c.x(), t.c.y(), t.c.z()};
    return methods::bullet_contact(sphere, corners);
  });
}

}  // namespace
}  // namespace touchstone

int main() {
  nlohmann::json polygon;  // of the case before: usually that of the next
  std::vector<touchstone::Triangle> triangles;
  for (std::string line; std::getline(std::cin, line);) {
    nlohmann::json given = nlohmann::json::parse(line);
    if (given["polygon"] != polygon) {
      polygon = std::move(given["polygon"]);
      triangles = touchstone::methods::triangles_of(touchstone::polygon_in(polygon));
    }
    const bool contact = touchstone::touches(given["ball"], triangles);
    std::cout << nlohmann::json{{"id", given["id"]}, {"contact", contact}} << std::endl;
  }
}
