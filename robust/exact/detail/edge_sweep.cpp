// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/edge_sweep.h"

#if !defined(TOUCHSTONE_BOOST_NUMBERS)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>  // in no other file: it takes 4 s to compile
#endif

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "robust/detail/exact_kernel.h"
#include "robust/detail/sound_arithmetic.h"

namespace touchstone::exact::detail {

namespace {

using Unfiltered = kernel::Simple_cartesian<Number>;
#if defined(TOUCHSTONE_BOOST_NUMBERS)
using Filtered = Unfiltered;
constexpr bool filters = false;
#else
using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;  // only its exact predicates are used
/// Whether its intervals are sound. False while static objects of other files are made: that is slower alone.
const bool filters = has_directed_rounding();
#endif

template <class Kernel>
inline int orientation_in(double ax, double ay, double bx, double by, double px, double py) {
  using Point = typename Kernel::Point_2;
  return kernel::orientation(Point(ax, ay), Point(bx, by), Point(px, py));
}

template <class Kernel>
inline bool coplanar_in(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        const Eigen::Vector3d& d) {
  const auto point = [](const Eigen::Vector3d& p) { return typename Kernel::Point_3(p.x(), p.y(), p.z()); };
  return kernel::coplanar(point(a), point(b), point(c), point(d));
}

/// Never inlined: numbers of any size would take registers from the filter.
__attribute__((noinline)) int unfiltered_orientation(double ax, double ay, double bx, double by, double px, double py) {
  return orientation_in<Unfiltered>(ax, ay, bx, by, px, py);
}

}  // namespace

int orientation(double ax, double ay, double bx, double by, double px, double py) {
  if (!filters) [[unlikely]]
    return unfiltered_orientation(ax, ay, bx, by, px, py);
  return orientation_in<Filtered>(ax, ay, bx, by, px, py);
}

bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return filters ? coplanar_in<Filtered>(a, b, c, d) : coplanar_in<Unfiltered>(a, b, c, d);
}

namespace {

using Point = PlanarLoops::Point;

/// Returns whether p is to the left of (1), on (0) or to the right of (-1) the directed line a b.
int side(const Point& a, const Point& b, const Point& p) { return orientation(a.x, a.y, b.x, b.y, p.x, p.y); }

class Sweep {
 public:
  Sweep(const PlanarLoops& loops, std::size_t begin, std::size_t end)
      : loops_(loops), status_(Below{this}), order_(end - begin) {
    std::iota(order_.begin(), order_.end(), begin);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t i, std::size_t j) { return loops_[i] != loops_[j] ? loops_[i] < loops_[j] : i < j; });
  }

  std::optional<Meeting> run() {
    for (const std::size_t i : order_)
      if (loops_[i] == loops_[loops_.next(i)]) return Meeting{Meeting::Kind::Point, i, i};
    for (auto first = order_.begin(); first != order_.end() && !found_;) {
      const auto last = std::find_if(first, order_.end(), [&](std::size_t i) { return loops_[i] != loops_[*first]; });
      pass(std::span(order_).subspan(static_cast<std::size_t>(first - order_.begin()),
                                     static_cast<std::size_t>(last - first)));
      first = last;
    }
    return found_;
  }

 private:
  /// Orders edges along the sweep line, from bottom to top, and points of the line among them.
  struct Below {
    using is_transparent = void;
    Sweep* sweep;
    bool operator()(std::size_t i, std::size_t j) const { return i != j && sweep->order(i, j) < 0; }
    bool operator()(std::size_t i, const Point& p) const { return sweep->side_of(i, p) > 0; }
    bool operator()(const Point& p, std::size_t i) const { return sweep->side_of(i, p) < 0; }
  };
  using Status = std::set<std::size_t, Below>;

  /// An edge as seen from one of its points.
  struct Ray {
    Point to;
    std::size_t edge;
    std::pair<bool, std::size_t> run;  // the edge, or the vertex with its two edges, that runs through the point
  };

  [[nodiscard]] const Point& left(std::size_t edge) const { return std::min(loops_[edge], loops_[loops_.next(edge)]); }
  [[nodiscard]] const Point& right(std::size_t edge) const { return std::max(loops_[edge], loops_[loops_.next(edge)]); }
  [[nodiscard]] int side_of(std::size_t edge, const Point& p) const { return side(left(edge), right(edge), p); }

  void report(Meeting::Kind kind, std::size_t i, std::size_t j) {
    if (!found_) found_ = Meeting{kind, std::min(i, j), std::max(i, j)};
  }

  /// Both edges cross the sweep line, so the ends that were passed last decide; if edges touch there, the other ends.
  [[nodiscard]] int order(std::size_t i, std::size_t j) const {
    if (left(j) < left(i)) return place_above(j, i);
    return -place_above(i, j);
  }
  /// Returns whether `later`, which does not start before `edge`, runs above (1) or below it (-1).
  [[nodiscard]] int place_above(std::size_t edge, std::size_t later) const {
    const int start = side_of(edge, left(later));
    return start != 0 ? start : side_of(edge, right(later));
  }

  /// Finds edges that cross at no vertex.
  void test(std::size_t i, std::size_t j) {
    const Point &a = loops_[i], &b = loops_[loops_.next(i)], &c = loops_[j], &d = loops_[loops_.next(j)];
    if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) report(Meeting::Kind::Crossing, i, j);
  }

  /// Returns whether two rays from p have the same direction.
  static bool same_direction(const Point& p, const Ray& first, const Ray& second) {
    return (first.to < p) == (second.to < p) && side(p, first.to, second.to) == 0;
  }

  /// Examines the runs through p: the vertices there, and edges that do not end there. Runs that do not cross are
  /// nested like brackets around p.
  void compare_runs(const Point& p, std::span<const std::size_t> vertices, Status::iterator low,
                    Status::iterator high) {
    std::vector<Ray>& rays = rays_;
    rays.clear();
    for (const std::size_t v : vertices) {
      rays.push_back({loops_[loops_.previous(v)], loops_.previous(v), {false, v}});
      rays.push_back({loops_[loops_.next(v)], v, {false, v}});
    }
    for (; low != high; ++low)
      if (right(*low) != p)
        for (const Point& end : {left(*low), right(*low)}) rays.push_back({end, *low, {true, *low}});
    if (rays.size() > 2)
      std::sort(rays.begin(), rays.end(), [&](const Ray& first, const Ray& second) {
        const bool is_left = first.to < p, other_is_left = second.to < p;
        return is_left != other_is_left ? is_left : side(p, first.to, second.to) > 0;
      });
    for (std::size_t k = 1; k < rays.size(); ++k)
      if (same_direction(p, rays[k - 1], rays[k]))
        return report(Meeting::Kind::Overlap, rays[k - 1].edge, rays[k].edge);
    if (rays.size() == 2) return;

    std::set<std::pair<bool, std::size_t>> opened;
    std::vector<const Ray*> open;
    for (const Ray& ray : rays) {
      if (opened.insert(ray.run).second)
        open.push_back(&ray);
      else if (open.back()->run == ray.run)
        open.pop_back();
      else
        return report(Meeting::Kind::Crossing, open.back()->edge, ray.edge);
    }
  }

  /// The sweep line passes the vertices at a point: edges that end there leave, edges that start there enter.
  void pass(std::span<const std::size_t> vertices) {
    const Point& p = loops_[vertices.front()];
    auto [low, high] = status_.equal_range(p);
    compare_runs(p, vertices, low, high);
    if (found_) return;
    const bool has_lower = low != status_.begin();
    const auto lower = has_lower ? std::prev(low) : low;
    while (low != high) low = right(*low) == p ? status_.erase(low) : std::next(low);
    for (const std::size_t v : vertices)
      for (const std::size_t edge : {loops_.previous(v), v})
        if (left(edge) == p) status_.insert(high, edge);
    const auto first = has_lower ? std::next(lower) : status_.begin();
    if (has_lower && first != status_.end()) test(*lower, *first);
    if (first != high && high != status_.end()) test(*std::prev(high), *high);
  }

  const PlanarLoops& loops_;
  Status status_;
  std::vector<std::size_t> order_;  // vertices from left to right
  std::vector<Ray> rays_;           // of `compare_runs`, kept for their memory
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

bool begins_inside(const PlanarLoops& loops, std::size_t edge, std::size_t begin, std::size_t end) {
  const Point &p = loops[edge], &towards = loops[loops.next(edge)];
  // A ray runs to the right from the point that follows p on the edge, however near.
  const auto above = [&](const Point& q) { return q.y != p.y ? q.y > p.y : towards.y < p.y; };
  bool inside = false;
  for (std::size_t i = begin; i < end; ++i) {
    const Point &a = loops[i], &b = loops[loops.next(i)];
    if (above(a) == above(b)) continue;
    const int at_start = side(a, b, p), place = at_start != 0 ? at_start : side(a, b, towards);
    if ((place > 0) == above(b)) inside = !inside;
  }
  return inside;
}

}  // namespace touchstone::exact::detail
