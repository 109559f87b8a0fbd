// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "geometry/io/read_mesh.h"
#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

const std::string kOffPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(ReadOff, ReadsVerticesAndPolygons) {
  const Mesh mesh = read(".off", "OFF\n5 2 0\n" + kOffPoints + "2 2 0\n3 3 1\n3 0 1 2\n5 4 3 2 1 0\n");
  EXPECT_EQ(mesh.vertices.size(), 5u);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {4, 3, 2, 1, 0}}));
}

TEST(ReadOff, ReadsCountsOnTheFirstLineWithOrWithoutEdgesOrTheWord) {
  for (const std::string header : {"OFF 3 1 3\n", "OFF\n3 1 3\n", "OFF\n3 1\n", "3 1 3\n"}) {
    expect_triangle(read(".off", header + kOffPoints + "3 0 1 2\n"));
  }
}

TEST(ReadOff, PassesOverCommentsAndBlankLines) {
  expect_triangle(read(
      ".off",
      "# before\nOFF # after\n\n#\n3 1 0 # counts\n0 0 0 # first\n\n1 0 0\r\n0 1 0\n# faces\n3 0 1 2 # red\n\n# end"));
}

TEST(ReadOff, PassesOverColoursAndNormals) {
  EXPECT_EQ(points(read(".off", "COFF\n1 0 0\n1 2 3 255 0 0 255\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(points(read(".off", "NOFF\n1 0 0\n1 2 3 nan nan nan\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(points(read(".off", "STCNOFF\n1 0 0\n1 2 3 0 0 1 1 0 0 1 0.5 0.5\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(read(".off", "OFF 3 2 0\n" + kOffPoints + "3 0 1 2 0.5 0.5 0\n3 2 1 0 7\n").faces,
            (Faces{{0, 1, 2}, {2, 1, 0}}));
}

TEST(ReadOff, ReadsHeadersInLowerCaseAndGluedToTheCounts) {
  for (const std::string header : {"off\n3 1 0\n", "OFF3 1 0\n", "off3 1\n"})
    expect_triangle(read(".off", header + kOffPoints + "3 0 1 2\n"));
  EXPECT_EQ(points(read(".off", "coff1 0 0\n1 2 3 255 0 0\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(fault(".off", "nOFF 4 1 0 0\n0 0 0 0\n"), "line 1: expected 'OFF', found 'nOFF'");
}

TEST(ReadOff, ReadsCountsOnSeveralLines) {
  for (const std::string counts : {"3 1\n0\n", "3\n1 0\n", "3\n1\n0\n", "3\n1\n"})
    expect_triangle(read(".off", "OFF\n" + counts + kOffPoints + "3 0 1 2\n"));
  EXPECT_EQ(fault(".off", "OFF 3 1 0 7\n" + kOffPoints + "3 0 1 2\n"), "line 1: unexpected numbers after the counts");
}

TEST(ReadOff, ReadsWordsWhereLinesDoNotHoldThePartsOneByOne) {
  const std::string twice = "3 0 1 2 3\n2 1 0";
  for (const std::string& points : {std::string("0 0 0 1 0 0\n0 1 0\n"), std::string("0\n0 0\n1 0 0 0 1 # here\n0\n")})
    EXPECT_EQ(read(".off", "OFF 3 2 0\n" + points + twice).faces, (Faces{{0, 1, 2}, {2, 1, 0}})) << points;
  // With colours, and as many lines as there are parts.
  EXPECT_EQ(read(".off", "OFF 4 2 0\n0 0 0 1 0 0 0 1 0 0 0 1\n3 0 1 2 255 0 0\n3 2 1 3 255 0 0\n").faces,
            (Faces{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(read(".off", "OFF 7 1 0\n0 0 0 4 0 0\n5 2 0\n4 4 0\n2 5 0\n0 4 0\n-1 2 0\n7 0 1 2\n3 4 5 6\n").faces,
            (Faces{{0, 1, 2, 3, 4, 5, 6}}));
  // Words that do not fill the file are not taken for others.
  EXPECT_EQ(fault(".off", "OFF 3 2 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2 3 2 1 0 7\n"),
            "line 3: a vertex has 3 numbers, the first one has 6");
}

TEST(ReadOff, ReadsAFileOnOneLine) {
  const std::string parts = "0 0 0 1 0 0 0 1 0 3 0 1 2";
  for (const std::string& content :
       std::vector<std::string>{"OFF 3 1 0 " + parts, "OFF\n3 1 0 " + parts + "\n", "OFF\n3 1 0\n" + parts + " 9\n",
                                "COFF 3 1 0 0 0 0 9 9 9 1 0 0 9 9 9 0 1 0 9 9 9 3 0 1 2"})
    expect_triangle(read(".off", content));
  EXPECT_EQ(fault(".off", "OFF 3 1 " + parts), "line 1: unexpected numbers after the counts");
  EXPECT_EQ(fault(".off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0\n1 2\n"), "line 1: unexpected numbers after the counts");
}

// On lines, a vertex may have other numbers than those that the header announces; among words it may not.
TEST(ReadOff, ReadsColoursAndNormalsAmongWords) {
  const std::string faces = "3 0 1 2\n";
  expect_triangle(read(".off", "COFF\n3 1 0\n0 0 0 9 9 9 1 0 0 9 9 9\n0 1 0 9 9 9\n" + faces));
  expect_triangle(read(".off", "COFF\n3 1 0\n0 0 0 9 9 9 255 1 0 0 9 9 9 255\n0 1 0 9 9 9 255\n" + faces));
  expect_triangle(read(".off", "NOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 0 0 1\n0 1 0 0 0 1\n" + faces));
  expect_triangle(read(".off", "STOFF\n3 1 0\n0 0 0 .5 1 1 0 0 .5 1\n0 1 0 .5 1\n3 0 1\n2 255 0 0\n"));
  expect_triangle(
      read(".off", "STCNOFF 3 1 0\n0 0 0 0 0 1 9 9 9 .5 1\n1 0 0 0 0 1 9 9 9\n.5 1 0 1 0 0 0 1 9 9 9 .5 1\n3 0 1 2\n"));
  EXPECT_EQ(fault(".off", "COFF\n3 1 0\n0 0 0 9 9 1 0 0 9 9\n0 1 0 9 9\n" + faces),
            "line 4: a vertex has 5 numbers, the first one has 10");
}

TEST(ReadOff, RefusesNumbersThatCanBeReadInTwoWays) {
  EXPECT_EQ(fault(".off", "OFF\n4 2 0\n0 0 0 1 0 0 1 1 0 0 1 0\n3 0 1 2 5\n3 0 2 3 1\n"),
            "line 2: the numbers after the counts can be read in two ways");
}

// A count that is wrong makes a vertex of a face, or a face of the end of another.
TEST(ReadOff, RefusesLinesThatAreNotAlike) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  EXPECT_EQ(fault(".off", "OFF\n5 3 0\n" + points + faces), "line 7: a vertex has 4 numbers, the first one has 3");
  EXPECT_EQ(fault(".off", "OFF\n4 1 0\n" + points + "3 0 1 2 1 2 3 4 5\n"),
            "line 7: 5 numbers after a face are not a colour");
}

TEST(ReadOff, LeavesOutAFaceAmongWordsThatUsesAVertexThatIsNotFinite) {
  const ReadMesh result = skip(".off", "OFF 4 2 0\n0 0 0 1 0 0\n0 1 0 nan 0 0\n3 0 1 2 3 0 1 3\n");
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 4: the face uses vertex 3, whose coordinates (line 3) are not finite doubles"}));
}

// As some compilers print what is no number.
TEST(ReadOff, BeginsCommentsAtTheStartOfAWordOnly) {
  EXPECT_EQ(fault(".off", "OFF 1 0 0\n0 0 -1.#IND00\n"), "line 2: '-1.#IND00' is not a number");
}

TEST(ReadOff, RefusesABadHeader) {
  EXPECT_EQ(fault(".off", "FOO\n1 0 0\n"), "line 1: expected 'OFF', found 'FOO'");
  EXPECT_EQ(fault(".off", "4OFF\n1 0 0\n"), "line 1: expected 'OFF', found '4OFF'");
  EXPECT_EQ(fault(".off", "OFF BINARY\n"), "line 1: 'BINARY' is not a count");
  EXPECT_EQ(fault(".off", "OFF\n3\n"), "line 2: expected a count, found the end of the line");
  EXPECT_EQ(fault(".off", "OFF\n-3 1 0\n"), "line 2: the count -3 is negative");
  EXPECT_EQ(fault(".off", "OFF\n3 99999999999999999999 0\n"), "line 2: '99999999999999999999' is not a count");
  EXPECT_EQ(fault(".off", "OFF\n\n"), "line 2: the file is truncated: the counts of vertices and faces are missing");
}

TEST(ReadOff, RefusesAWrongCount) {
  EXPECT_EQ(fault(".off", "OFF 4 0 0\n" + kOffPoints), "line 4: the file is truncated: vertex 3 of 4 is missing");
  EXPECT_EQ(fault(".off", "OFF 3 2 0\n" + kOffPoints + "3 0 1 2\n"),
            "line 5: the file is truncated: face 1 of 2 is missing");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "3 0 1 2\n3 0 1 2\n"),
            "line 6: unexpected data after the elements that the counts declare");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "4 0 1 2\n"), "line 5: expected 4 vertex numbers, found 3");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "-3 0 1 2\n"), "line 5: the count -3 is negative");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "-9223372036854775808 0 1 2\n"),
            "line 5: the count -9223372036854775808 is negative");
}

TEST(ReadOff, RefusesAWrongFace) {
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "3 0 1 3\n"),
            "line 5: vertex 3 is out of range: 3 vertices were read, numbered from 0");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "3 0 1 -1\n"),
            "line 5: vertex -1 is out of range: 3 vertices were read, numbered from 0");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "2 0 1\n"),
            "line 5: a face needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "3 0 1 1.5\n"), "line 5: '1.5' is not a vertex number");
}

TEST(ReadOff, AbsurdCountsCostNothing) {
  const std::string header = "OFF 3 1000000000000 0\n" + kOffPoints + "3 0 1 2\n";
  EXPECT_EQ(fault(".off", header), "line 5: the file is truncated: face 1 of 1000000000000 is missing");
  EXPECT_EQ(fault(".off", "OFF 1000000000000 1 0\n0 0 0\n"),
            "line 2: the file is truncated: vertex 1 of 1000000000000 is missing");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "1000000000000 0 1 2\n"),
            "line 5: expected 1000000000000 vertex numbers, found 3");
  EXPECT_EQ(skip(".off", header).mesh.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadOff, SkipLeavesOutWrongLinesAndKeepsWhatCameBeforeTheEnd) {
  const ReadMesh result = skip(".off", "OFF 4 4 0\n0 0 0\n1 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 x\n3 0 2 3\n");
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 2, 3}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 7: 'x' is not a vertex number", "line 8: the file is truncated: face 3 of 4 is missing",
                       "line 6: the face uses vertex 1, whose coordinates (line 3) are not finite doubles"}));
}

}  // namespace
}  // namespace touchstone::geometry_tests
