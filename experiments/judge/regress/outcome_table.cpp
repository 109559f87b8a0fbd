// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/regress/outcome_table.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "experiments/cases/comparison.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::regress {
namespace {

constexpr std::size_t kMiddle = kExponents.size();

/// Returns the factor of the radius, in ascending order.
double factor(std::size_t radius) {
  if (radius == kMiddle) return 1;
  if (radius < kMiddle) return 1 - std::ldexp(1.0, -kExponents[radius]);
  return 1 + std::ldexp(1.0, -kExponents[kRadii - 1 - radius]);
}

/// Draws the ball and polygon of a block of kRadii cases.
workloads::Sample draw(const Settings& settings, workloads::Family family, std::size_t block) {
  return workloads::sample({.family = family, .ball = kPlaces[block / settings.samples]}, settings.seed,
                           block % settings.samples);
}

}  // namespace

std::optional<int> exponent_of(std::size_t n) {
  const std::size_t radius = n % kRadii;
  if (radius == kMiddle) return std::nullopt;
  return kExponents[radius < kMiddle ? radius : kRadii - 1 - radius];
}

workloads::Sample draw_case(const Settings& settings, workloads::Family family, std::size_t n) {
  workloads::Sample sample = draw(settings, family, n / kRadii);
  sample.id = fmt::format("regress-{}-{}-{}", to_string(family), settings.seed, n);
  sample.ball.radius *= factor(n % kRadii);
  return sample;
}

bool answers(const cases::Method& method) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto answer = method.prepare(square)->ask({{1, 1, 1}, 2}, cases::QueryKind::Contact);
  return answer.contact || answer.unsure;
}

std::uint64_t blocks_of(const Settings& settings) {
  return workloads::all_families().size() * kPlaces.size() * settings.samples;
}

std::optional<OutcomeTable> find_outcomes(const Settings& settings, const std::vector<const cases::Method*>& methods,
                                          unsigned threads, const std::atomic<bool>& stop,
                                          const harness::Progress& progress) {
  const auto& families = workloads::all_families();
  const std::size_t blocks = kPlaces.size() * settings.samples;
  std::vector<Outcomes> outcomes(methods.size(), Outcomes(families.size() * settings.cases()));
  const std::uint64_t done =
      harness::run_blocks(blocks_of(settings), threads, stop, progress, [&](unsigned, std::uint64_t b) {
        const std::size_t family = b / blocks, block = b % blocks;
        const workloads::Sample sample = draw(settings, families[family], block);
        const filtered::PreparedPolygon certified(sample.polygon);
        std::array<bool, kRadii> truth;
        for (std::size_t i = 0; i < kRadii; ++i)
          truth[i] = filtered::contact({sample.ball.center, sample.ball.radius * factor(i)}, certified);
        for (std::size_t m = 0; m < methods.size(); ++m) {
          const auto prepared = methods[m]->prepare(sample.polygon);
          for (std::size_t i = 0; i < kRadii; ++i) {
            const Ball ball{sample.ball.center, sample.ball.radius * factor(i)};
            cases::PartialAnswer certain;
            certain.contact = truth[i];
            const auto answer = prepared->ask(ball, cases::QueryKind::Contact);
            const auto compared = cases::compare(cases::Test::Contact, answer, certain, true);
            if (compared == cases::Outcome::Right) continue;
            outcomes[m][family * settings.cases() + block * kRadii + i] = compared ? Outcome::Wrong : Outcome::Unsure;
            if (exact::contact(ball, sample.polygon) != truth[i])
              throw std::logic_error(fmt::format("filtered differs from exact: {} family {} case {}", settings.seed,
                                                 to_string(families[family]), block * kRadii + i));
          }
        }
      });
  if (done < blocks_of(settings)) return std::nullopt;

  OutcomeTable table;
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (std::size_t f = 0; f < families.size(); ++f) {
      const auto begin = outcomes[m].begin() + static_cast<std::ptrdiff_t>(f * settings.cases());
      table[std::string(methods[m]->name())][std::string(to_string(families[f]))] =
          Outcomes(begin, begin + static_cast<std::ptrdiff_t>(settings.cases()));
    }
  return table;
}

Summary summary_of(const Outcomes& outcomes) {
  Summary summary;
  summary.cases = outcomes.size();
  for (std::size_t n = 0; n < outcomes.size(); ++n) {
    if (outcomes[n] == Outcome::Unsure) ++summary.unsure;
    if (outcomes[n] != Outcome::Wrong) continue;
    ++summary.wrong;
    const auto exponent = exponent_of(n);
    if (exponent && (!summary.first || *exponent < *summary.first)) summary.first = exponent;
  }
  return summary;
}

}  // namespace touchstone::regress
