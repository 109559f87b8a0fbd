// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "experiments/cases/comparison.h"
#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"

namespace touchstone::stability {
namespace {

using workloads::move_by_doubles;

struct Radius {
  double value;
  Nearness nearness;
};

std::vector<Radius> radii_about(double distance, bool few) {
  std::vector<Radius> radii{{distance, Nearness::OneDouble}};
  const auto add = [&](double radius, Nearness nearness) {
    if (radius >= 0 && radius <= std::numeric_limits<double>::max()) radii.push_back({radius, nearness});
  };
  add(distance * (1 + 0x1p-30), Nearness::Close);
  add(distance * 1.25, Nearness::Ample);
  if (few) return radii;
  add(move_by_doubles(distance, -1), Nearness::OneDouble);
  add(move_by_doubles(distance, 1), Nearness::OneDouble);
  add(distance * (1 - 0x1p-30), Nearness::Close);
  add(distance * 0.75, Nearness::Ample);
  return radii;
}

std::vector<Test> tests_of(Nearness nearness, const Answer& truth) {
  if (nearness == Nearness::Ample) return {Test::Plane, Test::Edges, Test::Contact, Test::Relation};
  const bool face = truth.nearest.kind == Feature::Kind::Face;
  return {face ? Test::Plane : Test::Edges, Test::Contact, Test::Relation};
}

}  // namespace

Oracle::Oracle(const Polygon& polygon) : exact_(polygon) {
  if (polygon.vertex_count() > kMostForExact) filtered_.emplace(polygon);
}

Answer Oracle::answer(const Ball& ball) const {
  return filtered_ ? filtered::answer(ball, *filtered_) : exact::answer(ball, exact_);
}

bool Oracle::confirms(const Ball& ball) const { return !filtered_ || answer(ball) == exact::answer(ball, exact_); }

std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle) {
  const Placed& meant = scene.meant ? *scene.meant : scene.asked;
  const bool few = oracle.spares_exact();
  std::vector<Probe> probes;
  std::vector<bool> foot_seen(kNearnesses.size());
  for (std::size_t i = 0; i < meant.placements.size(); ++i) {
    const BallPlacement& placement = meant.placements[i];
    const Eigen::Vector3d& asked_center = scene.asked.placements[i].center;
    const auto add = [&](double radius, Nearness nearness, std::vector<Test> tests, const Answer& truth, bool measured,
                         bool bounded) {
      probes.push_back(
          {{asked_center, radius}, cases::PartialAnswer::of(truth, ""), nearness, std::move(tests), measured, bounded});
    };
    if (placement.site == BallPlacement::Site::Foot) {
      const auto place = static_cast<std::size_t>(placement.nearness);
      if (few && foot_seen[place]) continue;
      const bool first = !foot_seen[place] && placement.nearness == Nearness::OneDouble;
      foot_seen[place] = true;
      add(placement.radius, placement.nearness, {Test::Foot}, oracle.answer({placement.center, placement.radius}),
          false, first);
      continue;
    }
    const double distance = oracle.answer({placement.center, 0}).distance;
    if (!(distance > 0 && distance <= std::numeric_limits<double>::max())) continue;
    for (const auto& [radius, nearness] : radii_about(distance, few)) {
      const Answer truth = oracle.answer({placement.center, radius});
      const bool measured = nearness == Nearness::Ample && radius > distance;
      add(radius, nearness, tests_of(nearness, truth), truth, measured, radius == distance);
    }
  }
  return probes;
}

namespace {

using cases::PartialAnswer;
using cases::QueryKind;

/// A method with a polygon; it prepares and answers in the scene's mode. What it throws is no answer.
class Asked {
 public:
  Asked(const cases::Method& method, const Scene& scene) : mode_(scene.mode) {
    try {
      const Environment environment(mode_);
      prepared_ = method.prepare(scene.asked.polygon);
    } catch (const std::exception&) {
    }
  }

  [[nodiscard]] std::optional<PartialAnswer> ask(const Ball& ball, QueryKind kind) const {
    if (!prepared_) return std::nullopt;
    try {
      const Environment environment(mode_);
      return prepared_->ask(ball, kind);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

 private:
  FloatingPointMode mode_;
  std::unique_ptr<cases::PreparedMethod> prepared_;
};

double distance_error(double found, double truth) {
  if (!std::isfinite(found)) return INFINITY;
  return static_cast<double>(std::abs(static_cast<long double>(found) - truth) / truth);
}

/// Returns nothing if the exact point is the origin.
std::optional<double> point_error(const Eigen::Vector3d& found, const Eigen::Vector3d& truth) {
  const double largest = truth.cwiseAbs().maxCoeff();
  if (largest == 0) return std::nullopt;
  if (!found.allFinite()) return INFINITY;
  long double difference = 0;
  for (int k = 0; k < 3; ++k)
    difference = std::max(difference, std::abs(static_cast<long double>(found[k]) - truth[k]));
  return static_cast<double>(difference / largest);
}

class Study {
 public:
  explicit Study(const Settings& settings) : settings_(settings) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  [[nodiscard]] Block block(std::uint64_t number) const {
    const std::uint64_t sample = number / settings_.axes.size();
    const Axis axis = settings_.axes[number % settings_.axes.size()];
    Block block;
    block.number = number;
    block.axis = axis;
    block.sample = sample;
    for (std::size_t level = 0; level < levels(axis).size(); ++level) {
      if (!is_drawn(axis, level, sample)) continue;
      if (const auto scene = draw_scene(axis, level, settings_.seed, sample))
        ask_all(*scene, level, block);
      else
        ++block.missing;
    }
    return block;
  }

 private:
  using Key = std::tuple<Test, Nearness>;

  void ask_all(const Scene& scene, std::size_t level, Block& block) const {
    const Oracle oracle(scene.meant ? scene.meant->polygon : scene.asked.polygon);
    const std::vector<Probe> probes = probes_of(scene, oracle);
    std::vector<bool> to_confirm(probes.size());
    if (!probes.empty()) to_confirm[0] = true;
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) ask(scene, probes, level, m, block, to_confirm);
    if (oracle.spares_exact()) confirm(oracle, probes, to_confirm, block);
    if (bounds_number(block.axis, level, block.sample)) observe_bounds(scene, probes, level, block);
  }

  void ask(const Scene& scene, const std::vector<Probe>& probes, std::size_t level, std::size_t m, Block& block,
           std::vector<bool>& failed) const {
    const Asked asked(*settings_.methods[m], scene);
    std::map<Key, TestResult> results;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const Probe& probe = probes[i];
      bool wrong_somewhere = false;
      for (const Test test : probe.tests) {
        const auto answer = asked.ask(probe.ball, query_kind(test));
        const auto outcome = answer ? compare(test, *answer, probe.truth, knows_boundary_[m]) : std::nullopt;
        if (answer && !outcome) continue;  // the method has no such test
        auto& result =
            results.try_emplace({test, probe.nearness}, TestResult{level, m, test, probe.nearness, 0, 0}).first->second;
        const bool wrong = outcome != cases::Outcome::Right;
        result.wrong += wrong ? 1 : 0;
        ++result.asked;
        wrong_somewhere = wrong_somewhere || wrong;
      }
      failed[i] = failed[i] || wrong_somewhere;
      const bool off = probe.measured && measure(scene, asked, probe, level, m, block);
      if (wrong_somewhere || off) keep_worst(scene, asked, probe, level, m, block);
    }
    for (const auto& [key, result] : results) block.tests.push_back(result);
  }

  /// Adds the errors of distance and point; returns whether the distance is off.
  bool measure(const Scene& scene, const Asked& asked, const Probe& probe, std::size_t level, std::size_t m,
               Block& block) const {
    const auto answer = asked.ask(probe.ball, QueryKind::Answer);
    bool off = false;
    if (answer && answer->distance) {
      const double error = distance_error(*answer->distance, *probe.truth.distance);
      off = error > 0;
      block.errors.push_back({level, m, Quantity::Distance, error});
    }
    if (answer && answer->point && !scene.meant)
      if (const auto error = point_error(*answer->point, *probe.truth.point))
        block.errors.push_back({level, m, Quantity::Point, *error});
    return off;
  }

  /// A case says neither what was meant nor in which mode it is asked.
  void keep_worst(const Scene& scene, const Asked& asked, const Probe& probe, std::size_t level, std::size_t method,
                  Block& block) const {
    if (scene.meant || !scene.mode.usual() || scene.asked.polygon.vertex_count() > kMostForCases) return;
    const auto answer = asked.ask(probe.ball, QueryKind::Answer);
    if (!answer) return;
    WorstCase worst{level, method, 0, 0, block.number, {}};
    if (answer->contact && *answer->contact != *probe.truth.contact) worst.rank = 1 + static_cast<int>(probe.nearness);
    if (answer->distance && *probe.truth.distance > 0)
      worst.error = distance_error(*answer->distance, *probe.truth.distance);
    const auto held = std::find_if(block.worst.begin(), block.worst.end(),
                                   [&](const WorstCase& other) { return other.method == method; });
    if (held != block.worst.end() && !worst.worse_than(*held)) return;
    const std::vector<cases::Key> wrong = cases::differing_keys(probe.truth, *answer);
    if (wrong.empty()) return;
    const std::string_view name = settings_.methods[method]->name();
    worst.line = cases::case_line(fmt::format("{}-{}", scene.id, name), cases::Shapes{probe.ball, scene.asked.polygon},
                                  {std::string(name), std::string(to_string(probe.nearness)),
                                   worst.rank > 0 ? "wrong final answer" : "right final answer"},
                                  only(probe.truth, wrong));
    if (held != block.worst.end())
      *held = std::move(worst);
    else
      block.worst.push_back(std::move(worst));
  }

  static void confirm(const Oracle& oracle, const std::vector<Probe>& probes, const std::vector<bool>& chosen,
                      Block& block) {
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (!chosen[i]) continue;
      ++(oracle.confirms(probes[i].ball) ? block.confirmed : block.disputed);
    }
  }

  /// For each ball at the boundary, the nearest edge and one other.
  void observe_bounds(const Scene& scene, const std::vector<Probe>& probes, std::size_t level, Block& block) const {
    const std::size_t count = scene.asked.polygon.vertex_count();
    if (scene.meant || count > kMostForBounds) return;
    const BoundTrial trial(scene.asked.polygon);
    workloads::Random random(settings_.seed, block.sample, std::uint64_t{1} << 50);
    std::vector<Observation> observations;
    for (const Probe& probe : probes) {
      if (!probe.bounded) continue;
      const auto other = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(count) - 1));
      for (const std::size_t edge : {probe.truth.nearest->index, other})
        trial.observe(probe.ball, edge, scene.mode, settings_.bound_factor, observations);
    }
    for (const Observation& observation : observations) block.bounds.push_back({level, observation});
  }

  const Settings& settings_;
  std::vector<bool> knows_boundary_;
};

}  // namespace

std::string_view to_string(Quantity quantity) { return quantity == Quantity::Distance ? "distance" : "point"; }

std::uint64_t block_count(const Settings& settings) { return settings.samples * settings.axes.size(); }

Block ask_block(const Settings& settings, std::uint64_t number) { return Study(settings).block(number); }

std::optional<std::uint64_t> bounds_number(Axis axis, std::size_t level, std::uint64_t sample) {
  const std::uint64_t drawn = sample / levels(axis)[level].one_in, row = drawn / kBoundsOneIn;
  if (row % kBoundsOneIn != 0) return std::nullopt;
  return row / kBoundsOneIn * kBoundsOneIn + drawn % kBoundsOneIn;
}

}  // namespace touchstone::stability
