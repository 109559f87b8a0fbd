// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/lattice/lattice_loops.h"

#include <algorithm>

namespace touchstone::lattice_tests {
namespace {

int turn(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const int product = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (product > 0) - (product < 0);
}

bool holds(const LatticePoint& a, const LatticePoint& b, const LatticePoint& p) {
  return turn(a, b, p) == 0 && (p.x - a.x) * (p.x - b.x) + (p.y - a.y) * (p.y - b.y) <= 0;
}

/// Do the segments a b and c d cross between their ends, or share more than a point?
bool meet(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  if (turn(a, b, c) != 0 || turn(a, b, d) != 0)
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  const auto along = [&](const LatticePoint& p) { return (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y); };
  return std::min(std::max(along(c), along(d)), along(b)) > std::max(std::min(along(c), along(d)), 0);
}

/// Is p to the left of the path a, b, c near b? Requires that it is on none of the two rays from b.
bool is_left(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& p) {
  const bool left_of_first = turn(a, b, p) > 0, left_of_second = turn(b, c, p) > 0;
  return turn(a, b, c) >= 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
}

/// Grows paths vertex by vertex. A loop starts at its lowest vertex. Of all sequences that are the same loop it takes
/// the lowest.
class Search {
 public:
  Search(int width, int height, std::size_t most_vertices) : most_vertices_(most_vertices) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) points_.push_back({x, y});
    for (std::size_t start = 0; start < points_.size(); ++start) extended_by(start);
  }

  std::vector<LatticeLoop> found;

 private:
  void extended_by(std::size_t point) {
    path_.push_back(points_[point]);
    numbers_.push_back(point);
    if (numbers_.size() >= 3 && closes() && is_lowest()) found.push_back(path_);
    if (numbers_.size() < most_vertices_)
      for (std::size_t next = numbers_[0]; next < points_.size(); ++next)
        if (next != point && admits(points_[next])) extended_by(next);
    numbers_.pop_back();
    path_.pop_back();
  }

  [[nodiscard]] bool admits(const LatticePoint& next) const {
    for (std::size_t i = 0; i + 1 < path_.size(); ++i)
      if (meet(path_[i], path_[i + 1], path_.back(), next)) return false;
    return true;
  }

  [[nodiscard]] bool closes() const {
    if (path_.front() == path_.back() || !admits(path_[0])) return false;
    for (std::size_t vertex = 0; vertex < path_.size(); ++vertex)
      for (std::size_t edge = 0; edge < path_.size(); ++edge)
        if (crosses(vertex, edge)) return false;
    return true;
  }

  [[nodiscard]] const LatticePoint& at(std::size_t i) const { return path_[i % path_.size()]; }

  /// Does the loop cross itself at this vertex, which is the start of the edge or lies between its ends?
  [[nodiscard]] bool crosses(std::size_t vertex, std::size_t edge) const {
    const LatticePoint &here = at(vertex), &start = at(edge), &end = at(edge + 1);
    if (vertex == edge || here == end || !holds(start, end, here)) return false;
    const LatticePoint& before = here == start ? at(edge + path_.size() - 1) : start;
    return is_left(before, here, end, at(vertex + path_.size() - 1)) != is_left(before, here, end, at(vertex + 1));
  }

  [[nodiscard]] bool is_lowest() const {
    std::vector<std::size_t> other = numbers_;
    for (int direction = 0; direction < 2; ++direction, std::ranges::reverse(other))
      for (std::size_t start = 0; start < other.size(); ++start) {
        if (other < numbers_) return false;
        std::rotate(other.begin(), other.begin() + 1, other.end());
      }
    return true;
  }

  std::size_t most_vertices_;
  std::vector<LatticePoint> points_;
  LatticeLoop path_;
  std::vector<std::size_t> numbers_;
};

}  // namespace

std::vector<LatticeLoop> valid_loops(int width, int height, std::size_t most_vertices) {
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
