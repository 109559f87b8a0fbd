// SPDX-License-Identifier: GPL-3.0-or-later
// The known errors of the thesis's method, with what was stated of them before.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/thesis/figures/convex_cover.h"
#include "experiments/thesis/figures/entries.h"
#include "experiments/thesis/figures/stated_share.h"

namespace touchstone::figures {
namespace {

/// Wrong yeses per right one, in percent, with limits: of all yeses, the wrong ones are a binomial count.
Number ratio(std::string what, std::uint64_t wrong, std::uint64_t right, std::uint64_t samples, bool chosen) {
  Number number = found(std::move(what), "%", 100 * static_cast<double>(wrong) / static_cast<double>(right), chosen);
  const auto of_called = statistics::clopper_pearson(wrong, wrong + right);
  number.limits = {100 * of_called.lower / (1 - of_called.lower), 100 * of_called.upper / (1 - of_called.upper)};
  number.samples = samples;
  return number;
}

Number beside_share(Number number, std::uint64_t wrong, std::uint64_t right, double percent, double unit,
                    std::uint64_t stated_samples) {
  const StatedShare stated{percent / 100, unit / 100, stated_samples};
  const double allowed = 100 * tolerance(wrong, right, number.samples, stated);
  return beside(std::move(number), Label::Derived, percent, allowed);
}

void add_areas(const Study& study, EntryList& entries) {
  const auto area_number = [&](const stability::FalseArea& area, bool chosen) {
    return ratio(fmt::format("{}: area wrongly called inside, of its own", area.outline->name), area.wrong, area.right,
                 area.points, chosen);
  };
  const stability::GripperPoints points = stability::gripper_points(study.gripper());
  const double threshold = 0.99 * 360;
  double least = 720;
  std::uint64_t in_gap = 0, called = 0;
  const auto& corners = study.gripper().corners;
  const auto gap_left = std::ranges::max_element(corners, {}, [&](const auto& corner) {
                          return corner.first < points.gap.x() ? corner.first : -1e300;
                        })->first;
  const double gap_right = 2 * points.gap.x() - gap_left, bottom = bounds(study.gripper()).bottom,
               end = 2 * points.gap.y() - bottom;
  for (const stability::MapPoint& p : study.map.points) {
    if (p.x < gap_left || p.x > gap_right || p.y < bottom || p.y > end || p.inside) continue;
    ++in_gap;
    called += p.called;
    least = std::min(least, p.sum);
  }
  std::vector<Number> numbers{beside(found("points of the gap that are called inside", "%",
                                           100 * static_cast<double>(called) / static_cast<double>(in_gap), true),
                                     Label::Derived, 100),
                              found("the least sum of angles in the gap", "°", least, true),
                              found("from so much on a point is called inside", "°", threshold, false)};
  if (!study.areas.empty()) numbers.push_back(area_number(study.areas[0], true));
  entries.add(
      "E.1", Status::WithChosen,
      "Angles without signs add up to 360 degrees or more inside a polygon; and so they do in the gap of a U. A ball "
      "between the jaws of the chosen gripper touches it, by this method, wherever it is. "
      "With signs the sum is 0 there (Fig. 4.8), and hardly a ball of Fig. 4.3 ends elsewhere than exactly.",
      std::move(numbers),
      "Map of the plane around the gripper's front: the sum of the angles at every point. The gripper itself "
      "and its whole gap are called inside; outside it the sum falls off.");

  constexpr std::array<std::pair<double, double>, 8> kStated{
      {{4.2, 0.1}, {2.1, 0.1}, {28, 1}, {86, 1}, {151, 1}, {136, 1}, {81.6, 0.1}, {169, 1}}};
  std::vector<Number> areas;
  std::uint64_t missed = 0, right = 0;
  for (std::size_t i = 1; i < study.areas.size(); ++i) {
    const stability::FalseArea& area = study.areas[i];
    areas.push_back(beside_share(area_number(area, false), area.wrong, area.right, kStated[i - 1].first,
                                 kStated[i - 1].second, 1'000'000));
    missed += area.missed;
    right += area.right + area.missed;
  }
  areas.push_back(
      beside(share("points inside that are called outside, all outlines", missed, right, false), Label::Derived, 0));
  // What the angle sum is to avoid: stated beside it, in whole percent.
  constexpr std::array<double, 9> kHulls{50, 0, 0, 17, 29, 36, 36, 54, 112};
  std::size_t parts = 0;
  for (std::size_t i = 0; i < study.areas.size(); ++i) {
    const stability::Outline& outline = *study.areas[i].outline;
    const ConvexCover cover = convex_cover(outline);
    areas.push_back(beside(found(fmt::format("{}: area in its convex hull outside it, of its own", outline.name), "%",
                                 100 * cover.hull, i == 0),
                           Label::Derived, kHulls[i], 0.5));
    parts += cover.parts;
  }
  areas.push_back(
      found("convex parts that cover all of them, with no area outside", "", static_cast<double>(parts), false));
  entries.add(
      "E.2", Status::Reproduced,
      "Uniform points in each outline's bounding box, enlarged on every side by half its extent; factor 0.99. "
      "What is stated was each seen once, in a million points; ours may differ by four standard deviations of "
      "both and half a unit of the last digit. The thesis wants neither convex hulls, which fill notches, nor "
      "decompositions into convex parts, which are exact and more faces. On every outline that is not convex its "
      "test takes more area outside for inside than the hull that it is to avoid.",
      std::move(areas),
      "For eight outlines and the gripper, a bar: the area wrongly called inside as a share of the outline's "
      "own; beside it, grey, the same for "
      "its convex hull; under both a small drawing of the outline.");
}

void add_false_hits(const Study& study, EntryList& entries) {
  struct Stated {
    std::size_t outline;  // place in Study::outlines
    std::array<double, kRadii.size()> percent;
    double unit;
  };
  constexpr std::array<Stated, 5> kStated{{{4, {30, 35, 41, 25}, 1},
                                           {5, {38, 44, 49, 40}, 1},
                                           {3, {18, 20, 12, 6}, 1},
                                           {6, {38, 45, 60, 29}, 1},
                                           {2, {1.2, 0.2, 0, 0}, 0.1}}};
  std::vector<Number> numbers;
  std::uint64_t misses = 0, hits = 0, false_hits = 0, culled = 0;
  for (const Flowchart& flowchart : study.flowcharts) {
    const Ends& ends = flowchart.methods[0];
    misses += ends.misses(), hits += ends.misses() + ends.true_hits();
    false_hits += ends.false_hits(), culled += flowchart.culled;
  }
  const auto number = [&](std::size_t outline, std::size_t k) {
    const Ends& ends = study.flowchart(outline, k).methods[0];
    return ratio(fmt::format("{}, radius {:g} % of its extent: false hits per true one", study.outlines[outline].name,
                             100 * kRadii[k]),
                 ends.false_hits(), ends.true_hits(), ends.samples(), outline == 0);
  };
  if (!study.flowcharts.empty()) {
    for (const Stated& stated : kStated)
      for (std::size_t k = 0; k < kRadii.size(); ++k) {
        const Ends& ends = study.flowchart(stated.outline, k).methods[0];
        numbers.push_back(beside_share(number(stated.outline, k), ends.false_hits(), ends.true_hits(),
                                       stated.percent[k], stated.unit, 800'000));
      }
    for (std::size_t k = 0; k < kRadii.size(); ++k) numbers.push_back(number(0, k));
  }
  numbers.push_back(
      beside(share("contacts that are missed, all outlines and radii", misses, hits, false), Label::Derived, 0));
  numbers.push_back(share("false hits that a box around the outline would cull", culled, false_hits, false));
  entries.add("E.3", Status::Reproduced,
              "The whole method on the balls of Fig. 4.3. Larger balls reach the edges of a gap anyway, so that a "
              "part of what the angle sum gets wrong does not matter. A cull by boxes changes this method's answers: "
              "it removes some of its false hits.",
              std::move(numbers),
              "False hits per true hit against the radius of the ball, a line for each of five outlines and the "
              "gripper, with the stated values as marks.");
}

void add_factor(const Study& study, EntryList& entries) {
  std::vector<Number> numbers;
  const auto reach_of = [](const std::vector<FactorReach>& all, double factor) {
    const FactorReach* longest = nullptr;
    for (const FactorReach& reach : all)
      if (reach.factor == factor && (longest == nullptr || reach.length > longest->length)) longest = &reach;
    return *longest;
  };
  if (!study.square_reach.empty()) {
    for (const double factor : {0.99, 0.9999, 1.0}) {
      const FactorReach reach = reach_of(study.square_reach, factor);
      // The arc cosine of a number near -1 keeps only half of its digits.
      numbers.push_back(beside(found(fmt::format("square of side 1, factor {:g}", factor), "", reach.reach, false),
                               Label::Derived, derived_factor_reach(1, factor), 1e-7));
    }
    numbers.front().stated = 0.00785;
    numbers.front().tolerance = 0.5e-5;
    const FactorReach gripper = reach_of(study.gripper_reach, 0.99);
    numbers.push_back(
        found(fmt::format("the gripper's {:g} mm edge, factor 0.99", gripper.length), "mm", gripper.reach, true));
  }
  entries.add(
      "E.4", Status::Reproduced,
      "From a point at the distance h outside the middle of an edge of length L the edge is seen at 2 atan(L / "
      "2h), and the others of a convex outline at as much. So the sum reaches 0.99 x 360 degrees up to h = L / "
      "(2 tan 89.1°) = 0.00785 L. Found by bisection of the method's own answers. Beside an outline that is not convex "
      "the edges of its gaps add to the sum, and the strip is wider.",
      std::move(numbers),
      "How far outside each edge of the square and of the gripper's back a point still counts as inside, for "
      "the factors 0.99, 0.9999 and 1, on a logarithmic axis.");
}

}  // namespace

void add_known_errors(const Study& study, EntryList& entries) {
  add_areas(study, entries);
  add_false_hits(study, entries);
  add_factor(study, entries);

  const NotNumbers& nan = study.not_numbers;
  entries.add(
      "E.5", Status::WithChosen,
      "On an edge u.v / |u||v| is -1; rounded, it may be less, and then its arc cosine is no number and counts "
      "as 0: half a turn is lost, and the point is called outside. The edge test finds the contact anyway. "
      "Random points of the gripper's edges, rounded to floats; the gripper made 1000 wide and turned at "
      "random. About a quarter was stated; we take 20 to 30 % for that.",
      {beside(share("points whose arc cosine is no number, in floats", nan.in_floats, nan.samples, true),
              Label::Derived, 25, 5),
       share("the same in doubles", nan.in_doubles, nan.samples, true),
       share("of those in floats, called outside", nan.called_outside, nan.in_floats, true),
       beside(share("of those, contacts of a ball of radius 1 that are missed", nan.misses, nan.in_floats, true),
              Label::Derived, 0)},
      "Bars: the share of points on edges whose arc cosine is no number, in floats and in doubles, and what "
      "comes of them.");

  constexpr std::array<const char*, 3> kTouched{"faces", "edges", "corners"};
  std::vector<Number> touching;
  std::uint64_t missed_closed = 0, all = 0;
  for (std::size_t i = 0; i < kTouched.size(); ++i) {
    const Touching& t = study.touching[i];
    Number as_it_is = share(fmt::format("{} touched: contacts missed", kTouched[i]), t.missed, t.samples, true);
    touching.push_back(i == 0 ? beside(std::move(as_it_is), Label::Derived, 100) : std::move(as_it_is));
    touching.push_back(
        beside(share("the same with signed angles", t.missed_signed, t.samples, true), Label::Derived, 100));
    missed_closed += t.missed_closed, all += t.samples;
  }
  touching.push_back(
      beside(share("all of them, where touching counts: missed", missed_closed, all, true), Label::Derived, 0));
  entries.add(
      "E.6", Status::WithChosen,
      "|s| < r and d < r are strict. Balls that touch the gripper's front in exactly one point, drawn so that "
      "no sum is rounded; the exact answer is contact. Beside edges and corners the unsigned angle sum takes "
      "many of their feet for inside (Fig. E.1), and so hides the error; with signed angles every one is missed.",
      std::move(touching),
      "Bars: the share of exactly touching balls that are missed, on faces, edges and corners: by the method as "
      "it is, with signed angles, and where touching counts.");

  const Collinear& line = study.collinear;
  entries.add("E.7", Status::WithChosen,
              "The gripper's front with one more vertex, in the middle of its first edge: the same polygon, but its "
              "first three vertices give no normal. N is not a number, every comparison is false, and every contact "
              "is missed without a word.",
              {beside(share("contacts that are missed", line.missed, line.contacts, true), Label::Derived, 100),
               beside(share("the same with the normal of all vertices", line.missed_newell, line.contacts, true),
                      Label::Derived, 0)},
              "The gripper's front with the further vertex marked, and bars: all contacts are missed with the normal "
              "of the first three vertices, none with that of all.");

  std::vector<Number> far;
  constexpr std::array<const char*, 3> kFarMethods{"signed angles, doubles", "signed angles, floats", "ours, doubles"};
  for (std::size_t m = 0; m < kFarMethods.size(); ++m) {
    const auto failed =
        std::ranges::find_if(study.far_away, [&](const FarAway& away) { return 100 * away.wrong[m] > away.samples; });
    if (failed != study.far_away.end())
      far.push_back(found(fmt::format("least power of ten with more than 1 % wrong, {}", kFarMethods[m]), "mm",
                          failed->offset, true));
  }
  for (const FarAway& away : study.far_away)
    if (away.offset == 1e6 || away.offset == 1e9)
      far.push_back(
          share(fmt::format("wrong at {:g} mm, {}", away.offset, kFarMethods[1]), away.wrong[1], away.samples, true));
  entries.add("E.8", Status::WithChosen,
              "s = N.C + D is a small difference of large numbers far from the origin. Gripper and balls are moved "
              "together along all three axes and rounded to doubles; truth is about what is then there. Angles are "
              "signed, so that nothing is wrong near the origin.",
              std::move(far),
              "The share of wrong answers against the distance from the origin: floats fail first, by many powers of "
              "ten; doubles, and ours, far behind.");

  std::vector<Number> passed;
  for (const std::size_t radius : {std::size_t{0}, kinematics::kRadii.size() - 1}) {
    const kinematics::Missed& missed = study.missed.counts[radius][2];
    passed.push_back(share(fmt::format("sphere of {:g} mm, steps of {:g}°: contacts passed over",
                                       kinematics::kRadii[radius], kinematics::kSteps[2]),
                           missed.missed, missed.contacts, true));
  }
  entries.add(
      "E.9", Status::WithChosen,
      fmt::format("The arm is looked at after every whole degree, not between. Random moves of one joint through thin "
                  "sheets: the first contact is certified, the stops are asked exactly. In the case studies nothing "
                  "is passed over: the sphere is {:g} mm wide. `touchstone cell missed` has more of this.",
                  2 * study.cell.gripper.sphere.radius),
      std::move(passed),
      "The share of certified first contacts that steps pass over, against the step, a line for each radius "
      "of the sphere.");
}

}  // namespace touchstone::figures
