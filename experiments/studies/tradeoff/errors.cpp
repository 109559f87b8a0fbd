// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tradeoff/errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "experiments/methods/registry.h"
#include "experiments/program/statistics/errors.h"
#include "robust/exact/exact.h"

namespace touchstone::tradeoff {
namespace {

using cases::Crossing;

/// Adds the errors of distance and point. Returns whether one of them is not finite.
bool add_numbers(MethodErrors& errors, const cases::PartialAnswer& answer, const cases::PartialAnswer& truth,
                 std::uint64_t n, std::size_t stratum) {
  std::array<std::optional<double>, kQuantities.size()> found;  // by Quantity
  if (answer.distance) found[0] = statistics::number_error(*answer.distance, *truth.distance);
  if (answer.point) found[1] = statistics::point_error(*answer.point, *truth.point);
  bool finite = true;
  for (std::size_t q = 0; q < found.size(); ++q) {
    ++errors.ulps[q].asked;
    if (!found[q]) continue;
    errors.ulps[q].known.add(*found[q]);
    errors.worst[q] += {*found[q], n, stratum};
    finite &= std::isfinite(*found[q]);
  }
  return !finite;
}

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
    if (std::abs(cases::all_offsets()[i]) <= kNear) program::add(sum, offsets[i]);
  return sum;
}

double MethodErrors::reach() const {
  const auto& all = cases::all_offsets();
  const double least = all[all.size() / 2 + 1];
  double reach = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i)
    if (offsets[i].not_right() > 0) reach = std::max({reach, std::abs(all[i]), least / 2});
  return reach;
}

MethodErrors Errors::sum(const std::vector<std::size_t>& strata, std::size_t method) const {
  MethodErrors sum;
  for (const std::size_t stratum : strata) program::add(sum, at[stratum][method]);
  return sum;
}

std::uint64_t Errors::polygons(const std::vector<std::size_t>& strata, std::size_t method) const {
  std::uint64_t sum = 0;
  for (const std::size_t stratum : strata) sum += at[stratum][method].samples;
  return sum;
}

Errors no_errors(const Settings& settings) {
  Errors errors;
  errors.at.assign(cases::all_strata().size(), std::vector<MethodErrors>(settings.methods.size()));
  return errors;
}

void measure_errors(const Settings& settings, const program::RunControl& control, Errors& errors) {
  const cases::Method& exact = *methods::find_method("exact");
  const auto crosses_radius = [](const Crossing& crossing) {
    return cases::moves_radius(cases::all_strata()[crossing.stratum].threshold);
  };
  cases::walk(
      {.methods = settings.methods,
       .samples = settings.samples,
       .threads = settings.threads,
       .slow_stride = kSlowStride},
      control, no_errors(settings), errors,
      [&](std::uint64_t n, Errors& part, const auto& visit) {
        ++part.samples;
        part.missing += cases::draw_crossings(settings, n, exact, [&](Crossing& crossing) {
          const std::size_t middle = crossing.middle();
          if (crosses_radius(crossing))
            crossing.truths[middle] =
                cases::PartialAnswer::of(exact::answer(crossing.balls[middle], crossing.polygon), "");
          visit(crossing);
        });
      },
      [&](Errors& part, const Crossing& crossing, std::size_t m, const cases::Asked& asked) {
        MethodErrors& found = part.at[crossing.stratum][m];
        ++found.samples;
        const std::size_t middle = crossing.middle();
        const bool overflowed =
            crosses_radius(crossing) && add_numbers(found, asked.answer(middle, cases::QueryKind::Answer),
                                                    crossing.truths[middle], crossing.n, crossing.stratum);
        asked.compare(cases::test_at(cases::all_strata()[crossing.stratum].threshold),
                      [&](std::size_t ball, const cases::Outcomes& outcomes) {
                        Answers& at = found.offsets[crossing.offsets[ball]];
                        const std::uint64_t wrong = at.wrong;
                        at.add(outcomes, asked.lifts());
                        if (overflowed) at.overflowed += at.wrong - wrong;
                      });
      });
}

}  // namespace touchstone::tradeoff
