// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

#include "geometry/io/read_mesh.h"
#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

const std::string kFacet =
    "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

const std::string kBinaryFacet = binary_facet({0, 0, 0, 1, 0, 0, 0, 1, 0});

TEST(ReadStl, EachFacetOfTextMakesThreeNewVertices) {
  const Mesh mesh = read(".stl", "solid part with a name\n" + kFacet + kFacet + "endsolid part with a name\n");
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(mesh.vertices[4], Eigen::Vector3d(1, 0, 0));
}

TEST(ReadStl, ReadsDoublesFromText) {
  const Mesh mesh = read(
      ".stl",
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0.1 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid");
  EXPECT_EQ(mesh.vertices[0][0], 0.1);
}

TEST(ReadStl, ReadsTextInAnyCaseIndentedAndOfSeveralSolids) {
  const std::string solid =
      "\n  SOLID A\r\n\tFacet Normal 0 0 1\r\n Outer Loop\r\n  Vertex 0 0 0\r\nVERTEX 1 0 0\r\nvertex 0 1 "
      "0\r\nEndLoop\r\nEndFacet\r\nENDSOLID\r\n";
  EXPECT_EQ(read(".stl", solid + solid).faces, (Faces{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_TRUE(read(".stl", "solid nothing\nendsolid nothing\n").faces.empty());
}

TEST(ReadStl, ReadsBinaryFloatsAsTheSameDoubles) {
  const Mesh mesh =
      read(".stl", binary_stl("made by hand", 2, kBinaryFacet + binary_facet({0.1f, 2, 3, 4, 5, 6, 7, 8, 9.5f})));
  EXPECT_EQ(points(mesh),
            (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {static_cast<double>(0.1f), 2, 3}, {4, 5, 6}, {7, 8, 9.5}}));
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {3, 4, 5}}));
}

TEST(ReadStl, TellsBinaryFromTextByTheContent) {
  EXPECT_EQ(read(".stl", binary_stl("solid but binary", 1, kBinaryFacet)).faces.size(), 1u);
  EXPECT_EQ(read(".stl", binary_stl("solid " + std::string(74, ' '), 1, kBinaryFacet)).faces.size(), 1u);
  EXPECT_EQ(read(".stl", binary_stl("solid", 0, "")).faces.size(), 0u);
  EXPECT_EQ(fault(".stl", binary_stl("solid", 2, kBinaryFacet)),
            "byte 134: the file is truncated: facet 1 of 2 is not complete");
}

TEST(ReadStl, RefusesBinaryOfAnotherSizeThanItsCountPromises) {
  const std::string whole = binary_stl("", 2, kBinaryFacet + kBinaryFacet);
  EXPECT_EQ(fault(".stl", whole.substr(0, whole.size() - 1)),
            "byte 134: the file is truncated: facet 1 of 2 is not complete");
  const std::string plain = binary_stl("", 1, kBinaryFacet.substr(0, 48) + std::string(2, '\0'));
  EXPECT_EQ(fault(".stl", plain + "ab"), "byte 134: 2 bytes left over after the elements that the counts declare");
  EXPECT_EQ(fault(".stl", whole.substr(0, 50)), "byte 50: the file is truncated within its header of 84 bytes");
  EXPECT_EQ(skip(".stl", whole.substr(0, 150)).mesh.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadStl, AbsurdCountsCostNothing) {
  const ReadMesh result = skip(".stl", binary_stl("", 4294967295u, kBinaryFacet));
  EXPECT_EQ(result.mesh.faces.size(), 1u);
  EXPECT_EQ(result.left_out, (Sentences{"byte 134: the file is truncated: facet 1 of 4294967295 is not complete"}));
}

TEST(ReadStl, NamesTheByteOfABinaryVertexThatIsNotFinite) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::string file =
      binary_stl("", 3, kBinaryFacet + binary_facet({0, 0, 0, 0, infinity, 0, 0, 0, 0}) + kBinaryFacet);
  EXPECT_EQ(fault(".stl", file), "byte 158: a coordinate is not a finite number");
  const ReadMesh result = skip(".stl", file);
  EXPECT_EQ(result.mesh.vertices.size(), 6u);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(result.left_out, (Sentences{"byte 158: a coordinate is not a finite number"}));
}

TEST(ReadStl, RefusesWrongText) {
  const std::string begin = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(fault(".stl", begin + "vertex 1 0\n"), "line 5: expected three numbers after 'vertex', found 2");
  EXPECT_EQ(fault(".stl", begin + "vertex 1 0 0 0\n"), "line 5: expected three numbers after 'vertex', found more");
  EXPECT_EQ(fault(".stl", begin + "vertex 1 0 o\n"), "line 5: 'o' is not a number");
  EXPECT_EQ(fault(".stl", begin + "endloop\nendfacet\nendsolid\n"), "line 2: a facet has 3 vertices, this one has 1");
  EXPECT_EQ(fault(".stl", begin + "vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"),
            "line 2: a facet has 3 vertices, this one has 4");
  EXPECT_EQ(fault(".stl", begin + "endfacet\n"), "line 5: expected 'endloop', found 'endfacet'");
  EXPECT_EQ(fault(".stl", begin), "line 4: the file is truncated: expected 'endloop'");
  EXPECT_EQ(fault(".stl", "solid\n"), "line 1: the file is truncated: expected 'facet' or 'endsolid'");
  EXPECT_EQ(fault(".stl", "solid\ncolour\nendsolid\n"), "line 2: expected 'facet' or 'endsolid', found 'colour'");
  EXPECT_EQ(fault(".stl", "solid\nendsolid\nfacet\n"), "line 3: expected 'solid', found 'facet'");
}

TEST(ReadStl, ReadsWordsOnWhateverLines) {
  const std::string vertices = "vertex 0 0 0 vertex 1 0 0 vertex\n0\n1 0 ";
  const std::string glued = "facet normal 0 0 1 outer loop " + vertices + "endloop endfacet ";
  const std::string apart = "facet outer\nloop " + vertices + "end loop\nEnd Facet ";
  for (const std::string& text :
       {"solid a plate " + glued + apart + "endsolid a plate", "solid\n" + apart + "\n" + glued + "end solid\n",
        "solid a " + glued + "endsolid a solid b " + glued + "endsolid b",
        "solid facet of a solid\n" + glued + "endsolid solid\nsolid\n" + apart + "endsolid"})
    EXPECT_EQ(read(".stl", text).faces, (Faces{{0, 1, 2}, {3, 4, 5}})) << text;
}

// What stands between solids and before facets is a name or a normal, and nothing that only a facet has.
TEST(ReadStl, PassesNoFacetOverAsANameOrANormal) {
  const std::string facet = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
  const std::string typing_error = "facet normal 0 0 1 oute" + facet.substr(24);
  for (const std::string& text :
       {"solid a " + typing_error + facet + "endsolid a", "solid a face" + facet.substr(5) + facet + "endsolid a",
        "solid a facet" + facet.substr(12) + facet + "endsolid a",
        "solid a " + facet + "endsolid a " + facet + "endsolid a",
        "solid a " + facet + "endsolid a sold b " + facet + "endsolid b"})
    EXPECT_NE(fault(".stl", text), "no fault") << text;
  for (const std::string name : {"my solid facets", "facet normal test", "outer shell", "vertex"})
    EXPECT_EQ(read(".stl", "solid " + name + "\n" + facet + "\nendsolid " + name + "\n").faces.size(), 1u) << name;
  EXPECT_EQ(read(".stl", "solid\nfacet\nnormal\n0 0\n1\nouter\n" + facet.substr(25) + "end\nsolid").faces.size(), 1u);
}

// A search of the rest of the line at each word would take minutes.
TEST(ReadStl, ReadsALongNameInLinearTime) {
  std::string name;
  for (int i = 0; i < 300'000; ++i) name += " facet normal";
  const std::string facet = "\nfacet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n";
  EXPECT_EQ(read(".stl", "solid" + name + facet + "endsolid").faces.size(), 1u);
}

TEST(ReadStl, WarnsOfALastEndThatIsMissing) {
  const std::string whole = "solid a\n" + kFacet + "endsolid a\n" + "solid b\n" + kFacet + kFacet;
  EXPECT_EQ(warnings(".stl", whole), (Sentences{"line 24: the last 'endsolid' is missing"}));
  EXPECT_EQ(warnings(".stl", whole + "endsolid"), Sentences{});
  EXPECT_NE(fault(".stl", whole + "facet"), "no fault");
}

// The attribute counts of other programs are colours; that of the fixture is.
TEST(ReadStl, ReadsWhatAttributeCountsAnnounceIfTheFileIsAsLong) {
  const auto facet = [](std::uint16_t announced) {
    return kBinaryFacet.substr(0, 48) + bytes(announced) + std::string(announced, 'x');
  };
  const std::string whole = binary_stl("", 3, facet(4) + facet(0) + facet(60));
  EXPECT_EQ(read(".stl", whole).faces.size(), 3u);
  for (const std::string& broken : {whole.substr(0, whole.size() - 1), whole + "x"}) {
    EXPECT_EQ(fault(".stl", broken),
              "byte 134: the size of the file fits neither its count nor the 4 bytes announced after facet 0");
    EXPECT_EQ(skip(".stl", broken).mesh.faces.size(), 1u);
  }
}

TEST(ReadStl, PrefersWhatAttributeCountsAnnounceToBlankBytes) {
  const std::string first = kBinaryFacet.substr(0, 48) + bytes(std::uint16_t{10}) + "payload123";
  const std::string second = binary_facet({5, 0, 0, 5, 1, 0, 6, 0, 0}).substr(0, 48) + bytes(std::uint16_t{0});
  EXPECT_EQ(points(read(".stl", binary_stl("", 2, first + second)))[3], (std::array<double, 3>{5, 0, 0}));
}

TEST(ReadStl, WarnsOfBlankBytesAfterBinaryFacets) {
  EXPECT_EQ(warnings(".stl", binary_stl("", 1, kBinaryFacet) + "\r\n"),
            (Sentences{"byte 134: 2 blank bytes left over after the elements that the counts declare"}));
}

TEST(ReadStl, SkipGoesOnWithTheNextFacet) {
  const std::string wrong_vertex = "facet\nouter loop\nvertex 0 0 0\nvertex 0 0 x\nvertex 0 0 0\nendloop\nendfacet\n";
  const std::string no_end = "facet\nouter loop\n";
  const std::string stray = "colour\n";
  const ReadMesh result =
      skip(".stl", "solid\n" + wrong_vertex + kFacet + no_end + stray + kFacet + stray + kFacet + no_end);
  EXPECT_EQ(result.mesh.vertices.size(), 9u);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}));
  EXPECT_EQ(result.left_out, (Sentences{"line 5: 'x' is not a number", "line 18: expected 'endloop', found 'colour'",
                                        "line 26: expected 'facet' or 'endsolid', found 'colour'",
                                        "line 35: the file is truncated: expected 'endloop'"}));
}

}  // namespace
}  // namespace touchstone::geometry_tests
