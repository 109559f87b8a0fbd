// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/motions/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/methods/registry.h"
#include "experiments/program/statistics/errors.h"
#include "geometry/io/detail/legible.h"
#include "robust/exact/motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::motions {
namespace {

using workloads::BallPlace;
using workloads::Placement;

Event event_of(const Motion& motion, const filtered::PreparedPolygon& polygon) {
  if (filtered::contact(motion.ball, polygon)) return Event::Start;
  return filtered::contact(Ball{motion.to, motion.ball.radius}, polygon) ? Event::End : Event::Graze;
}

/// Scales a sample by a power of two, which is exact.
void scale(workloads::Sample& sample) {
  const int exponent = -std::ilogb(workloads::extent_of(sample.polygon));
  const auto scaled = [exponent](const Eigen::Vector3d& v) -> Eigen::Vector3d { return std::ldexp(1.0, exponent) * v; };
  auto loops = workloads::loops_of(sample.polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) vertex = scaled(vertex);
  sample.polygon = workloads::polygon_of(loops);
  sample.ball = {scaled(sample.ball.center), std::ldexp(sample.ball.radius, exponent)};
  sample.to = scaled(*sample.to);
}

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
      cases::PartialAnswer truth;
      truth.contact = truths_[i].contact();
      const auto outcome = compare(cases::Test::Contact, answer, truth, true);
      errors.offsets[i].add(outcome);
      if (!outcome) continue;
      decided = true;
      if (*outcome != cases::Outcome::Right) {
        errors.furthest += {std::abs(all_offsets()[i]), n_, stratum_, i, true};
        failed = true;
      } else if (*answer.contact) {
        add_time(answer, *motions_[i], truths_[i], errors.times);
      }
    }
    if (decided) errors.samples.add_sample(failed);
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
    auto& by_method = part.at[{all_strata()[stratum].way, at->event, at->feature}];
    by_method.resize(settings.methods.size());
    for (std::size_t m = 0; m < settings.methods.size(); ++m)
      if (!settings.methods[m]->slow() || n % kSlowStride == 0) sample.ask(*settings.methods[m], by_method[m]);
  }
  ++part.samples;
}

bool is_picture(const AtThreshold& at, double time) {
  return at.event == Event::Graze && at.feature == Feature::Kind::Edge && time > 0.4 && time < 0.6;
}

}  // namespace

std::string_view to_string(Event event) {
  switch (event) {
    case Event::Start: return "start";
    case Event::Graze: return "graze";
    case Event::End: break;
  }
  return "end";
}

std::optional<Motion> AtThreshold::moved(double share) const {
  const double radius = motion.ball.radius + share * workloads::extent_of(polygon);
  if (radius < 0 || (share != 0 && radius == motion.ball.radius)) return std::nullopt;
  return workloads::with_radius(motion, radius);
}

std::optional<AtThreshold> find_threshold(Polygon polygon, const Motion& motion) {
  const filtered::PreparedPolygon prepared(polygon);
  const double radius = workloads::grazing_radius(
      motion, [&prepared](const Motion& asked) { return filtered::contact(asked, prepared); });
  if (radius == 0) return std::nullopt;
  const Motion at = workloads::with_radius(motion, radius);
  const Event event = event_of(at, prepared);
  return AtThreshold{std::move(polygon), at, event, filtered::first_contact(at, prepared).feature.kind};
}

const std::vector<Stratum>& all_strata() {
  static const std::vector<Stratum> strata = [] {
    std::vector<Stratum> list;
    for (const auto way : kWays)
      for (const auto placement : {Placement::LatticeFrame, Placement::Rotated})
        for (const auto place :
             {BallPlace::NearFace, BallPlace::NearEdge, BallPlace::NearVertex, BallPlace::LatticeTangent})
          if (place != BallPlace::LatticeTangent || placement == Placement::LatticeFrame)
            list.push_back({way, place, placement});
    return list;
  }();
  return strata;
}

std::optional<AtThreshold> draw_at_threshold(std::size_t stratum, std::size_t vertices, std::uint64_t seed,
                                             std::uint64_t n) {
  const auto& [way, place, placement] = all_strata()[stratum];
  workloads::Workload workload;
  workload.family = workloads::all_families()[n % workloads::all_families().size()];
  workload.placement = placement;
  workload.ball = place;
  workload.vertices = vertices;
  workload.way = way;
  try {
    auto sample = workloads::sample(workload, seed, n * all_strata().size() + stratum);
    scale(sample);
    return find_threshold(std::move(sample.polygon), {sample.ball, *sample.to});
  } catch (const std::invalid_argument&) {  // the workload found no such polygon or ball
    return std::nullopt;
  }
}

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

void measure_errors(const Settings& settings, const program::RunControl& control, Errors& errors) {
  program::run_sweep(settings.samples, settings.threads, control, Errors(), errors,
                     [&](std::uint64_t n, Errors& part) { ask_all(settings, n, part); });
}

Eigen::Vector2d GrazingPass::seen(const Eigen::Vector3d& point) const {
  const Motion& motion = at.motion;
  const Eigen::Vector3d along = (motion.to - motion.ball.center).normalized();
  const Eigen::Vector3d center = motion.ball.center + first.time * (motion.to - motion.ball.center);
  const Eigen::Vector3d away = center - first.point;
  const Eigen::Vector3d up = (away - away.dot(along) * along).normalized();
  const Eigen::Vector3d from = (point - first.point) / extent;
  return {from.dot(along), from.dot(up)};
}

std::optional<GrazingPass> find_grazing_pass(std::size_t vertices, std::uint64_t seed) {
  const auto stratum =
      static_cast<std::size_t>(std::ranges::find_if(all_strata(),
                                                    [](const Stratum& s) {
                                                      return s.way == workloads::Way::Across &&
                                                             s.place == workloads::BallPlace::NearEdge &&
                                                             s.placement == workloads::Placement::Rotated;
                                                    }) -
                               all_strata().begin());
  constexpr std::uint64_t kMost = 1000;
  for (std::uint64_t n = 0; n < kMost; ++n) {
    auto at = draw_at_threshold(stratum, vertices, seed, n);
    if (!at) continue;
    const FirstContact first = exact::first_contact(at->motion, at->polygon);
    const double extent = workloads::extent_of(at->polygon), radius = at->motion.ball.radius / extent;
    if (is_picture(*at, first.time) && radius > 0.05 && radius < 0.5) return GrazingPass{std::move(*at), first, extent};
  }
  return std::nullopt;
}

std::vector<Said> ask_about(const GrazingPass& pass, const std::vector<const cases::Method*>& methods) {
  std::vector<double> offsets{0};
  for (int exponent = -53; exponent <= -4; ++exponent)
    for (const double side : {-1.0, 1.0}) offsets.push_back(side * std::ldexp(1.0, exponent));
  std::ranges::sort(offsets);

  const exact::PreparedPolygon exact(pass.at.polygon);
  std::vector<Said> all;
  for (const auto* method : methods) {
    const auto prepared = method->prepare(pass.at.polygon);
    for (const double offset : offsets) {
      const auto motion = pass.at.moved(offset);
      if (!motion) continue;
      const FirstContact truth = exact::first_contact(*motion, exact);
      const auto answer = prepared->ask_moving(*motion).value();
      Said said{method->name(), offset, truth.contact(), answer.contact, {}};
      if (truth.contact() && answer.contact == true && answer.time)
        said.time_error = std::abs(*answer.time - truth.time) * (motion->to - motion->ball.center).norm() / pass.extent;
      all.push_back(said);
    }
  }
  return all;
}

}  // namespace touchstone::motions
