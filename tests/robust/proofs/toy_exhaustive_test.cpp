// SPDX-License-Identifier: GPL-3.0-or-later
// Evidence beside the proofs: 4-bit arithmetic on every operand of a grid, for expressions of few operands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "tests/robust/proofs/toy.h"
#include "tests/robust/proofs/toy_bounds.h"
#include "tests/robust/proofs/toy_sample.h"

namespace touchstone::proofs {
namespace {

constexpr int kBits = 4;

/// The numbers from -last to last: those above 15 have to be rounded, as differences are.
std::vector<Exact> all_up_to(Exact last) {
  std::vector<Exact> numbers;
  for (Exact number = -last; number <= last; ++number) numbers.push_back(number);
  return numbers;
}

double bound_of(std::string_view constant) {
  const std::vector<double> bounds = bounds_at(std::ldexp(1.0, 1 - kBits));
  std::size_t i = 0, found = bounds.size();
  for_each_claim([&](const Claim& claim, const auto&) {
    if (claim.constant == constant) found = i;
    ++i;
  });
  return bounds.at(found);
}

/// The operands whose error takes the largest share of its bound.
struct Largest {
  double share = 0;
  std::vector<Exact> operands;

  void add(Toy computed, Exact exact, double bound, std::initializer_list<Exact> of) {
    const Exact error = std::abs(computed.value - exact);
    if (error == 0 || static_cast<double>(error) <= share * bound) return;
    share = static_cast<double>(error) / bound;
    operands = of;
  }
};

template <class Expression>
void expect_within_bounds(Expression largest, double floor) {
  for_each_rounding(kBits, [&](Rounding rounding) {
    const Largest found = largest();
    EXPECT_LE(found.share, 1) << "rounding " << static_cast<int>(rounding) << ", operands "
                              << testing::PrintToString(found.operands);
    EXPECT_GT(found.share, floor);
  });
}

TEST(AllToys, VertexStaysWithinItsBound) {
  const double bound = bound_of("kVertex");
  const std::vector<Exact> numbers = all_up_to(35);
  expect_within_bounds(
      [&] {
        Largest largest;
        for (const Exact x : numbers)
          for (const Exact y : numbers)
            for (const Exact z : numbers) {
              const Vector3<Exact> from{x, y, z};
              const auto from_computed = computed(from);
              const double m_from = largest_magnitude(from_computed);
              for (Exact r = 0; r <= 16; ++r) {
                const double m_w = std::max(m_from, static_cast<double>(r));
                largest.add(signs::vertex(from_computed, Toy::of(r)), signs::vertex(from, r), bound * m_w * m_w,
                            {x, y, z, r});
              }
            }
        return largest;
      },
      0.2);
}

/// visit(from, edge) for all vectors in the plane z = 0 with coordinates among the numbers.
template <class Visit>
void for_each_pair_in_plane(const std::vector<Exact>& numbers, Visit visit) {
  for (const Exact from_x : numbers)
    for (const Exact from_y : numbers)
      for (const Exact edge_x : numbers)
        for (const Exact edge_y : numbers) visit(Vector3<Exact>{from_x, from_y, 0}, Vector3<Exact>{edge_x, edge_y, 0});
}

TEST(AllToys, AlongStaysWithinItsBoundInThePlane) {
  const double bound = bound_of("kAlong");
  expect_within_bounds(
      [&] {
        Largest largest;
        for_each_pair_in_plane(all_up_to(19), [&](const Vector3<Exact>& from, const Vector3<Exact>& edge) {
          const auto w = computed(from), e = computed(edge);
          largest.add(signs::along(w, e), signs::along(from, edge), bound * largest_magnitude(w) * largest_magnitude(e),
                      {from.x, from.y, edge.x, edge.y});
        });
        return largest;
      },
      0.1);
}

TEST(AllToys, LineStaysWithinItsBoundInThePlane) {
  const double bound = bound_of("kLine");
  const std::vector<Exact> numbers{-19, -17, -15, -13, -11, -9, -7, -4, -1, 0, 1, 4, 7, 9, 11, 13, 15, 17, 19};
  expect_within_bounds(
      [&] {
        Largest largest;
        for_each_pair_in_plane(numbers, [&](const Vector3<Exact>& from, const Vector3<Exact>& edge) {
          const auto w = computed(from), e = computed(edge);
          const double m_from = largest_magnitude(w), m_e = largest_magnitude(e);
          for (const Exact r : {0, 1, 5, 9, 11, 13, 15}) {
            const double m_w = std::max(m_from, static_cast<double>(r));
            largest.add(signs::line(w, e, Toy::of(r)), signs::line(from, edge, r), bound * m_w * m_w * m_e * m_e,
                        {from.x, from.y, edge.x, edge.y, r});
          }
        });
        return largest;
      },
      0.03);
}

}  // namespace
}  // namespace touchstone::proofs
