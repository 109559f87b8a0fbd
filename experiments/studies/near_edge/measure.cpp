// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/measure.h"

#include "experiments/methods/registry.h"

namespace touchstone::near_edge {
namespace {

struct NearCrossing : cases::Crossing {
  Ranges found{};
};

/// Adds the answers to `contact` to those of the ranges in which the crossing lies.
void add_by_property(ByProperty& sum, const NearCrossing& crossing, std::size_t method,
                     const std::vector<cases::Outcomes>& outcomes, bool lifts) {
  auto& properties = sum[static_cast<std::size_t>(cases::all_strata()[crossing.stratum].threshold)];
  for (std::size_t p = 0; p < kProperties.size(); ++p)
    if (const auto range = crossing.found[p])
      for (std::size_t ball = 0; ball < outcomes.size(); ++ball)
        properties[p][*range].offsets[method][crossing.offsets[ball]].add(outcomes[ball], lifts);
}

}  // namespace

void TestFailures::add(const cases::Crossing& crossing, const std::vector<cases::Outcomes>& outcomes, bool lifts) {
  bool failed = false;
  for (std::size_t ball = 0; ball < outcomes.size(); ++ball) {
    offsets[crossing.offsets[ball]].add(outcomes[ball], lifts);
    failed |= (lifts ? outcomes[ball].contract : outcomes[ball].as_given) != Outcome::Right;
  }
  samples.add_sample(failed);
}

TestFailures sum(const Counts& counts, const std::vector<std::size_t>& strata, Test test, std::size_t method) {
  TestFailures sum;
  for (const std::size_t stratum : strata) program::add(sum, counts[stratum][static_cast<std::size_t>(test)][method]);
  return sum;
}

Result no_result(const Settings& settings) {
  Result result;
  result.counts.resize(cases::all_strata().size());
  for (auto& tests : result.counts) tests.fill(std::vector<TestFailures>(settings.methods.size()));
  const RangeFailures none{
      std::vector(settings.methods.size(), std::vector<CrossingFailures>(cases::all_offsets().size()))};
  std::vector<std::vector<RangeFailures>> properties;
  for (const Property property : kProperties) properties.emplace_back(ends(property).size(), none);
  result.by_property.assign(cases::all_thresholds().size(), properties);
  return result;
}

void run_study(const Settings& settings, const program::RunControl& control, Result& result) {
  const cases::Method& exact = *methods::find_method("exact");
  cases::walk(
      {settings.methods, settings.samples, settings.threads}, control, no_result(settings), result,
      [&](std::uint64_t n, Result& part, const auto& visit) {
        ++part.samples;
        part.missing += cases::draw_crossings(settings, n, exact, [&](cases::Crossing& drawn) {
          const auto& stratum = cases::all_strata()[drawn.stratum];
          NearCrossing crossing{{std::move(drawn)}, {}};
          if (stratum.placement == workloads::Placement::Planar && cases::moves_radius(stratum.threshold))
            crossing.found = ranges(crossing);
          visit(crossing);
        });
      },
      [](Result& part, const NearCrossing& crossing, std::size_t m, const cases::Asked& asked) {
        for (const Test test : kTests) {
          std::vector<cases::Outcomes> outcomes;
          asked.compare(test, [&](std::size_t, const cases::Outcomes& of_ball) { outcomes.push_back(of_ball); });
          if (outcomes.size() == crossing.balls.size())
            part.counts[crossing.stratum][static_cast<std::size_t>(test)][m].add(crossing, outcomes, asked.lifts());
          if (test == Test::Contact) add_by_property(part.by_property, crossing, m, outcomes, asked.lifts());
        }
      });
}

}  // namespace touchstone::near_edge
