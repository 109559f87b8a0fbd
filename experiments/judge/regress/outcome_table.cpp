// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/comparison.h"
#include "experiments/judge/regress/regress.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::regress {
namespace {

constexpr std::size_t kMiddle = kExponents.size();

const auto& exponents(Numbers numbers) { return numbers == Numbers::Doubles ? kExponents : kFloatExponents; }

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

double rounded(Numbers numbers, double x) { return numbers == Numbers::Doubles ? x : as_float(x); }

bool are_floats(const Polygon& polygon) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::ranges::all_of(polygon.coordinates(axis), [](double x) { return x == as_float(x); })) return false;
  return true;
}

/// Returns the radius number i, in ascending order, where `distance` is the nearest number to the distance.
double radius(Numbers numbers, double distance, std::size_t i) {
  if (i == kMiddle) return distance;
  const int exponent = exponents(numbers)[i < kMiddle ? i : kRadii - 1 - i];
  return rounded(numbers, distance * (i < kMiddle ? 1 - std::ldexp(1.0, -exponent) : 1 + std::ldexp(1.0, -exponent)));
}

/// Draws the ball and polygon of a block of kRadii cases. Of floats: the first polygon whose vertices are floats, with
/// the ball's centre rounded, unless that is on the polygon.
workloads::Sample draw(const Settings& settings, const Group& group, std::size_t block) {
  const workloads::Workload workload{.family = group.family, .ball = kPlaces[block / settings.samples]};
  for (std::uint64_t n = block % settings.samples;; n += kMostSamples) {
    workloads::Sample sample = workloads::sample(workload, settings.seed, n);
    if (group.numbers == Numbers::Doubles) return sample;
    if (!are_floats(sample.polygon)) continue;
    sample.ball.center = sample.ball.center.cast<float>().cast<double>();
    sample.ball.radius = as_float(exact::answer({sample.ball.center, 0}, sample.polygon).distance);
    if (sample.ball.radius > 0) return sample;
  }
}

}  // namespace

std::string_view to_string(Numbers numbers) { return numbers == Numbers::Doubles ? "doubles" : "floats"; }

std::string Group::name() const {
  return std::string(to_string(family)) + (numbers == Numbers::Doubles ? "" : " in floats");
}

const std::vector<Group>& all_groups() {
  static const std::vector<Group> groups = [] {
    std::vector<Group> list;
    for (const Numbers numbers : {Numbers::Doubles, Numbers::Floats})
      for (const auto family : workloads::all_families()) list.push_back({family, numbers});
    return list;
  }();
  return groups;
}

std::optional<int> exponent_of(Numbers numbers, std::size_t n) {
  const std::size_t i = n % kRadii;
  if (i == kMiddle) return std::nullopt;
  return exponents(numbers)[i < kMiddle ? i : kRadii - 1 - i];
}

workloads::Sample draw_case(const Settings& settings, const Group& group, std::size_t n) {
  workloads::Sample sample = draw(settings, group, n / kRadii);
  sample.id = fmt::format("regress-{}-{}-{}{}", to_string(group.family), settings.seed, n,
                          group.numbers == Numbers::Doubles ? "" : "-floats");
  sample.ball.radius = radius(group.numbers, sample.ball.radius, n % kRadii);
  return sample;
}

bool answers(const cases::Method& method) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto answer = method.prepare(square)->ask({{1, 1, 1}, 2}, cases::QueryKind::Contact);
  return answer.contact || answer.unsure;
}

std::uint64_t blocks_of(const Settings& settings) { return all_groups().size() * kPlaces.size() * settings.samples; }

std::optional<OutcomeTable> find_outcomes(const Settings& settings, const std::vector<const cases::Method*>& methods,
                                          unsigned threads, const std::atomic<bool>& stop,
                                          const program::Progress& progress) {
  const auto& groups = all_groups();
  const std::size_t blocks = kPlaces.size() * settings.samples;
  std::vector<Outcomes> outcomes(methods.size(), Outcomes(groups.size() * settings.cases()));
  const std::uint64_t done =
      program::run_blocks(blocks_of(settings), threads, stop, progress, [&](unsigned, std::uint64_t b) {
        const std::size_t g = b / blocks, block = b % blocks;
        const workloads::Sample sample = draw(settings, groups[g], block);
        const filtered::PreparedPolygon certified(sample.polygon);
        std::array<Ball, kRadii> balls;
        std::array<bool, kRadii> truth;
        for (std::size_t i = 0; i < kRadii; ++i) {
          balls[i] = {sample.ball.center, radius(groups[g].numbers, sample.ball.radius, i)};
          truth[i] = filtered::contact(balls[i], certified);
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
          const auto prepared = methods[m]->prepare(sample.polygon);
          for (std::size_t i = 0; i < kRadii; ++i) {
            cases::PartialAnswer certain;
            certain.contact = truth[i];
            const auto answer = prepared->ask(balls[i], cases::QueryKind::Contact);
            const auto compared = cases::compare(cases::Test::Contact, answer, certain, true);
            if (compared == cases::Outcome::Right) continue;
            outcomes[m][g * settings.cases() + block * kRadii + i] = compared ? Outcome::Wrong : Outcome::Unsure;
            if (exact::contact(balls[i], sample.polygon) != truth[i])
              throw std::logic_error(fmt::format("filtered differs from exact: {}, {}, case {}", settings.seed,
                                                 groups[g].name(), block * kRadii + i));
          }
        }
      });
  if (done < blocks_of(settings)) return std::nullopt;

  OutcomeTable table;
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto begin = outcomes[m].begin() + static_cast<std::ptrdiff_t>(g * settings.cases());
      table[std::string(methods[m]->name())][groups[g].name()] =
          Outcomes(begin, begin + static_cast<std::ptrdiff_t>(settings.cases()));
    }
  return table;
}

Summary summary_of(const Outcomes& outcomes, Numbers numbers) {
  Summary summary;
  summary.cases = outcomes.size();
  for (std::size_t n = 0; n < outcomes.size(); ++n) {
    if (outcomes[n] == Outcome::Unsure) ++summary.unsure;
    if (outcomes[n] != Outcome::Wrong) continue;
    ++summary.wrong;
    const auto exponent = exponent_of(numbers, n);
    if (exponent && (!summary.first || *exponent < *summary.first)) summary.first = exponent;
  }
  return summary;
}

}  // namespace touchstone::regress
