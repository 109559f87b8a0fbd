// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/lattice/lattice_loops.h"

namespace touchstone::lattice_tests {
namespace {

int turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const int product = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (product > 0) - (product < 0);
}

bool holds(const LatticePoint& a, const LatticePoint& b, const LatticePoint& p) {
  return turn(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

bool meet(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  if (holds(a, b, c) || holds(a, b, d) || holds(c, d, a) || holds(c, d, b)) return true;
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Does the path a, b, c turn back on itself?
bool is_spike(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return turn(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0;
}

/// Grows paths vertex by vertex. A loop starts at its lowest vertex, and the second is lower than the last.
class Search {
 public:
  Search(int width, int height, std::size_t most_vertices) : most_vertices_(most_vertices) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) points_.push_back({x, y});
    used_.resize(points_.size());
    for (std::size_t start = 0; start < points_.size(); ++start) extended_by(start);
  }

  std::vector<LatticeLoop> found;

 private:
  void extended_by(std::size_t point) {
    path_.push_back(points_[point]);
    numbers_.push_back(point);
    used_[point] = true;
    if (numbers_.size() >= 3 && numbers_[1] < numbers_.back() && closes()) found.push_back(path_);
    if (numbers_.size() < most_vertices_)
      for (std::size_t next = numbers_[0] + 1; next < points_.size(); ++next)
        if (!used_[next] && admits(points_[next])) extended_by(next);
    used_[point] = false;
    numbers_.pop_back();
    path_.pop_back();
  }

  [[nodiscard]] bool admits(const LatticePoint& next) const {
    const std::size_t n = path_.size();
    if (n >= 2 && is_spike(path_[n - 2], path_[n - 1], next)) return false;
    for (std::size_t i = 0; i + 2 < n; ++i)
      if (meet(path_[i], path_[i + 1], path_[n - 1], next)) return false;
    return true;
  }

  [[nodiscard]] bool closes() const {
    const std::size_t n = path_.size();
    if (is_spike(path_[n - 2], path_[n - 1], path_[0]) || is_spike(path_[n - 1], path_[0], path_[1])) return false;
    for (std::size_t i = 1; i + 2 < n; ++i)
      if (meet(path_[i], path_[i + 1], path_[n - 1], path_[0])) return false;
    return true;
  }

  std::size_t most_vertices_;
  std::vector<LatticePoint> points_;
  std::vector<bool> used_;
  LatticeLoop path_;
  std::vector<std::size_t> numbers_;
};

}  // namespace

std::vector<LatticeLoop> simple_loops(int width, int height, std::size_t most_vertices) {
  return Search(width, height, most_vertices).found;
}

PointLocation place(const std::vector<LatticeLoop>& loops, const LatticePoint& point) {
  bool inside = false;
  for (const LatticeLoop& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const LatticePoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (holds(a, b, point)) return PointLocation::Boundary;
      // A point on the vertical line through `point` lies to the left of the ray.
      const bool left_start = a.x <= point.x, left_end = b.x <= point.x;
      if (left_start != left_end && turn(a, b, point) == (left_start ? -1 : 1)) inside = !inside;
    }
  return inside ? PointLocation::Inside : PointLocation::Outside;
}

int doubled_area(const LatticeLoop& loop) {
  int sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const LatticePoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

}  // namespace touchstone::lattice_tests
