// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"

namespace touchstone::stability {
namespace {

using cases::PartialAnswer;
using cases::QueryKind;
using workloads::move_by_doubles;

/// Sets the mode during its lifetime, then restores the previous one.
class Environment {
 public:
  explicit Environment(const FloatingPointMode& mode) {
    std::fegetenv(&found_);
    std::fesetround(mode.rounding);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | mode.flush);
#endif
  }
  ~Environment() { std::fesetenv(&found_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::fenv_t found_;
};

/// The truth about one polygon: `exact`, or for more vertices than kMostForExact `filtered`.
class Oracle {
 public:
  explicit Oracle(const Polygon& polygon) : exact_(polygon) {
    if (polygon.vertex_count() > kMostForExact) filtered_.emplace(polygon);
  }

  [[nodiscard]] Answer answer(const Ball& ball) const {
    return filtered_ ? filtered::answer(ball, *filtered_) : exact::answer(ball, exact_);
  }
  /// Returns whether `exact` is asked less often than the truth is needed.
  [[nodiscard]] bool spares_exact() const { return filtered_.has_value(); }
  /// Returns whether `exact` gives the same answer.
  [[nodiscard]] bool confirms(const Ball& ball) const { return answer(ball) == exact::answer(ball, exact_); }

 private:
  exact::PreparedPolygon exact_;
  std::optional<filtered::PreparedPolygon> filtered_;
};

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

/// A ball, the tests to ask about it, and the truth.
struct Probe {
  Ball ball;
  PartialAnswer truth;
  Nearness nearness;
  std::vector<Test> tests;
  bool measured;  ///< whether distance and point are compared with the truth
};

/// For each placement, one radius or several; none at distance 0. If the oracle spares `exact`, one of each nearness.
std::vector<Probe> probes_of(const Scene& scene, const Oracle& oracle) {
  const std::vector<BallPlacement>& placements = (scene.meant ? *scene.meant : scene.asked).placements;
  const bool few = oracle.spares_exact();
  std::vector<Probe> probes;
  std::array<bool, kNearnesses.size()> foot_seen{};
  for (std::size_t i = 0; i < placements.size(); ++i) {
    const BallPlacement& placement = placements[i];
    const auto add = [&](double radius, Nearness nearness, std::vector<Test> tests, const Answer& truth,
                         bool measured) {
      const Ball ball{scene.asked.placements[i].center, radius};
      probes.push_back({ball, PartialAnswer::of(truth, ""), nearness, std::move(tests), measured});
    };
    if (placement.site == BallPlacement::Site::Foot) {
      bool& seen = foot_seen[static_cast<std::size_t>(placement.nearness)];
      if (!few || !seen)
        add(placement.radius, placement.nearness, {Test::Foot}, oracle.answer({placement.center, placement.radius}),
            false);
      seen = true;
      continue;
    }
    const double distance = oracle.answer({placement.center, 0}).distance;
    if (!(distance > 0 && distance <= std::numeric_limits<double>::max())) continue;
    for (const auto& [radius, nearness] : radii_about(distance, few)) {
      const Answer truth = oracle.answer({placement.center, radius});
      add(radius, nearness, tests_of(nearness, truth), truth, nearness == Nearness::Ample && radius > distance);
    }
  }
  return probes;
}

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

/// A polygon that methods are asked about, and its place in the sum.
struct Asking {
  Axis axis;
  std::size_t level;
  std::uint64_t block;
  const Scene& scene;
  std::vector<Probe> probes;
};

class Study {
 public:
  explicit Study(const Settings& settings) : settings_(settings) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  void ask_block(std::uint64_t block, Summary& sum) const {
    const std::uint64_t sample = block / settings_.axes.size();
    const Axis axis = settings_.axes[block % settings_.axes.size()];
    for (std::size_t level = 0; level < levels(axis).size(); ++level) {
      if (!is_drawn(axis, level, sample)) continue;
      const auto scene = draw_scene(axis, level, settings_.seed, sample);
      if (!scene) {
        ++sum.missing;
        continue;
      }
      const Oracle oracle(scene->meant ? scene->meant->polygon : scene->asked.polygon);
      ask_all({axis, level, block, *scene, probes_of(*scene, oracle)}, oracle, sum);
    }
    ++sum.blocks;
  }

 private:
  void ask_all(const Asking& at, const Oracle& oracle, Summary& sum) const {
    std::vector<bool> to_confirm(at.probes.size());
    if (!at.probes.empty()) to_confirm[0] = true;
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) ask(at, m, to_confirm, sum);
    if (!oracle.spares_exact()) return;
    for (std::size_t i = 0; i < at.probes.size(); ++i)
      if (to_confirm[i]) ++(oracle.confirms(at.probes[i].ball) ? sum.confirmed : sum.disputed);
  }

  void ask(const Asking& at, std::size_t m, std::vector<bool>& failed, Summary& sum) const {
    const Asked asked(*settings_.methods[m], at.scene);
    std::map<std::pair<Test, Nearness>, cases::Failures> found;
    for (std::size_t i = 0; i < at.probes.size(); ++i) {
      const Probe& probe = at.probes[i];
      bool wrong_somewhere = false;
      for (const Test test : probe.tests) {
        const auto answer = asked.ask(probe.ball, query_kind(test));
        const auto outcome = answer ? compare(test, *answer, probe.truth, knows_boundary_[m]) : std::nullopt;
        if (answer && !outcome) continue;  // the method has no such test
        const bool wrong = outcome != cases::Outcome::Right;
        found[{test, probe.nearness}].add_sample(wrong);
        wrong_somewhere = wrong_somewhere || wrong;
      }
      failed[i] = failed[i] || wrong_somewhere;
      const bool off = probe.measured && measure(at, asked, probe, m, sum);
      if (wrong_somewhere || off) keep_worst(at, asked, probe, m, sum);
    }
    for (const auto& [key, answers] : found) {
      SampledFailures& cell = sum.failures[{at.axis, key.second, key.first, m, at.level}];
      cell.samples.add_sample(answers.wrong > 0);
      program::add(cell.answers, answers);
    }
  }

  /// Adds the errors of distance and point; returns whether the distance is off.
  static bool measure(const Asking& at, const Asked& asked, const Probe& probe, std::size_t m, Summary& sum) {
    const auto answer = asked.ask(probe.ball, QueryKind::Answer);
    bool off = false;
    if (answer && answer->distance) {
      const double error = distance_error(*answer->distance, *probe.truth.distance);
      off = error > 0;
      sum.errors[{at.axis, Quantity::Distance, m, at.level}].add(error);
    }
    if (answer && answer->point && !at.scene.meant)
      if (const auto error = point_error(*answer->point, *probe.truth.point))
        sum.errors[{at.axis, Quantity::Point, m, at.level}].add(*error);
    return off;
  }

  /// A case says neither what was meant nor in which mode it is asked.
  void keep_worst(const Asking& at, const Asked& asked, const Probe& probe, std::size_t m, Summary& sum) const {
    const Polygon& polygon = at.scene.asked.polygon;
    if (at.scene.meant || !at.scene.mode.usual() || polygon.vertex_count() > kMostForCases) return;
    const auto answer = asked.ask(probe.ball, QueryKind::Answer);
    if (!answer) return;
    WorstCase worst{0, 0, at.block, {}};
    if (answer->contact && *answer->contact != *probe.truth.contact) worst.rank = 1 + static_cast<int>(probe.nearness);
    if (answer->distance && *probe.truth.distance > 0)
      worst.error = distance_error(*answer->distance, *probe.truth.distance);
    const auto held = sum.worst.find({at.axis, m});
    if (held != sum.worst.end() && !worst.worse_than(held->second)) return;
    const std::vector<cases::Key> wrong = cases::differing_keys(probe.truth, *answer);
    if (wrong.empty()) return;
    const std::string_view name = settings_.methods[m]->name();
    worst.line = cases::case_line(fmt::format("{}-{}", at.scene.id, name), cases::Shapes{probe.ball, polygon},
                                  {std::string(name), std::string(to_string(probe.nearness)),
                                   worst.rank > 0 ? "wrong final answer" : "right final answer"},
                                  only(probe.truth, wrong));
    sum.worst[{at.axis, m}] = std::move(worst);
  }

  const Settings& settings_;
  std::vector<bool> knows_boundary_;
};

}  // namespace

std::string_view to_string(Quantity quantity) { return quantity == Quantity::Distance ? "distance" : "point"; }

const SampledFailures* Summary::at(Axis axis, Nearness nearness, Test test, std::size_t method,
                                   std::size_t level) const {
  const auto found = failures.find({axis, nearness, test, method, level});
  return found == failures.end() ? nullptr : &found->second;
}

std::optional<std::size_t> Summary::first_failure(Axis axis, Nearness nearness, Test test, std::size_t method) const {
  for (std::size_t level = 0; level < levels(axis).size(); ++level)
    if (const SampledFailures* found = at(axis, nearness, test, method, level); found && found->samples.wrong > 0)
      return level;
  return std::nullopt;
}

std::uint64_t block_count(const Settings& settings) { return settings.samples * settings.axes.size(); }

void run_study(const Settings& settings, const program::RunControl& control, Summary& summary) {
  const Study study(settings);
  program::run_sweep(block_count(settings), settings.threads, control, Summary(), summary,
                     [&](std::uint64_t block, Summary& sum) { study.ask_block(block, sum); });
}

}  // namespace touchstone::stability
