// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "experiments/cases/key.h"
#include "experiments/cases/truth_as_given.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"
#include "robust/exact/validate.h"
#include "robust/filtered/filtered.h"

namespace touchstone::near_edge {
namespace {

constexpr std::uint64_t kClimbStream = std::uint64_t{1} << 33;

/// All regions and methods of one search.
class Search {
 public:
  explicit Search(const Settings& settings)
      : settings_(settings),
        regions_(search_regions(settings.families)),
        filtered_(*methods::find_method("filtered")),
        exact_(*methods::find_method("exact")) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  void measure(std::uint64_t n, Onsets& part) const {
    ++part.done;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const auto at = draw_at_threshold(place(regions_[r], n));
      if (!at) {
        ++part.missing;
        continue;
      }
      const auto truth = filtered_.prepare(at->polygon);
      for (std::size_t m = 0; m < settings_.methods.size(); ++m) {
        const auto method = settings_.methods[m]->prepare(at->polygon);
        const WrongReach reach = wrong_reach(*at, *method, knows_boundary_[m], *truth);
        Onset one;
        one.samples = 1;
        for (std::size_t k = 0; k < reach.wrong.size(); ++k) one.wrong[k] = reach.wrong[k] ? 1 : 0;
        if (reach.furthest) one.furthest = {{reach.share, n}};
        part.all[r * settings_.methods.size() + m] += one;
      }
    }
  }

  /// Climbs from one of the furthest samples of a region and method. Returns nothing if the method is not wrong there;
  /// a case without a line if `exact` does not confirm it.
  [[nodiscard]] std::optional<Worst> climb_from(std::size_t region_and_method, const Find& find) const {
    const Region& region = regions_[region_and_method / settings_.methods.size()];
    const std::size_t m = region_and_method % settings_.methods.size();
    const cases::Method& method = *settings_.methods[m];
    auto start = draw_at_threshold(place(region, find.n));
    const workloads::Random random(settings_.seed, find.n, kClimbStream + region_and_method);
    const auto [at, reach] = climb(*std::move(start), method, random);
    if (!reach.furthest) return std::nullopt;

    const Ball& ball = *reach.furthest;
    const auto truth = exact_.prepare(at.polygon)->ask(ball, query_kind(at.test()));
    const auto answer = method.prepare(at.polygon)->ask(ball, query_kind(at.test()));
    if (compare(at.test(), answer, truth, knows_boundary_[m]) == cases::Outcome::Right) return Worst();
    const std::string name(method.name());
    return Worst{reach.share, find.n,
                 cases::case_line("worst-" + name + "-" + id(place(region, find.n)), cases::Shapes{ball, at.polygon},
                                  {"worst", name}, cases::only(truth, {cases::key_of(at.test())}))};
  }

 private:
  [[nodiscard]] cases::SamplePlace place(const Region& region, std::uint64_t n) const {
    cases::Shape shape = settings_.shape;
    shape.origin_distance = region.origin_distance;
    return {region.stratum, shape, settings_.seed, n};
  }

  const Settings& settings_;
  std::vector<Region> regions_;
  const cases::Method &filtered_, &exact_;
  std::vector<bool> knows_boundary_;
};

using workloads::Random;

/// About one of the lower 32 bits of it, or as many doubles.
double nudged(Random& random, double x) {
  const auto bit = static_cast<int>(random.integer(0, 31));
  if (random.coin()) return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (std::uint64_t{1} << bit));
  const std::int64_t most = std::int64_t{1} << bit;
  return workloads::move_by_doubles(x, random.integer(-most, most));
}

Eigen::Vector3d& vertex(std::vector<Loop>& loops, std::size_t i) {
  auto loop = loops.begin();
  for (; i >= loop->size(); ++loop) i -= loop->size();
  return (*loop)[i];
}

/// The case with one coordinate of its polygon or its centre nudged; nothing if that is not a polygon.
std::optional<AtThreshold> with_nudge(Random& random, const AtThreshold& at) try {
  AtThreshold result = at;
  const auto count = static_cast<std::int64_t>(at.polygon.vertex_count());
  const auto chosen = random.integer(-count / 2, count - 1);  // the centre in a third of the draws
  const auto axis = static_cast<int>(random.integer(0, 2));
  if (chosen < 0) {
    result.ball.center[axis] = nudged(random, at.ball.center[axis]);
  } else {
    auto loops = workloads::loops_of(at.polygon);
    double& x = vertex(loops, static_cast<std::size_t>(chosen))[axis];
    x = nudged(random, x);
    result.polygon = workloads::polygon_of(loops);
    if (exact::validate(result.polygon)) return std::nullopt;
  }
  return result;
} catch (const Rejected&) {
  return std::nullopt;
}

/// Puts the ball at the threshold again; false where it is another kind of threshold.
bool settle(AtThreshold& at, Feature::Kind kind) {
  const filtered::PreparedPolygon polygon(at.polygon);
  if (at.moved_axis < 0) {
    const Answer answer = filtered::answer({at.ball.center, 0}, polygon);
    at.ball.radius = answer.distance;
    return answer.nearest.kind == kind && answer.distance > 0 && std::isfinite(answer.distance);
  }
  constexpr std::int64_t kReach = std::int64_t{1} << 34;  // a nudge moves a vertex by up to 2^31 doubles
  const auto crossing = cases::find_foot_crossing(at.ball, at.moved_axis, kReach, [&](const Ball& ball) {
    return filtered::foot(ball, polygon) == PointLocation::Outside;
  });
  if (!crossing) return false;
  at.ball = crossing->last;
  return true;
}

Feature::Kind nearest_kind(const AtThreshold& at) {
  return filtered::answer({at.ball.center, 0}, filtered::PreparedPolygon(at.polygon)).nearest.kind;
}

int differing_axis(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis]) return axis;
  return -1;
}

}  // namespace

std::vector<Region> search_regions(const std::vector<workloads::Family>& families) {
  std::vector<Region> regions;
  for (const workloads::Family family : families)
    for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
      const cases::Stratum& stratum = cases::all_strata()[s];
      if (stratum.family != family || stratum.placement != workloads::Placement::Rotated) continue;
      for (const double distance : kSearchDistances) regions.push_back({s, distance});
    }
  return regions;
}

Onset& Onset::operator+=(const Onset& other) {
  for (std::size_t k = 0; k < wrong.size(); ++k) wrong[k] += other.wrong[k];
  samples += other.samples;
  furthest.insert(furthest.end(), other.furthest.begin(), other.furthest.end());
  std::sort(furthest.begin(), furthest.end());
  if (furthest.size() > kMostKept) furthest.resize(kMostKept);
  return *this;
}

Onsets no_onsets(const Settings& settings) {
  return {std::vector<Onset>(search_regions(settings.families).size() * settings.methods.size())};
}

void run_onsets(const Settings& settings, std::uint64_t samples, const program::RunControl& control, Onsets& onsets) {
  const Search search(settings);
  program::run_sweep(samples, settings.threads, control, no_onsets(settings), onsets,
                     [&](std::uint64_t n, Onsets& part) { search.measure(n, part); });
}

std::uint64_t climb_count(const Settings& settings) {
  return search_regions(settings.families).size() * settings.methods.size() * Onset::kMostKept;
}

WorstCases run_climbs(const Settings& settings, const program::RunControl& control, const Onsets& onsets) {
  const Search search(settings);
  std::vector<std::optional<Worst>> found(climb_count(settings));
  program::run_items(found.size(), 1, settings.threads, control, [&](unsigned, std::uint64_t i) {
    const std::size_t where = i / Onset::kMostKept, rank = i % Onset::kMostKept;
    const std::vector<Find>& furthest = onsets.all[where].furthest;
    if (rank < furthest.size()) found[i] = search.climb_from(where, furthest[rank]);
  });
  WorstCases worst{std::vector<Worst>(onsets.all.size())};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    Worst& best = worst.all[i / Onset::kMostKept];
    if (found[i]->line.empty())
      ++worst.wrong_truths;
    else if (Find{found[i]->share, found[i]->n} < Find{best.share, best.n})
      best = *found[i];
  }
  return worst;
}

Climbed climb(AtThreshold start, const cases::Method& method, Random random) {
  const cases::Method& truth = *methods::find_method("filtered");
  const bool knows_boundary = cases::knows_boundary(method);
  const auto reach_of = [&](const AtThreshold& at) {
    return wrong_reach(at, *method.prepare(at.polygon), knows_boundary, *truth.prepare(at.polygon));
  };
  const Feature::Kind kind = nearest_kind(start);
  WrongReach reach = reach_of(start);
  Climbed best{std::move(start), reach};
  for (int step = 0; step < kClimbSteps; ++step) {
    auto next = with_nudge(random, best.at);
    if (!next || !settle(*next, kind)) continue;
    reach = reach_of(*next);
    if (reach < best.reach) continue;
    best = {*std::move(next), reach};
  }
  return best;
}

double AtThreshold::size() const { return workloads::extent_of(polygon); }

std::optional<Ball> AtThreshold::moved(double share) const {
  Ball result = ball;
  if (moved_axis >= 0)
    result.center[moved_axis] += share * size();
  else
    result.radius += share * size();
  if (result.radius < 0) return std::nullopt;
  return result;
}

double AtThreshold::share_of(const Ball& other) const {
  const double offset =
      moved_axis < 0 ? other.radius - ball.radius : other.center[moved_axis] - ball.center[moved_axis];
  return std::abs(offset) / size();
}

std::optional<AtThreshold> draw_at_threshold(const cases::SamplePlace& place) {
  auto crossing = cases::draw_crossing(place, *methods::find_method("filtered"));
  if (!crossing) return std::nullopt;
  const Ball &here = crossing->balls[crossing->middle()], &next = crossing->balls[crossing->middle() + 1];
  return AtThreshold{std::move(crossing->polygon), here, differing_axis(here.center, next.center)};
}

WrongReach wrong_reach(const AtThreshold& at, const cases::PreparedMethod& method, bool knows_boundary,
                       const cases::PreparedMethod& truth) {
  WrongReach reach;
  const Test test = at.test();
  const cases::TruthAsGiven as_given(truth, at.polygon);
  const auto is_wrong = [&](double share) {
    const auto ball = at.moved(share);
    if (!ball || at.share_of(*ball) == 0) return false;
    const auto answer = method.ask(*ball, query_kind(test));
    for (const cases::PreparedMethod* each : {&truth, static_cast<const cases::PreparedMethod*>(&as_given)}) {
      const auto verdict = compare(test, answer, each->ask(*ball, query_kind(test)), knows_boundary);
      if (!verdict || verdict == cases::Outcome::Right) return false;
    }
    if (at.share_of(*ball) > reach.share) {
      reach.share = at.share_of(*ball);
      reach.furthest = ball;
    }
    return true;
  };

  for (const double side : {-1.0, 1.0}) {
    int furthest = -1;
    for (std::size_t k = kMostExponent + 1; k-- > 0;) {
      const auto exponent = static_cast<int>(k);
      if (!is_wrong(side * std::ldexp(1.0, -exponent))) continue;
      reach.wrong[k] = true;
      furthest = exponent;
    }
    if (furthest <= 0) continue;
    const double offset = side * std::ldexp(1.0, -furthest);
    for (int step = kSteps - 1; step > 0; --step)
      if (is_wrong(offset * (1 + static_cast<double>(step) / kSteps))) break;
  }
  return reach;
}

}  // namespace touchstone::near_edge
