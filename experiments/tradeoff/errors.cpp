// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/tradeoff/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "experiments/tradeoff/units.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using judge::Outcome;
using judge::Test;
using near_edge::Crossing;

const Worst& worse(const Worst& a, const Worst& b) {
  const auto rank = [](const Worst& w) { return std::make_tuple(-w.ulps, w.n, w.stratum); };
  return rank(b) < rank(a) ? b : a;
}

MethodErrors nothing() {
  MethodErrors errors;
  errors.offsets.resize(near_edge::all_offsets().size());
  return errors;
}

/// One thread's part.
class Part {
 public:
  Part(const Settings& settings, const std::vector<bool>& knows_boundary)
      : settings_(settings), knows_boundary_(knows_boundary), exact_(*methods::find_method("exact")) {
    errors_.at.assign(near_edge::all_strata().size(), std::vector(settings.methods.size(), nothing()));
  }

  /// Sample n of every stratum of the selected families.
  void ask_all(std::uint64_t n) {
    for (std::size_t stratum = 0; stratum < errors_.at.size(); ++stratum) {
      const auto& families = settings_.families;
      if (std::ranges::find(families, near_edge::all_strata()[stratum].family) == families.end()) continue;
      if (const auto crossing = near_edge::draw_crossing({stratum, {}, settings_.seed, n}, exact_))
        ask(stratum, n, *crossing);
      else
        ++errors_.missing;
    }
  }

  [[nodiscard]] const Errors& errors() const { return errors_; }

 private:
  void ask(std::size_t stratum, std::uint64_t n, const Crossing& crossing) {
    const auto threshold = near_edge::all_strata()[stratum].threshold;
    const Ball& middle = crossing.balls[crossing.balls.size() / 2];  // at offset 0
    std::optional<Answer> truth;
    if (near_edge::moves_radius(threshold)) truth = exact::answer(middle, crossing.polygon);
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) {
      if (settings_.methods[m]->slow() && n % kSlowStride != 0) continue;
      MethodErrors& errors = errors_.at[stratum][m];
      const auto prepared = settings_.methods[m]->prepare(crossing.polygon);
      ++errors.samples;
      const Test test = test_at(threshold);
      for (std::size_t i = 0; i < crossing.balls.size(); ++i) {
        const auto answer = prepared->ask(crossing.balls[i], question(test));
        const auto outcome = compare(test, answer, crossing.truths[i], knows_boundary_[m]);
        if (!outcome && !answer.unsure) continue;  // the method has no such test
        const bool wrong = outcome && *outcome != Outcome::Right;
        errors.offsets[i] += {wrong ? 1U : 0U, outcome ? 0U : 1U, 1};
      }
      if (!truth) continue;
      const auto answer = prepared->ask(middle, methods::Question::Answer);
      using enum Quantity;
      add(errors, Distance,
          answer.distance ? std::optional(distance_error(*answer.distance, truth->distance)) : std::nullopt, n,
          stratum);
      add(errors, Point, answer.point ? std::optional(point_error(*answer.point, truth->point)) : std::nullopt, n,
          stratum);
    }
  }

  static void add(MethodErrors& errors, Quantity quantity, std::optional<double> error, std::uint64_t n,
                  std::size_t stratum) {
    const auto q = static_cast<std::size_t>(quantity);
    ++errors.ulps[q].asked;
    if (!error) return;
    errors.ulps[q].known.push_back(*error);
    errors.worst[q] = worse(errors.worst[q], {*error, n, stratum});
  }

  const Settings& settings_;
  const std::vector<bool>& knows_boundary_;
  const methods::Method& exact_;
  Errors errors_;
};

}  // namespace

judge::Test test_at(near_edge::Threshold threshold) {
  return near_edge::moves_radius(threshold) ? Test::Contact : Test::Foot;
}

Tally& Tally::operator+=(const Tally& other) {
  wrong += other.wrong;
  unsure += other.unsure;
  trials += other.trials;
  return *this;
}

std::string_view word(Quantity quantity) { return quantity == Quantity::Distance ? "distance" : "point"; }

double UlpErrors::quantile(double share) const {
  const auto place = static_cast<std::size_t>(std::ceil(share * static_cast<double>(known.size())));
  return known[std::max<std::size_t>(place, 1) - 1];
}

Tally MethodErrors::near_threshold() const {
  Tally sum;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (std::abs(near_edge::all_offsets()[i]) <= kNear) sum += offsets[i];
  return sum;
}

MethodErrors& MethodErrors::operator+=(const MethodErrors& other) {
  for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] += other.offsets[i];
  samples += other.samples;
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    ulps[q].asked += other.ulps[q].asked;
    ulps[q].known.insert(ulps[q].known.end(), other.ulps[q].known.begin(), other.ulps[q].known.end());
    worst[q] = worse(worst[q], other.worst[q]);
  }
  return *this;
}

MethodErrors Errors::sum(const std::vector<std::size_t>& strata, std::size_t method) const {
  MethodErrors sum = nothing();
  for (const std::size_t stratum : strata) sum += at[stratum][method];
  for (UlpErrors& errors : sum.ulps) std::ranges::sort(errors.known);
  return sum;
}

Errors measure_errors(const Settings& settings, const std::atomic<bool>& stop, const run::Progress& progress) {
  std::vector<bool> knows_boundary;
  for (const auto* method : settings.methods) knows_boundary.push_back(judge::knows_boundary(*method));
  std::vector<Part> parts(settings.threads, Part(settings, knows_boundary));
  Errors result = Part(settings, knows_boundary).errors();
  result.samples = run::run_blocks(settings.samples, settings.threads, stop, progress,
                                   [&](unsigned thread, std::uint64_t n) { parts[thread].ask_all(n); });
  for (const Part& part : parts) {
    result.missing += part.errors().missing;
    for (std::size_t stratum = 0; stratum < result.at.size(); ++stratum)
      for (std::size_t m = 0; m < settings.methods.size(); ++m) result.at[stratum][m] += part.errors().at[stratum][m];
  }
  return result;
}

}  // namespace touchstone::tradeoff
