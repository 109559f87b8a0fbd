// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/thesis/cell/simulation/moving_parts.h"
#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 2e-4;  // of the arm's reach
constexpr double kShare = 0.1;       // of a distance, between stops

std::size_t index(Mover mover) { return static_cast<std::size_t>(mover); }

struct Element {
  std::string name;
  TriangleTree triangles;           ///< of material in its own frame
  std::optional<StationSlot> slot;  ///< of material

  [[nodiscard]] bool is_there(const MaterialTransfer& state) const { return !slot || slot == state.slot; }
  /// Returns a pose in the cell as it is in the frame of the triangles.
  [[nodiscard]] Pose seen(const Pose& pose, const MaterialTransfer& state) const {
    return slot ? within(inverse(state.lies->pose), pose) : pose;
  }
  /// Returns a height that no point is above.
  [[nodiscard]] double top(const MaterialTransfer& state) const {
    const touchstone::Box box = triangles.whole();
    if (!slot) return box.high.z();
    const Eigen::Vector3d half = (box.high - box.low) / 2;
    return (state.lies->pose * (box.low + half)).z() + (state.lies->pose.rotation.cwiseAbs() * half).z();
  }
};

/// What is known of a stretch: at each stop the arm's links and lower bounds by part and element, and the way to the
/// next stop.
struct Measured {
  Stretch stretch;
  std::vector<std::vector<double>> lower;
  std::vector<std::vector<Pose>> links;
  std::vector<WayBetween> ways;
};

/// The least distance of a mover from an element, and where.
struct Best {
  DistanceBounds bounds{kInfinity, kInfinity};
  std::size_t part = 0, stop = 0;
  double degrees = 0;
};

class Measurement {
 public:
  Measurement(const Workcell& workcell, const Process& process)
      : cell_(workcell),
        arm_(workcell.arm()),
        process_(process),
        tolerance_(kTolerance * workcell.plane().furthest()),
        parts_(moving_parts(workcell)) {
    take_elements();
    best_.resize(kMovers.size() * elements_.size());
    for (auto& nearest : nearest_) nearest.resize(process.stops.size());
  }

  Separation run() {
    Separation result;
    result.tolerance = tolerance_;
    for (const Element& element : elements_) result.elements.push_back(element.name);
    std::vector<Measured> all;
    for (const Stretch& stretch : stretches_of(process_)) all.push_back({stretch, {}, {}, {}});
    for (Measured& each : all) measure_stops(each);
    for (const Measured& each : all) measure_ways(each);
    for (const Mover mover : kMovers)
      for (std::size_t e = 0; e < elements_.size(); ++e)
        if (const Best& best = best_of(mover, e); best.bounds.upper < kInfinity)
          result.least.push_back(
              {mover, elements_[e].name, parts_[best.part].name, best.bounds, best.stop, best.degrees});
    result.nearest = std::move(nearest_);
    return result;
  }

 private:
  void take_elements() {
    for (auto& triangles : by_owner(cell_.standing_parts())) {
      const std::string& name = cell_.names()[triangles.front().owner];
      elements_.push_back({name, TriangleTree(std::move(triangles)), {}});
    }
    for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
      elements_.push_back({"the material in the " + std::string(to_string(slot)), cell_.material_tree(), slot});
  }

  [[nodiscard]] Best& best_of(Mover mover, std::size_t element) {
    return best_[index(mover) * elements_.size() + element];
  }

  /// A part's distance from an element with the arm at these links; `stop` and `degrees` say where that is.
  DistanceBounds measure(std::size_t p, std::size_t e, const std::vector<Pose>& links, const MaterialTransfer& state,
                         double cutoff, std::size_t stop, double degrees) {
    const MovingPart& part = parts_[p];
    const Pose pose = elements_[e].seen(part.pose(links, state), state);
    const DistanceBounds bounds = part.distance_from(elements_[e].triangles, pose, cutoff);
    if (Best& best = best_of(part.mover, e); bounds.upper < best.bounds.upper) {
      best.bounds.upper = bounds.upper;
      best.part = p, best.stop = stop, best.degrees = degrees;
    }
    return bounds;
  }

  /// Distances at the stops, as far as they can be the least of their mover, or of the run.
  void measure_stops(Measured& measured) {
    const Stretch& stretch = measured.stretch;
    const std::size_t pairs = parts_.size() * elements_.size();
    std::vector<double> lower(pairs, 0);
    std::vector<double> way(parts_.size(), 0);
    for (std::size_t stop = stretch.first; stop <= stretch.last; ++stop) {
      if (stop > stretch.first) {
        measured.ways.push_back(way_between(arm_, parts_, process_.stops[stop - 1], process_.stops[stop],
                                            measured.links.back(), *stretch.state));
        way = measured.ways.back().moved;
        for (std::size_t i = 0; i < pairs; ++i) lower[i] = std::max(0.0, lower[i] - way[i / elements_.size()]);
      }
      measured.links.push_back(arm_.link_poses(process_.stops[stop].commanded));
      const std::vector<Pose>& links = measured.links.back();
      std::array<double, kMovers.size()> upper{kInfinity, kInfinity, kInfinity};
      std::array<double, kMovers.size()> least = upper;
      std::array<std::size_t, kMovers.size()> element{};
      std::vector<std::size_t> order;
      for (std::size_t i = 0; i < pairs; ++i)
        if (parts_[i / elements_.size()].is_there(*stretch.state) &&
            elements_[i % elements_.size()].is_there(*stretch.state))
          order.push_back(i);
      std::ranges::sort(order, {}, [&](std::size_t i) { return lower[i]; });
      for (const std::size_t i : order) {
        const std::size_t p = i / elements_.size(), e = i % elements_.size(), m = index(parts_[p].mover);
        const double needed = std::max(upper[m], best_of(parts_[p].mover, e).bounds.upper);
        if (lower[i] >= needed) continue;
        const DistanceBounds bounds = measure(p, e, links, *stretch.state, needed + kAhead * way[p], stop, 0);
        lower[i] = std::max(lower[i], bounds.lower);
        if (bounds.upper < upper[m]) upper[m] = bounds.upper, element[m] = e;
      }
      for (const std::size_t i : order) {
        double& its = least[index(parts_[i / elements_.size()].mover)];
        its = std::min(its, lower[i]);
      }
      measured.lower.push_back(lower);
      for (std::size_t m = 0; m < kMovers.size(); ++m) {
        if (upper[m] == kInfinity) continue;
        auto& nearest = nearest_[m][stop];
        if (!nearest || upper[m] < nearest->here) nearest = {{least[m], upper[m]}, upper[m], element[m]};
      }
    }
  }

  /// A way between two stops, in degrees from the first one.
  struct Way {
    std::size_t part, element, stop;
    Step step;
    const MaterialTransfer* state;
    double rate;    ///< by which the distance changes at most, per degree
    double upper;   ///< attained on the way
    double always;  ///< a lower bound on the whole way
  };
  /// A lower bound of the distance on the way, by its bounds at the ends. Halves until it is good enough.
  double lowest(Way& way, const Clearance& whole) {
    double lower = kInfinity;
    const auto judge = [&](const Clearance& part) {
      const double here = std::max(way.always, part.least(way.rate));
      if (here < needed(way) && way.rate * (part.end - part.begin) > tolerance_ / 4) return Next::Halve;
      lower = std::min(lower, here);
      return Next::Done;
    };
    by_halves(whole, judge, [&](double middle, const Clearance& part) {
      const kinematics::Angles angles = way.step.after(process_.stops[way.stop].commanded, middle);
      const double cutoff = std::max(part.at_begin, part.at_end) + way.rate * (part.end - part.begin);
      const DistanceBounds there = measure(way.part, way.element, arm_.link_poses(angles), *way.state, cutoff, way.stop,
                                           std::copysign(middle, way.step.degrees));
      way.upper = std::min(way.upper, there.upper);
      return there.lower;
    });
    return lower;
  }
  /// How much higher than an element a part stays while one joint turns it about a vertical axis; 0 for other moves.
  [[nodiscard]] double above(std::size_t p, std::size_t e, const Step& step, const JointTurn& turn,
                             const std::vector<Pose>& links, const MaterialTransfer& state) const {
    if (std::ranges::count(step.by, 0.0) < 2 || std::hypot(turn.axis().x(), turn.axis().y()) > 0) return 0;
    const MovingPart& part = parts_[p];
    const Pose pose = part.pose(links, state);
    const touchstone::Box box = part.triangles.whole();
    const Eigen::Vector3d half = (box.high - box.low) / 2;
    const double center = (pose * (box.low + half)).z(), reach = (pose.rotation.cwiseAbs() * half).z() + part.radius;
    return std::max(0.0, center - reach - elements_[e].top(state) - kTolerance * tolerance_);
  }
  [[nodiscard]] double needed(const Way& way) {
    return std::max(best_of(parts_[way.part].mover, way.element).bounds.upper - tolerance_,
                    way.upper - std::max(tolerance_, kShare * way.upper));
  }

  void measure_ways(const Measured& measured) {
    const Stretch& stretch = measured.stretch;
    for (std::size_t i = 0; i < parts_.size() * elements_.size(); ++i) {  // a stretch may be a single stop
      const std::size_t p = i / elements_.size(), e = i % elements_.size();
      if (!parts_[p].is_there(*stretch.state) || !elements_[e].is_there(*stretch.state)) continue;
      Best& best = best_of(parts_[p].mover, e);
      best.bounds.lower = std::min({best.bounds.lower, best.bounds.upper, measured.lower.front()[i]});
    }
    for (std::size_t stop = stretch.first; stop < stretch.last; ++stop) {
      const std::size_t number = stop - stretch.first;
      const auto& [step, way] = measured.ways[number];
      const double degrees = std::abs(step.degrees);
      const JointTurn turn(arm_, process_.stops[stop].commanded, step.joint);
      const std::vector<Pose>& links = measured.links[number];
      const auto &before = measured.lower[number], &after = measured.lower[number + 1];
      for (std::size_t p = 0; p < parts_.size(); ++p) {
        if (!parts_[p].is_there(*stretch.state)) continue;
        auto& nearest = *nearest_[index(parts_[p].mover)][stop + 1];
        nearest.bounds.upper = std::min(nearest.bounds.upper, nearest_[index(parts_[p].mover)][stop]->here);
        for (std::size_t e = 0; e < elements_.size(); ++e) {
          if (!elements_[e].is_there(*stretch.state)) continue;
          Best& best = best_of(parts_[p].mover, e);
          const std::size_t i = p * elements_.size() + e;
          Way over{p,
                   e,
                   stop,
                   step,
                   stretch.state,
                   degrees > 0 ? way[p] / degrees : 0,
                   nearest.bounds.upper,
                   above(p, e, step, turn, links, *stretch.state)};
          const double lower = lowest(over, {0, before[i], degrees, after[i]});
          best.bounds.lower = std::min(best.bounds.lower, lower);
          nearest.bounds.upper = std::min(nearest.bounds.upper, over.upper);
          nearest.bounds.lower = std::min(nearest.bounds.lower, lower);
        }
      }
    }
  }

  const Workcell& cell_;
  const Arm& arm_;
  const Process& process_;
  double tolerance_;
  std::vector<MovingPart> parts_;
  std::vector<Element> elements_;
  std::vector<Best> best_;  // by mover, then element
  std::array<std::vector<std::optional<NearestElement>>, kMovers.size()> nearest_;
};

}  // namespace

Separation separation_of(const Workcell& workcell, const Process& process) {
  return Measurement(workcell, process).run();
}

}  // namespace touchstone::cell
