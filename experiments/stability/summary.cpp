// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/stability/summary.h"

#include <algorithm>
#include <cmath>

namespace touchstone::stability {

Tally& Tally::operator+=(const Tally& other) {
  failed += other.failed;
  samples += other.samples;
  wrong += other.wrong;
  balls += other.balls;
  return *this;
}

void Distribution::sort() { std::sort(numbers_.begin(), numbers_.end()); }

std::size_t Distribution::infinite() const {
  return static_cast<std::size_t>(numbers_.end() - std::lower_bound(numbers_.begin(), numbers_.end(), INFINITY));
}

double Distribution::quantile(double share) const {
  const auto place = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count())));
  return numbers_[std::clamp<std::size_t>(place, 1, count()) - 1];
}

Summary::Summary(const Settings& settings, const Result& result)
    : worst(settings.axes.size(), std::vector<std::optional<WorstCase>>(settings.methods.size())),
      missing(settings.axes.size()) {
  for (std::size_t b = 0; b < result.blocks.size(); ++b) {
    const Block& block = result.blocks[b];
    const std::size_t axis = b % settings.axes.size();
    for (const TestResult& r : block.tests)
      failures[{axis, r.nearness, r.test, r.method, r.level}] += {r.wrong > 0 ? 1U : 0U, 1, r.wrong, r.asked};
    for (const NumberError& e : block.errors) {
      ErrorSummary& summary = errors[{axis, e.quantity, e.method, e.level}];
      summary.relative.add(e.relative);
      summary.ulps.add(e.ulps);
    }
    std::map<std::pair<std::size_t, std::size_t>, bool> exceeded;  // by level, each of which is a polygon, and quantity
    for (const auto& [level, o] : block.bounds) {
      BoundSummary& cell = bounds[{o.quantity, axis, level}];
      for (BoundSummary* summary : {&cell, &all_bounds[o.quantity]}) {
        summary->tightness.add(o.tightness);
        summary->exceeded += o.holds ? 0 : 1;
      }
      bool& any = exceeded[{level, o.quantity}];
      any = any || !o.holds;
    }
    for (const auto& [place, any] : exceeded)
      for (BoundSummary* summary : {&bounds[{place.second, axis, place.first}], &all_bounds[place.second]}) {
        ++summary->polygons;
        summary->failed += any ? 1 : 0;
      }
    for (const WorstCase& candidate : block.worst)
      if (auto& held = worst[axis][candidate.method]; !held || candidate.worse_than(*held)) held = candidate;
    missing[axis] += block.missing;
    confirmed += block.confirmed;
    disputed += block.disputed;
  }
  for (auto& [cell, summary] : errors) {
    summary.relative.sort();
    summary.ulps.sort();
  }
  for (auto& [cell, summary] : bounds) summary.tightness.sort();
  for (auto& [quantity, summary] : all_bounds) summary.tightness.sort();
}

const Tally* Summary::at(std::size_t axis, Nearness nearness, Test test, std::size_t method, std::size_t level) const {
  const auto found = failures.find({axis, nearness, test, method, level});
  return found == failures.end() ? nullptr : &found->second;
}

std::optional<std::size_t> Summary::first_level(const Settings& settings, std::size_t axis, Nearness nearness,
                                                Test test, std::size_t method, double share) const {
  for (std::size_t level = 0; level < levels(settings.axes[axis]).size(); ++level)
    if (const Tally* tally = at(axis, nearness, test, method, level); tally != nullptr && tally->rate() > share)
      return level;
  return std::nullopt;
}

Tally Summary::total(const Settings& settings, std::size_t method) const {
  Tally sum;
  for (const auto& [cell, tally] : failures) {
    const auto& [axis, nearness, test, asked, level] = cell;
    if (asked != method || against_motion(settings.axes[axis])) continue;
    sum.wrong += tally.wrong;
    sum.balls += tally.balls;
    if (test != Test::Contact || nearness != Nearness::OneDouble) continue;
    sum.failed += tally.failed;
    sum.samples += tally.samples;
  }
  return sum;
}

}  // namespace touchstone::stability
