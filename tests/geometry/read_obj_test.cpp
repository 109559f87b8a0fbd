// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "geometry/io/read_mesh.h"
#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

constexpr std::string_view kObjTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kObj{kObjTriangle};

TEST(ReadObj, ReadsTheVertexOfEachFormOfCorner) {
  const Mesh mesh =
      read(".obj", kObj + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 3/1 2/1 1/1\nf 1/1/1 2/1/1 3/1/1\nf 3//1 1//1 2//1\n");
  EXPECT_EQ(points(mesh), kTrianglePoints);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {2, 1, 0}, {0, 1, 2}, {2, 0, 1}}));
}

TEST(ReadObj, CountsNegativeIndicesFromTheLastVertexSoFar) {
  EXPECT_EQ(read(".obj", kObj + "f -3 -2 -1\nv 5 5 5\nf -1/-1 -2/-1 -3/-1\n").faces, (Faces{{0, 1, 2}, {3, 2, 1}}));
}

TEST(ReadObj, KeepsAFaceOfFiveVerticesAsOnePolygon) {
  EXPECT_EQ(read(".obj", kObj + "v 2 2 0\nv 3 3 1\nf 5 4 3 2 1\n").faces, (Faces{{4, 3, 2, 1, 0}}));
}

TEST(ReadObj, JoinsALineThatEndsWithABackslash) {
  const Mesh mesh = read(".obj", "v 0 0 \\\n0\nv 1 \\\r\n0 \\\r\n0\nv 0 1 0\nf 1 2\\\n 3\nf 3 2 1\\");
  EXPECT_EQ(points(mesh), kTrianglePoints);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {2, 1, 0}}));
}

TEST(ReadObj, NamesTheLineOfAWordOnAContinuedOneAndCountsThemAll) {
  EXPECT_EQ(fault(".obj", "v 0 \\\n0 \\\nx\n"), "line 3: 'x' is not a number");
  EXPECT_EQ(fault(".obj", "v 0 \\\nx \\\n0\n"), "line 2: 'x' is not a number");
  EXPECT_EQ(fault(".obj", "v 0 0 0 1 0 \\\n0 red\n"), "line 2: 'red' is not a number");
  EXPECT_EQ(fault(".obj", "v 0 0 0 2 \\\n0 0 0\n"), "line 1: the weight of a vertex must be 1");
  EXPECT_EQ(fault(".obj", "surf 0 1 \\\n0 1\n"), "line 1: 'surf' is not read: only polygons are");
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 \\\n3 \\\nx\n"), "line 6: 'x' is not a corner of a face");
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 3\nf 1 \\\n 2 9 \\\n3\n"),
            "line 6: vertex 9 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(fault(".obj", kObj + "f 1 \\\n0 2\n"),
            "line 5: vertex 0 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(read_mesh(kObj + "f 3 2 1\nf 1 2 \\\n3\n", "obj", "memory").places[1].number, 5U);
  EXPECT_EQ(fault(".obj", "v 0 \\\n0 \\\n0\nv x 0 0\n"), "line 4: 'x' is not a number");
}

// A path of Windows in a comment must not swallow the vertex after it.
TEST(ReadObj, DoesNotContinueComments) {
  EXPECT_EQ(points(read(".obj", "# C:\\models\\\nv 1 2 3 # here\\\nv 4 5 6\n")), (Points{{1, 2, 3}, {4, 5, 6}}));
}

TEST(ReadObj, TakesTheFirstThreeOfAVertexWithAColourOrTheWeightOne) {
  EXPECT_EQ(points(read(".obj", "v 1 2 3 1.0\nv 4 5 6 0 0 0.25\n\tv\t7  8\t9 \n")),
            (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(points(read(".obj", "v 1 2 3 1 0.5 0.5 0.5\n")), (Points{{1, 2, 3}}));
  for (const std::string more : {"2", "2 0 0 0"})
    EXPECT_EQ(fault(".obj", "v 1 2 3 " + more + "\n"), "line 1: the weight of a vertex must be 1");
  for (const std::string more : {"1 0", "1 0 0 0 0"})
    EXPECT_EQ(fault(".obj", "v 1 2 3 " + more + "\n"),
              "line 1: a vertex has a weight, a colour of three numbers, or both");
}

TEST(ReadObj, ContinuesLinesOfGeometryAlone) {
  const Mesh mesh =
      read(".obj", "g C:\\work\\\nv 0 0 0\nusemtl walls\\ \nv 1 0 \\ \t\n0\nvt 0 \\\n0\nv 0 1 0\nf 1 2 \\ \n3\n");
  EXPECT_EQ(points(mesh), kTrianglePoints);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
}

// Without a number they can be no vertex and no face, whatever the case of a keyword.
TEST(ReadObj, ContinuesNamesOnLinesWithoutAKeywordAndANumber) {
  EXPECT_EQ(read(".obj", kObj + "g wheel \\\nleft \\ \nfront\nmtllib a.mtl \\\nb.mtl\nf 1 2 3\n").faces,
            (Faces{{0, 1, 2}}));
  EXPECT_EQ(fault(".obj", kObj + "g wheel \\\nF 1 2 3\nf 1 2 3\n"), "line 5: 'F' is not an OBJ keyword");
  EXPECT_EQ(fault(".obj", kObj + "g wheel \\\nF 1/1 2/2 3/3\nf 1 2 3\n"), "line 5: 'F' is not an OBJ keyword");
  EXPECT_EQ(fault(".obj", kObj + "g wheel \\\n\nleft\nf 1 2 3\n"), "line 6: 'left' is not an OBJ keyword");
  EXPECT_EQ(fault(".obj", kObj + "g wheel \\\nleft\nfront\nf 1 2 3\n"), "line 6: 'front' is not an OBJ keyword");
  EXPECT_EQ(fault(".obj", kObj + "g wheel \\\ncall other.obj\nf 1 2 3\n"),
            "line 5: 'call' is not read, and the file that it names may hold vertices");
}

// A vertex that a faulty line swallowed would shift the numbers of all later ones.
TEST(ReadObj, SkipReadsNothingAfterAFaultOfAContinuedLine) {
  for (const std::string line : {"vt 0 0", "f 1 2 3", "v 0 0 0", "surf 0 1"})
    EXPECT_EQ(skip(".obj", kObj + "f 1 2 3\n" + line + " \\\nv 1 0 0\nf 3 2 1\n").mesh.faces, (Faces{{0, 1, 2}}))
        << line;
  EXPECT_EQ(skip(".obj", kObj + "unknown \\\nv 9 9 9\nf 1 2 4\n").mesh.faces, (Faces{{0, 1, 3}}));
}

TEST(ReadObj, BeginsCommentsAtTheStartOfAWordOnly) {
  EXPECT_EQ(fault(".obj", "v 0 0 -1.#IND00\n"), "line 1: '-1.#IND00' is not a number");
  EXPECT_EQ(points(read(".obj", "v 1 2 3 #4\n#v 4 5 6\n")), (Points{{1, 2, 3}}));
}

TEST(ReadObj, RefusesWordsAfterAVertex) {
  EXPECT_EQ(fault(".obj", "v 1 2 3 v 4 5 6\n"), "line 1: 'v' is not a number");
}

TEST(ReadObj, PassesOverLinesWithoutVertexOrFace) {
  const Mesh mesh = read(
      ".obj",
      "# a comment\nmtllib a.mtl\no part\ng group\nusemtl red#1\ns off\nl 1 2\np 1\nvp 1 1\nvn nan 0 0\nv 1 2 3\n");
  EXPECT_EQ(mesh.vertices.size(), 1u);
  EXPECT_TRUE(mesh.faces.empty());
}

// It may be a vertex or a face: in capitals, or behind a byte order mark between two files that were joined.
TEST(ReadObj, RefusesAWordThatItDoesNotKnow) {
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 3\nF 1 2 3\n"), "line 5: 'F' is not an OBJ keyword");
  EXPECT_EQ(fault(".obj", "\xEF\xBB\xBF" + kObj + "f 1 2 3\n\xEF\xBB\xBF" + kObj),
            "line 5: '\\xef\\xbb\\xbfv' is not an OBJ keyword");
  const ReadMesh result = skip(".obj", kObj + "colour red\nf 1 2 3\nV 1 2 3\nf 3 2 1\n");
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 4: 'colour' is not an OBJ keyword", "line 6: 'V' is not an OBJ keyword"}));
}

// A backslash too many, or a line end too few, puts a vertex or a face on such a line.
TEST(ReadObj, RefusesWordsAmongNumbersThatItDoesNotKeep) {
  EXPECT_EQ(fault(".obj", kObj + "vt 0 0 \\\nv 1 0 0\nf 1 2 3\n"), "line 5: 'v' is not a number");
  EXPECT_EQ(fault(".obj", kObj + "vn 0 0 1 f 1 2 3\nf 1 2 3\n"), "line 4: 'f' is not a number");
  EXPECT_EQ(fault(".obj", kObj + "l 1/1 2/2 v\nf 1 2 3\n"), "line 4: 'v' is not a number");
  EXPECT_EQ(read(".obj", kObj + "parm u 0 1 2\nl 1/1 -2/-2\nvn nan 0 0\nf 1 2 3\n").faces, (Faces{{0, 1, 2}}));
}

TEST(ReadObj, RefusesSurfacesThatAreNoPolygonsAndFilesThatItIncludes) {
  for (const std::string word : {"surf", "bzp", "bsp", "cdp"})
    EXPECT_EQ(fault(".obj", kObj + "f 1 2 3\n" + word + " 1\n"),
              "line 5: '" + word + "' is not read: only polygons are");
  EXPECT_EQ(fault(".obj", kObj + "call other.obj\nf 1 2 3\n"),
            "line 4: 'call' is not read, and the file that it names may hold vertices");
}

// Each word of the format's specification, in the order of its index.
TEST(ReadObj, KnowsTheWordsOfTheFormatThatSayNothingOfFaces) {
  for (const char* word :
       {"bevel",     "bmat", "c_interp", "cdc",    "con",  "csh",  "cstype",     "ctech",  "curv",  "curv2",
        "d_interp",  "deg",  "end",      "g",      "hole", "l",    "lod",        "maplib", "mg",    "mtllib",
        "o",         "p",    "parm",     "res",    "s",    "scrv", "shadow_obj", "sp",     "stech", "step",
        "trace_obj", "trim", "usemap",   "usemtl", "vn",   "vp",   "vt"})
    EXPECT_EQ(fault(".obj", std::string(word) + " 1\n"), "the file has no face") << word;
}

TEST(ReadObj, FacesMayNameVerticesThatComeLater) {
  EXPECT_EQ(read(".obj", "f 1 2 3\n" + kObj).faces, (Faces{{0, 1, 2}}));
}

TEST(ReadObj, RefusesAnIndexOutOfRange) {
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 4\n"),
            "line 4: vertex 4 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(fault(".obj", kObj + "f 0 1 2\n"),
            "line 4: vertex 0 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 -4\n"), "line 4: vertex -4 is out of range: 3 vertices come before it");
  EXPECT_EQ(fault(".obj", kObj + "f 1 2 4294967299\n"),
            "line 4: vertex 4294967299 is out of range: 3 vertices were read, numbered from 1");
}

TEST(ReadObj, RefusesAMalformedCorner) {
  for (const std::string corner : {"x", "/1", "1.5", "99999999999999999999", "1e0", "3/x", "3/3#4", "3/1/y", "3/1/1/1"})
    EXPECT_EQ(fault(".obj", kObj + "f 1 2 " + corner + "\n"), "line 4: '" + corner + "' is not a corner of a face");
}

TEST(ReadObj, RefusesAFaceOfFewerThanThreeVertices) {
  EXPECT_EQ(fault(".obj", kObj + "f 1 2\n"), "line 4: a face needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault(".obj", kObj + "f\n"), "line 4: a face needs at least 3 vertices, this one has 0");
}

// What is left keeps its order and is numbered again; a face that needs a vertex left out goes with it.
TEST(ReadObj, SkipLeavesOutWrongVerticesAndTheFacesThatNeedThem) {
  const ReadMesh result =
      skip(".obj", "v 0 0 0\nv 0 x 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 1 3\nf 4 3 9\nf -1 -2 -4\n");
  EXPECT_EQ(points(result.mesh), kTrianglePoints);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 2: 'x' is not a number", "line 7: a face needs at least 3 vertices, this one has 2",
                       "line 5: the face uses vertex 2, which was left out",
                       "line 8: vertex 9 is out of range: 4 vertices were read, numbered from 1"}));
}

}  // namespace
}  // namespace touchstone::geometry_tests
