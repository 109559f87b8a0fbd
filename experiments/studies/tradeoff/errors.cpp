// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>

#include "experiments/methods/registry.h"
#include "experiments/run/statistics/errors.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::Crossing;
using cases::Outcome;
using cases::Test;

class Study {
 public:
  explicit Study(const Settings& settings) : settings_(settings), exact_(*methods::find_method("exact")) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  /// Sample n of every stratum of the selected families.
  void ask_all(std::uint64_t n, Errors& part) const {
    const auto& families = settings_.families;
    for (std::size_t stratum = 0; stratum < part.at.size(); ++stratum) {
      if (std::ranges::find(families, cases::all_strata()[stratum].family) == families.end()) continue;
      if (const auto crossing = cases::draw_crossing({stratum, {}, settings_.seed, n}, exact_))
        ask(stratum, n, *crossing, part.at[stratum]);
      else
        ++part.missing;
    }
    ++part.samples;
  }

 private:
  void ask(std::size_t stratum, std::uint64_t n, const Crossing& crossing, std::vector<MethodErrors>& by_method) const {
    const auto threshold = cases::all_strata()[stratum].threshold;
    const Ball& middle = crossing.balls[crossing.balls.size() / 2];  // at offset 0
    std::optional<Answer> truth;
    if (cases::moves_radius(threshold)) truth = exact::answer(middle, crossing.polygon);
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) {
      if (settings_.methods[m]->slow() && n % kSlowStride != 0) continue;
      MethodErrors& errors = by_method[m];
      const auto prepared = settings_.methods[m]->prepare(crossing.polygon);
      ++errors.samples;
      const Test test = cases::test_at(threshold);
      const bool overflowed = truth && ask_numbers(*prepared, middle, *truth, n, stratum, errors);
      for (std::size_t i = 0; i < crossing.balls.size(); ++i) {
        const auto answer = prepared->ask(crossing.balls[i], query_kind(test));
        const auto outcome = compare(test, answer, crossing.truths[i], knows_boundary_[m]);
        if (!outcome && !answer.unsure) continue;  // the method has no such test
        errors.offsets[i].add(outcome);
        if (overflowed && outcome && *outcome != Outcome::Right) ++errors.offsets[i].overflowed;
      }
    }
  }

  /// Adds the errors of distance and point. Returns whether one of them is not finite.
  static bool ask_numbers(const cases::PreparedMethod& method, const Ball& ball, const Answer& truth, std::uint64_t n,
                          std::size_t stratum, MethodErrors& errors) {
    const auto answer = method.ask(ball, cases::QueryKind::Answer);
    std::optional<double> distance, point;
    if (answer.distance) distance = statistics::number_error(*answer.distance, truth.distance);
    if (answer.point) point = statistics::point_error(*answer.point, truth.point);
    add(errors, Quantity::Distance, distance, n, stratum);
    add(errors, Quantity::Point, point, n, stratum);
    return !std::isfinite(distance.value_or(0)) || !std::isfinite(point.value_or(0));
  }

  static void add(MethodErrors& errors, Quantity quantity, std::optional<double> error, std::uint64_t n,
                  std::size_t stratum) {
    const auto q = static_cast<std::size_t>(quantity);
    ++errors.ulps[q].asked;
    if (!error) return;
    errors.ulps[q].known.add(*error);
    errors.worst[q] += {*error, n, stratum};
  }

  const Settings& settings_;
  const cases::Method& exact_;
  std::vector<bool> knows_boundary_;
};

}  // namespace

double UlpErrors::quantile_of_finite(double share) const {
  if (known.infinite() == 0) return known.quantile(share);
  const auto all = static_cast<double>(known.count()), finite = all - static_cast<double>(known.infinite());
  return known.quantile((std::ceil(share * finite) - 0.5) / all);  // half a number short: rounding passes none
}

std::string_view to_string(Quantity quantity) { return quantity == Quantity::Distance ? "distance" : "point"; }

Worst& Worst::operator+=(const Worst& other) {
  const auto rank = [](const Worst& w) { return std::make_tuple(-w.ulps, w.n, w.stratum); };
  if (rank(other) < rank(*this)) *this = other;
  return *this;
}

Answers MethodErrors::near_threshold() const {
  Answers sum;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (std::abs(cases::all_offsets()[i]) <= kNear) run::add(sum, offsets[i]);
  return sum;
}

MethodErrors Errors::sum(const std::vector<std::size_t>& strata, std::size_t method) const {
  MethodErrors sum;
  for (const std::size_t stratum : strata) run::add(sum, at[stratum][method]);
  return sum;
}

std::uint64_t Errors::polygons(const std::vector<std::size_t>& strata, std::size_t method) const {
  std::map<std::pair<workloads::Family, workloads::Placement>, std::uint64_t> most;
  for (const std::size_t stratum : strata) {
    const auto& [family, placement, threshold] = cases::all_strata()[stratum];
    std::uint64_t& polygons = most[{family, placement}];
    polygons = std::max(polygons, at[stratum][method].samples);
  }
  std::uint64_t sum = 0;
  for (const auto& [place, polygons] : most) sum += polygons;
  return sum;
}

Errors no_errors(const Settings& settings) {
  Errors errors;
  errors.at.assign(cases::all_strata().size(), std::vector<MethodErrors>(settings.methods.size()));
  return errors;
}

void measure_errors(const Settings& settings, const run::RunControl& control, Errors& errors) {
  const Study study(settings);
  run::run_sweep(settings.samples, settings.threads, control, no_errors(settings), errors,
                 [&](std::uint64_t n, Errors& part) { study.ask_all(n, part); });
}

}  // namespace touchstone::tradeoff
