// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/computed.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <variant>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/figures/angle_sum.h"
#include "experiments/thesis/figures/predictions.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

/// The gripper's balls of all radii, by where a method ends; or those of the eight outlines that are not chosen.
Ends ends_of(const Study& study, std::size_t method, bool gripper) {
  Ends sum;
  for (std::size_t i = 0; i < study.flowcharts.size(); ++i)
    if ((i < kRadii.size()) == gripper) sum += study.flowcharts[i].methods[method];
  return sum;
}

void compute_flowchart(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const Ends ends = ends_of(study, 0, true);
  for (const End end : kEnds) {
    numbers[fmt::format("ends: {}", to_string(end))] = share(ends.at(end), ends.samples());
    numbers[fmt::format("exactly: {}", to_string(end))] = share(ends.exactly_at(end), ends.samples());
  }
  for (std::size_t m = 0; m < kMethods.size(); ++m)
    numbers[fmt::format("ends elsewhere: {}", kMethods[m])] =
        share(ends_of(study, m, true).elsewhere(), ends.samples());

  const auto in_floats = std::ranges::find(kMethods, "thesis-float") - kMethods.begin();
  for (const auto& [scalar, method] : {std::pair("doubles", std::size_t{0}), {"floats", std::size_t(in_floats)}}) {
    const Ends its = ends_of(study, method, false);
    for (const auto& [side, end] : {std::pair("in front", End::InFront), {"behind", End::Behind}}) {
      const auto i = static_cast<std::size_t>(end);
      numbers[fmt::format("{}, {}", side, scalar)] = share(its.counts[i][i], its.exactly_at(end));
    }
  }
  const Ends outlines = ends_of(study, 0, false);
  const std::uint64_t inside = outlines.counts[2][2], called = outlines.at(End::Inside);
  numbers["inside"] = share(inside, outlines.exactly_at(End::Inside));
  numbers["inside wrongly"] = share(called - inside, called);
}

void compute_points(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  numbers["foot, doubles"] = study.feet.in_doubles;
  numbers["foot, floats"] = study.feet.in_floats;
  numbers["foot, balls"] = study.feet.samples;
  const GripperPoints points = gripper_points(study.gripper());
  const AngleSum palm = angle_sum(study.gripper(), points.palm), gap = angle_sum(study.gripper(), points.gap);
  numbers["palm, sum"] = palm.unsigned_sum;
  numbers["palm, with signs"] = palm.signed_sum;
  numbers["gap, sum"] = gap.unsigned_sum;
  numbers["gap, with signs"] = std::abs(gap.signed_sum);
  const EdgePlaces& edges = study.edges;
  numbers["before the edge"] = share(edges.before, edges.pairs);
  numbers["beside the edge"] = share(edges.beside, edges.pairs);
  numbers["beyond the edge"] = share(edges.beyond, edges.pairs);
  numbers["edge tests, doubles"] = share(edges.wrong[0], edges.pairs);
  numbers["edge tests, floats"] = share(edges.wrong[1], edges.pairs);
}

struct Primitives {
  int boxes = 0, cylinders = 0;
  double volume = 0;  ///< summed
};

/// Of a solid's tree. The volume of a cylinder is that of its prism of equal sides.
Primitives primitives_of(const cell::Solid& solid) {
  Primitives sum;
  if (const auto* box = std::get_if<cell::Box>(&solid.shape)) {
    sum.boxes = 1;
    sum.volume = (box->upper - box->lower).prod();
  } else if (const auto* cylinder = std::get_if<cell::Cylinder>(&solid.shape)) {
    sum.cylinders = 1;
    const double area =
        cylinder->sides * cylinder->radius * cylinder->radius * workloads::sine(360.0 / cylinder->sides) / 2;
    sum.volume = area * (cylinder->to - cylinder->from).norm();
  } else if (const auto* boolean = std::get_if<cell::Boolean>(&solid.shape)) {
    for (const cell::Solid& part : boolean->parts) {
      const Primitives its = primitives_of(part);
      sum.boxes += its.boxes, sum.cylinders += its.cylinders, sum.volume += its.volume;
    }
  }
  return sum;
}

const cell::ModelPart& part_called(const Study& study, std::string_view name) {
  return *std::ranges::find(study.parts, name, &cell::ModelPart::name);
}

std::size_t faces(const Study& study, cell::Carrier carrier) {
  std::size_t sum = 0;
  for (const cell::ModelPart& part : study.parts)
    if (part.carrier == carrier) sum += part.faces.faces.size();
  return sum;
}

void compute_model_files(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  std::size_t all_polygons = 0, all_same = 0;
  for (const LinkFile& file : study.link_files) {
    std::size_t vertices = 0, polygons = 0, holes = 0;
    for (const cell::LinkPart& part : file.model.parts) {
      vertices += part.vertices.size();
      polygons += part.polygons.size();
      for (const cell::LinkPolygon& polygon : part.polygons) holes += polygon.holes.size();
    }
    all_polygons += polygons, all_same += file.same;
    const std::string& name = file.model.name;
    const bool shown = name == "Axis1" || name == "Gripper1", bottom = name == "machine-bottom";
    if (!bottom) numbers[name + ": polygons"] = polygons;
    if (shown) numbers[name + ": parts"] = file.model.parts.size();
    if (!shown && !bottom) continue;
    numbers[name + ": vertices"] = vertices;
    numbers[name + ": polygons"] = polygons;
    numbers[name + ": holes"] = holes;
    numbers[name + ": the same"] = file.same;
  }
  numbers["model files"] = study.link_files.size();
  numbers["files of links"] = study.link_files.size() - 1;
  numbers["links and gripper"] = study.cell.robot.links.size() + 1;
  numbers["polygons in all files"] = all_polygons;
  numbers["files that are the same"] = all_same;
}

void compute_robot(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const auto& links = study.cell.robot.links;
  std::size_t robot_parts = 0;
  for (const cell::Link& link : links) robot_parts += link.parts.size();
  numbers["parts of the robot"] = robot_parts;
  numbers["parts of the gripper"] = parts_of(study.cell.gripper).size();
  numbers["parts of the storage"] = study.cell.storage.parts.size() + 1;
  numbers["parts of the machine"] = study.cell.machine.parts.size() + 1;
  numbers["faces of the robot"] = faces(study, cell::Carrier::Link);
  numbers["faces of all"] = faces(study, cell::Carrier::Link) + faces(study, cell::Carrier::Gripper) +
                            faces(study, cell::Carrier::Finger) + faces(study, cell::Carrier::Storage) +
                            faces(study, cell::Carrier::Machine) + faces(study, cell::Carrier::Material);
  numbers["revolute axes"] =
      std::ranges::count(study.cell.robot.joints, cell::Joint::Kind::Revolute, &cell::Joint::kind);
  double off_plane = 0;
  for (const cell::ModelPart& part : study.parts)
    if (part.carrier == cell::Carrier::Link) off_plane = std::max(off_plane, part.faces.off_plane());
  numbers["off its plane"] = off_plane;

  const Primitives base = primitives_of(links[0].parts[0].solid), shoulder = primitives_of(links[1].parts[0].solid);
  numbers["base: cylinders"] = base.cylinders;
  numbers["base: other primitives"] = base.boxes;
  numbers["base: volume"] = part_called(study, "Base/pedestal").faces.volume.value() / 1000;
  numbers["base: sum of volumes"] = base.volume / 1000;
  numbers["base: tolerance of the volume"] = 1e-4 * base.volume / 1000;
  numbers["shoulder: boxes"] = shoulder.boxes;
  numbers["shoulder: cylinders"] = shoulder.cylinders;
  numbers["shoulder: volume"] = part_called(study, "Axis1/body").faces.volume.value() / 1000;
  numbers["shoulder: faces"] = part_called(study, "Axis1/body").faces.faces.size();

  // Level hands turn the wrist back: at the table's home pose, all angles 0, they do not.
  const auto frames = cell::arm_of(study.cell).chain.frames(Angles(6, 0.0));
  const auto at = [&](std::size_t joint) { return frames[joint].translation; };
  numbers["shoulder's height"] = at(kShoulder).z();
  numbers["upper arm"] = (at(kElbow) - at(kShoulder)).norm();
  numbers["forearm"] = (at(kWristPitch) - at(kElbow)).norm();
  numbers["hand"] = (at(kHandRoll) - at(kWristPitch)).norm();
  numbers["wrist, outward"] = at(kWristPitch).x();
  numbers["wrist, upward"] = at(kWristPitch).z();
  numbers["flange, upward"] = at(kHandRoll).z();
  numbers["reach of the flange"] = kUpperArm + kForearm + kHand;
  for (const char* part : {"table", "bottom"})
    for (const auto& [direction, axis] : {std::pair("along", 0), {"across", 1}}) {
      double low = 1e300, high = -1e300;
      for (const cell::Face& face : part_called(study, fmt::format("machine/{}", part)).faces.faces)
        for (const double x : face.polygon.coordinates(axis)) low = std::min(low, x), high = std::max(high, x);
      numbers[fmt::format("{}, {}", part, direction)] = high - low;
    }
  numbers["vice's jaws"] = study.cell.machine.height + 25;
}

/// The floor area of the places that complete, in m².
double area_of(const std::vector<cell::Tried>& places, const Settings& settings) {
  const double of_one = settings.radius_step * settings.angle_step / 57.29577951308232 * 1e-6;
  double sum = 0;
  for (const cell::Tried& place : places)
    if (!place.cause) sum += place.radius * of_one;
  return sum;
}

void compute_area(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const auto completes = [](const cell::Tried& place) { return !place.cause; };
  std::set<double> angles;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < study.area.size(); ++i) {
    if (completes(study.area[i])) angles.insert(study.area[i].angle);
    differing += completes(study.area[i]) != completes(study.area_of_sphere[i]);
  }
  numbers["area: floor"] = area_of(study.area, study.settings);
  numbers["area: floor by the sphere"] = area_of(study.area_of_sphere, study.settings);
  numbers["area: complete"] = std::ranges::count_if(study.area, completes);
  numbers["area: tried"] = study.area.size();
  auto &least = numbers["area: least angle"], &largest = numbers["area: largest angle"];
  if (!angles.empty()) least = *angles.begin(), largest = *angles.rbegin();
  numbers["area: differing"] = differing;
  numbers["area: cases"] =
      std::ranges::count_if(study.cases, [](const CaseStudy& its) { return its.process.failure.empty(); });
  numbers["area: degrees"] = study.settings.angle_step;
  numbers["area: millimetres"] = study.settings.radius_step;
}

void compute_radii(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const cell::Station& storage = study.cell.storage;
  numbers["storage: angle"] = storage.angle;
  numbers["storage: radius"] = storage.radius;
  numbers["storage: height"] = storage.height;
  numbers["machine: angle"] = -study.cell.machine.azimuth();
  numbers["machine: radius"] = study.cell.machine.radius;
  numbers["reach of the sphere"] = cell::reach_of(study.cell).outer;
  numbers["radii: step"] = study.settings.radius_scan;
  auto &least = numbers["radii: least"], &greatest = numbers["radii: greatest"], &body = numbers["robot's body"],
       &near = numbers["storage: near side"];
  std::string &too_close = computed.texts["too close"], &too_far = computed.texts["too far"];
  const auto& radii = study.radii;
  const auto ends = completing(radii);
  if (!ends) return;
  least = radii[ends->first].radius, greatest = radii[ends->last].radius;
  body = study.plan.body;
  near = -study.plan.storage.min().x();
  const auto fails = [&](std::size_t at) {
    return fmt::format(" It does not complete at {:g} mm: {}.", radii[at].radius, radii[at].reason);
  };
  if (ends->first > 0) too_close = fails(ends->first - 1);
  if (ends->last + 1 < radii.size()) too_far = fails(ends->last + 1);
  if (const std::string between = gaps(radii, *ends, &cell::Tried::radius); !between.empty())
    too_far += fmt::format(" Of the radii between the least and the greatest, it does not complete at {}.", between);
}

void compute_heights(const Study& study, Computed& computed) {
  auto& texts = computed.texts;
  for (const char* name : {"above", "below", "between"}) texts[name].clear();
  for (std::size_t i = 0; i < study.heights.size(); ++i) {
    const auto number = [&](const char* what) -> auto& {
      return computed.numbers[fmt::format("case {}: {}", i + 1, what)];
    };
    auto &highest = number("greatest height"), &lowest = number("least height"),
         &highest_of_sphere = number("greatest height by the sphere"),
         &lowest_of_sphere = number("least height by the sphere");
    const auto &places = study.heights[i], &by_sphere = study.heights_of_sphere[i];
    const auto ends = completing(places), of_sphere = completing(by_sphere);
    if (!ends || !of_sphere) continue;
    highest = places[ends->last].height, lowest = places[ends->first].height;
    highest_of_sphere = by_sphere[of_sphere->last].height, lowest_of_sphere = by_sphere[of_sphere->first].height;
    const auto next = [&](std::size_t end, std::size_t beyond) {
      if (beyond >= places.size())
        return fmt::format(" Case {} completes at {:g} mm, where the scan ends.", i + 1, places[end].height);
      return fmt::format(" Case {} does not complete at {:g} mm: {}.", i + 1, places[beyond].height,
                         places[beyond].reason);
    };
    texts["above"] += next(ends->last, ends->last + 1);
    texts["below"] += next(ends->first, ends->first - 1);  // before the first one: beyond the end, too
    if (const std::string in_between = gaps(places, *ends, &cell::Tried::height); !in_between.empty())
      texts["between"] += fmt::format(" Of the heights between, case {} does not complete at {}.", i + 1, in_between);
  }
}

/// Moves whose angles before rounding to whole degrees no entry names, by case and move: turns of the base that face a
/// place, and the lift.
constexpr std::array<std::pair<std::size_t, std::size_t>, 4> kWholeMoves{{{0, 3}, {1, 1}, {1, 3}, {1, 5}}};

/// The moves that captions name, in the directions that they name.
void compute_moves(const Study& study, Computed& computed) {
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    const CaseStudy& its = study.cases[i];
    const auto named = moves_of(kCases[i]);
    for (std::size_t k = 0; k < named.size(); ++k) {
      const auto& [joint, degrees] = named[k];
      const int direction = degrees < 0 ? -1 : 1;
      const std::string name = fmt::format("case {}, move {}", i + 1, k + 1);
      const cell::Move* move = k < its.moves_to_machine() ? &its.process.moves[k] : nullptr;
      const bool moved = move != nullptr && std::size_t{move->joint} == joint;
      computed.numbers[name] = moved ? direction * move->degrees : std::numeric_limits<double>::quiet_NaN();
      if (std::ranges::find(kWholeMoves, std::pair(i, k)) != kWholeMoves.end()) continue;
      auto &exact = computed.numbers[name + ", unrounded"], &margin = computed.numbers[name + ", margin"];
      if (move == nullptr || move->until == cell::Until::Facing) continue;
      exact = direction * move->exact;
      margin = move->margin;
    }
  }
}

/// The contacts at the ends of two moves of the first case: in storage, and at the machine.
void compute_stops(const Study& study, Computed& computed) {
  const CaseStudy& its = study.cases[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const auto number = [&](const char* what) -> auto& {
      return computed.numbers[fmt::format("stop {}: {}", i + 1, what)];
    };
    auto &first = number("first contact"), &before = number("distance before"), &at = number("distance"),
         &found = number("collisions found"), &collisions = number("collisions"), &found_at = number("found"),
         &contact_at = number("contact"), &found_before = number("found before"),
         &contact_before = number("contact before"), &radius = number("radius");
    std::string& face = computed.texts[fmt::format("stop {}: face", i + 1)];
    if (i >= its.stops.size()) continue;
    const Stop& stop = its.stops[i];
    face = stop.face;
    first = std::abs(its.process.moves[stop.move].exact);
    radius = study.cell.gripper.sphere.radius;
    before = stop.before.distance, at = stop.at.distance;
    found_at = stop.thesis_at, found_before = stop.thesis_before;
    contact_at = stop.at.contact(), contact_before = stop.before.contact();
    found = stop.thesis_at + stop.thesis_before, collisions = stop.at.contact() + stop.before.contact();
  }
  auto &shift = computed.numbers["material let go from its place"], &turn = computed.numbers["material turned"];
  for (const cell::MaterialTransfer& transfer : its.process.transfers)
    if (transfer.slot == cell::StationSlot::Machine) shift = transfer.shift, turn = transfer.turn;
}

void compute_cases(const Study& study, Computed& computed) {
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const CaseStudy& its = study.cases[i];
    const auto number = [&](const char* what) -> auto& {
      return computed.numbers[fmt::format("case {}: {}", i + 1, what)];
    };
    double steps = 0;
    for (std::size_t k = 0; k < its.moves_to_machine(); ++k) steps += std::abs(its.process.moves[k].degrees);
    std::uint64_t wrong = 0;
    for (const std::uint64_t its_wrong : its.wrong) wrong += its_wrong;
    number("steps") = steps;
    number("moves to the machine") = its.moves_to_machine();
    number("angle") = its.cell.storage.angle;
    number("radius") = its.cell.storage.radius;
    number("elbow at the machine") = its.process.net(cell::kElbow);
    number("shoulder at the machine") = its.process.net(cell::kShoulder);
    number("pairs") = its.asked;
    number("wrong answers") = share(wrong, its.asked * kMethods.size());
  }
  const auto& [first, second] = study.cases;
  computed.numbers["case 1: moves"] = first.process.moves.size();
  computed.numbers["case 2: angle, clockwise"] = -second.cell.storage.angle;
  computed.texts["outward"] = fmt::format("{:.1f}", second.cell.storage.radius - first.cell.storage.radius);
  for (const std::size_t moment : {0U, 2U, 5U, 8U})
    for (const auto& [axis, name] : {std::pair(0, 'x'), {1, 'y'}, {2, 'z'}}) {
      auto& number = computed.numbers[fmt::format("moment {}: {}", moment, name)];
      if (moment < first.moments.size()) number = first.process.stops[first.moments[moment].stop].sphere.center[axis];
    }
  const auto& joints = study.cell.robot.joints;
  computed.numbers["home: upper arm"] = joints[1].home;
  computed.numbers["home: forearm"] = -joints[2].home;
}

/// How well the layout is determined, and what it predicts.
void compute_layout(const Study& study, Computed& computed) {
  auto& numbers = computed.numbers;
  const auto predicted = [&](const auto& counts) {
    return std::ranges::count_if(study.predictions, [&](const Prediction& p) { return !p.fitted && counts(p); });
  };
  numbers["predictions"] = predicted([](const Prediction&) { return true; });
  numbers["predictions: between"] = predicted([](const Prediction& place) { return place.line == "between"; });
  for (std::size_t i = 0; i < kImplied.size(); ++i)
    numbers[fmt::format("predictions: {}", kImplied[i])] = predicted([i](const Prediction& p) { return p.agrees(i); });
  numbers["predictions: contacts"] =
      predicted([](const Prediction& p) { return p.contact && std::abs(*p.contact - *p.derived) < 1e-9; });
  numbers["predictions: wrong stops"] = predicted([](const Prediction& p) { return p.found && p.wrong_stops == 0; });
  // The lift of the second case is not captioned.
  const std::size_t captioned = moves_of(kCases[0]).size() + moves_of(kCases[1]).size() - 1;
  auto &free_values = numbers["layout: free parameters"], &moves = numbers["layout: captioned moves"],
       &homes = numbers["layout: home poses"], &fitting = numbers["layout: fitting home poses"];
  if (study.homes.empty()) return;
  free_values = parameters().size();
  moves = captioned;
  homes = study.homes.size();
  const auto fit = std::ranges::count_if(study.homes, [](const Member& member) { return member.failure.empty(); });
  fitting = 100 * static_cast<double>(fit) / static_cast<double>(study.homes.size());
}

}  // namespace

Value share(std::uint64_t count, std::uint64_t samples) {
  Value value = samples == 0 ? 0 : 100 * static_cast<double>(count) / static_cast<double>(samples);
  const auto limits = statistics::clopper_pearson(count, samples);
  value.limits = {100 * limits.lower, 100 * limits.upper};
  value.samples = samples;
  return value;
}

Computed computed(const Study& study) {
  Computed all;
  for (const auto compute :
       {compute_flowchart, compute_points, compute_model_files, compute_robot, compute_area, compute_radii,
        compute_heights, compute_moves, compute_stops, compute_cases, compute_layout, compute_errors})
    compute(study, all);
  return all;
}

}  // namespace touchstone::figures
