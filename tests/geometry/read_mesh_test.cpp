// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/io/read_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

TEST(ReadMesh, NamesAFileThatIsNotThere) {
  try {
    (void)read_mesh("no/such/arm.stl", OnFault::Skip);
    FAIL();
  } catch (const BrokenMesh& broken) {
    EXPECT_TRUE(std::string(broken.what()).starts_with("no/such/arm.stl: cannot be opened")) << broken.what();
  }
}

TEST(ReadMesh, CannotOpenAFolder) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "ReadMesh.CannotOpenAFolder.obj";
  std::filesystem::create_directory(folder);
  EXPECT_THROW((void)read_mesh(folder), BrokenMesh);
  std::filesystem::remove(folder);
}

TEST(ReadMesh, NamesAnExtensionThatItDoesNotKnow) {
  const TemporaryFile file(".step", "");
  try {
    (void)read_mesh(file.path(), OnFault::Skip);
    FAIL();
  } catch (const BrokenMesh& broken) {
    EXPECT_EQ(
        after_file(file, broken.what()),
        "unknown extension '.step'; expected .obj, .off, .stl or .ply: a modelling program, such as Blender, exports other "
        "files as these");
  }
}

TEST(ReadMesh, KnowsTheExtensionInAnyCase) {
  EXPECT_EQ(read(".OBJ", "v 1 2 3\n").vertices.size(), 1u);
  EXPECT_EQ(read(".Off", "OFF\n0 0 0\n").vertices.size(), 0u);
}

TEST(ReadMesh, AnEmptyFileIsOfNoFormatButObj) {
  EXPECT_EQ(fault(".obj", ""), "the file has no face");
  EXPECT_EQ(fault(".off", ""), "line 1: the file is truncated: expected 'OFF'");
  EXPECT_EQ(fault(".stl", ""), "line 1: the file is truncated: expected 'solid'");
  EXPECT_EQ(fault(".ply", ""), "line 1: the file is truncated: its header has no 'end_header'");
}

TEST(ReadMesh, ReadsTheNearestDouble) {
  const Mesh mesh = read(".obj",
                         "v 0.1 +1.5 -2.5e-3\n"
                         "v 0.12345678901234567890 1. .5\n"
                         "v 9007199254740993 1.7976931348623158e308 1E2\n");
  EXPECT_EQ(points(mesh), (Points{{0.1, 1.5, -2.5e-3},
                                  {0.12345678901234567890, 1.0, 0.5},
                                  {9007199254740992.0, std::numeric_limits<double>::max(), 100.0}}));
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double coordinate_read(const std::string& number) { return read(".obj", "v 0 0 " + number + "\n").vertices[0][2]; }

TEST(ReadMesh, ReadsHexadecimalNumbers) {
  const Mesh mesh = read(".obj",
                         "v 0x1p+2 -0X1.8P-3 +0x10\n"
                         "v 0x.8 0x1.fffffffffffff7fp0 -0x1p-1074\n"
                         "v 0x1p-1076 0x0p99999 -0x0.000001p-1080\n");
  EXPECT_EQ(points(mesh), (Points{{4, -0.1875, 16}, {0.5, 0x1.fffffffffffffp0, -0x1p-1074}, {0, 0, 0}}));
  EXPECT_TRUE(std::signbit(mesh.vertices[2][2]));
  EXPECT_EQ(coordinate_read("-0x1p1024"), -kInfinity);
  EXPECT_EQ(coordinate_read("0x0.0001p1200"), kInfinity);
}

// Rounding to zero is not a fault; rounding to infinity is. Both are out of range for std::from_chars.
TEST(ReadMesh, ReadsNumbersCloseToZeroAsTheNearestDouble) {
  constexpr double kTiniest = std::numeric_limits<double>::denorm_min();
  const std::string zeros(400, '0');
  const Mesh mesh = read(".obj", "v 2.4e-324 2.5e-324 -1e-400\nv 1e-99999999999999999999 0." + zeros + "1 0." + zeros +
                                     "1e401\nv 0e99999999999999999999 1" + zeros + "e-800 1" + zeros + "e-400\n");
  EXPECT_EQ(points(mesh), (Points{{0, kTiniest, 0}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_TRUE(std::signbit(mesh.vertices[0][2]));
}

TEST(ReadMesh, RefusesFacesThatUseNumbersBeyondTheFiniteDoubles) {
  for (const std::string number : {"1e400", "-1.7976931348623159e308", "nan", "-inf", "1e99999999999999999999"}) {
    EXPECT_FALSE(std::isfinite(coordinate_read(number))) << number;
    EXPECT_EQ(fault(".obj", "v 0 0 0\nv 1 " + number + " 0\nv 0 1 0\n\nf 1 2 3\n"),
              "line 5: the face uses vertex 2, whose coordinates (line 2) are not finite doubles");
    EXPECT_EQ(fault(".off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 " + number + " 1\n3 0 1 2\n"),
              "line 5: the face uses vertex 2, whose coordinates (line 4) are not finite doubles");
    EXPECT_EQ(fault(".stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 " + number + "\nvertex 0 1 0\n"),
              "line 5: '" + number + "' is not a finite double");
  }
  EXPECT_FALSE(std::isfinite(coordinate_read("1" + std::string(400, '0'))));
}

// As of an organised scan. The others keep their numbers.
TEST(ReadMesh, KeepsVerticesThatNoFaceUsesWhateverTheyAre) {
  for (const OnFault on_fault : {OnFault::Refuse, OnFault::Skip}) {
    const ReadMesh result =
        read_mesh("v nan nan nan\nv 0 0 0\nv 1 0 0\nv inf 0 1e400\nv 0 1 0\nf 2 3 5\n", "OBJ", "scan", on_fault);
    EXPECT_EQ(result.mesh.vertices.size(), 5U);
    EXPECT_EQ(result.mesh.faces, (Faces{{1, 2, 4}}));
    EXPECT_EQ(result.parts_left_out, 0U);
  }
}

TEST(ReadMesh, ReadsTheContentOfAFileInMemory) {
  const std::string content = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_triangle(read_mesh(content, "obj", "memory").mesh);
  const auto fault_of = [](const std::string& bytes, const std::string& format) -> std::string {
    try {
      (void)read_mesh(bytes, format, "memory");
      return "no fault";
    } catch (const BrokenMesh& broken) {
      return broken.what();
    }
  };
  EXPECT_EQ(fault_of(content + "f 1 2 4\n", "obj"),
            "memory: line 5: vertex 4 is out of range: 3 vertices were read, numbered from 1");
  EXPECT_EQ(fault_of("", "obj"), "memory: the file has no face");
  EXPECT_EQ(
      fault_of(content, "step"),
      "memory: unknown format 'step'; expected obj, off, stl or ply: a modelling program, such as Blender, exports other "
      "files as these");
}

TEST(ReadMesh, RefusesMalformedNumbers) {
  for (const std::string number :
       {"1,5", "1.2.3", "0x", "0xg", "0x1p", "0x-1", "0xnan", "1p3", "1e", "+-1", "++1", "-", "+", "abc", "1d5"})
    EXPECT_EQ(fault(".obj", "v 0 " + number + " 0\n"), "line 1: '" + number + "' is not a number");
}

TEST(ReadMesh, NamesTheLineWithTooFewNumbers) {
  EXPECT_EQ(fault(".obj", "\n\nv 1 2\n"), "line 3: expected three numbers after 'v', found 2");
  EXPECT_EQ(fault(".off", "OFF\n1 0 0\n\n7\n"), "line 4: expected three numbers for a vertex, found 1");
}

TEST(ReadMesh, ReadsAnyEndOfLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "v 0 0 0" + end + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3";
    expect_triangle(read(".obj", text));
    expect_triangle(read(".obj", text + end));
    EXPECT_EQ(fault(".obj", text + end + "f 1 2 4"),
              "line 6: vertex 4 is out of range: 3 vertices were read, numbered from 1");
  }
}

TEST(ReadMesh, PassesOverAByteOrderMark) {
  EXPECT_EQ(points(read(".obj", "\xEF\xBB\xBFv 1 2 3\n")), (Points{{1, 2, 3}}));
}

// Nothing would touch it, in silence.
TEST(ReadMesh, RefusesAFileWithoutAFace) {
  for (const auto& [extension, content] : std::map<std::string, std::string>{
           {".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
           {".off", "OFF\n1 0 0\n0 0 0\n"},
           {".stl", std::string(84, '\0')},
           {".Stl", "solid nothing\nendsolid nothing\n"},
           {".ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 0\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"}}) {
    EXPECT_EQ(fault(extension, content), "the file has no face") << extension;
    EXPECT_EQ(fault(extension, content, OnFault::Skip), "the file has no face") << extension;
  }
}

TEST(ReadMesh, SaysWhyNoFaceIsLeft) {
  const std::string wrong = "v 0 0 0\nv 0 x 0\nv 1 1 1\nf 1 2 3\nf 1 2\n";
  EXPECT_EQ(fault(".obj", wrong, OnFault::Skip), "line 2: 'x' is not a number; the file has no face");
  EXPECT_EQ(fault(".ply", "hello\n", OnFault::Skip), "line 1: expected 'ply', found 'hello'; the file has no face");
}

TEST(ReadMesh, RefusesTextThatIsNotUtf8ByItsByteOrderMark) {
  using namespace std::string_literals;
  const std::string reason = "line 1: the byte order mark is that of UTF-16 or UTF-32; text must be UTF-8";
  for (const std::string& mark : {"\xFF\xFE"s, "\xFE\xFF"s, "\xFF\xFE\0\0"s, "\0\0\xFE\xFF"s})
    for (const char* extension : {".obj", ".off", ".stl", ".ply"}) {
      const std::string wide = mark +
                               "v\0 \0"
                               "1\0\n\0"s;
      for (const std::string& content : {mark, wide, wide + std::string(100, '\0')}) {
        EXPECT_EQ(fault(extension, content), reason) << extension;
        EXPECT_EQ(fault(extension, content, OnFault::Skip), reason + "; the file has no face") << extension;
      }
    }
}

// The title of a binary STL may be anything.
TEST(ReadMesh, ReadsABinaryStlThatBeginsWithThatMark) {
  const std::string title = "\xFF\xFE" + std::string(78, ' ');
  expect_triangle(read(".stl", binary_stl(title, 1, binary_facet({0, 0, 0, 1, 0, 0, 0, 1, 0}))));
}

TEST(ReadMesh, SkipOfABadHeaderKeepsNothingAndSaysSo) {
  for (const std::string extension : {".off", ".stl", ".ply"}) {
    const ReadMesh result = skip(extension, "hello\n");
    EXPECT_TRUE(result.mesh.vertices.empty());
    ASSERT_EQ(result.left_out.size(), 1u);
    EXPECT_TRUE(result.left_out[0].starts_with("line 1: expected ")) << result.left_out[0];
  }
}

}  // namespace
}  // namespace touchstone::geometry_tests
