// SPDX-License-Identifier: GPL-3.0-or-later
// Cell files: the cell is what they say, and what cannot be is refused by the name of its key.
#include "experiments/thesis/cell/model/read_cell.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/solid.h"
#include "experiments/thesis/cell/simulation/arm.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cell {
namespace {

using nlohmann::json;
using run_tests::after_file;
using run_tests::kCells;
using run_tests::message_of;

class BadCells : public testing::Test {
 protected:
  BadCells() {
    whole = json::parse(run_tests::text_of(kCells / "aristo.json"));
    std::filesystem::copy_file(kCells / "aristo.urdf", scratch.path / "aristo.urdf",
                               std::filesystem::copy_options::overwrite_existing);
  }

  /// What a cell file with this text is refused for, after the name of the file.
  [[nodiscard]] std::string fault(const std::string& text) const {
    const std::string file = (scratch.path / "cell.json").string();
    program::write_file(file, text);
    return after_file(file, message_of<BadCell>([&] { return read_cell(file); }));
  }
  /// The same of the Aristo's file with one value in place of another; null takes the key out.
  [[nodiscard]] std::string fault(const char* pointer, const json& value) const {
    json changed = whole;
    if (value.is_null()) {
      const json::json_pointer at(pointer);
      changed[at.parent_pointer()].erase(at.back());
    } else {
      changed[json::json_pointer(pointer)] = value;
    }
    return fault(changed.dump());
  }
  [[nodiscard]] std::string urdf_fault(const std::string& old_text, const std::string& new_text) const {
    std::string text = run_tests::text_of(kCells / "aristo.urdf");
    const std::size_t at = text.find(old_text);
    if (at == std::string::npos) return "nothing to replace";
    text.replace(at, old_text.size(), new_text);
    const std::string file = (scratch.path / "aristo.urdf").string();
    program::write_file(file, text);
    return after_file(file, fault(whole.dump()));
  }

  const run_tests::Scratch scratch;
  json whole;
};

TEST_F(BadCells, TheOriginalIsGood) { EXPECT_EQ(fault(whole.dump()), ""); }

TEST_F(BadCells, KeysAreNamed) {
  EXPECT_EQ(
      fault("/machine/hight", 5),
      "machine.hight: is an unknown key; there are home, angle, radius, height, slots, parts, stand, about, turn");
  EXPECT_EQ(fault("/machine/height", nullptr), "machine: the key \"height\" is missing");
  EXPECT_EQ(fault("/machine/height", -1), "machine.height: must not be negative, is -1");
  EXPECT_EQ(fault("/machine/height", "high"), "machine.height: must be a number");
  EXPECT_EQ(fault("/storage/radius", 0), "storage.radius: must be positive, is 0");
  EXPECT_EQ(fault("/step", 0), "step: must be positive, is 0");
  EXPECT_EQ(fault("/step", 91), "step: must be at most 90, is 91");
  EXPECT_EQ(fault("/unit", "ell"), "unit: there is no unit \"ell\"; there are um, mm, cm, m, inch, foot");
  EXPECT_EQ(fault("/name", ""), "name: must be a text that is not empty");
  EXPECT_EQ(fault("/gripper/sphere/at", json::array({0, 0})), "gripper.sphere.at: must be an array of 3 numbers");
  EXPECT_EQ(fault("/gripper/sphere/radius", -6), "gripper.sphere.radius: must be positive, is -6");
  EXPECT_EQ(fault("/material/slot", "Z"), "material.slot: there is no slot \"Z\"");
  EXPECT_EQ(fault("/storage/slots/1/name", "A"), "storage.slots[1].name: this name is taken");
  EXPECT_EQ(fault("/storage/slots", json::array()), "storage.slots: must not be empty");
  EXPECT_EQ(fault("/storage/stand/top", -242), "storage.stand.top: lies at or below the floor");
  EXPECT_EQ(fault("/meshes", "nowhere"), "meshes: there is no folder " + (scratch.path / "nowhere").string());
  EXPECT_EQ(fault("[]"), "the whole: must be an object");
  EXPECT_EQ(fault("{\"name\":1,\"name\":2}"), "duplicate key \"name\"");
  EXPECT_EQ(
      fault("{\n  \"name\": x}"),
      "is not JSON: line 2, column 11: syntax error while parsing value - invalid literal; last read: '\"name\": x'");
  EXPECT_EQ(fault(std::string(70, '[') + std::string(70, ']')), "is nested deeper than 64 levels");
  EXPECT_EQ(fault("/step", nullptr), "the whole: the key \"step\" is missing");
  std::string overflow = whole.dump();
  overflow.replace(overflow.find("\"step\":1"), 8, "\"step\":1e999");
  EXPECT_EQ(fault(overflow), "step: is beyond the finite doubles");
}

// What the file says reaches terminals, pages and JSON; a refusal shows it as it is legible.
TEST_F(BadCells, TextsAreUtf8WithoutControlCharacters) {
  EXPECT_EQ(fault("/name", "a\x1b[31m"), R"(name: must have no control character, is "a\x1b[31m")");
  EXPECT_EQ(fault("/storage/slots/1/name", "\n"),
            R"(storage.slots[1].name: must have no control character, is "\x0a")");
  EXPECT_EQ(fault("/machine/\x1b]0;x\x07", 1).substr(0, 40), R"(machine.\x1b]0;x\x07: is an unknown key;)");
  EXPECT_EQ(fault("/name", "\xc3\xa9"), "");
  std::string latin = whole.dump();
  latin.replace(latin.find("Aristo"), 6, "\xe9");
  EXPECT_NE(fault(latin).find("syntax error while parsing value - invalid string: "), std::string::npos)
      << fault(latin);
}

TEST_F(BadCells, AFileWithoutEndIsNotReadToItsEnd) {
  EXPECT_EQ(message_of<BadCell>([] { return read_cell("/dev/zero"); }), "/dev/zero: has more than 16 MiB");
  std::filesystem::remove(scratch.path / "aristo.urdf");
  std::filesystem::create_symlink("/dev/zero", scratch.path / "aristo.urdf");
  EXPECT_EQ(fault("/name", "x"), "robot.urdf: there is no file " + (scratch.path / "aristo.urdf").string());
}

// At a step that hardly moves a process would not end.
TEST_F(BadCells, TheStopsOfAJointAreLimited) {
  EXPECT_EQ(
      fault("/step", 1e-320),
      "step: at 9.99989e-321 degrees a stop, joint \"base\" would take inf stops from -270 to 90 degrees; at most "
      "100000 are allowed");
  EXPECT_NE(fault("/step", 0.0031), "");
  EXPECT_EQ(fault("/step", 0.01), "");
  // So would one of a joint that turns a million times.
  const std::string turning =
      urdf_fault("lower=\"-1.570796326794897\" upper=\"1.570796326794897\"", "lower=\"-9e9\" upper=\"9e9\"");
  EXPECT_TRUE(turning.starts_with("step: at 1 degrees a stop, joint \"shoulder\" would take ")) << turning;
}

TEST_F(BadCells, SolidsAreNamed) {
  const char* const box = "/gripper/parts/0/difference/0/box";
  const std::string path = "gripper.parts[0].difference[0].box: ";
  EXPECT_EQ(fault(box, {{"from", {0, 0, 0}}, {"to", {1, 0, 1}}}),
            path + "\"from\" must be less than \"to\" in coordinate 1: 0 and 0");
  const auto cylinder = [&](const json& value) { return fault("/material/solid", {{"cylinder", value}}); };
  EXPECT_EQ(cylinder({{"from", {0, 0, 0}}, {"to", {1, 1, 0}}, {"radius", 1}, {"sides", 8}}),
            "material.solid.cylinder: \"from\" and \"to\" must differ in one coordinate only");
  EXPECT_EQ(cylinder({{"from", {0, 0, 0}}, {"to", {0, 0, 0}}, {"radius", 1}, {"sides", 8}}),
            "material.solid.cylinder: \"from\" and \"to\" are the same point");
  EXPECT_EQ(cylinder({{"from", {0, 0, 0}}, {"to", {0, 0, 1}}, {"radius", 1}, {"sides", 2.5}}),
            "material.solid.cylinder.sides: must be a whole number from 3 to 1000, is 2.5");
  EXPECT_EQ(fault("/material/solid", json::object()),
            "material.solid: has no shape: box, cylinder, sphere, mesh, union, difference or intersection");
  EXPECT_EQ(fault("/material/solid", {{"union", {{{"box", {{"from", {0, 0, 0}}, {"to", {1, 1, 1}}}}}}}}),
            "material.solid.union: needs at least two solids");
  EXPECT_EQ(fault("/material/solid/turn", {{"axis", "z"}, {"degrees", 45}}),
            "material.solid.turn.degrees: must be a multiple of 90 from -360 to 360");
  EXPECT_EQ(fault("/material/solid", {{"mesh", {{"file", "none.stl"}, {"unit", "mm"}}}}),
            "material.solid.mesh.file: there is no file " + (scratch.path / "none.stl").string());
  EXPECT_EQ(fault("/machine/parts/1/name", "../bottom"),
            "machine.parts[1].name: must be a name of letters, digits, '-' and '_'");
  EXPECT_EQ(fault("/machine/parts/1/name", "stand"), "machine.parts[1].name: only the stand has this name");
  EXPECT_EQ(fault("/gripper/parts/0/name", "Axis1"), "gripper.parts[0].name: a link, or something else, has this name");
  EXPECT_EQ(fault("/machine/parts/1/name", "bottom"), "machine.parts[1].name: the name \"bottom\" is taken");
}

TEST_F(BadCells, RobotsAreNamed) {
  EXPECT_EQ(fault("/robot/urdf", "none.urdf"), "robot.urdf: there is no file " + (scratch.path / "none.urdf").string());
  // The elbow follows the shoulder, which is at 29.8.
  EXPECT_EQ(fault("/robot/home/elbow", 91),
            "robot.home.elbow: crosses a limit of the joint: 120.8 is not within -120 to 120 degrees");
  EXPECT_EQ(fault("/robot/home/elbow", 90), "");
  EXPECT_EQ(fault("/robot/home/shoulder", 90.5),
            "robot.home.shoulder: crosses a limit of the joint: 90.5 is not within -90 to 90 degrees");
  EXPECT_EQ(fault("/robot/home/elbow", nullptr), "robot.home: the key \"elbow\" is missing");
  EXPECT_EQ(fault("/robot/home/knee", 0), "robot.home.knee: the robot has no joint of this name that turns or slides");
  EXPECT_EQ(fault("/robot/coupling/0/follows", "knee"),
            "robot.coupling[0].follows: the robot has no joint \"knee\" that turns");
  EXPECT_EQ(fault("/robot/coupling/0/follows", "elbow"), "robot.coupling[0].follows: a joint does not follow itself");
  EXPECT_EQ(fault("/robot/links/Axis9", json::array()), "robot.links.Axis9: the robot has no link of this name");
}

// Only its direction counts; an axis without a direction is refused where it stands.
TEST_F(BadCells, AnAxisMayHaveAnyLength) {
  const std::string urdf = run_tests::text_of(kCells / "aristo.urdf");
  for (const char* length : {"1e154", "1e200", "1.7e308", "3", "1e-200", "5e-324"}) {
    std::string text = urdf;
    for (std::size_t at = 0; (at = text.find("<axis xyz=", at)) != std::string::npos; ++at)
      text.replace(text.find('1', at), 1, length);
    ASSERT_NE(text, urdf);
    program::write_file(scratch.path / "aristo.urdf", text);
    EXPECT_EQ(fault(whole.dump()), "") << length;
    const Cell cell = read_cell(scratch.path / "cell.json");
    for (const Joint& joint : cell.robot.joints) EXPECT_EQ(joint.axis.norm(), 1) << length << ' ' << joint.name;
    EXPECT_NO_THROW((void)arm_of(cell)) << length;
  }
  program::write_file(scratch.path / "aristo.urdf", urdf);
  for (const double length : {1e200, 1e-200})
    EXPECT_EQ(fault("/gripper/fingers/along", json::array({0, length, 0})), "") << length;
  EXPECT_EQ(fault("/gripper/fingers/along", json::array({0, 0, 0})), "gripper.fingers.along: has no direction");
}

TEST_F(BadCells, AGripperHasTwoFingersWithNamesOfTheirOwn) {
  const json finger = whole["gripper"]["fingers"]["parts"][0];
  EXPECT_EQ(fault("/gripper/fingers/parts", json::array({finger})), "gripper.fingers.parts: a gripper has two fingers");
  EXPECT_EQ(fault("/gripper/fingers/parts/1/name", "Gripper1"),
            "gripper.fingers.parts[1].name: another part of the gripper has this name");
  EXPECT_EQ(fault("/gripper/fingers/parts/1/name", "Axis1"),
            "gripper.fingers.parts[1].name: a link, or something else, has this name");
  EXPECT_EQ(fault("/gripper/fingers/stroke", 0), "gripper.fingers.stroke: must be positive, is 0");
}

TEST_F(BadCells, UrdfFilesAreNamedWithLinkOrJoint) {
  EXPECT_EQ(urdf_fault("lower=\"-1.570796326794897\" upper=\"1.570796326794897\"", "lower=\"1\" upper=\"-1\""),
            "line 23: joint shoulder: limits are crossed: lower 57.295779513 and upper -57.295779513 degrees");
  EXPECT_EQ(
      urdf_fault("name=\"wrist_pitch\" type=\"revolute\"", "name=\"wrist_pitch\" type=\"floating\""),
      "line 44: joint wrist_pitch: is neither revolute, continuous, prismatic nor fixed; robot.root can name a link "
      "behind it");
  EXPECT_EQ(urdf_fault("<axis xyz=\"0 0 -1\"/>", "<axis xyz=\"0 0 0\"/>"), "line 51: joint hand_roll: has no axis");
  EXPECT_EQ(urdf_fault("<parent link=\"Axis5\"/>", "<parent link=\"Axis4\"/>"),
            "as many joints turn on the way to link Axis6 as to Axis5: robot.tip must name the last link");
  EXPECT_EQ(urdf_fault("<origin xyz=\"0 0 0.3\"/>", "<origin xyz=\"0 0 0.3\"/><mimic joint=\"shoulder\"/>"),
            "robot.home.elbow: the joint mimics another, and has no angle of its own");
  whole["robot"]["home"].erase("elbow");
  EXPECT_EQ(urdf_fault("<origin xyz=\"0 0 0.3\"/>", "<origin xyz=\"0 0 0.3\"/><mimic joint=\"shoulder\"/>"),
            "robot.urdf: joint \"elbow\" mimics another, but the cell moves it by itself: only joints after the first "
            "three that turn can follow");
  whole["robot"]["home"]["elbow"] = -25;
  const auto link = [&](const char* inside) {
    return urdf_fault("<link name=\"Base\"/>",
                      "<link name=\"Base\"><visual><geometry>" + std::string(inside) + "</geometry></visual></link>");
  };
  EXPECT_EQ(link("<sphere radius=\"0\"/>"), "line 9: link Base: visual0: a size must be positive, is 0");
  EXPECT_EQ(link("<mesh filename=\"package://none/a.stl\"/>").substr(0, 74),
            "line 9: link Base: visual0: mesh: package://none/a.stl is in none of the f");
  EXPECT_EQ(link("<box size=\"1 0 1\"/>"), "line 9: link Base: visual0: a size must be positive, is 0");
  EXPECT_EQ(link("<mesh filename=\"none.stl\"/>"),
            "line 9: link Base: visual0: mesh: there is no file " + (scratch.path / "none.stl").string());
  EXPECT_NE(urdf_fault("</robot>", ""), "");
  EXPECT_NE(urdf_fault("<link name=\"Axis3\"/>", ""), "");
  EXPECT_EQ(urdf_fault("<origin xyz=\"0 0 0.2\"/>", "<origin xyz=\"0.1 0 0.2\"/>"),
            "robot.urdf: the first joint, \"base\", does not turn about the z axis of the first link");
}

// Spheres become polyhedra, and a mesh is found in its package: above the URDF, or where the cell file says.
TEST_F(BadCells, UrdfsFromElsewhereAreRead) {
  const auto link = [&](const std::string& inside) {
    return urdf_fault("<link name=\"Base\"/>",
                      "<link name=\"Base\"><visual><geometry>" + inside + "</geometry></visual></link>");
  };
  EXPECT_EQ(link("<sphere radius=\"0.1\"/>"), "");
  program::make_folder(scratch.path / "arm" / "meshes");
  program::write_file(scratch.path / "arm/meshes/a.obj",
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_EQ(link("<mesh filename=\"package://arm/meshes/a.obj\"/>"), "");
  EXPECT_EQ(link("<mesh filename=\"file://" + (scratch.path / "arm/meshes/a.obj").string() + "\"/>"), "");
}

TEST_F(BadCells, AccelerationsAndWaitsArePositive) {
  for (const char* key : {"/gripper/grip_seconds", "/gripper/release_seconds", "/material/milling_seconds",
                          "/robot/accelerations/elbow", "/robot/speeds/elbow"}) {
    whole["robot"]["accelerations"] = json::object();
    std::string path = key + 1;
    std::ranges::replace(path, '/', '.');
    EXPECT_EQ(fault(key, 0.5), "");
    EXPECT_EQ(fault(key, 0), path + ": must be positive, is 0");
    EXPECT_EQ(fault(key, -0.5), path + ": must be positive, is -0.5");
    EXPECT_EQ(fault(key, "fast"), path + ": must be a number");
  }
  for (const char* key : {"/gripper/grip_seconds", "/gripper/release_seconds", "/material/milling_seconds"})
    EXPECT_NE(fault(key, 1e308).find("_seconds: must be at most 1000000000 seconds, is 1e+308"), std::string::npos);
  EXPECT_EQ(fault("/robot/accelerations/elbow", 5e-324),
            "robot.accelerations.elbow: must be at least 1e-09, is 5e-324");
  EXPECT_EQ(fault("/robot/accelerations/knee", 1),
            "robot.accelerations.knee: the robot has no joint of this name that turns");
  EXPECT_EQ(fault("/storage/milling_seconds", 1).substr(0, 45), "storage.milling_seconds: is an unknown key; t");
  std::string text = whole.dump();
  text.replace(text.find("\"drop\":2.5"), 10, "\"milling_seconds\":1e999");
  EXPECT_NE(fault(text), "");
}

// Each goes to its own place.
TEST(ReadCell, AccelerationsAndWaitsAreThoseOfTheFile) {
  const Cell cell = read_cell(kCells / "aristo.json", std::nullopt,
                              {"robot.accelerations={\"elbow\": 150}", "gripper.grip_seconds=0.5",
                               "gripper.release_seconds=0.25", "material.milling_seconds=30"});
  EXPECT_EQ(arm_of(cell).accelerations, (std::vector<double>{0, 0, 150, 0, 0, 0}));
  EXPECT_EQ(cell.gripper.grip_seconds, 0.5);
  EXPECT_EQ(cell.gripper.release_seconds, 0.25);
  EXPECT_EQ(cell.material.milling_seconds, 30);
  EXPECT_EQ(cell.label("material.milling_seconds"), Label::Chosen);
  EXPECT_EQ(cell.label("robot.accelerations.elbow"), Label::Chosen);
}

// A joint that slides stands where `home` says.
TEST_F(BadCells, JointsThatSlideStandStill) {
  const std::string revolute = "name=\"wrist_pitch\" type=\"revolute\"";
  std::string urdf = run_tests::text_of(kCells / "aristo.urdf");
  urdf.replace(urdf.find(revolute), revolute.size(), "name=\"wrist_pitch\" type=\"prismatic\"");
  program::write_file(scratch.path / "aristo.urdf", urdf);
  whole["robot"].erase("coupling");
  whole["robot"].erase("speeds");
  whole["robot"]["home"]["wrist_pitch"] = 1e9;
  EXPECT_TRUE(fault(whole.dump())
                  .starts_with("robot.home.wrist_pitch: crosses a limit of the joint: 1000000000 is not within "));
  whole["robot"]["home"].erase("wrist_pitch");
  EXPECT_EQ(fault(whole.dump()), "robot.home: the key \"wrist_pitch\" is missing");
}

// urdfdom's own words have no line; XML is checked before it reads it.
TEST_F(BadCells, XmlFaultsAreNamedWithTheirLine) {
  const auto text = [&](const std::string& urdf) {
    program::write_file(scratch.path / "aristo.urdf", urdf);
    return after_file(scratch.path / "aristo.urdf", fault(whole.dump()));
  };
  EXPECT_EQ(text(""), "line 1: is not XML in UTF-8: no element found");
  EXPECT_EQ(text("<robot name=\"a\">\n<link name=\"b\">\n</robot>"), "line 3: is not XML in UTF-8: mismatched tag");
  EXPECT_EQ(text("<robot>\n<1/></robot>"), "line 2: is not XML in UTF-8: not well-formed (invalid token)");
  EXPECT_EQ(text("<robot\n name=\"\xe9\"/>"), "line 2: is not XML in UTF-8: not well-formed (invalid token)");
  EXPECT_EQ(text("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<robot name=\"\xe9\"/>"),
            "line 2: is not XML in UTF-8: not well-formed (invalid token)");
  EXPECT_EQ(text("<!DOCTYPE robot [<!ENTITY a \"aaaa\">]>\n<robot name=\"&a;\"/>"),
            "line 1: a document type is not read");
  EXPECT_EQ(text("<robot name=\"a\">\n<?x <a><a> ?></robot>"), "line 2: an instruction holds a '>'");
}

// Names reach terminals, pages and files of JSON.
TEST_F(BadCells, NamesInUrdfAreUtf8WithoutControlCharacters) {
  const std::string robot = "<robot name=\"Aristo\">";
  const auto named = [&](const std::string& name) { return urdf_fault(robot, "<robot name=\"" + name + "\">"); };
  EXPECT_EQ(named("&#xe9;"), "");
  EXPECT_EQ(named("&#x9;"), R"(line 8: robot \x09: the name has a control character, or is not UTF-8)");
  EXPECT_EQ(named("\x7f"), R"(line 8: robot \x7f: the name has a control character, or is not UTF-8)");
  EXPECT_EQ(named("\xc3\xa9"), "");
  // To urdfdom, an entity is a lone byte where the declaration says so.
  std::string latin = run_tests::text_of(kCells / "aristo.urdf");
  latin.replace(0, latin.find("?>"), "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"");
  latin.replace(latin.find(robot), robot.size(), "<robot name=\"&#xe9;\">");
  program::write_file(scratch.path / "aristo.urdf", latin);
  EXPECT_EQ(fault(whole.dump()), (scratch.path / "aristo.urdf").string() +
                                     R"(: robot \xe9: the name has a control character, or is not UTF-8)");
}

// urdfdom's parser recurses, and is quadratic, in what these limits bound; they are checked before it reads.
TEST_F(BadCells, XmlIsLimitedInDepthAndNumbers) {
  const auto inside = [&](const std::string& xml) {
    return urdf_fault("<link name=\"Base\"/>", "<link name=\"Base\">" + xml + "</link>");
  };
  const auto nested = [](std::size_t levels) {
    std::string xml;
    for (std::size_t i = 0; i < levels; ++i) xml += "<x>";
    for (std::size_t i = 0; i < levels; ++i) xml += "</x>";
    return xml;
  };
  const auto repeated = [](std::size_t count, const auto& piece) {
    std::string xml;
    for (std::size_t i = 0; i < count; ++i) xml += piece(std::to_string(i));
    return xml;
  };
  EXPECT_EQ(inside(nested(62)), "");
  const std::string deep = "elements are nested in more than 64 levels";
  EXPECT_EQ(inside(nested(63)), "line 9: " + deep);
  EXPECT_EQ(inside(nested(500'000)), "line 9: " + deep);
  EXPECT_EQ(urdf_fault("</robot>", repeated(200'000, [](const std::string&) { return "<a>"; })).substr(9), deep);
  const auto attribute = [](const std::string& number) { return " a" + number + "=\"\""; };
  EXPECT_EQ(inside("<x" + repeated(64, attribute) + "/>"), "");
  EXPECT_EQ(inside("<x" + repeated(65, attribute) + "/>"), "line 9: an element has more than 64 attributes");
  EXPECT_EQ(inside(repeated(100'000, [](const std::string&) { return "<x/>"; })),
            "line 9: there are more than 100000 elements");
  EXPECT_EQ(urdf_fault("</robot>",
                       repeated(2'000, [](const std::string& i) { return "<link name=\"l" + i + "\"/>"; }) + "</robot>")
                .substr(9),
            "there are more than 2000 links, joints and other named elements");
}

// Sizes in metres become half above and half below the origin in mm, turned and moved.
TEST_F(BadCells, UrdfBoxesAndCylindersArePartsOfTheirLink) {
  ASSERT_EQ(
      urdf_fault("<link name=\"Base\"/>",
                 "<link name=\"Base\"><visual><geometry><sphere radius=\"1\"/></geometry></visual>"
                 "<collision name=\"foot\"><origin xyz=\"0 0 0.05\" rpy=\"1.5707963267948966 0 0\"/>"
                 "<geometry><box size=\"0.2 0.1 0.3\"/></geometry></collision>"
                 "<collision><geometry><cylinder radius=\"0.025\" length=\"0.4\"/></geometry></collision></link>"),
      "");
  whole["robot"]["links"].erase("Base");
  program::write_file(scratch.path / "cell.json", whole.dump());
  const Cell cell = read_cell(scratch.path / "cell.json");
  const std::vector<Part>& parts = cell.robot.links[0].parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "foot");
  EXPECT_EQ(parts[1].name, "collision1");
  const Eigen::AlignedBox3d foot = bounds_of(parts[0].solid), rod = bounds_of(parts[1].solid);
  EXPECT_EQ(foot.min(), Eigen::Vector3d(-100, -150, 0));
  EXPECT_EQ(foot.max(), Eigen::Vector3d(100, 150, 100));
  EXPECT_EQ(rod.min(), Eigen::Vector3d(-25, -25, -200));
  EXPECT_EQ(faces_of(parts[0].solid, "foot").volume, 200.0 * 100 * 300);
  EXPECT_EQ(faces_of(parts[1].solid, "rod").faces.size(), 26U);
}

TEST_F(BadCells, WhatIsOutOfReachIsNamed) {
  const std::string machine = fault("/machine/radius", 2000);
  EXPECT_TRUE(machine.starts_with("machine.radius: too far: material in slot \"vice\" is ")) << machine;
  EXPECT_NE(machine.find(" from the second joint (shifted by "), std::string::npos) << machine;  // a level hand
  const std::string storage = fault("/storage/height", 1600);
  EXPECT_TRUE(storage.starts_with("storage.radius: too far: material in slot \"A\" is ")) << storage;
  // A hand of 1000 cannot be brought near to the shoulder by an arm of 738.
  json changed = whole;
  changed["robot"]["coupling"].erase(1);  // a level hand hangs below, wherever the arm is
  changed["gripper"]["sphere"]["at"] = {0, 0, -1000};
  changed["storage"]["radius"] = 100;
  changed["storage"]["height"] = 300;
  const std::string near = fault(changed.dump());
  EXPECT_TRUE(near.starts_with("storage.radius: too near: ")) << near;
  EXPECT_NE(near.find(" from the second joint, where "), std::string::npos) << near;
}

TEST_F(BadCells, LabelsAreOfWhatIsThereAndCoverAllNumbers) {
  EXPECT_EQ(fault("/labels/storage.hight", "C"), "labels.storage.hight: there is no value of this path");
  EXPECT_EQ(fault("/labels/storage", "X"), "labels.storage: must be \"T\", \"S\", \"D\" or \"C\"");
  EXPECT_EQ(fault("/labels/material", nullptr), "labels: nothing is said of where material.drop comes from");
}

}  // namespace
}  // namespace touchstone::cell
