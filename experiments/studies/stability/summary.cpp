// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/summary.h"

#include <algorithm>
#include <cmath>

namespace touchstone::stability {
namespace {

void keep_worse(std::optional<WorstCase>& held, const WorstCase& candidate) {
  if (!held || candidate.worse_than(*held)) held = candidate;
}

}  // namespace

void Summary::add(const Block& block) {
  const std::size_t axis = block.number % missing.size();
  ++blocks;
  for (const TestResult& r : block.tests)
    run::add(
        failures[{axis, r.nearness, r.test, r.method, r.level}],
        {.samples = {.trials = 1, .wrong = r.wrong > 0 ? 1U : 0U}, .answers = {.trials = r.asked, .wrong = r.wrong}});
  for (const NumberError& e : block.errors) errors[{axis, e.quantity, e.method, e.level}].add(e.relative);
  add_bounds(block, axis);
  for (const WorstCase& candidate : block.worst) keep_worse(worst[axis][candidate.method], candidate);
  missing[axis] += block.missing;
  confirmed += block.confirmed;
  disputed += block.disputed;
}

void Summary::add_bounds(const Block& block, std::size_t axis) {
  // By level, each of which is a polygon, and quantity.
  std::map<std::pair<std::size_t, std::size_t>, BoundSummary> found;
  std::vector<ConditionPoint> shown;
  for (const auto& [level, o] : block.bounds) {
    BoundSummary& bound = found[{level, o.quantity}];
    bound.tightness.add(o.tightness);
    bound.exceeded += o.holds ? 0 : 1;
    if (bounds_number(block.axis, level, block.sample).value() >= kSamplesShown) continue;
    if (!std::isnan(o.relative_error)) shown.push_back({level, o.quantity, o.condition, o.relative_error});
  }
  for (auto& [place, bound] : found) {
    bound.polygons = 1;
    bound.failed = bound.exceeded > 0 ? 1 : 0;
    run::add(bounds[{place.second, axis, place.first}], bound);
    run::add(all_bounds[place.second], bound);
  }
  if (!shown.empty()) points[block.number] = std::move(shown);
}

Summary& Summary::operator+=(const Summary& other) {
  blocks += other.blocks;
  run::add(failures, other.failures);
  run::add(errors, other.errors);
  run::add(bounds, other.bounds);
  run::add(all_bounds, other.all_bounds);
  points.insert(other.points.begin(), other.points.end());
  for (std::size_t axis = 0; axis < worst.size(); ++axis) {
    for (std::size_t m = 0; m < worst[axis].size(); ++m)
      if (other.worst[axis][m]) keep_worse(worst[axis][m], *other.worst[axis][m]);
    missing[axis] += other.missing[axis];
  }
  confirmed += other.confirmed;
  disputed += other.disputed;
  return *this;
}

Summary no_summary(const Settings& settings) {
  Summary summary;
  summary.worst.resize(settings.axes.size(), std::vector<std::optional<WorstCase>>(settings.methods.size()));
  summary.missing.resize(settings.axes.size());
  return summary;
}

void run_study(const Settings& settings, const run::RunControl& control, Summary& summary) {
  run::run_sweep(block_count(settings), settings.threads, control, no_summary(settings), summary,
                 [&](std::uint64_t number, Summary& part) { part.add(ask_block(settings, number)); });
}

const SampledFailures* Summary::at(std::size_t axis, Nearness nearness, Test test, std::size_t method,
                                   std::size_t level) const {
  const auto found = failures.find({axis, nearness, test, method, level});
  return found == failures.end() ? nullptr : &found->second;
}

std::optional<std::size_t> Summary::first_level(const Settings& settings, std::size_t axis, Nearness nearness,
                                                Test test, std::size_t method, double share) const {
  for (std::size_t level = 0; level < levels(settings.axes[axis]).size(); ++level)
    if (const SampledFailures* found = at(axis, nearness, test, method, level); found && found->samples.share() > share)
      return level;
  return std::nullopt;
}

SampledFailures Summary::total(const Settings& settings, std::size_t method) const {
  SampledFailures sum;
  for (const auto& [cell, found] : failures) {
    const auto& [axis, nearness, test, asked, level] = cell;
    if (asked != method || against_motion(settings.axes[axis])) continue;
    run::add(sum.answers, found.answers);
    if (test == Test::Contact && nearness == Nearness::OneDouble) run::add(sum.samples, found.samples);
  }
  return sum;
}

}  // namespace touchstone::stability
