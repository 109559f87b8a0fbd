// SPDX-License-Identifier: GPL-3.0-or-later
// Chapters 3 and 5: the virtual environment, its model files and its reconfiguration.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "experiments/thesis/figures/drawn_cell.h"
#include "experiments/thesis/figures/entries.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

double count(std::size_t n) { return static_cast<double>(n); }

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

const LinkFile& file_called(const Study& study, std::string_view name) {
  return *std::ranges::find_if(study.link_files, [&](const LinkFile& file) { return file.model.name == name; });
}

std::size_t faces(const Study& study, cell::Carrier carrier) {
  std::size_t sum = 0;
  for (const cell::ModelPart& part : study.parts)
    if (part.carrier == carrier) sum += part.faces.faces.size();
  return sum;
}

std::vector<Number> file_numbers(const LinkFile& file) {
  std::size_t vertices = 0, polygons = 0, holes = 0;
  for (const cell::LinkPart& part : file.model.parts) {
    vertices += part.vertices.size();
    polygons += part.polygons.size();
    for (const cell::LinkPolygon& polygon : part.polygons) holes += polygon.holes.size();
  }
  return {found("vertices", "", count(vertices), true), found("polygons", "", count(polygons), true),
          found("holes in them", "", count(holes), true),
          beside(found("files that are the same model when read again, of 1", "", file.same, true), Label::Derived, 1)};
}

void add_model_files(const Study& study, EntryList& entries) {
  entries.add("3.2", Status::WithChosen,
              "The layout of the thesis's model files is not public; ours fits what the captions say of them (one file "
              "a link, parts, vertices, polygons made of them). The bottom part of our milling machine is a box with a "
              "trough, of chosen size.",
              file_numbers(file_called(study, "machine-bottom")),
              "The text of the model file of the machine's bottom part: its vertices, its polygons, one with a hole; "
              "and the part that it describes.");
  entries.add("5.12", Status::WithChosen,
              "Ours: a link of parts, each of them a list of vertices and one of polygons; a polygon is a loop of "
              "vertices by number, and loops of holes.",
              {found("model files", "", count(study.link_files.size()), true)},
              "The grammar of our model files, with the beginning of one beside it.");
  std::vector<Number> axis = file_numbers(file_called(study, "Axis1"));
  axis.insert(axis.begin(),
              beside(found("parts", "", count(file_called(study, "Axis1").model.parts.size()), true), Label::Text, 3));
  entries.add("5.13", Status::WithChosen,
              "Three parts, as the caption says; which they are is chosen: the body with the shoulder's bearing, a "
              "motor, a plate with a hole.",
              std::move(axis),
              "The three parts of Axis1, each in a colour, and the lines that begin them in its file.");
  std::vector<Number> gripper = file_numbers(file_called(study, "Gripper1"));
  gripper.insert(
      gripper.begin(),
      beside(found("parts", "", count(file_called(study, "Gripper1").model.parts.size()), true), Label::Text, 1));
  entries.add("5.14", Status::WithChosen,
              "One part, as the caption says: a box less a gap, so that front and back are not convex.",
              std::move(gripper), "The gripper, and its whole file.");
  std::size_t polygons = 0, same = 0;
  for (const LinkFile& file : study.link_files) {
    for (const cell::LinkPart& part : file.model.parts) polygons += part.polygons.size();
    same += file.same;
  }
  entries.add("5.15", Status::WithChosen, "All files are written and read again without loss (section 5.3.2).",
              {found("polygons in all files", "", count(polygons), true),
               beside(found("files that are the same model when read again", "", count(same), true), Label::Derived,
                      count(study.link_files.size()))},
              "The polygons of Axis1 as they are read from its file, drawn by their edges alone.");
}

void add_robot(const Study& study, EntryList& entries) {
  const auto& links = study.cell.robot.links;
  std::size_t robot_parts = 0;
  for (const cell::Link& link : links) robot_parts += link.parts.size();
  entries.add(
      "5.6", Status::WithChosen,
      "What our cell consists of: the elements that the captions and the contents name. How many parts each has "
      "is chosen.",
      {found("parts of the robot", "", count(robot_parts), true),
       found("parts of the gripper", "", count(study.cell.gripper.parts.size()), true),
       found("parts of the storage, its stand included", "", count(study.cell.storage.parts.size() + 1), true),
       found("parts of the machine, its stand included", "", count(study.cell.machine.parts.size() + 1), true),
       found("faces of all", "",
             count(faces(study, cell::Carrier::Link) + faces(study, cell::Carrier::Gripper) +
                   faces(study, cell::Carrier::Storage) + faces(study, cell::Carrier::Machine) +
                   faces(study, cell::Carrier::Material)),
             true)},
      "A tree: the cell, its robot, gripper, storage, machine and material, and the parts of each.");
  std::vector<Number> numbers{
      beside(found("files of links, the gripper's among them", "", count(study.link_files.size() - 1), true),
             Label::Derived, count(links.size() + 1))};
  for (const LinkFile& file : study.link_files) {
    if (file.model.name == "machine-bottom") continue;
    std::size_t polygons = 0;
    for (const cell::LinkPart& part : file.model.parts) polygons += part.polygons.size();
    numbers.push_back(found("polygons of " + file.model.name, "", count(polygons), true));
  }
  entries.add("5.7", Status::WithChosen,
              "A base, six links, one behind each axis, and the gripper. Lengths along the arm are public; what links "
              "look like is chosen.",
              std::move(numbers), "The robot's base, its six links and the gripper, each by itself, shaded.");
  const auto revolute = std::ranges::count(study.cell.robot.joints, cell::Joint::Kind::Revolute, &cell::Joint::kind);
  entries.add("5.8", Status::WithChosen,
              "Each link moves with the one before it. The Aristo has six revolute axes; that the forearm keeps its "
              "elevation while the shoulder turns, and the hand stays level, is chosen.",
              {beside(found("revolute axes", "", static_cast<double>(revolute), false), Label::Source, 6)},
              "A chain from the base through six links to the gripper, a joint between each two, with its axis and "
              "limits.");

  const Primitives base = primitives_of(links[0].parts[0].solid);
  const double base_volume = part_called(study, "Base/pedestal").faces.volume.value();
  entries.add("5.9", Status::WithChosen,
              "A union, evaluated exactly. The cylinders, prisms of 32 sides, stand on one another, so that the volume "
              "must be the sum of theirs.",
              {beside(found("cylinders", "", base.cylinders, true), Label::Text, 2),
               beside(found("other primitives", "", base.boxes, true), Label::Text, 0),
               beside(found("volume of the union", "cm³", base_volume / 1000, true), Label::Derived, base.volume / 1000,
                      1e-4 * base.volume / 1000)},
              "The base of the robot: a wide low cylinder and a narrower, higher one on it, apart and united.");
  const Primitives shoulder = primitives_of(links[1].parts[0].solid);
  const double shoulder_volume = part_called(study, "Axis1/body").faces.volume.value();
  entries.add("5.10", Status::WithChosen,
              "A union, evaluated exactly: a box, a turntable under it and the shoulder's bearing across its top, half "
              "of which lies in the box.",
              {beside(found("boxes", "", shoulder.boxes, true), Label::Text, 1),
               beside(found("cylinders", "", shoulder.cylinders, true), Label::Text, 2),
               found("volume of the union", "cm³", shoulder_volume / 1000, true),
               found("faces", "", count(part_called(study, "Axis1/body").faces.faces.size()), true)},
              "The shoulder: a box, an upright and a lying cylinder, apart and united.");
  double off_plane = 0;
  for (const cell::ModelPart& part : study.parts)
    if (part.carrier == cell::Carrier::Link) off_plane = std::max(off_plane, part.faces.off_plane());
  entries.add(
      "5.11", Status::WithChosen, "All links at the chosen home pose, with the gripper.",
      {found("faces of the robot, without the gripper", "", count(faces(study, cell::Carrier::Link)), true),
       found("furthest that a vertex is off its face's plane", "mm", off_plane, true)},
      "The whole robot, shaded: base, shoulder, upper arm leaning forward, forearm sloping down, the hand with the "
      "gripper pointing down.");

  const cell::Arm arm = cell::arm_of(study.cell);
  // Level hands turn the wrist back: at the table's home pose, all angles 0, they do not.
  const auto frames = arm.chain.frames(Angles(6, 0.0));
  const auto at = [&](std::size_t joint) { return frames[joint].translation; };
  const double reach = kUpperArm + kForearm + kHand;
  entries.add(
      "table 5.1", Status::NotComputable,
      fmt::format(
          "The table's rows are not public. Beside our model stands what other public sources say of an Aristo: "
          "a Denavit-Hartenberg table, of a later model perhaps, and a weak source's reach of 0.8 m, which these "
          "lengths do not give: the flange, stretched out, is {:g} mm from the shoulder's axis. A payload (2.5 kg) is "
          "nothing that geometry could compute.",
          reach),
      {beside(found("revolute axes", "", static_cast<double>(revolute), false), Label::Source, 6),
       beside(found("shoulder's axis above the floor", "mm", at(kShoulder).z(), false), Label::Source, 322),
       beside(found("upper arm", "mm", (at(kElbow) - at(kShoulder)).norm(), false), Label::Source, 300, 1e-9),
       beside(found("forearm", "mm", (at(kWristPitch) - at(kElbow)).norm(), false), Label::Source, 375, 1e-9),
       beside(found("hand, to the flange", "mm", (at(kHandRoll) - at(kWristPitch)).norm(), false), Label::Source, 63,
              1e-9),
       beside(found("wrist at the table's home pose, from the base's axis", "mm", at(kWristPitch).x(), false),
              Label::Source, 375, 1e-9),
       beside(found("the same, above the floor", "mm", at(kWristPitch).z(), false), Label::Source, 622, 1e-9),
       beside(found("flange at that pose, above the floor", "mm", at(kHandRoll).z(), false), Label::Source, 559, 1e-9),
       beside(found("reach of the flange from the shoulder's axis", "mm", reach, false), Label::Source, 800)});
  const auto size = [&](const char* what, std::string_view name, int axis) {
    double low = 1e300, high = -1e300;
    for (const cell::Face& face : part_called(study, name).faces.faces)
      for (const double x : face.polygon.coordinates(axis)) low = std::min(low, x), high = std::max(high, x);
    return found(what, "mm", high - low, true);
  };
  entries.add(
      "table 5.2", Status::NotComputable,
      "The table's rows are not public, and we know of no other public source. All sizes of our machine are "
      "chosen; some of them:",
      {size("table, across the arm's direction", "machine/table", 1), size("table, along it", "machine/table", 0),
       size("bottom part, across", "machine/bottom", 1), size("bottom part, along", "machine/bottom", 0),
       found("vice's jaws above the floor", "mm", study.cell.machine.height + 25, true)});
}

/// The floor area of the places that complete, in m².
double area_of(const std::vector<cell::Tried>& places, const Settings& settings) {
  const double of_one = settings.radius_step * settings.angle_step / 57.29577951308232 * 1e-6;
  double sum = 0;
  for (const cell::Tried& place : places)
    if (!place.cause) sum += place.radius * of_one;
  return sum;
}

void add_area(const Study& study, EntryList& entries) {
  const auto completes = [](const cell::Tried& place) { return !place.cause; };
  std::vector<Number> area;
  std::set<double> angles;
  for (const cell::Tried& place : study.area)
    if (completes(place)) angles.insert(place.angle);
  area.push_back(
      found("floor area in which the storage's axis may stand", "m²", area_of(study.area, study.settings), true));
  area.push_back(
      found("places that complete", "", static_cast<double>(std::ranges::count_if(study.area, completes)), true));
  area.push_back(found("places tried", "", count(study.area.size()), true));
  if (!angles.empty()) {
    area.push_back(found("least angle at which some radius completes", "°", *angles.begin(), true));
    area.push_back(found("largest angle at which some radius completes", "°", *angles.rbegin(), true));
  }
  area.push_back(found("floor area by the sphere alone", "m²", area_of(study.area_of_sphere, study.settings), true));
  std::size_t differing = 0;
  for (std::size_t i = 0; i < study.area.size(); ++i)
    differing += completes(study.area[i]) != completes(study.area_of_sphere[i]);
  area.push_back(found("places where the sphere alone says otherwise", "", count(differing), true));
  const auto both =
      std::ranges::count_if(study.cases, [](const CaseStudy& its) { return its.process.failure.empty(); });
  area.push_back(beside(found("of the two cases' places, those that complete", "", static_cast<double>(both), true),
                        Label::Derived, 2));
  entries.add(
      "5.22", Status::WithChosen,
      fmt::format("The whole process, home to storage to machine and back, for the storage at every {} degrees and {} "
                  "mm, at the chosen height, as `touchstone cell area` runs it: nothing may touch what it should not, "
                  "and what is carried must arrive. The thesis's own rule tests the sphere alone; what it gives stands "
                  "beside.",
                  study.settings.angle_step, study.settings.radius_step),
      std::move(area),
      "The floor from above: where the storage's axis may stand, and why not elsewhere: out of reach, beyond a joint's "
      "limit, not between the fingers, let go too far from its place, or something in the way.");
}

void add_reconfiguration(const Study& study, EntryList& entries) {
  const auto& [first, second] = study.cases;
  const cell::Station& storage = study.cell.storage;
  entries.add(
      "5.17", Status::WithChosen,
      "The cell from above. The storage may stand at any angle, radius and height; these are the chosen ones, "
      "at the first case's angle.",
      {found("storage's angle", "°", storage.angle, true), found("storage's radius", "mm", storage.radius, true),
       found("height of the storage's deck", "mm", storage.height, true),
       beside(found("machine's angle, clockwise from home", "°", -study.cell.machine.azimuth(), true), Label::Derived,
              83),
       found("machine's radius", "mm", study.cell.machine.radius, true)},
      "The cell from above: robot, storage with three slots, machine, the circle in which the robot's body "
      "turns, and the arm at home.");

  const auto& radii = study.radii;
  const auto ends = completing(radii);
  std::vector<Number> close, far;
  std::string too_close, too_far;
  if (ends) {
    close.push_back(found("least radius that completes", "mm", radii[ends->first].radius, true));
    close.push_back(found("circle in which the robot's body turns", "mm", study.plan.body, true));
    close.push_back(found("from the storage's axis to its near side", "mm", -study.plan.storage.min().x(), true));
    far.push_back(found("greatest radius that completes", "mm", radii[ends->last].radius, true));
    const auto fails = [&](std::size_t at) {
      return fmt::format(" It does not complete at {:g} mm: {}.", radii[at].radius, radii[at].reason);
    };
    if (ends->first > 0) too_close = fails(ends->first - 1);
    if (ends->last + 1 < radii.size()) too_far = fails(ends->last + 1);
    if (const std::string between = gaps(radii, *ends, &cell::Tried::radius); !between.empty())
      too_far += fmt::format(" Of the radii between the least and the greatest, it does not complete at {}.", between);
  }
  const cell::Reach reach = cell::reach_of(study.cell);
  far.push_back(found("reach of the sphere's centre from the shoulder's axis, at most", "mm", reach.outer, true));
  const std::string tried = fmt::format(
      "The whole process with the storage at the first case's angle and height, and at radii by {} mm and its own. ",
      study.settings.radius_scan);
  entries.add("5.18", Status::WithChosen, tried + "No radius below the least one here completes." + too_close,
              std::move(close),
              "The cell from above with the storage at the greatest radius that is too close, and the circle in which "
              "the robot's body turns.");
  entries.add("5.19", Status::WithChosen, tried + "No radius beyond the greatest one here completes." + too_far,
              std::move(far),
              "The cell from above with the storage at the least radius that is too far, and the circle that the "
              "sphere can reach at that height.");
  const auto position = [&](const CaseStudy& its, int moves) -> std::vector<Number> {
    return {found("angle", "°", its.cell.storage.angle, true), found("radius", "mm", its.cell.storage.radius, true),
            beside(found("moves that complete the way to the machine", "", count(its.moves_to_machine()), true),
                   Label::Derived, moves)};
  };
  entries.add("5.20", Status::WithChosen,
              "Where the thesis's position 1 is, its caption does not say; this is the storage of the first case.",
              position(first, 5), "The cell in perspective with the storage at 1 degree, the arm at home.");
  entries.add("5.21", Status::WithChosen,
              "Where the thesis's position 2 is, its caption does not say; this is the storage of the second case. Its "
              "moves are six that captions name and the lift that follows from them.",
              position(second, 7), "The cell in perspective with the storage at minus 33 degrees, the arm at home.");
  add_area(study, entries);

  const auto pose = [&](const CaseStudy& its, std::size_t moment) -> std::vector<Number> {
    if (moment >= its.moments.size()) return {};
    const Eigen::Vector3d& at = its.process.stops[its.moments[moment].stop].sphere.center;
    return {found("sphere's centre, x", "mm", at.x(), true), found("y", "mm", at.y(), true),
            found("z", "mm", at.z(), true)};
  };
  const auto& joints = study.cell.robot.joints;
  entries.add("5.23", Status::WithChosen,
              fmt::format("The chosen home pose: the upper arm leans {:g} degrees forward, the forearm slopes down by "
                          "{:g}. With a level forearm the hand would go through the machine's vice on its way to the "
                          "storage.",
                          joints[1].home, -joints[2].home),
              pose(first, 0), "The cell in perspective, the arm at home.");
  entries.add("5.24", Status::WithChosen, "The first case, after the base's turn to the storage.", pose(first, 2),
              "The cell in perspective, the gripper at the material in storage.");
  entries.add("5.25", Status::WithChosen,
              "The first case, after the shoulder's way down at the machine. The hand stays level: the wrist makes up "
              "for the forearm.",
              pose(first, 5), "The cell in perspective, the gripper and the material at the machine's vice.");
  entries.add("5.26", Status::WithChosen,
              "The first case, once the milled piece is gripped again and the shoulder has risen to where it is at "
              "home. The captions of chapter 6 end at the machine; angles of the way back are not public.",
              pose(first, 8), "The cell in perspective, the gripper with the material above the machine's vice.");
}

void add_process(const Study& study, EntryList& entries) {
  const auto& [first, second] = study.cases;
  const auto steps = [](const CaseStudy& its) {
    double sum = 0;
    for (std::size_t i = 0; i < its.moves_to_machine(); ++i) sum += std::abs(its.process.moves[i].degrees);
    return sum;
  };
  entries.add(
      "5.2", Status::WithChosen,
      "The process as chapter 1 tells it: the robot picks the part from the storage, loads it onto the machine, "
      "and brings it back. The moves are those of the first case, the whole process.",
      {beside(found("moves from home to the machine, first case", "", count(first.moves_to_machine()), true),
              Label::Derived, 5),
       found("moves of the whole process", "", count(first.process.moves.size()), true)},
      "A flow chart: home, elbow down 3, base 149 clockwise to contact, grip, elbow up 38, base 66 back, "
      "shoulder down 28 to contact, place, withdraw, mill, grip again, back to the storage, home.");
  entries.add("5.5", Status::WithChosen,
              "What every joint does on the way from home to the machine, move by move, in both cases.",
              {found("steps of 1°, first case", "", steps(first), true),
               found("steps of 1°, second case", "", steps(second), true)},
              "Commanded angles of base, shoulder and elbow against steps of one degree, one panel for each case.");
}

}  // namespace

void add_environment(const Study& study, EntryList& entries) {
  add_model_files(study, entries);
  add_robot(study, entries);
  add_process(study, entries);
  add_reconfiguration(study, entries);
}

}  // namespace touchstone::figures
