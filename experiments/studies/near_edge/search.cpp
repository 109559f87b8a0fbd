// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/search.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/methods/registry.h"

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

  /// From one of the furthest samples of a region and method.
  void climb_from(std::size_t region_and_method, const Find& find, WorstCases& part) const {
    const Region& region = regions_[region_and_method / settings_.methods.size()];
    const std::size_t m = region_and_method % settings_.methods.size();
    const cases::Method& method = *settings_.methods[m];
    auto start = draw_at_threshold(place(region, find.n));
    const workloads::Random random(settings_.seed, find.n, kClimbStream + region_and_method);
    const auto [at, reach] = climb(*std::move(start), method, random);
    if (!reach.furthest) return;

    const Ball& ball = *reach.furthest;
    const auto truth = exact_.prepare(at.polygon)->ask(ball, query_kind(at.test()));
    const auto verdict =
        compare(at.test(), method.prepare(at.polygon)->ask(ball, query_kind(at.test())), truth, knows_boundary_[m]);
    if (verdict == cases::Outcome::Right) {
      ++part.wrong_truths;
      return;
    }
    Worst& worst = part.all[region_and_method];
    const Worst found{reach.share, find.n, doubles_moved(at, ball), line(region, method, find.n, at, ball, truth)};
    if (is_worse(found, worst)) worst = found;
  }

  static bool is_worse(const Worst& a, const Worst& b) { return Find{a.share, a.n} < Find{b.share, b.n}; }

 private:
  [[nodiscard]] cases::SamplePlace place(const Region& region, std::uint64_t n) const {
    cases::Shape shape = settings_.shape;
    shape.origin_distance = region.origin_distance;
    return {region.stratum, shape, settings_.seed, n};
  }

  static std::int64_t doubles_moved(const AtThreshold& at, const Ball& ball) {
    if (at.moved_axis < 0) return workloads::doubles_between(at.ball.radius, ball.radius);
    return workloads::doubles_between(at.ball.center[at.moved_axis], ball.center[at.moved_axis]);
  }

  [[nodiscard]] std::string line(const Region& region, const cases::Method& method, std::uint64_t n,
                                 const AtThreshold& at, const Ball& ball, const cases::PartialAnswer& truth) const {
    cases::PartialAnswer expected;
    if (at.test() == Test::Contact)
      expected.contact = truth.contact;
    else
      expected.foot = truth.foot;
    const std::vector<std::string> tags{"worst", std::string(method.name())};
    return cases::case_line("worst-" + std::string(method.name()) + "-" + id(place(region, n)), ball, at.polygon, tags,
                            expected);
  }

  const Settings& settings_;
  std::vector<Region> regions_;
  const cases::Method &filtered_, &exact_;
  std::vector<bool> knows_boundary_;
};

WorstCases no_worst_cases(const Settings& settings) {
  return {std::vector<Worst>(search_regions(settings.families).size() * settings.methods.size()), 0};
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

WorstCases& WorstCases::operator+=(const WorstCases& other) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (Search::is_worse(other.all[i], all[i])) all[i] = other.all[i];
  wrong_truths += other.wrong_truths;
  return *this;
}

Onsets no_onsets(const Settings& settings) {
  return {std::vector<Onset>(search_regions(settings.families).size() * settings.methods.size())};
}

std::uint64_t run_onsets(const Settings& settings, std::uint64_t samples, const run::RunControl<Onsets>& control,
                         Onsets& onsets) {
  const Search search(settings);
  return run::run_sweep(samples, settings.threads, control, no_onsets(settings), onsets,
                        [&](std::uint64_t n, Onsets& part) { search.measure(n, part); });
}

std::uint64_t climb_count(const Settings& settings) {
  return search_regions(settings.families).size() * settings.methods.size() * Onset::kMostKept;
}

std::uint64_t run_climbs(const Settings& settings, const run::RunControl<WorstCases>& control, const Onsets& onsets,
                         WorstCases& worst) {
  const Search search(settings);
  worst = no_worst_cases(settings);
  return run::run_sweep(
      {climb_count(settings), 1, settings.threads, control.stop, control.progress},
      [&](std::uint64_t i, WorstCases& part) {
        const std::size_t where = static_cast<std::size_t>(i) / Onset::kMostKept, rank = i % Onset::kMostKept;
        const std::vector<Find>& furthest = onsets.all[where].furthest;
        if (rank < furthest.size()) search.climb_from(where, furthest[rank], part);
      },
      [](std::uint64_t, const WorstCases&) {}, no_worst_cases(settings), 0, worst);
}

}  // namespace touchstone::near_edge
