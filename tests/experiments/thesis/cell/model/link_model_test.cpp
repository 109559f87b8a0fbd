// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's model files: nothing is lost, and what is wrong is named with its line.
#include "experiments/thesis/cell/model/link_model.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "experiments/program/output.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::cell {
namespace {

LinkModel read(const std::string& text) {
  const run_tests::Scratch scratch;
  program::write_file(scratch.path / "Axis1.txt", text);
  return read_link_model(scratch.path / "Axis1.txt");
}

/// What the text is refused for, from the line on.
std::string fault_of_model(const std::string& text) {
  const run_tests::Scratch scratch;
  const std::string path = (scratch.path / "Axis1.txt").string();
  program::write_file(path, text);
  return run_tests::after_file(path, run_tests::message_of<BrokenMesh>([&] { return read_link_model(path); }));
}

rc::Gen<double> finite_doubles() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
      [](double x) { return std::isfinite(x); });
}

rc::Gen<std::vector<std::uint32_t>> loops(std::uint32_t vertices) {
  return rc::gen::resize(
      6, rc::gen::suchThat(rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, vertices)),
                           [](const auto& loop) { return loop.size() >= 3; }));
}

LinkPart random_part() {
  LinkPart part;
  part.name = *rc::gen::element<std::string>("body", "a-b", "3", "Link", "Hole", "\xC3\xA4");
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 6);
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const double x = *finite_doubles(), y = *finite_doubles(), z = *finite_doubles();
    part.vertices.emplace_back(x, y, z);
  }
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    LinkPolygon polygon{*loops(vertices), {}};
    for (int k = *rc::gen::inRange(0, 3); k > 0; --k) polygon.holes.push_back(*loops(vertices));
    part.polygons.push_back(polygon);
  }
  return part;
}

RC_GTEST_PROP(LinkModelFile, IsReadAsItWasWrittenAndWrittenAsItWasRead, ()) {
  LinkModel model{"Axis1", {}};
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) model.parts.push_back(random_part());
  const std::string text = link_model_text(model);
  const LinkModel again = read(text);
  RC_ASSERT(again == model);
  RC_ASSERT(link_model_text(again) == text);  // the sign of zero, too
}

constexpr const char* kPlate =
    "# a plate with a hole\n"
    "Link  Gripper1\n"
    "Parts 1\n"
    "\n"
    "Part plate   # its only part\n"
    "Vertices 7\n"
    "0 0 0\n4 0 0\n0 4 0\r\n1 1 0\n2 1 0\n1 2 0\n+1e1 -0 .5\n"
    "Polygons 2\n"
    "3 0 1 2 Hole 3 3 4 5\n"
    "3 0 1 6\n";

TEST(LinkModelFile, HoldsPartsVerticesPolygonsAndHoles) {
  const LinkModel model = read(kPlate);
  EXPECT_EQ(model.name, "Gripper1");
  ASSERT_EQ(model.parts.size(), 1U);
  EXPECT_EQ(model.parts[0].name, "plate");
  EXPECT_EQ(model.parts[0].vertices.back(), Eigen::Vector3d(10, 0, 0.5));
  EXPECT_TRUE(std::signbit(model.parts[0].vertices.back().y()));
  EXPECT_EQ(model.parts[0].polygons, (std::vector<LinkPolygon>{{{0, 1, 2}, {{3, 4, 5}}}, {{0, 1, 6}, {}}}));
}

TEST(LinkModelFile, EveryFaultIsNamedWithItsLine) {
  const std::string head = "Link A\nParts 1\nPart p\nVertices 3\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(fault_of_model(""), "line 1: the file is truncated: expected 'Link'");
  EXPECT_EQ(fault_of_model("Robot A\n"), "line 1: expected 'Link', found 'Robot'");
  EXPECT_EQ(fault_of_model("Link\n"), "line 1: a name is expected after 'Link'");
  EXPECT_EQ(fault_of_model("Link A B\n"), "line 1: expected the end of the line, found 'B'");
  EXPECT_EQ(fault_of_model("Link A\nParts -1\n"), "line 2: the count -1 is negative");
  EXPECT_EQ(fault_of_model("Link A\nParts 1.5\n"), "line 2: '1.5' is not a count");
  EXPECT_EQ(fault_of_model("Link A\nParts 2\nPart p\nVertices 0\nPolygons 0\n"),
            "line 5: the file is truncated: expected 'Part'");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 2\n0 0 0\n"),
            "line 5: the file is truncated: vertex 1 of 2 is missing");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 1\n0 0\n"),
            "line 5: expected three numbers for a vertex, found 2");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 1\n0 0 0 0\n"),
            "line 5: expected the end of the line, found '0'");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 1\n0 x 0\n"), "line 5: 'x' is not a number");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 1\n0 1e999 0\n"),
            "line 5: '1e999' is not a finite double");
  EXPECT_EQ(fault_of_model("Link A\nParts 1\nPart p\nVertices 1\n0 nan 0\n"), "line 5: 'nan' is not a finite double");
  EXPECT_EQ(fault_of_model(head + "0 0 1\n"), "line 8: expected 'Polygons', found '0'");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n"), "line 8: the file is truncated: polygon 0 of 1 is missing");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n2 0 1\n"), "line 9: a loop needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1\n"), "line 9: expected 3 vertex numbers, found 2");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1 3\n"),
            "line 9: vertex 3 is out of range: the part has 3 vertices, numbered from 0");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1 -1\n"),
            "line 9: vertex -1 is out of range: the part has 3 vertices, numbered from 0");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1 2 0\n"),
            "line 9: expected 'Hole' or the end of the line, found '0'");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1 2 Hole\n"), "line 9: expected a count, found the end of the line");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n3 0 1 2\n3 0 1 2\n"),
            "line 10: the file continues after the announced counts");
  EXPECT_EQ(fault_of_model(head + "Polygons 1\n9223372036854775807 0 1 2\n"),
            "line 9: expected 9223372036854775807 vertex numbers, found 3");
  EXPECT_THROW((void)read_link_model("/nowhere/Axis1.txt"), BrokenMesh);
}

TEST(LinkModelFile, ANameIsOneWord) {
  for (const char* const name : {"", "two words", "a#b", "a\tb", "a\n", "a\x01", "a\x7f", "a\xff", "\xe9"})
    EXPECT_THROW((void)link_model_text({name, {}}), std::invalid_argument) << name;
  EXPECT_EQ(fault_of_model(std::string("Link A\nParts 1\nPart a") + '\0' + "b\n"),
            "line 3: the name 'a\\x00b' has a control character, or is not UTF-8");
  EXPECT_EQ(fault_of_model("Link \xff\xfe\nParts 0\n"),
            "line 1: the name '\\xff\\xfe' has a control character, or is not UTF-8");
  EXPECT_THROW((void)link_model_text({"A", {{"b c", {}, {}}}}), std::invalid_argument);
  EXPECT_EQ(link_model_text({"\xc3\xa9", {}}), "Link \xc3\xa9\nParts 0\n");
}

}  // namespace
}  // namespace touchstone::cell
