// SPDX-License-Identifier: GPL-3.0-or-later

// The points come in random order already; CGAL's shuffle would take numbers from std::rand.
#define CGAL_DONT_SHUFFLE_IN_RANDOM_POLYGON_2
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/random_polygon_2.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "experiments/workloads/outline.h"

namespace touchstone::workloads {

LatticeLoop random_simple(Random& random, std::size_t vertices) {
  // Doubles decide exactly here: differences are below 2^22, products below 2^44.
  using Kernel = CGAL::Simple_cartesian<double>;
  vertices = std::max<std::size_t>(vertices, 4);

  std::vector<Kernel::Point_2> points;
  std::set<std::pair<std::int64_t, std::int64_t>> taken;
  while (points.size() < vertices) {
    const std::int64_t x = random.integer(-kLatticeRadius, kLatticeRadius);
    const std::int64_t y = random.integer(-kLatticeRadius, kLatticeRadius);
    if (taken.emplace(x, y).second) points.emplace_back(static_cast<double>(x), static_cast<double>(y));
  }

  std::vector<Kernel::Point_2> polygon;
  CGAL::random_polygon_2(points.size(), std::back_inserter(polygon), points.begin());

  LatticeLoop loop;
  for (const Kernel::Point_2& p : polygon)
    loop.push_back({static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y())});
  return loop;
}

}  // namespace touchstone::workloads
