// SPDX-License-Identifier: GPL-3.0-or-later
// The known errors of the thesis's method.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "experiments/thesis/figures/computed.h"
#include "experiments/thesis/figures/false_areas.h"

namespace touchstone::figures {
namespace {

/// Wrong yeses per right one, in percent, with limits: of all yeses, the wrong ones are a binomial count.
Value ratio(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples) {
  Value value = 100 * static_cast<double>(wrong) / static_cast<double>(right);
  const auto of_called = statistics::clopper_pearson(wrong, wrong + right);
  value.limits = {100 * of_called.lower / (1 - of_called.lower), 100 * of_called.upper / (1 - of_called.upper)};
  value.samples = samples;
  value.wrong = wrong, value.right = right;
  return value;
}

/// The points of the gripper's gap in the map of angle sums.
void compute_gap(const Study& study, Computed& computed) {
  const GripperPoints points = gripper_points(study.gripper());
  double least = 720;
  std::uint64_t in_gap = 0, called = 0;
  const auto& corners = study.gripper().corners;
  const auto gap_left = std::ranges::max_element(corners, {}, [&](const auto& corner) {
                          return corner.first < points.gap.x() ? corner.first : -1e300;
                        })->first;
  const double gap_right = 2 * points.gap.x() - gap_left, bottom = bounds(study.gripper()).bottom,
               end = 2 * points.gap.y() - bottom;
  for (const MapPoint& p : study.map.points) {
    if (p.x < gap_left || p.x > gap_right || p.y < bottom || p.y > end || p.inside) continue;
    ++in_gap;
    called += p.called;
    least = std::min(least, p.sum);
  }
  computed.numbers["gap: called inside"] = 100 * static_cast<double>(called) / static_cast<double>(in_gap);
  computed.numbers["gap: least sum"] = least;
  computed.numbers["least sum inside"] = 0.99 * 360;
}

void compute_areas(const Study& study, Computed& computed) {
  std::uint64_t missed = 0, inside = 0;
  std::size_t parts = 0;
  for (std::size_t i = 0; i < study.outlines.size(); ++i) {
    const std::string name(study.outlines[i].name);
    auto &area = computed.numbers["area: " + name], &hull = computed.numbers["hull: " + name];
    if (study.areas.empty()) continue;
    const FalseArea& its = study.areas[i];
    area = ratio(its.wrong, its.right, its.points);
    if (i > 0) missed += its.missed, inside += its.right + its.missed;
    const ConvexCover cover = convex_cover(*its.outline);
    hull = 100 * cover.hull;
    parts += cover.parts;
  }
  computed.numbers["points called outside"] = share(missed, inside);
  computed.numbers["convex parts"] = parts;
}

void compute_false_hits(const Study& study, Computed& computed) {
  std::uint64_t misses = 0, hits = 0, false_hits = 0, culled = 0;
  for (const Flowchart& flowchart : study.flowcharts) {
    const Ends& ends = flowchart.methods[0];
    misses += ends.misses(), hits += ends.misses() + ends.true_hits();
    false_hits += ends.false_hits(), culled += flowchart.culled;
  }
  for (const std::size_t outline : {4U, 5U, 3U, 6U, 2U, 0U})
    for (std::size_t k = 0; k < kRadii.size(); ++k) {
      auto& value =
          computed.numbers[fmt::format("false hits: {}, {:g} %", study.outlines[outline].name, 100 * kRadii[k])];
      if (study.flowcharts.empty()) continue;
      const Ends& ends = study.flowchart(outline, k).methods[0];
      value = ratio(ends.false_hits(), ends.true_hits(), ends.samples());
    }
  computed.numbers["contacts missed"] = share(misses, hits);
  computed.numbers["false hits culled"] = share(culled, false_hits);
}

/// The reach of a factor beyond the longest edge.
void compute_factor(const Study& study, Computed& computed) {
  const auto longest = [](const std::vector<FactorReach>& all, double factor) {
    const FactorReach* found = nullptr;
    for (const FactorReach& reach : all)
      if (reach.factor == factor && (found == nullptr || reach.length > found->length)) found = &reach;
    return found;
  };
  for (const double factor : {0.99, 0.9999, 1.0}) {
    auto& value = computed.numbers[fmt::format("square, factor {:g}", factor)];
    if (const FactorReach* reach = longest(study.square_reach, factor)) value = reach->reach;
    if (factor != 0.99)
      computed.numbers[fmt::format("square, factor {:g}, derived", factor)] = derived_factor_reach(1, factor);
  }
  auto &length = computed.numbers["gripper's longest edge"], &reach = computed.numbers["gripper, factor 0.99"];
  if (const FactorReach* its = longest(study.gripper_reach, 0.99)) length = its->length, reach = its->reach;
}

void compute_rounding(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const NotNumbers& nan = study.not_numbers;
  numbers["no number, floats"] = share(nan.in_floats, nan.samples);
  numbers["no number, doubles"] = share(nan.in_doubles, nan.samples);
  numbers["no number, called outside"] = share(nan.called_outside, nan.in_floats);
  numbers["no number, missed"] = share(nan.misses, nan.in_floats);

  constexpr std::array<const char*, 3> kTouched{"faces", "edges", "corners"};
  std::uint64_t missed_closed = 0, all = 0;
  for (std::size_t i = 0; i < kTouched.size(); ++i) {
    const Touching& t = study.touching[i];
    numbers[fmt::format("touching {}", kTouched[i])] = share(t.missed, t.samples);
    numbers[fmt::format("touching {}, signed", kTouched[i])] = share(t.missed_signed, t.samples);
    missed_closed += t.missed_closed, all += t.samples;
  }
  numbers["touching, closed"] = share(missed_closed, all);

  const Collinear& line = study.collinear;
  numbers["collinear start"] = share(line.missed, line.contacts);
  numbers["collinear start, Newell"] = share(line.missed_newell, line.contacts);

  constexpr std::array<const char*, 3> kFarMethods{"signed angles, doubles", "signed angles, floats", "ours, doubles"};
  for (std::size_t m = 0; m < kFarMethods.size(); ++m) {
    auto& value = numbers[fmt::format("far away: {}", kFarMethods[m])];
    const auto failed =
        std::ranges::find_if(study.far_away, [&](const FarAway& away) { return 100 * away.wrong[m] > away.samples; });
    if (failed != study.far_away.end()) value = failed->offset;
  }
  for (const double offset : {1e6, 1e9}) {
    auto& value = numbers[fmt::format("wrong at {:g} mm", offset)];
    const auto away = std::ranges::find(study.far_away, offset, &FarAway::offset);
    if (away != study.far_away.end()) value = share(away->wrong[1], away->samples);
  }
}

}  // namespace

void compute_errors(const Study& study, Computed& computed) {
  compute_gap(study, computed);
  compute_areas(study, computed);
  compute_false_hits(study, computed);
  compute_factor(study, computed);
  compute_rounding(study, computed);
  computed.numbers["width of the sphere"] = 2 * study.cell.gripper.sphere.radius;
  for (const std::size_t radius : {std::size_t{0}, kinematics::kRadii.size() - 1}) {
    const kinematics::Missed& missed = study.missed.counts[radius][2];
    computed.numbers[fmt::format("missed by steps: {:g} mm", kinematics::kRadii[radius])] =
        share(missed.missed, missed.contacts);
  }
}

}  // namespace touchstone::figures
