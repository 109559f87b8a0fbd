// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 4: the algorithm, and the angles of its animation.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/studies/stability/angle_sum.h"
#include "experiments/thesis/figures/entries.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

/// The gripper's balls of all radii, by where a method ends.
Ends gripper_ends(const Study& study, std::size_t method) {
  Ends sum;
  if (study.flowcharts.empty()) return sum;
  for (std::size_t k = 0; k < kRadii.size(); ++k) sum += study.flowchart(0, k).methods[method];
  return sum;
}

/// The same for the eight outlines that are not chosen.
Ends outline_ends(const Study& study, std::size_t method) {
  Ends sum;
  for (std::size_t i = kRadii.size(); i < study.flowcharts.size(); ++i) sum += study.flowcharts[i].methods[method];
  return sum;
}

std::size_t number_of(std::string_view method) {
  return static_cast<std::size_t>(std::ranges::find(kMethods, method) - kMethods.begin());
}

/// A contact at the end of a move: what is known of it.
std::vector<Number> contact_numbers(const Study& study, std::size_t number, std::size_t stop, Number captioned_angle) {
  const CaseStudy& its_case = study.cases[number];
  const double radius = study.cell.gripper.sphere.radius;
  std::vector<Number> numbers{std::move(captioned_angle)};
  if (stop >= its_case.stops.size()) return numbers;
  const Stop& its_stop = its_case.stops[stop];
  const cell::Move& move = its_case.process.moves[its_stop.move];
  numbers.push_back(found("first contact, certified", "°", std::abs(move.exact), true));
  numbers.push_back(found("from the sphere's centre to the " + its_stop.face + ", a step before", "mm",
                          its_stop.before.distance, true));
  numbers.push_back(found("the same at the stop", "mm", its_stop.at.distance, true));
  numbers.push_back(found("radius of the sphere", "mm", radius, true));
  numbers.push_back(beside(found("collisions that the thesis's method finds at the stop and a step before, of 2", "",
                                 its_stop.thesis_at + its_stop.thesis_before, true),
                           Label::Derived, its_stop.at.contact() + its_stop.before.contact()));
  return numbers;
}

void add_flowchart(const Study& study, EntryList& entries) {
  const Ends ends = gripper_ends(study, 0);
  const std::uint64_t samples = ends.samples();
  std::vector<Number> numbers;
  for (const End end : kEnds) {
    numbers.push_back(share(fmt::format("balls that end at \"{}\", by the thesis's method", to_string(end)),
                            ends.at(end), samples, true));
    numbers.push_back(
        share(fmt::format("the same, exactly: \"{}\"", to_string(end)), ends.exactly_at(end), samples, true));
  }
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    const Ends its = gripper_ends(study, m);
    numbers.push_back(share(fmt::format("balls that end elsewhere than exactly, by {}", kMethods[m]), its.elsewhere(),
                            samples, true));
  }
  entries.add("4.3", Status::WithChosen,
              "The order of the tests is that of the thesis's contents: plane, intersection point, edges. Every branch "
              "is counted over random balls about the front of the chosen gripper, of four radii (0.2, 1, 5 and 10 % "
              "of its width), feet uniform in its bounding box and 3 radii around it, heights within 1.5 radii; "
              "branches.csv has the same for eight more outlines. The two ways of ending in a collision differ from "
              "the exact ones by the gripper's gap (Fig. E.1).",
              std::move(numbers),
              "A flowchart: is the sphere in front, behind or does it intersect the plane; is the intersection point "
              "inside the polygon; is an edge nearer than the radius. At each end, the share of random balls that "
              "end there by the thesis's method and exactly.");
}

void add_plane_sides(const Study& study, EntryList& entries) {
  const Ends ends = outline_ends(study, 0), in_floats = outline_ends(study, number_of("thesis-float"));
  const auto of_exact = [](const Ends& its, End end) {
    const auto i = static_cast<std::size_t>(end);
    return std::pair(its.counts[i][i], its.exactly_at(end));
  };
  const auto side = [&](End end, const std::string& name) -> std::vector<Number> {
    const auto [right, all] = of_exact(ends, end);
    const auto [right_in_floats, same] = of_exact(in_floats, end);
    return {beside(share("balls exactly " + name + " that are called so, in doubles", right, all, false),
                   Label::Derived, 100),
            share("the same in floats, as in the lesson's code", right_in_floats, same, false)};
  };
  entries.add(
      "4.4", Status::Reproduced,
      "s = N.(C - P0) with N from the first three vertices; s >= r is INFRONT. Touching from the front counts "
      "as in front: the comparison is strict. Measured on balls as in Fig. 4.3, about the eight outlines of Fig. E.2.",
      side(End::InFront, "in front"),
      "Side view of a plane with its normal N upwards; a sphere above it, its centre further from the plane "
      "than its radius: s is at least r.");
  entries.add("4.5", Status::Reproduced,
              "What neither intersects nor has s >= r is BEHIND; so is everything where N is not a number (Fig. E.7). "
              "Measured on balls as in Fig. 4.3, about the eight outlines of Fig. E.2.",
              side(End::Behind, "behind"),
              "Side view of a plane with its normal N upwards; a sphere below it, s at most minus r.");
  const std::uint64_t inside = ends.counts[2][2], exactly_inside = ends.exactly_at(End::Inside);
  entries.add(
      "4.6", Status::Reproduced,
      "|s| < r is INTERSECTS. With the plane and with the polygon: the intersection point is inside, too. None "
      "that is inside is missed; but of those called inside a part is not (Fig. E.1). Measured on balls as in Fig. "
      "4.3, about the eight outlines of Fig. E.2.",
      {beside(share("balls exactly intersecting with the foot inside that end so", inside, exactly_inside, false),
              Label::Derived, 100),
       share("balls called inside whose foot is not", ends.at(End::Inside) - inside, ends.at(End::Inside), false)},
      "Side view of a plane and a sphere that cuts it over the polygon: the distance s of the centre is less "
      "than the radius.");
}

void add_points(const Study& study, EntryList& entries) {
  entries.add("4.7", Status::WithChosen,
              "Q = C - sN, the foot of the perpendicular, held against the exact one rounded to doubles; on the "
              "gripper's front where it stands at the storage in case 1, about half a metre from the base's axis.",
              {found("largest distance of Q from the exact foot, in doubles", "mm", study.feet.in_doubles, true),
               found("the same in floats", "mm", study.feet.in_floats, true),
               found("balls", "", static_cast<double>(study.feet.samples), true)},
              "Side view of a plane and a sphere that cuts it, with the centre C, its distance s from the plane along "
              "the normal N, and the intersection point Q under it.");
  const stability::GripperPoints points = stability::gripper_points(study.gripper());
  const stability::AngleSum palm = stability::angle_sum(study.gripper(), points.palm),
                            gap = stability::angle_sum(study.gripper(), points.gap);
  entries.add("4.8", Status::WithChosen,
              "The angles at which the edges are seen from the point, without signs, must add up to 0.99 x 360 = 356.4 "
              "degrees. From inside a polygon they do: with signs they would add up to 360, without to no less. They "
              "also do from the middle of the gripper's gap, where with signs they would add up to 0.",
              {found("sum at a point of the palm", "°", palm.unsigned_sum, true),
               beside(found("the same with signs", "°", palm.signed_sum, true), Label::Derived, 360, 1e-9),
               found("sum in the middle of the gap", "°", gap.unsigned_sum, true),
               beside(found("the same with signs", "°", std::abs(gap.signed_sum), true), Label::Derived, 0, 1e-9)},
              "The gripper's front twice, with the angles at which its eight edges are seen from a point of the palm "
              "and from one of the gap; both sums are more than 356.4 degrees.");
  const EdgePlaces& places = study.edges;
  const auto part = [&](const char* what, std::uint64_t count) { return share(what, count, places.pairs, true); };
  entries.add("4.9", Status::WithChosen,
              "Along an edge from Pi, t = (C - Pi).unit(Pi+1 - Pi) is clamped to the edge: a sphere is before, beside "
              "or beyond it. Counted for all edges of the gripper's front and balls whose foot is outside.",
              {part("before the edge's start", places.before), part("beside the edge", places.beside),
               part("beyond its end", places.beyond)},
              "An edge in its plane, and spheres before its start, beside it and beyond its end, each joined to the "
              "nearest point of the edge.");
  entries.add("4.10", Status::WithChosen,
              "A sphere collides with an edge that comes nearer to its centre than its radius. Every edge test of Fig. "
              "4.9 is held against the exact one.",
              {beside(part("edge tests unlike the exact ones, in doubles", places.wrong[0]), Label::Derived, 0),
               part("the same in floats", places.wrong[1])},
              "A sphere whose intersection point is outside the polygon and which reaches over one of its edges.");
}

void add_angles(const Study& study, EntryList& entries) {
  const auto& [first, second] = study.cases;
  const Predictions& p = study.predictions;
  const auto places = static_cast<double>(p.places);
  entries.add(
      "4.11", Status::WithChosen,
      "From home to the storage the base turns clockwise by 150 degrees less the storage's angle: 150 - 1 = 149 "
      "and 150 + 33 = 183, so that the second case's storage stands at minus 33. It comes out at every whole "
      "angle from -60 to 60, at the radii of both cases, as it must: the base turns by what the storage is turned. "
      "(These runs test the sphere alone, so that the storage may stand in the machine.)",
      {captioned("base clockwise, storage at +1°", -moved(first, 1, kBase), 149),
       captioned("base clockwise, storage at -33°", -moved(second, 1, kBase), 183),
       beside(found("angles of the storage at which it turns by 150 less the angle", "",
                    static_cast<double>(p.to_storage), true),
              Label::Derived, places)},
      "The cell from above: the arm's direction at home, and arcs of 149 and 183 degrees clockwise to the "
      "storage's two places.");
  entries.add(
      "4.12", Status::WithChosen,
      "From the storage to the machine the base turns back by 67 degrees less the storage's angle: 66 and 100. "
      "Both lead to 83 degrees clockwise from home, where the machine stands. There the elbow is 35 degrees up "
      "and the shoulder 28 down, whatever the angle.",
      {captioned("base counter-clockwise, storage at +1°", moved(first, 3, kBase), 66),
       captioned("base counter-clockwise, storage at -33°", moved(second, 5, kBase), 100),
       beside(found("angles of the storage at which it turns by 67 less the angle", "",
                    static_cast<double>(p.to_machine), true),
              Label::Derived, places),
       beside(found("those with elbow +35 and shoulder +28 at the machine", "", static_cast<double>(p.net), true),
              Label::Derived, places)},
      "The cell from above: arcs of 66 and 100 degrees counter-clockwise from the storage's two places to the "
      "machine.");
}

}  // namespace

void add_algorithm(const Study& study, EntryList& entries) {
  const auto& [first, second] = study.cases;
  entries.add("4.1", Status::WithChosen,
              "The end of the base's turn in case 1: the virtual sphere touches the side of the material in storage. "
              "The arm stops at the first whole degree at which it does.",
              contact_numbers(study, 0, 0, captioned("base clockwise at the stop", -moved(first, 1, kBase), 149)),
              "The material in storage from above and the sphere, at the stop and a step before, with the certified "
              "first contact between them.");
  entries.add("4.2", Status::WithChosen,
              "The end of the shoulder's way down at the machine in case 1: the sphere touches the upper face of the "
              "virtual material.",
              contact_numbers(study, 0, 1, captioned("shoulder down at the stop", moved(first, 4, kShoulder), 28)),
              "The virtual material at the machine from the side and the sphere, at the stop and a step before, with "
              "the certified first contact between them.");
  add_flowchart(study, entries);
  add_plane_sides(study, entries);
  add_points(study, entries);
  add_angles(study, entries);
}

}  // namespace touchstone::figures
