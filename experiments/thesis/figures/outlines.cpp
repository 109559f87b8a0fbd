// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/outlines.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace touchstone::figures {

Polygon Outline::polygon() const {
  Loop loop;
  for (const auto& [x, y] : corners) loop.emplace_back(x, y, 0);
  return Polygon(loop);
}

double Outline::area() const {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [x, y] = corners[i];
    const auto& [next_x, next_y] = corners[(i + 1) % corners.size()];
    twice += x * next_y - next_x * y;
  }
  return std::abs(twice) / 2;
}

const std::vector<Outline>& outlines() {
  static const std::vector<Outline> all{
      {"triangle", {{-1, 0}, {1, 0}, {0, 1}}},
      {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
      {"U3x3", {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {"U3x5", {{0, 0}, {3, 0}, {3, 5}, {2, 5}, {2, 1}, {1, 1}, {1, 5}, {0, 5}}},
      {"comb", {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {"dart", {{0, 0}, {2, 1}, {0, 2}, {0.7, 1}}},
      // Ten points at angles 90 + 36 i degrees, radii 1 and 0.382 in turn.
      {"star",
       {{0, 1},
        {-0.22453396637572473, 0.30904449185122992},
        {-0.95105651629515353, 0.30901699437494745},
        {-0.36330358922474865, -0.11804449185122992},
        {-0.58778525229247314, -0.80901699437494745},
        {0, -0.382},
        {0.58778525229247314, -0.80901699437494745},
        {0.36330358922474865, -0.11804449185122992},
        {0.95105651629515353, 0.30901699437494745},
        {0.22453396637572473, 0.30904449185122992}}}};
  return all;
}

const Outline& find_outline(std::string_view name) {
  const auto found = std::ranges::find(outlines(), name, &Outline::name);
  assert(found != outlines().end());
  return *found;
}

Eigen::Vector3d Box::point(workloads::Random& random) const {
  const double x = left + width() * random.unit();
  return {x, bottom + height() * random.unit(), 0};
}

Box bounds(const Outline& outline) {
  const auto by_y = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto [left, right] = std::ranges::minmax_element(outline.corners);
  const auto [bottom, top] = std::ranges::minmax_element(outline.corners, by_y);
  return {left->first, right->first, bottom->second, top->second};
}

}  // namespace touchstone::figures
