// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 6: both case studies, and the heights of the storage.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/thesis/figures/entries.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

const char* const kPerspective = "The cell in perspective";

/// A move as a caption has it, and what was not rounded to whole degrees.
std::vector<Number> move_numbers(const CaseStudy& study, std::size_t move, AristoJoint joint, const char* what,
                                 int direction, int stated) {
  std::vector<Number> numbers{captioned(what, direction * moved(study, move, joint), stated)};
  if (move < study.moves_to_machine()) {
    const cell::Move& its = study.process.moves[move];
    if (its.until != Until::Facing)
      numbers.push_back(found(its.until == Until::Planned   ? "by inverse kinematics, before rounding"
                              : its.until == Until::Contact ? "first contact, certified"
                                                            : "until it is clear, before rounding",
                              "°", direction * its.exact, true));
    if (its.until != Until::Facing) numbers.push_back(found("from the next whole degree", "°", its.margin, true));
  }
  return numbers;
}

/// The arm in the plane of its links, and from above.
std::string views(const std::string& when) { return "The arm from the side and the cell from above, " + when + "."; }

std::vector<Number> joined(std::vector<Number> a, const std::vector<Number>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns the results at a stop, by the exact test and by the thesis's.
std::vector<Number> stop_numbers(const Study& study, std::size_t number, std::size_t stop) {
  const CaseStudy& its = study.cases[number];
  if (stop >= its.stops.size()) return {};
  const Stop& at = its.stops[stop];
  return {found("sphere's centre to the " + at.face + " at the stop", "mm", at.at.distance, true),
          found("a step before", "mm", at.before.distance, true),
          found("radius of the sphere", "mm", study.cell.gripper.sphere.radius, true)};
}

std::vector<Number> detection_numbers(const Study& study, std::size_t number, std::size_t stop) {
  const CaseStudy& its = study.cases[number];
  if (stop >= its.stops.size()) return {};
  const Stop& at = its.stops[stop];
  return {beside(found("collision at the stop, by the thesis's method (1 is yes)", "", at.thesis_at, true),
                 Label::Derived, at.at.contact()),
          beside(found("collision a step before", "", at.thesis_before, true), Label::Derived, at.before.contact())};
}

/// The same at the machine, and how far from its place the material is let go.
std::vector<Number> put_numbers(const Study& study, std::size_t number) {
  std::vector<Number> numbers = detection_numbers(study, number, 1);
  for (const cell::MaterialTransfer& transfer : study.cases[number].process.transfers)
    if (transfer.slot == cell::StationSlot::Machine) {
      numbers.push_back(found("material, let go from its place by", "mm", transfer.shift, true));
      numbers.push_back(found("turned from its place by", "°", transfer.turn, true));
    }
  return numbers;
}

/// The numbers of all moves, and of the whole run.
std::vector<Number> run_numbers(const CaseStudy& its, std::vector<Number> numbers) {
  numbers.push_back(
      beside(found("elbow at the machine, from home", "°", its.net(cell::kElbow), true), Label::Derived, 35));
  numbers.push_back(
      beside(found("shoulder at the machine, from home", "°", its.net(cell::kShoulder), true), Label::Derived, 28));
  numbers.push_back(found("pairs of sphere and face that could touch, at every degree of the whole process", "",
                          static_cast<double>(its.asked), true));
  std::uint64_t wrong = 0;
  for (const std::uint64_t its_wrong : its.wrong) wrong += its_wrong;
  numbers.push_back(share("wrong answers, all variants of the thesis's method and fast doubles", wrong,
                          its.asked * kMethods.size(), true));
  return numbers;
}

/// The moves that captions of either case name; the lift of the second is not captioned.
double captioned_moves() {
  double moves = 0;
  for (const Captions& its : kCases)
    for (const int degrees :
         {its.elbow, its.base, its.shoulder, its.elbow_to_machine, its.base_to_machine, its.shoulder_to_machine})
      moves += degrees != 0;
  return moves;
}

void add_first_case(const Study& study, EntryList& entries) {
  const CaseStudy& its = study.cases[0];
  const auto moves = [&](std::size_t move, AristoJoint joint, const char* what, int direction, int stated) {
    return move_numbers(its, move, joint, what, direction, stated);
  };
  const std::vector<Number> angle{set_angle("angle of the storage", its.cell.storage.angle, 1)};
  entries.add("6.1", Status::WithChosen, "The plan of the cell with the storage at 1 degree.", angle,
              "The cell from above, the storage at 1 degree, the arm at home.");
  entries.add("6.2", Status::WithChosen, "The same cell in perspective.", angle,
              std::string(kPerspective) + ", the storage at 1 degree, the arm at home.");
  entries.add(
      "6.4", Status::WithChosen,
      "The elbow goes where inverse kinematics has it for the middle of the material's side, rounded to a degree.",
      moves(0, kElbow, "elbow down", -1, 3), views("after the elbow has moved down 3 degrees"));
  entries.add("6.6", Status::WithChosen, "The base turns until the sphere touches, by steps of 1 degree.",
              moves(1, kBase, "base clockwise", -1, 149),
              "The cell from above with the arm at home and at the storage, and the arc of 149 degrees between them.");
  entries.add("6.7", Status::WithChosen, "The pose at the end of that turn.",
              moves(1, kBase, "base clockwise", -1, 149), std::string(kPerspective) + ", the arm at the storage.");
  entries.add("6.9", Status::WithChosen,
              "The sphere in front of the side that it touches, at the stop and a step before.",
              stop_numbers(study, 0, 0),
              "From above, close: the material, and the sphere at the stop, where it overlaps the side, and a step "
              "before, where it does not.");
  entries.add("6.10", Status::WithChosen,
              "What makes the gripper grip: the answer of the sphere's test at every stop. The thesis's method and the "
              "exact one agree. Our gripper also requires a finger on either side of the material.",
              detection_numbers(study, 0, 0), "The gripper and the material in storage, close, in perspective.");
  entries.add("6.11", Status::WithChosen, "The elbow goes where it must be at the machine.",
              moves(2, kElbow, "elbow up", 1, 38), views("after the elbow has moved up 38 degrees with the material"));
  entries.add("6.13", Status::WithChosen, "The base turns to face the machine, which takes whole degrees here.",
              moves(3, kBase, "base counter-clockwise", 1, 66), views("after the base has turned to the machine"));
  entries.add("6.14", Status::WithChosen, "The shoulder goes down until the sphere touches the virtual material.",
              moves(4, kShoulder, "shoulder down", 1, 28), views("after the shoulder has moved down 28 degrees"));
  entries.add(
      "6.16", Status::WithChosen,
      "The virtual material is an unseen copy where the material is to be put. The sphere touches its upper face.",
      stop_numbers(study, 0, 1),
      "From the side, close: the virtual material, dashed, and the sphere at the stop, where it overlaps the "
      "upper face, and a step before, where it does not.");
  entries.add("6.17", Status::WithChosen,
              "The answers of the sphere's test that end the move. The hand stays level, so that the material arrives "
              "upright over its place in the vice, into which it is let go.",
              put_numbers(study, 0), "The gripper, the material and the virtual material, close, in perspective.");
  std::vector<Number> table{angle.front(),
                            captioned("elbow down", -moved(its, 0, kElbow), 3),
                            captioned("base clockwise", -moved(its, 1, kBase), 149),
                            captioned("elbow up", moved(its, 2, kElbow), 38),
                            captioned("base counter-clockwise", moved(its, 3, kBase), 66),
                            captioned("shoulder down", moved(its, 4, kShoulder), 28)};
  table = run_numbers(its, std::move(table));
  if (!study.homes.empty()) {
    const auto fitting = static_cast<std::uint64_t>(
        std::ranges::count_if(study.homes, [](const Member& member) { return member.failure.empty(); }));
    table.push_back(
        found("values of the layout that are chosen freely", "", static_cast<double>(free_parameters()), true));
    table.push_back(found("captioned moves of both cases that it must reproduce", "", captioned_moves(), false));
    table.push_back(found("home poses that were tried", "", static_cast<double>(study.homes.size()), true));
    table.push_back(found("of these with a layout in which all captions hold", "%",
                          100 * static_cast<double>(fitting) / static_cast<double>(study.homes.size()), true));
  }
  entries.add("table 6.1", Status::WithChosen,
              "All moves of the first case. The table itself is not public; its angles are those of the captions. More "
              "is chosen than captions state, and many home poses have a layout in which all captions hold: that "
              "ours does is a fit, not a finding.",
              std::move(table));
}

/// The angle, and where the storage is moved besides.
std::vector<Number> moved_outward(const Study& study, std::vector<Number> angle) {
  angle.push_back(found("radius of the storage in the first case", "mm", study.cases[0].cell.storage.radius, true));
  angle.push_back(found("in the second", "mm", study.cases[1].cell.storage.radius, true));
  return angle;
}

void add_second_case(const Study& study, EntryList& entries) {
  const CaseStudy& its = study.cases[1];
  const auto moves = [&](std::size_t move, AristoJoint joint, const char* what, int direction, int stated) {
    return move_numbers(its, move, joint, what, direction, stated);
  };
  const std::vector<Number> angle{set_angle("angle of the storage, clockwise", -(its.cell.storage.angle), 33)};
  entries.add("6.18", Status::WithChosen,
              fmt::format("The captions say 33 degrees; 183 = 150 + 33 says that these are clockwise, where 1 degree "
                          "was counter-clockwise. With the angle alone changed, the captions of the first case come "
                          "out again, but for the base. Those of the second need the storage moved outward as well, by "
                          "{:.1f} mm, to where the shoulder must move and the material is touched from above.",
                          its.cell.storage.radius - study.cases[0].cell.storage.radius),
              moved_outward(study, angle), "The cell from above, the storage at minus 33 degrees, the arm at home.");
  entries.add("6.19", Status::WithChosen, "The same cell in perspective.", angle,
              std::string(kPerspective) + ", the storage at minus 33 degrees, the arm at home.");
  entries.add("6.20", Status::WithChosen, "The elbow goes where inverse kinematics has it for the upper face.",
              moves(0, kElbow, "elbow up", 1, 12), views("after the elbow has moved up 12 degrees"));
  entries.add("6.22", Status::WithChosen, "The base turns to face the storage.",
              moves(1, kBase, "base clockwise", -1, 183),
              "The cell from above with the arm at home and at the storage, and the arc of 183 degrees between them.");
  entries.add("6.23", Status::WithChosen,
              "The base's turn, then the shoulder down until the sphere touches the material's upper edge.",
              joined(moves(1, kBase, "base clockwise", -1, 183), moves(2, kShoulder, "shoulder down", 1, 25)),
              views("after the shoulder has moved down 25 degrees at the storage"));
  entries.add(
      "6.25", Status::WithChosen,
      "Between this move and the last one the shoulder must have lifted the material, by 11 degrees, which no "
      "caption names: 25 - 11 + 14 is the 28 of the first case.",
      joined(moves(4, kElbow, "elbow up", 1, 23),
             {beside(found("shoulder up before it", "°", -moved(its, 3, kShoulder), true), Label::Derived, 11)}),
      views("after the elbow has moved up 23 degrees with the material"));
  entries.add("6.27", Status::WithChosen, "The base turns to face the machine.",
              moves(5, kBase, "base counter-clockwise", 1, 100), views("after the base has turned to the machine"));
  entries.add("6.28", Status::WithChosen, "The caption's \"storage\" must be the machine, to which these moves lead.",
              joined(moves(5, kBase, "base counter-clockwise", 1, 100), moves(6, kShoulder, "shoulder down", 1, 14)),
              views("after the shoulder has moved down 14 degrees at the machine"));
  std::vector<Number> table{
      angle.front(),
      captioned("elbow up", moved(its, 0, kElbow), 12),
      captioned("base clockwise", -moved(its, 1, kBase), 183),
      captioned("shoulder down", moved(its, 2, kShoulder), 25),
      beside(found("shoulder up, not captioned", "°", -moved(its, 3, kShoulder), true), Label::Derived, 11),
      captioned("elbow up", moved(its, 4, kElbow), 23),
      captioned("base counter-clockwise", moved(its, 5, kBase), 100),
      captioned("shoulder down", moved(its, 6, kShoulder), 14)};
  entries.add("table 6.2", Status::WithChosen,
              "All moves of the second case. The table itself is not public; its angles are those of the captions, and "
              "the lift that follows from them. They result with the storage moved outward as well as turned (Fig. "
              "6.18). Held out: in the layout of the first case the storage's angle alone predicts the base's moves "
              "and the net angles at the machine, but not how elbow and shoulder move to the storage.",
              run_numbers(its, std::move(table)));
}

void add_heights(const Study& study, EntryList& entries) {
  std::vector<Number> highest, lowest;
  std::string above, below, between;
  for (std::size_t i = 0; i < study.heights.size(); ++i) {
    const auto &places = study.heights[i], &by_sphere = study.heights_of_sphere[i];
    const auto ends = completing(places), of_sphere = completing(by_sphere);
    if (!ends || !of_sphere) continue;
    const std::string which = fmt::format("case {}'s angle and radius", i + 1);
    const auto height = [](const cell::Tried& place) { return place.height; };
    highest.push_back(found("greatest height that completes, at " + which, "mm", height(places[ends->last]), true));
    highest.push_back(found("the same by the sphere alone", "mm", height(by_sphere[of_sphere->last]), true));
    lowest.push_back(found("least height that completes, at " + which, "mm", height(places[ends->first]), true));
    lowest.push_back(found("the same by the sphere alone", "mm", height(by_sphere[of_sphere->first]), true));
    const auto next = [&](std::size_t end, std::size_t beyond) {
      if (beyond >= places.size())
        return fmt::format(" Case {} completes at {:g} mm, where the scan ends.", i + 1, height(places[end]));
      return fmt::format(" Case {} does not complete at {:g} mm: {}.", i + 1, height(places[beyond]),
                         places[beyond].reason);
    };
    above += next(ends->last, ends->last + 1);
    below += next(ends->first, ends->first - 1);  // before the first one: beyond the end, too
    if (const std::string in_between = gaps(places, *ends, &cell::Tried::height); !in_between.empty())
      between += fmt::format(" Of the heights between, case {} does not complete at {}.", i + 1, in_between);
  }
  for (auto* numbers : {&highest, &lowest})
    numbers->push_back(found("height in the case studies", "mm", study.cell.storage.height, true));
  entries.add("6.30", Status::WithChosen,
              "The storage raised step by step, and the whole process tried at each height, as `touchstone cell area` "
              "does. The thesis's own rule, which tests the sphere alone, lets the arm through the storage." +
                  above + between,
              std::move(highest),
              "The arm from the side, touching the material in storage at the chosen height and at the highest, and "
              "the range of heights of both cases as bars.");
  entries.add("6.31", Status::WithChosen, "The same, lowered step by step." + below + between, std::move(lowest),
              "The arm from the side, touching the material in storage at the chosen height and at the lowest, and the "
              "range of heights of both cases as bars.");
}

}  // namespace

void add_case_studies(const Study& study, EntryList& entries) {
  add_first_case(study, entries);
  add_second_case(study, entries);
  add_heights(study, entries);
}

}  // namespace touchstone::figures
