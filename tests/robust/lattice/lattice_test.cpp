// SPDX-License-Identifier: GPL-3.0-or-later
// Bounded checking: every small lattice polygon, every foot on the half lattice in and around it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "experiments/program/statistics/shares.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "tests/robust/lattice/lattice_case.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/environment.h"

namespace touchstone::lattice_tests {
namespace {

using contact_tests::all_kernels;
using contact_tests::Environment;
using contact_tests::kModes;

/// Loops with vertices on a lattice, each as the outer loop or as a hole in a rectangle.
struct LatticeSet {
  std::string name;
  int width, height;
  std::size_t most_vertices;
  std::optional<int> margin;  ///< of the rectangle around the lattice; nothing if the loops are outlines

  [[nodiscard]] std::vector<std::vector<LatticeLoop>> polygons() const {
    std::vector<std::vector<LatticeLoop>> result;
    for (LatticeLoop& loop : valid_loops(width, height, most_vertices)) {
      if (margin == 0 && has_edge_on_rim(loop)) continue;
      result.emplace_back();
      if (margin) {
        const int low = -*margin, right = width - 1 + *margin, top = height - 1 + *margin;
        result.back().push_back({{low, low}, {right, low}, {right, top}, {low, top}});
      }
      result.back().push_back(std::move(loop));
    }
    return result;
  }

 private:
  [[nodiscard]] bool has_edge_on_rim(const LatticeLoop& loop) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const LatticePoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a.x == b.x && (a.x == 0 || a.x == width - 1)) || (a.y == b.y && (a.y == 0 || a.y == height - 1)))
        return true;
    }
    return false;
  }
};
const LatticeSet kSets[] = {{"3 x 3", 3, 3, 9, {}},
                            {"holes, 3 x 3", 3, 3, 9, 2},
                            {"holes that touch, 4 x 3", 4, 3, 7, 0},
                            {"4 x 3", 4, 3, 7, {}}};

/// One polygon in this number is asked about: TOUCHSTONE_LATTICE_SHARE of the environment, which `./check --full` sets
/// to 1.
std::uint64_t share() {
  const char* asked = std::getenv("TOUCHSTONE_LATTICE_SHARE");
  return asked == nullptr ? 1500 / TOUCHSTONE_SAMPLES : std::stoull(asked);
}

struct Tally {
  std::uint64_t polygons = 0, wrong_polygons = 0, questions = 0, wrong = 0;
};

/// Asks every engine, in some rounding mode.
class Examiner {
 public:
  Examiner(const LatticeCase& given, std::uint64_t number, PlaneKind kind, Tally& tally)
      : given_(given),
        number_(number),
        kind_(kind),
        prepared_(prepared(given.polygon(), number)),
        by_hierarchy_(given.polygon(), filtered::detail::EdgeIndex::Use::OftenByHierarchy),
        tally_(tally) {}

  void ask(const Questions& questions, int mode) {
    for (const filtered::detail::Kernels* kernels : all_kernels())
      for (const Parts* parts : {&parts_of(prepared_), &by_hierarchy_}) {
        const auto foot = [&](const Ball& ball) { return kernels->plain.foot(ball, *parts, none_); };
        const auto relation = [&](const Ball& ball) { return kernels->plain.relation(ball, *parts, none_); };
        hold(questions, mode, foot, relation, kernels == all_kernels().front() ? "baseline" : "fastest");
      }
    tally_.questions += 1 + questions.radii.size();
  }

  /// The truth itself is compared with `exact`.
  void ask_exact(const Questions& questions) {
    if (!exact_) exact_.emplace(given_.polygon());
    hold(
        questions, FE_TONEAREST, [&](const Ball& ball) { return exact::foot(ball, *exact_); },
        [&](const Ball& ball) { return exact::relation(ball, *exact_); }, "exact");
  }

 private:
  static filtered::PreparedPolygon prepared(const Polygon& polygon, std::uint64_t number) {
    const Environment changed(kModes[mixed(number, 3) % std::size(kModes)], Environment::kKeep);
    return filtered::PreparedPolygon(polygon);
  }

  template <class Foot, class Relate>
  void hold(const Questions& questions, int mode, const Foot& foot, const Relate& relation, const char* who) {
    PointLocation found_foot;
    std::vector<Relation> found;
    {
      const Environment changed(mode, Environment::kKeep);
      found_foot = foot({questions.center, 0});
      for (const Radius& radius : questions.radii) found.push_back(relation({questions.center, radius.value}));
    }
    if (found_foot != questions.foot) complain(questions, mode, who) << "foot " << to_string(found_foot);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != questions.radii[i].relation)
        complain(questions, mode, who) << "radius " << std::hexfloat << questions.radii[i].value << ' '
                                       << to_string(found[i]);
  }

  /// Names the first few; all are counted.
  std::ostream& complain(const Questions& questions, int mode, const char* who) {
    static std::ostringstream unseen;
    unseen.str("");
    if (++tally_.wrong > 5) return unseen;
    return std::cout << "\nwrong: " << name(kind_) << " polygon " << number_ << ", centre "
                     << questions.center.transpose() << ", rounding mode " << mode << ": " << who << ": ";
  }

  const LatticeCase& given_;
  std::uint64_t number_;
  PlaneKind kind_;
  using Parts = filtered::PreparedPolygon::Parts;

  filtered::PreparedPolygon prepared_;
  const Parts by_hierarchy_;
  std::optional<exact::PreparedPolygon> exact_;
  filtered::NoCounts none_;
  Tally& tally_;
};

void ask_about(const std::vector<LatticeLoop>& loops, const LatticeSet& set, std::uint64_t number, PlaneKind kind,
               Tally& tally) {
  const LatticeCase given(loops, kind, mixed(number, static_cast<std::uint64_t>(kind)));
  const bool is_valid = !exact::validate(given.polygon());
  if (kind == PlaneKind::Rounded && !is_valid) return;  // rounding may make loops that touch cross
  ASSERT_TRUE(is_valid) << name(kind) << " polygon " << number;
  Examiner examiner(given, number, kind, tally);
  const std::uint64_t wrong_before = tally.wrong;
  const bool also_exact = kind != PlaneKind::Rounded && mixed(number, 4) % 8 == 0;
  std::uint64_t asked = mixed(number, 5);
  for (int y = -1; y < 2 * set.height; ++y)
    for (int x = -1; x < 2 * set.width; ++x, ++asked) {
      const Questions questions = given.questions({x, y}, static_cast<int>(asked % 3));
      examiner.ask(questions, kModes[asked / 3 % std::size(kModes)]);
      if (also_exact) examiner.ask_exact(questions);
    }
  ++tally.polygons;
  tally.wrong_polygons += tally.wrong != wrong_before;
}

// Whole, this is not a sample: what is wrong about any polygon of this size is found.
TEST(Lattice, NeverDiffersFromTheTruth) {
  const std::uint64_t one_in = share();
  ASSERT_GT(one_in, 0U);
  for (const LatticeSet& set : kSets) {
    const auto polygons = set.polygons();
    for (const PlaneKind kind : kAllPlanes) {
      Tally tally;
      for (std::uint64_t number = 0; number < polygons.size(); ++number)
        if (mixed(number, 6) % one_in == 0) ask_about(polygons[number], set, number, kind, tally);
      EXPECT_EQ(tally.wrong, 0U) << set.name << ", " << name(kind);
      EXPECT_GT(tally.polygons, 0U) << set.name << ", " << name(kind);
      std::cout << set.name << ", " << name(kind) << ": " << tally.questions << " questions about " << tally.polygons
                << " of " << polygons.size() << " polygons, " << tally.wrong << " wrong";
      if (tally.polygons < polygons.size())
        std::cout << ", in at most "
                  << 100 * statistics::clopper_pearson(tally.wrong_polygons, tally.polygons, 0.9).upper
                  << " % of all such polygons (95 %, one-sided)";
      std::cout << '\n';
    }
  }
}

/// Calls f with every sequence of points of the 3 x 3 lattice, of at most six or all different, that starts at its
/// lowest one and is not higher than any that is the same loop.
template <class F>
void for_each_sequence(std::vector<int>& numbers, bool different, const F& f) {
  const auto is_lowest = [&] {
    std::vector<int> other = numbers;
    for (int direction = 0; direction < 2; ++direction, std::ranges::reverse(other))
      for (std::size_t start = 0; start < other.size();
           ++start, std::rotate(other.begin(), other.begin() + 1, other.end()))
        if (other < numbers) return false;
    return true;
  };
  if (numbers.size() >= 3 && numbers.front() != numbers.back() && is_lowest()) f(numbers);
  for (int next = numbers.empty() ? 0 : numbers[0]; next < 9; ++next) {
    const bool is_new = std::ranges::count(numbers, next) == 0;
    if ((!numbers.empty() && next == numbers.back()) || ((!is_new || !different) && numbers.size() >= 6)) continue;
    numbers.push_back(next);
    for_each_sequence(numbers, different && is_new, f);
    numbers.pop_back();
  }
}

// Also: `validate` decides every loop on that lattice.
TEST(Lattice, HasEveryLoopThatIsValid) {
  std::vector<LatticeLoop> valid;
  std::vector<int> numbers;
  for_each_sequence(numbers, true, [&](const std::vector<int>& sequence) {
    Loop in_space;
    LatticeLoop loop;
    for (const int i : sequence) {
      in_space.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3), 0});
      loop.push_back({i % 3, i / 3});
    }
    if (!exact::validate(Polygon(in_space))) valid.push_back(loop);
  });
  std::vector<LatticeLoop> searched = valid_loops(3, 3, 9);
  std::erase_if(searched, [](const LatticeLoop& loop) {
    if (loop.size() <= 6) return false;
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (std::ranges::count(loop, loop[i]) > 1) return true;
    return false;
  });
  EXPECT_EQ(searched, valid);
  EXPECT_EQ(valid.size(), 2323U);
}

}  // namespace
}  // namespace touchstone::lattice_tests
