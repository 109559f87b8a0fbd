// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/motions/steps.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "robust/filtered/motion.h"

namespace touchstone::motions {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kStream = 0x74756e6e656c;

/// Returns a direction, uniform on the sphere.
Vector3d any_direction(workloads::Random& random) {
  for (;;) {
    const double z = 2 * random.unit() - 1, y = 2 * random.unit() - 1, x = 2 * random.unit() - 1;
    const Vector3d v(x, y, z);
    const double square = v.squaredNorm();
    if (square > 0x1p-10 && square <= 1) return v / std::sqrt(square);
  }
}

/// Returns a random point of the box around the polygon.
Vector3d any_point(workloads::Random& random, const Polygon& polygon) {
  Vector3d low = polygon.vertex(0), high = low;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i) {
    low = low.cwiseMin(polygon.vertex(i));
    high = high.cwiseMax(polygon.vertex(i));
  }
  const double z = random.unit(), y = random.unit(), x = random.unit();
  return low + Vector3d(x, y, z).cwiseProduct(high - low);
}

void count_contacts(const Motion& motion, const filtered::PreparedPolygon& polygon, Contacts& contacts) {
  const bool touches = filtered::contact(motion, polygon);
  const auto level = first_level_that_touches(motion, polygon);
  if (!touches) {
    contacts.beside += level ? 1 : 0;
    return;
  }
  ++contacts.all;
  for (std::size_t i = 0; i < contacts.missed.size(); ++i) contacts.missed[i] += !level || i < *level ? 1 : 0;
}

/// A pass, and its prepared polygon.
using Query = std::pair<Motion, filtered::PreparedPolygon>;

std::shared_ptr<const std::vector<Query>> draw_queries(const Settings& settings, std::size_t count) {
  auto queries = std::make_shared<std::vector<Query>>();
  for (std::uint64_t n = 0; queries->size() < count; ++n)
    if (const auto pass = draw_pass(settings.vertices, settings.seed, n))
      queries->emplace_back(pass->of(kRadii[queries->size() % kRadii.size()]), pass->polygon);
  return queries;
}

struct StepsRow {
  double radius;
  std::uint64_t steps, passes, contacts, missed, beside;
  program::Rate rate;
};

const program::Table<StepsRow>& steps_csv() {
  static const program::Table<StepsRow> table(
      "steps.csv", "a radius and a number of steps",
      program::all_columns<StepsRow>(
          {{{"radius", "the radius of the ball, as a share of the polygon's size", &StepsRow::radius},
            {"steps", "equal steps of a way as long as the polygon's size", &StepsRow::steps},
            {"passes", "motions, each past a polygon of its own", &StepsRow::passes},
            {"contacts", "motions that touch, by the exact sweep", &StepsRow::contacts},
            {"missed", "those of which no place between steps touches", &StepsRow::missed}},
           program::rate_columns<StepsRow>("missed contacts", &StepsRow::rate),
           {{"beside",
             "motions that do not touch, although a place on them does, once rounded to doubles; at any "
             "number of steps",
             &StepsRow::beside}}}));
  return table;
}

std::vector<StepsRow> steps_rows(const Misses& misses) {
  std::vector<StepsRow> rows;
  for (std::size_t i = 0; i < kRadii.size(); ++i)
    for (std::size_t level = 0; level <= kMostLevel; ++level) {
      const auto& [all, missed, beside] = misses.of[i];
      rows.push_back({kRadii[i], std::uint64_t{1} << level, misses.passes(), all, missed[level], beside,
                      program::rate(missed[level], all)});
    }
  return rows;
}

struct CostRow {
  const timing::Measured* measured;
  timing::Quartiles nanoseconds;
  std::optional<timing::Quartiles> ratio;
};

const program::Table<CostRow>& cost_table() {
  constexpr const char* kTime = "{:.1f}";
  constexpr const char* kRatio = "{:.3g}";
  using timing::Quartiles;
  const auto ratio = [](double Quartiles::*part) {
    return [part](const CostRow& row) { return row.ratio ? std::optional((*row.ratio).*part) : std::nullopt; };
  };
  static const program::Table<CostRow> table(
      "steps-cost.csv", "a way of asking about a motion; a measurement, which differs from run to run",
      {{"asked", "the exact sweep, or a number of steps", program::path(&CostRow::measured, &timing::Measured::name)},
       {"motions", "motions", program::path(&CostRow::measured, &timing::Measured::queries)},
       {"repetitions", "turns", [](const CostRow& row) { return row.measured->nanoseconds.size(); }},
       {"lower_quartile_ns", "a motion, over the turns", program::path(&CostRow::nanoseconds, &Quartiles::lower),
        kTime},
       {"median_ns", "the same, median", program::path(&CostRow::nanoseconds, &Quartiles::median), kTime},
       {"upper_quartile_ns", "the same, upper quartile", program::path(&CostRow::nanoseconds, &Quartiles::upper),
        kTime},
       {"lower_quartile_ratio", "to the contact by the exact sweep, turn by turn", ratio(&Quartiles::lower), kRatio},
       {"median_ratio", "the same, median", ratio(&Quartiles::median), kRatio},
       {"upper_quartile_ratio", "the same, upper quartile", ratio(&Quartiles::upper), kRatio}});
  return table;
}

}  // namespace

std::optional<Pass> draw_pass(std::size_t vertices, std::uint64_t seed, std::uint64_t n) try {
  const workloads::Workload workload{.family = workloads::all_families()[n % workloads::all_families().size()],
                                     .placement = workloads::Placement::Rotated,
                                     .vertices = vertices};
  Polygon polygon = workloads::sample(workload, seed, n).polygon;
  workloads::Random random(seed, n, kStream);
  const double extent = workloads::extent_of(polygon);
  const Vector3d through = any_point(random, polygon), half = extent / 2 * any_direction(random);
  return Pass{std::move(polygon), through - half, through + half, extent};
} catch (const std::invalid_argument&) {  // the workload found no such polygon
  return std::nullopt;
}

Ball place_of(const Motion& motion, std::size_t level, std::size_t i) {
  const double time = static_cast<double>(i) / static_cast<double>(std::size_t{1} << level);  // exact
  return {motion.ball.center + time * (motion.to - motion.ball.center), motion.ball.radius};
}

bool touches_at_steps(const Motion& motion, std::size_t level, const filtered::PreparedPolygon& polygon) {
  for (std::size_t i = 0; i <= std::size_t{1} << level; ++i)
    if (filtered::contact(place_of(motion, level, i), polygon)) return true;
  return false;
}

std::optional<std::size_t> first_level_that_touches(const Motion& motion, const filtered::PreparedPolygon& polygon) {
  // Place i of the most steps is one of 2^level steps if its last kMostLevel - level bits are 0.
  const auto asked = [&](std::size_t level, std::size_t i) { return level == 0 || i % 2 == 1; };
  for (std::size_t level = 0; level <= kMostLevel; ++level)
    for (std::size_t i = 0; i <= std::size_t{1} << level; ++i)
      if (asked(level, i) && filtered::contact(place_of(motion, level, i), polygon)) return level;
  return std::nullopt;
}

void count_misses(const Settings& settings, const program::RunControl& control, Misses& misses) {
  constexpr std::uint64_t kBlock = 8;
  program::run_sweep(
      settings.passes, settings.threads, control, Misses(), misses,
      [&](std::uint64_t n, Misses& part) {
        ++part.samples;
        const auto pass = draw_pass(settings.vertices, settings.seed, n);
        if (!pass) {
          ++part.missing;
          return;
        }
        const filtered::PreparedPolygon polygon(pass->polygon);
        for (std::size_t i = 0; i < kRadii.size(); ++i) count_contacts(pass->of(kRadii[i]), polygon, part.of[i]);
      },
      kBlock);
}

std::string steps_name(std::size_t level) {
  return std::to_string(std::size_t{1} << level) + (level == 0 ? " step" : " steps");
}

timing::Result measure_cost(const Settings& settings, std::size_t count, const std::atomic<bool>& stop,
                            const program::Progress& progress) {
  const auto queries = draw_queries(settings, count);
  const std::shared_ptr<const std::vector<bool>> unchecked;
  timing::Benchmark benchmark;
  benchmark.unit = "motion";
  benchmark.candidates = {
      timing::candidate(kContact, queries, unchecked,
                        [](const Query& query) { return filtered::contact(query.first, query.second); }),
      timing::candidate(
          kFirstContact, queries, unchecked,
          [](const Query& query) { return filtered::first_contact(query.first, query.second).contact(); },
          timing::Comparison{kContact, {}})};
  for (std::size_t level = 0; level <= kMostLevel; ++level)
    benchmark.candidates.push_back(timing::candidate(
        steps_name(level), queries, unchecked,
        [level](const Query& query) { return touches_at_steps(query.first, level, query.second); },
        timing::Comparison{kContact, {}}));
  return timing::measure("steps", benchmark, settings.repetitions, stop, progress);
}

void write_steps(const std::filesystem::path& folder, const Misses& misses) {
  steps_csv().write(folder, steps_rows(misses));
}

void write_cost(const std::filesystem::path& folder, const timing::Result& cost) {
  std::vector<CostRow> rows;
  for (const timing::Measured& m : cost.candidates)
    if (!m.nanoseconds.empty())
      rows.push_back({&m, timing::quartiles(m.nanoseconds),
                      m.ratios.empty() ? std::nullopt : std::optional(timing::quartiles(m.ratios))});
  cost_table().write(folder, rows);
}

std::vector<program::TableDescription> step_tables() { return {steps_csv().description(), cost_table().description()}; }

std::string steps_table(const Misses& misses) { return steps_csv().aligned(steps_rows(misses)); }

}  // namespace touchstone::motions
