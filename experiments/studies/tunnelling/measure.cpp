// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tunnelling/measure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"
#include "robust/filtered/motion.h"

namespace touchstone::tunnelling {
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

void count(const Motion& motion, const filtered::PreparedPolygon& polygon, Contacts& contacts) {
  const bool touches = filtered::contact(motion, polygon);
  const auto level = first_level_that_touches(motion, polygon);
  if (!touches) {
    contacts.beside += level ? 1 : 0;
    return;
  }
  ++contacts.all;
  for (std::size_t i = 0; i < contacts.missed.size(); ++i) contacts.missed[i] += !level || i < *level ? 1 : 0;
}

struct Query {
  Motion motion;
  std::size_t polygon;
};

/// The passes and their prepared polygons.
struct Queries {
  std::vector<Query> list;
  std::vector<filtered::PreparedPolygon> polygons;
};

std::shared_ptr<const Queries> draw_queries(const CostSettings& settings) {
  Queries queries;
  for (std::uint64_t n = 0; queries.list.size() < settings.passes; ++n) {
    const auto pass = draw_pass(settings.vertices, settings.seed, n);
    if (!pass) continue;
    queries.list.push_back({pass->of(kRadii[queries.list.size() % kRadii.size()]), queries.polygons.size()});
    queries.polygons.emplace_back(pass->polygon);
  }
  return std::make_shared<const Queries>(std::move(queries));
}

/// `ask(motion, polygon)` returns whether the ball touches.
template <class Ask>
timing::Candidate candidate(std::string name, const std::shared_ptr<const Queries>& queries, Ask ask,
                            std::optional<timing::Comparison> comparison) {
  const auto count_contacts = [queries, ask](std::size_t count) {
    std::uint64_t contacts = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [motion, polygon] = queries->list[i];
      contacts += ask(motion, queries->polygons[polygon]) ? 1 : 0;
    }
    return contacts;
  };
  return {std::move(name), queries->list.size(), count_contacts, {}, {}, std::move(comparison)};
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
  program::run_sweep(
      settings.samples, settings.threads, control, Misses(), misses,
      [&](std::uint64_t n, Misses& part) {
        ++part.samples;
        const auto pass = draw_pass(settings.vertices, settings.seed, n);
        if (!pass) {
          ++part.missing;
          return;
        }
        const filtered::PreparedPolygon polygon(pass->polygon);
        for (std::size_t i = 0; i < kRadii.size(); ++i) count(pass->of(kRadii[i]), polygon, part.of[i]);
      },
      8);
}

std::string steps_name(std::size_t level) {
  return std::to_string(std::size_t{1} << level) + (level == 0 ? " step" : " steps");
}

timing::Result measure_cost(const CostSettings& settings, const std::atomic<bool>& stop,
                            const program::Progress& progress) {
  const auto queries = draw_queries(settings);
  const timing::Comparison to_contact{kContact, {}};
  timing::Benchmark benchmark;
  benchmark.unit = "motion";
  benchmark.candidates = {
      candidate(
          kContact, queries,
          [](const Motion& motion, const filtered::PreparedPolygon& p) { return filtered::contact(motion, p); },
          std::nullopt),
      candidate(
          kFirstContact, queries,
          [](const Motion& motion, const filtered::PreparedPolygon& p) {
            return filtered::first_contact(motion, p).contact();
          },
          to_contact)};
  for (std::size_t level = 0; level <= kMostLevel; ++level)
    benchmark.candidates.push_back(candidate(
        steps_name(level), queries,
        [level](const Motion& motion, const filtered::PreparedPolygon& p) {
          return touches_at_steps(motion, level, p);
        },
        to_contact));
  return timing::measure("tunnelling", benchmark, settings.repetitions, stop, progress);
}

}  // namespace touchstone::tunnelling
