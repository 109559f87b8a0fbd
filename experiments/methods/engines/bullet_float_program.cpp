// SPDX-License-Identifier: GPL-3.0-or-later
// An engine of Bullet's float build, for `touchstone judge --engine`: it decides contact, of moving balls too. Its
// symbols have the names of the double build, so one program cannot link both.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/methods/engines/bullet_sweep.h"
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

std::array<double, 4> numbers_of(const json& ball) {
  const json& center = ball["center"];
  return {center[0].get<double>(), center[1].get<double>(), center[2].get<double>(), ball["radius"].get<double>()};
}

std::array<double, 9> numbers_of(const Triangle& t) {
  return {t.a.x(), t.a.y(), t.a.z(), t.b.x(), t.b.y(), t.b.z(), t.c.x(), t.c.y(), t.c.z()};
}

bool touches(const json& ball, const std::vector<Triangle>& triangles) {
  return std::ranges::any_of(triangles, [&](const Triangle& t) {
    return methods::bullet_contact(numbers_of(ball).data(), numbers_of(t).data());
  });
}

/// Returns infinity without contact.
double first_time(const json& ball, const json& motion, const std::vector<Triangle>& triangles) {
  const auto to = motion["to"].get<std::array<double, 3>>();
  double first = std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles)
    first = std::min(first, methods::bullet_sweep(numbers_of(ball).data(), to.data(), numbers_of(t).data()));
  return first;
}

/// Returns the verdict about a case, without its id.
json verdict(const json& given, const std::vector<Triangle>& triangles) {
  if (!given.contains("motion")) return {{"contact", touches(given["ball"], triangles)}};
  const double time = first_time(given["ball"], given["motion"], triangles);
  const bool contact = std::isfinite(time);
  return {{"contact", contact}, {"time", contact ? json(time) : json()}};
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
    nlohmann::json answer = touchstone::verdict(given, triangles);
    answer["id"] = given["id"];
    std::cout << answer << std::endl;
  }
}
