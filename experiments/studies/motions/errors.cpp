// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/motions/errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/loops.h"
#include "experiments/methods/registry.h"
#include "experiments/run/statistics/units.h"
#include "geometry/io/detail/legible.h"
#include "robust/exact/motion.h"

namespace touchstone::motions {
namespace {

/// Returns why the method cannot answer about moving balls; empty if it can. An engine of the user may not know that
/// balls move; the ball of this question touches nothing at either end of its way, and everything in between.
std::string fault_of(const cases::Method& method) {
  const Polygon triangle({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}});
  const auto answer = method.prepare(triangle)->ask_moving({{{2, 2, 4}, 1}, {2, 2, -4}});
  if (!answer) return "cannot answer about moving balls";
  if (!method.through_pipe() || answer->contact == true) return "";
  return fmt::format(
      "{} whether a ball that moves through a triangle touches it, so it seems to ignore `motion`; "
      "near-edge and judge --at-rest ask about balls that do not move",
      answer->contact ? "is wrong about" : "does not say");
}

std::size_t kind_of(const AtThreshold& at, workloads::Way way) {
  const auto place = [](const auto& list, auto value) {
    return static_cast<std::size_t>(std::ranges::find(list, value) - list.begin());
  };
  return (place(kWays, way) * kEvents.size() + place(kEvents, at.event)) * kFeatures.size() +
         place(kFeatures, at.feature);
}

/// All questions about one sample.
class Sample {
 public:
  Sample(const AtThreshold& at, std::size_t stratum, std::uint64_t n)
      : at_(at), stratum_(stratum), n_(n), extent_(workloads::extent_of(at.polygon)) {
    const exact::PreparedPolygon exact(at.polygon);
    for (const double share : all_offsets()) {
      motions_.push_back(at.moved(share));
      truths_.push_back(motions_.back() ? exact::first_contact(*motions_.back(), exact) : FirstContact{});
    }
  }

  /// Returns the balls for which `exact` says anything else than the threshold does.
  [[nodiscard]] std::uint64_t disagreements() const {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < motions_.size(); ++i)
      if (motions_[i] && truths_[i].contact() != (motions_[i]->ball.radius >= at_.motion.ball.radius)) ++count;
    return count;
  }

  void ask(const cases::Method& method, MethodErrors& errors) const {
    const auto prepared = method.prepare(at_.polygon);
    bool failed = false, decided = false;
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      if (!motions_[i]) continue;
      const auto answer = prepared->ask_moving(*motions_[i]).value();
      Tally& tally = errors.offsets[i];
      ++tally.trials;
      decided |= answer.contact.has_value();
      if (!answer.contact) {
        ++tally.unsure;
      } else if (*answer.contact != truths_[i].contact()) {
        ++(*answer.contact ? tally.invented : tally.missed);
        errors.furthest += {std::abs(all_offsets()[i]), n_, stratum_, i, true};
        failed = true;
      } else if (*answer.contact) {
        add_time(answer, *motions_[i], truths_[i], errors.times);
      }
    }
    errors.samples += decided ? 1 : 0;
    errors.failed += failed ? 1 : 0;
  }

 private:
  void add_time(const cases::PartialAnswer& answer, const Motion& motion, const FirstContact& truth,
                TimeErrors& times) const {
    ++times.found;
    if (!answer.time) return;
    if (truth.kind == FirstContactKind::Way) times.ulps.add(statistics::number_error(*answer.time, truth.time));
    const double way = (motion.to - motion.ball.center).norm();
    times.ways.add(std::abs(*answer.time - truth.time) * way / extent_);
  }

  const AtThreshold& at_;
  std::size_t stratum_;
  std::uint64_t n_;
  double extent_;
  std::vector<std::optional<Motion>> motions_;  // by offset
  std::vector<FirstContact> truths_;
};

/// Sample n of every stratum.
void ask_all(const Settings& settings, std::uint64_t n, Errors& part) {
  for (std::size_t stratum = 0; stratum < all_strata().size(); ++stratum) {
    const auto at = draw_at_threshold(stratum, settings.vertices, settings.seed, n);
    if (!at) {
      ++part.missing;
      continue;
    }
    const Sample sample(*at, stratum, n);
    part.disagreements += sample.disagreements();
    auto& by_method = part.at[kind_of(*at, all_strata()[stratum].way)];
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      if (!settings.methods[m]->slow() || n % kSlowStride == 0) sample.ask(*settings.methods[m], by_method[m]);
  }
  ++part.samples;
}

}  // namespace

std::vector<const cases::Method*> find_moving_methods(const methods::Selection& selection) {
  const bool all = std::ranges::find(selection.names, "all") != selection.names.end();
  const auto left_out = methods::find_methods(all ? std::vector<std::string>{"all"} : std::vector<std::string>{});
  std::vector<const cases::Method*> found;
  for (const cases::Method* method : selection.methods()) {
    const std::string fault = fault_of(*method);
    if (fault.empty())
      found.push_back(method);
    else if (std::ranges::find(left_out, method) == left_out.end())
      throw std::invalid_argument("the method \"" + io::legible(method->name()) + "\" " + fault);
  }
  return found;
}

const std::vector<double>& all_offsets() {
  static const std::vector<double> offsets = [] {
    std::vector<double> list{0};
    for (int exponent = -52; exponent <= -4; exponent += 4)
      for (const double side : {-1.0, 1.0}) list.push_back(side * std::ldexp(1.0, exponent));
    std::ranges::sort(list);
    return list;
  }();
  return offsets;
}

Furthest& Furthest::operator+=(const Furthest& other) {
  const auto rank = [](const Furthest& f) { return std::tuple(!f.any, -f.share, f.n, f.stratum, f.offset); };
  if (rank(other) < rank(*this)) *this = other;
  return *this;
}

Tally MethodErrors::all() const {
  Tally sum;
  for (const Tally& tally : offsets) run::add(sum, tally);
  return sum;
}

const std::vector<Kind>& all_kinds() {
  static const std::vector<Kind> kinds = [] {
    std::vector<Kind> list;
    for (std::size_t way = 0; way < kWays.size(); ++way)
      for (std::size_t event = 0; event < kEvents.size(); ++event)
        for (std::size_t feature = 0; feature < kFeatures.size(); ++feature) list.push_back({way, event, feature});
    return list;
  }();
  return kinds;
}

Errors no_errors(const Settings& settings) {
  return {.at = {all_kinds().size(), std::vector<MethodErrors>(settings.methods.size())}};
}

void measure_errors(const Settings& settings, const run::RunControl<Errors>& control, Errors& errors) {
  run::run_sweep(settings.samples, settings.threads, control, no_errors(settings), errors,
                 [&](std::uint64_t n, Errors& part) { ask_all(settings, n, part); });
}

}  // namespace touchstone::motions
