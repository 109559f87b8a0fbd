// SPDX-License-Identifier: GPL-3.0-or-later

// The points come in random order already; CGAL's shuffle would take numbers from std::rand.
#define CGAL_DONT_SHUFFLE_IN_RANDOM_POLYGON_2
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/random_polygon_2.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/outline.h"

namespace touchstone::workloads {
namespace {

// Doubles decide exactly here: differences are below 2^22, products below 2^44.
using Kernel = CGAL::Simple_cartesian<double>;

// Orientations asked for, by the cube of the number of points; of a million outlines that came to an end none took 0.5.
constexpr std::uint64_t kPatience = 4;

struct GoesInCircles {};

/// A kernel that gives up after a number of orientations. If three points are collinear, the moves of CGAL need not
/// make the polygon shorter: they may return to an earlier state and never end.
class PatientKernel : public Kernel {
 public:
  explicit PatientKernel(std::uint64_t& patience) : patience_(patience) {}

  struct Orientation_2 {
    CGAL::Orientation operator()(const Kernel::Point_2& p, const Kernel::Point_2& q, const Kernel::Point_2& r) const {
      if (patience-- == 0) throw GoesInCircles();
      return Kernel().orientation_2_object()(p, q, r);
    }
    std::uint64_t& patience;
  };
  [[nodiscard]] Orientation_2 orientation_2_object() const { return {patience_}; }

 private:
  std::uint64_t& patience_;
};

std::vector<Kernel::Point_2> random_points(Random& random, std::size_t count) {
  std::vector<Kernel::Point_2> points;
  std::set<std::pair<std::int64_t, std::int64_t>> taken;
  while (points.size() < count) {
    const std::int64_t x = random.integer(-kLatticeRadius, kLatticeRadius);
    const std::int64_t y = random.integer(-kLatticeRadius, kLatticeRadius);
    if (taken.emplace(x, y).second) points.emplace_back(static_cast<double>(x), static_cast<double>(y));
  }
  return points;
}

/// Returns a simple polygon with these vertices; nothing if CGAL does not find one.
std::optional<std::vector<Kernel::Point_2>> polygon_through(const std::vector<Kernel::Point_2>& points) try {
  std::uint64_t patience = kPatience * points.size() * points.size() * points.size();
  std::vector<Kernel::Point_2> polygon;
  CGAL::random_polygon_2(points.size(), std::back_inserter(polygon), points.begin(), PatientKernel(patience));
  return polygon;
} catch (const GoesInCircles&) {
  return std::nullopt;
}

}  // namespace

LatticeLoop random_simple(Random& random, std::size_t vertices) {
  std::optional<std::vector<Kernel::Point_2>> polygon;
  while (!polygon) polygon = polygon_through(random_points(random, std::max<std::size_t>(vertices, 4)));

  LatticeLoop loop;
  for (const Kernel::Point_2& p : *polygon)
    loop.push_back({static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y())});
  return loop;
}

}  // namespace touchstone::workloads
