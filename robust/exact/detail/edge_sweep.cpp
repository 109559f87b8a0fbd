// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/edge_sweep.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>  // in no other file: it takes 4 s to compile

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <set>

#include "robust/detail/exact_kernel.h"

namespace touchstone::exact::detail {

#if defined(TOUCHSTONE_BOOST_NUMBERS)
using Kernel = kernel::Simple_cartesian<kernel::Mpzf>;
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // filtered; only its exact predicates are used
#endif

int orientation(double ax, double ay, double bx, double by, double px, double py) {
  return kernel::orientation(Kernel::Point_2(ax, ay), Kernel::Point_2(bx, by), Kernel::Point_2(px, py));
}

bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const auto point = [](const Eigen::Vector3d& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  return kernel::coplanar(point(a), point(b), point(c), point(d));
}

namespace {

using Point = PlanarLoops::Point;

/// Returns whether p is to the left of (1), on (0) or to the right of (-1) the directed line a b.
int side(const Point& a, const Point& b, const Point& p) { return orientation(a.x, a.y, b.x, b.y, p.x, p.y); }

/// Returns whether p lies on the closed segment. Requires that it lies on the line a b.
bool within(const Point& a, const Point& b, const Point& p) { return std::min(a, b) <= p && p <= std::max(a, b); }

class Sweep {
 public:
  Sweep(const PlanarLoops& loops, std::size_t begin, std::size_t end)
      : loops_(loops), begin_(begin), status_(Below{this}), place_(end - begin) {
    order_.resize(end - begin);
    std::iota(order_.begin(), order_.end(), begin);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t i, std::size_t j) { return loops_[i] != loops_[j] ? loops_[i] < loops_[j] : i < j; });
  }

  std::optional<Meeting> run() {
    coinciding_vertices();
    for (std::size_t k = 0; k < order_.size() && !found_; ++k) pass(order_[k]);
    return found_;
  }

 private:
  /// Orders edges along the sweep line, from bottom to top. Both cross it, so the ends that were passed last decide.
  /// Edges that touch cannot be ordered: they are a meeting.
  struct Below {
    Sweep* sweep;
    bool operator()(std::size_t i, std::size_t j) const { return i != j && sweep->order(i, j) < 0; }
  };
  using Status = std::set<std::size_t, Below>;

  const Point& left(std::size_t edge) const { return std::min(loops_[edge], loops_[loops_.next(edge)]); }
  const Point& right(std::size_t edge) const { return std::max(loops_[edge], loops_[loops_.next(edge)]); }

  void report(std::size_t i, std::size_t j) {
    if (!found_) found_ = Meeting{std::min(i, j), std::max(i, j)};
  }

  void coinciding_vertices() {
    for (std::size_t k = 1; k < order_.size(); ++k) {
      const std::size_t i = order_[k - 1], j = order_[k];
      if (loops_[i] != loops_[j]) continue;
      if (loops_.next(i) == j) return report(i, i);
      if (loops_.next(j) == i) return report(j, j);
      return report(i, j);
    }
  }

  int order(std::size_t i, std::size_t j) {
    const bool i_starts_later = left(j) < left(i);
    const Point& later = i_starts_later ? left(i) : left(j);
    int place = i_starts_later ? side(left(j), right(j), later) : -side(left(i), right(i), later);
    if (place == 0 && left(i) == left(j)) place = side(left(j), right(j), right(i));
    if (place == 0) report(i, j);
    return place;
  }

  bool meet(std::size_t i, std::size_t j) const {
    const Point &a = loops_[i], &b = loops_[loops_.next(i)], &c = loops_[j], &d = loops_[loops_.next(j)];
    if (loops_.next(i) == j) return overlap(a, b, d);
    if (loops_.next(j) == i) return overlap(b, a, c);
    const int c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    return (c_side == 0 && within(a, b, c)) || (d_side == 0 && within(a, b, d)) || (a_side == 0 && within(c, d, a)) ||
           (b_side == 0 && within(c, d, b));
  }

  /// Returns whether the edges from `vertex` to `p` and to `q` share more than that vertex.
  static bool overlap(const Point& p, const Point& vertex, const Point& q) {
    return side(p, vertex, q) == 0 && (p < vertex) == (q < vertex);
  }

  void test(std::size_t i, std::size_t j) {
    if (meet(i, j)) report(i, j);
  }

  void insert(std::size_t edge) {
    const auto [place, inserted] = status_.insert(edge);
    if (!inserted || found_) return report(edge, *place);
    place_[edge - begin_] = place;
    if (place != status_.begin()) test(*std::prev(place), edge);
    if (std::next(place) != status_.end()) test(edge, *std::next(place));
  }

  void erase(std::size_t edge) {
    const auto after = status_.erase(place_[edge - begin_]);
    if (after != status_.begin() && after != status_.end()) test(*std::prev(after), *after);
  }

  /// The sweep line passes a vertex: edges that end there leave, edges that start there enter.
  void pass(std::size_t vertex) {
    const std::size_t edges[2] = {loops_.previous(vertex), vertex};
    for (const std::size_t edge : edges)
      if (!found_ && right(edge) == loops_[vertex]) erase(edge);
    for (const std::size_t edge : edges)
      if (!found_ && left(edge) == loops_[vertex]) insert(edge);
  }

  const PlanarLoops& loops_;
  std::size_t begin_;
  std::vector<std::size_t> order_;  // vertices from left to right
  Status status_;
  std::vector<Status::iterator> place_;  // of the edges that are in the status
  std::optional<Meeting> found_;
};

}  // namespace

PlanarLoops::PlanarLoops(const Polygon& polygon, int dropped_axis) : polygon_(&polygon) {
  const auto x = polygon.coordinates((dropped_axis + 1) % 3), y = polygon.coordinates((dropped_axis + 2) % 3);
  points_.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points_.push_back({x[i], y[i]});
}

std::optional<Meeting> find_meeting(const PlanarLoops& loops, std::size_t begin, std::size_t end) {
  return Sweep(loops, begin, end).run();
}

bool is_inside(const PlanarLoops& loops, std::size_t vertex, std::size_t begin, std::size_t end) {
  const Point& p = loops[vertex];
  bool inside = false;
  for (std::size_t i = begin; i < end; ++i) {
    const Point &a = loops[i], &b = loops[loops.next(i)];
    const bool upwards = a.y <= p.y && p.y < b.y, downwards = b.y <= p.y && p.y < a.y;
    if ((upwards && side(a, b, p) > 0) || (downwards && side(a, b, p) < 0)) inside = !inside;
  }
  return inside;
}

}  // namespace touchstone::exact::detail
