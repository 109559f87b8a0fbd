// SPDX-License-Identifier: GPL-3.0-or-later
// What bounds.h says of the input of the filters, made real: what is prepared of a polygon is displaced. Within the
// model nothing may become wrong; far beyond it something must, or the test could not tell.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/lattice/lattice_case.h"

namespace touchstone::lattice_tests {
namespace {

using filtered::detail::DoubleDouble;
using filtered::detail::EdgeIndex;
using filtered::detail::EdgeTree;
using filtered::detail::Frame;
using Parts = filtered::PreparedPolygon::Parts;

/// Random signs, the same in every run.
class Signs {
 public:
  explicit Signs(std::uint64_t seed) : seed_(seed) {}
  double next() { return (mixed(seed_, count_++) >> 17 & 1) != 0 ? 1 : -1; }

 private:
  std::uint64_t seed_, count_ = 0;
};

std::vector<EdgeTree::Edge> edges_of(const EdgeIndex& index, std::size_t count) {
  std::vector<EdgeTree::Edge> edges(count);
  for (const EdgeTree::Leaf& leaf : index.all_leaves())
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane)
      edges[leaf.edge[lane]] = {leaf.start_x[lane],     leaf.start_y[lane],     leaf.end_x[lane], leaf.end_y[lane],
                                leaf.direction_x[lane], leaf.direction_y[lane], leaf.length[lane]};
  return edges;
}

/// A frame, and the edges in it.
struct Framed {
  Frame frame;
  std::vector<EdgeTree::Edge> edges;
};

/// The frame and its edges with every number displaced by a share of what bounds.h allows: those that move the foot,
/// the vertices and the height in the worst way for this centre together, all others at random.
Framed displaced(const Framed& framed, const Eigen::Vector3d& center, double share, Signs& signs) {
  using filtered::detail::bounds::kUnit, filtered::detail::bounds::kFramePoint,
      filtered::detail::bounds::kFrameDirection, filtered::detail::bounds::kFrameLength;
  const double off = share * kUnit;
  const Frame& frame = framed.frame;
  const double from[] = {std::ldexp(center[0], -frame.unit.exponent) - frame.origin.x,
                         std::ldexp(center[1], -frame.unit.exponent) - frame.origin.y,
                         std::ldexp(center[2], -frame.unit.exponent) - frame.origin.z};
  Framed result = framed;
  const auto displace = [&](filtered::detail::Vector3<double>& axis, double by) {
    axis.x += std::copysign(by, by * from[0]);
    axis.y += std::copysign(by, by * from[1]);
    axis.z += std::copysign(by, by * from[2]);
  };
  const double by_x = off * signs.next(), by_y = off * signs.next(), by_height = off * signs.next();
  displace(result.frame.x, by_x);
  displace(result.frame.y, by_y);
  displace(result.frame.normal, by_height);
  result.frame.plane_height -= by_height;

  for (EdgeTree::Edge& edge : result.edges) {
    edge.start_x -= kFramePoint * by_x, edge.start_y -= kFramePoint * by_y;
    edge.end_x -= kFramePoint * by_x, edge.end_y -= kFramePoint * by_y;
    edge.direction_x += kFrameDirection * off * signs.next();
    edge.direction_y += kFrameDirection * off * signs.next();
    edge.length += kFrameLength * off * signs.next();
  }
  return result;
}

/// The double-doubles, each displaced by `units` of what bounds.h allows for it.
filtered::detail::LiftedPolygon displaced(const filtered::detail::LiftedPolygon& lifted, double units, Signs& signs) {
  filtered::detail::LiftedPolygon result = lifted;
  const auto displace = [&](DoubleDouble& x, double size) {
    x = filtered::detail::quick_two_sum(x.high, x.low + units * size * signs.next());
  };
  for (DoubleDouble* x : {&result.normal.x, &result.normal.y, &result.normal.z})
    displace(*x, filtered::detail::bounds::kDoubleDoubleUnit * std::abs(x->high));
  displace(result.per_square,
           filtered::detail::bounds::kPerSquare * filtered::detail::bounds::kDoubleDoubleUnit * result.per_square.high);
  for (DoubleDouble* slope : {&result.slope_a, &result.slope_b})
    displace(*slope, filtered::detail::bounds::kSlope * filtered::detail::bounds::kDoubleDoubleUnit);
  for (DoubleDouble& lift : result.lifts) displace(lift, filtered::detail::bounds::kLift);
  result.exact_normal = false;
  return result;
}

struct Asked {
  std::uint64_t questions = 0, wrong = 0;

  void count(bool right) { ++questions, wrong += !right; }
};
std::ostream& operator<<(std::ostream& out, const Asked& asked) {
  return out << asked.wrong << " of " << asked.questions << " answers wrong";
}

/// Calls ask(parts, questions, signs) for polygons in integer planes, where ties are common.
template <class Ask>
void for_each_polygon(std::uint64_t feet, const Ask& ask) {
  const auto loops = valid_loops(4, 3, 7);
  std::uint64_t drawn = 0;
  for (std::uint64_t number = 0; drawn < feet; ++number)
    for (const PlaneKind kind : {PlaneKind::Tilted, PlaneKind::Warped}) {
      const LatticeCase given({loops[mixed(number, 200) % loops.size()]}, kind, number);
      Parts parts(given.polygon());
      std::vector<Questions> questions;
      for (int y = -1; y < 6; ++y)
        for (int x = -1; x < 8; ++x, ++drawn)
          questions.push_back(given.questions({x, y}, static_cast<int>(mixed(drawn, 201) % 3)));
      Signs signs(number);
      ask(parts, questions, signs);
    }
}

Asked of_displaced_frames(double share) {
  Asked asked;
  const auto& ask = filtered::detail::kernels().plain;
  filtered::NoCounts none;
  for_each_polygon(25'000, [&](Parts& parts, const std::vector<Questions>& about, Signs& signs) {
    const Framed framed{parts.frame.value(), edges_of(parts.edges.value(), parts.polygon.vertex_count())};
    for (const auto& [center, foot, radii] : about) {
      const Framed moved = displaced(framed, center, share, signs);
      parts.frame = moved.frame;
      parts.edges.emplace(moved.edges, parts.polygon, EdgeIndex::Use::Often);
      asked.count(ask.foot({center, 0}, parts, none) == foot);
      for (const auto& [radius, relation] : radii) asked.count(ask.relation({center, radius}, parts, none) == relation);
    }
  });
  return asked;
}

Asked of_displaced_double_doubles(double units) {
  Asked asked;
  const auto& ask = filtered::detail::kernels().plain;
  filtered::NoCounts none;
  for_each_polygon(20'000, [&](Parts& parts, const std::vector<Questions>& about, Signs& signs) {
    auto& lifted =
        const_cast<filtered::detail::LiftedPolygon&>(parts.exact_form().lifted);  // made by Parts, and not const
    const filtered::detail::LiftedPolygon found = lifted;
    for (const auto& [center, foot, radii] : about) {
      lifted = displaced(found, units, signs);
      asked.count(ask.foot({center, 0}, parts, none) == foot);
      for (const auto& [radius, relation] : radii) asked.count(ask.relation({center, radius}, parts, none) == relation);
      const Ball ball{center, radii.front().value};
      asked.count(ask.answer(ball, parts, none) == exact::answer(ball, parts.exact()));
    }
  });
  return asked;
}

// What is stored is itself off by up to half of what is allowed.
TEST(Perturbed, FramesWithinTheModelAreNeverWrong) {
  const Asked asked = of_displaced_frames(0.5);
  std::cout << asked << '\n';
  EXPECT_EQ(asked.wrong, 0U);
  EXPECT_GE(asked.questions, 90'000U);
}

TEST(Perturbed, FramesFarBeyondTheModelAreOftenWrong) {
  const Asked asked = of_displaced_frames(64);
  std::cout << asked << '\n';
  EXPECT_GE(asked.wrong, asked.questions / 100);
}

TEST(Perturbed, DoubleDoublesWithinTheModelAreNeverWrong) {
  const Asked asked = of_displaced_double_doubles(0.8);
  std::cout << asked << '\n';
  EXPECT_EQ(asked.wrong, 0U);
  EXPECT_GE(asked.questions, 90'000U);
}

TEST(Perturbed, DoubleDoublesFarBeyondTheModelAreOftenWrong) {
  const Asked asked = of_displaced_double_doubles(128);
  std::cout << asked << '\n';
  EXPECT_GE(asked.wrong, asked.questions / 1000);
}

}  // namespace
}  // namespace touchstone::lattice_tests
