// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/io/read_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace touchstone {
namespace {

using Face = std::vector<std::uint32_t>;
using Faces = std::vector<Face>;
using Sentences = std::vector<std::string>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A file in the test's folder, removed at the end of its scope.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& extension, std::string_view content)
      : path_(std::filesystem::path(testing::TempDir()) / (test_name() + extension)) {
    std::ofstream(path_, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  static std::string test_name() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    return std::string(test->test_suite_name()) + "." + test->name();
  }
  std::filesystem::path path_;
};

Mesh read(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  const ReadMesh result = read_mesh(file.path());
  EXPECT_EQ(result.left_out, Sentences{});
  return result.mesh;
}

/// The sentence without the file that it begins with.
std::string after_file(const TemporaryFile& file, const std::string& sentence) {
  const std::string prefix = file.path().string() + ": ";
  EXPECT_TRUE(sentence.starts_with(prefix)) << sentence;
  return sentence.substr(std::min(prefix.size(), sentence.size()));
}

/// What the file is refused for, from the line or byte on.
std::string fault(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  try {
    (void)read_mesh(file.path());
  } catch (const BrokenMesh& broken) {
    return after_file(file, broken.what());
  }
  return "no fault";
}

/// The mesh with OnFault::Skip, and what is left out from the line or byte on.
ReadMesh skip(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  ReadMesh result = read_mesh(file.path(), OnFault::Skip);
  for (std::string& sentence : result.left_out) sentence = after_file(file, sentence);
  return result;
}

std::vector<std::array<double, 3>> points(const Mesh& mesh) {
  std::vector<std::array<double, 3>> result;
  for (const auto& vertex : mesh.vertices) result.push_back({vertex[0], vertex[1], vertex[2]});
  return result;
}
using Points = std::vector<std::array<double, 3>>;

const Points kTrianglePoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

template <class Number>
std::string bytes(Number number, std::endian order = std::endian::little) {
  auto result = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native) std::reverse(result.begin(), result.end());
  return {result.begin(), result.end()};
}

template <class Number>
std::string row(std::initializer_list<Number> numbers, std::endian order = std::endian::little) {
  std::string result;
  for (const Number number : numbers) result += bytes(number, order);
  return result;
}

// ---- The file

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
    EXPECT_EQ(after_file(file, broken.what()), "the extension '.step' is none of .obj, .off, .stl and .ply");
  }
}

TEST(ReadMesh, KnowsTheExtensionInAnyCase) {
  EXPECT_EQ(read(".OBJ", "v 1 2 3\n").vertices.size(), 1u);
  EXPECT_EQ(read(".Off", "OFF\n0 0 0\n").vertices.size(), 0u);
}

TEST(ReadMesh, AnEmptyFileIsAnEmptyObjAndNoOtherFormat) {
  EXPECT_TRUE(read(".obj", "").vertices.empty());
  EXPECT_EQ(fault(".off", ""), "line 1: the file is truncated: expected 'OFF'");
  EXPECT_EQ(fault(".stl", ""), "line 1: the file is truncated: expected 'solid'");
  EXPECT_EQ(fault(".ply", ""), "line 1: the file is truncated: its header has no end");
}

// ---- Numbers

TEST(ReadMesh, ReadsTheNearestDouble) {
  const Mesh mesh = read(".obj",
                         "v 0.1 +1.5 -2.5e-3\n"
                         "v 0.12345678901234567890 1. .5\n"
                         "v 9007199254740993 1.7976931348623158e308 1E2\n");
  EXPECT_EQ(points(mesh), (Points{{0.1, 1.5, -2.5e-3},
                                  {0.12345678901234567890, 1.0, 0.5},
                                  {9007199254740992.0, std::numeric_limits<double>::max(), 100.0}}));
}

// Rounding to zero is no fault; rounding to infinity is. Both are out of range for std::from_chars.
TEST(ReadMesh, ReadsNumbersCloseToZeroAsTheNearestDouble) {
  constexpr double kTiniest = std::numeric_limits<double>::denorm_min();
  const std::string zeros(400, '0');
  const Mesh mesh = read(".obj", "v 2.4e-324 2.5e-324 -1e-400\nv 1e-99999999999999999999 0." + zeros + "1 0." + zeros +
                                     "1e401\nv 0e99999999999999999999 1" + zeros + "e-800 1" + zeros + "e-400\n");
  EXPECT_EQ(points(mesh), (Points{{0, kTiniest, 0}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_TRUE(std::signbit(mesh.vertices[0][2]));
}

TEST(ReadMesh, RefusesNumbersBeyondTheFiniteDoubles) {
  EXPECT_EQ(fault(".obj", "v 0 0 0\nv 0 1e400 0\n"), "line 2: '1e400' is not a finite double");
  EXPECT_EQ(fault(".obj", "v 0 -1.7976931348623159e308 0\n"),
            "line 1: '-1.7976931348623159e308' is not a finite double");
  EXPECT_EQ(fault(".obj", "v 0 nan 0\n"), "line 1: 'nan' is not a finite double");
  EXPECT_EQ(fault(".off", "OFF 1 0 0\n0 0 -inf\n"), "line 2: '-inf' is not a finite double");
  EXPECT_EQ(fault(".obj", "v 0 0 1e99999999999999999999\n"), "line 1: '1e99999999999999999999' is not a finite double");
  const std::string digits = "1" + std::string(400, '0');
  EXPECT_EQ(fault(".obj", "v 0 0 " + digits + "\n"),
            "line 1: '" + digits.substr(0, 40) + "...' is not a finite double");
}

TEST(ReadMesh, RefusesMalformedNumbers) {
  for (const std::string number : {"1,5", "1.2.3", "0x10", "1e", "+-1", "++1", "-", "+", "abc", "1d5"})
    EXPECT_EQ(fault(".obj", "v 0 " + number + " 0\n"), "line 1: '" + number + "' is not a number");
}

TEST(ReadMesh, NamesTheLineWithTooFewNumbers) {
  EXPECT_EQ(fault(".obj", "\n\nv 1 2\n"), "line 3: expected three numbers after 'v', found 2");
  EXPECT_EQ(fault(".off", "OFF\n1 0 0\n\n7\n"), "line 4: expected three numbers for a vertex, found 1");
}

// ---- OBJ

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

TEST(ReadObj, NamesTheFirstLineOfAContinuedOneAndCountsThemAll) {
  EXPECT_EQ(fault(".obj", "v 0 \\\n0 \\\nx\n"), "line 1: 'x' is not a number");
  EXPECT_EQ(fault(".obj", "v 0 \\\n0 \\\n0\nv x 0 0\n"), "line 4: 'x' is not a number");
}

// A path of Windows in a comment must not swallow the vertex after it.
TEST(ReadObj, DoesNotContinueComments) {
  EXPECT_EQ(points(read(".obj", "# C:\\models\\\nv 1 2 3 # here\\\nv 4 5 6\n")), (Points{{1, 2, 3}, {4, 5, 6}}));
}

TEST(ReadMesh, ReadsAnyEndOfLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = "v 0 0 0" + end + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3";
    EXPECT_EQ(points(read(".obj", text)), kTrianglePoints);
    EXPECT_EQ(read(".obj", text + end).faces, (Faces{{0, 1, 2}}));
    EXPECT_EQ(fault(".obj", text + end + "f 1 2 4"),
              "line 6: vertex 4 is out of range: 3 vertices were read, numbered from 1");
  }
}

TEST(ReadMesh, PassesOverAByteOrderMark) {
  EXPECT_EQ(points(read(".obj", "\xEF\xBB\xBFv 1 2 3\n")), (Points{{1, 2, 3}}));
}

TEST(ReadObj, TakesTheFirstThreeOfAVertexWithAWeightOrAColour) {
  EXPECT_EQ(points(read(".obj", "v 1 2 3 0.5\nv 4 5 6 1 0 0.25\n\tv\t7  8\t9 \n")),
            (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
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
  for (const std::string corner : {"x", "/1", "1.5", "99999999999999999999", "1e0"})
    EXPECT_EQ(fault(".obj", kObj + "f 1 2 " + corner + "\n"), "line 4: '" + corner + "' is not a corner of a face");
}

TEST(ReadObj, RefusesAFaceOfFewerThanThreeVertices) {
  EXPECT_EQ(fault(".obj", kObj + "f 1 2\n"), "line 4: a face needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault(".obj", kObj + "f\n"), "line 4: a face needs at least 3 vertices, this one has 0");
}

// What is left keeps its order and is numbered anew; a face that needs a vertex left out goes with it.
TEST(ReadObj, SkipLeavesOutWrongVerticesAndTheFacesThatNeedThem) {
  const ReadMesh result =
      skip(".obj", "v 0 0 0\nv 0 x 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 1 3\nf 4 3 9\nf -1 -2 -4\n");
  EXPECT_EQ(points(result.mesh), kTrianglePoints);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 2: 'x' is not a number", "line 7: a face needs at least 3 vertices, this one has 2",
                       "line 5: the face needs vertex 2, which is left out",
                       "line 8: vertex 9 is out of range: 4 vertices were read, numbered from 1"}));
}

// ---- OFF

const std::string kOffPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(ReadOff, ReadsVerticesAndPolygons) {
  const Mesh mesh = read(".off", "OFF\n5 2 0\n" + kOffPoints + "2 2 0\n3 3 1\n3 0 1 2\n5 4 3 2 1 0\n");
  EXPECT_EQ(mesh.vertices.size(), 5u);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}, {4, 3, 2, 1, 0}}));
}

TEST(ReadOff, ReadsCountsOnTheFirstLineWithOrWithoutEdgesOrTheWord) {
  for (const std::string header : {"OFF 3 1 3\n", "OFF\n3 1 3\n", "OFF\n3 1\n", "3 1 3\n"}) {
    const Mesh mesh = read(".off", header + kOffPoints + "3 0 1 2\n");
    EXPECT_EQ(points(mesh), kTrianglePoints);
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
  }
}

TEST(ReadOff, PassesOverCommentsAndBlankLines) {
  const Mesh mesh = read(
      ".off",
      "# before\nOFF # after\n\n#\n3 1 0 # counts\n0 0 0 # first\n\n1 0 0\r\n0 1 0\n# faces\n3 0 1 2 # red\n\n# end");
  EXPECT_EQ(points(mesh), kTrianglePoints);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadOff, PassesOverColoursAndNormals) {
  EXPECT_EQ(points(read(".off", "COFF\n1 0 0\n1 2 3 255 0 0 255\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(points(read(".off", "NOFF\n1 0 0\n1 2 3 nan nan nan\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(points(read(".off", "STCNOFF\n1 0 0\n1 2 3 0 0 1 1 0 0 1 0.5 0.5\n")), (Points{{1, 2, 3}}));
  EXPECT_EQ(read(".off", "OFF 3 2 0\n" + kOffPoints + "3 0 1 2 0.5 0.5 0\n3 2 1 0 7\n").faces,
            (Faces{{0, 1, 2}, {2, 1, 0}}));
}

TEST(ReadOff, RefusesABadHeader) {
  EXPECT_EQ(fault(".off", "FOO\n1 0 0\n"), "line 1: expected 'OFF', found 'FOO'");
  EXPECT_EQ(fault(".off", "4OFF\n1 0 0\n"), "line 1: expected 'OFF', found '4OFF'");
  EXPECT_EQ(fault(".off", "OFF BINARY\n"), "line 1: 'BINARY' is not a count");
  EXPECT_EQ(fault(".off", "OFF\n3\n"), "line 2: the line ends where a count is expected");
  EXPECT_EQ(fault(".off", "OFF\n-3 1 0\n"), "line 2: the count -3 is negative");
  EXPECT_EQ(fault(".off", "OFF\n3 99999999999999999999 0\n"), "line 2: '99999999999999999999' is not a count");
  EXPECT_EQ(fault(".off", "OFF\n\n"), "line 2: the file is truncated: the counts of vertices and faces are missing");
}

TEST(ReadOff, RefusesAWrongCount) {
  EXPECT_EQ(fault(".off", "OFF 4 0 0\n" + kOffPoints), "line 4: the file is truncated: vertex 3 of 4 is missing");
  EXPECT_EQ(fault(".off", "OFF 3 2 0\n" + kOffPoints + "3 0 1 2\n"),
            "line 5: the file is truncated: face 1 of 2 is missing");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "3 0 1 2\n3 0 1 2\n"),
            "line 6: the file goes on after what the counts promise");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "4 0 1 2\n"), "line 5: expected 4 vertex numbers, found 3");
  EXPECT_EQ(fault(".off", "OFF 3 1 0\n" + kOffPoints + "-3 0 1 2\n"), "line 5: the count -3 is negative");
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
  EXPECT_EQ(points(result.mesh), kTrianglePoints);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(result.left_out, (Sentences{"line 3: 'inf' is not a finite double", "line 7: 'x' is not a vertex number",
                                        "line 8: the file is truncated: face 3 of 4 is missing",
                                        "line 6: the face needs vertex 1, which is left out"}));
}

TEST(ReadMesh, SkipOfABadHeaderKeepsNothingAndSaysSo) {
  for (const std::string extension : {".off", ".stl", ".ply"}) {
    const ReadMesh result = skip(extension, "hello\n");
    EXPECT_TRUE(result.mesh.vertices.empty());
    ASSERT_EQ(result.left_out.size(), 1u);
    EXPECT_TRUE(result.left_out[0].starts_with("line 1: expected ")) << result.left_out[0];
  }
}

// ---- STL

const std::string kFacet =
    "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string binary_facet(std::array<float, 9> coordinates) {
  std::string result = row({0.0f, 0.0f, 1.0f});
  for (const float coordinate : coordinates) result += bytes(coordinate);
  return result + bytes(std::uint16_t{0x0a0d});
}

std::string binary_stl(const std::string& title, std::uint32_t count, const std::string& facets) {
  std::string header = title;
  header.resize(80, '\0');
  return header + bytes(count) + facets;
}

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
  EXPECT_EQ(fault(".stl", whole + "ab"), "byte 184: 2 bytes follow what the counts promise");
  EXPECT_EQ(fault(".stl", whole.substr(0, 50)), "byte 50: the file is truncated within its header of 84 bytes");
  EXPECT_EQ(skip(".stl", whole.substr(0, 150)).mesh.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadStl, AbsurdCountsCostNothing) {
  const ReadMesh result = skip(".stl", binary_stl("", 4294967295u, kBinaryFacet));
  EXPECT_EQ(result.mesh.faces.size(), 1u);
  EXPECT_EQ(result.left_out, (Sentences{"byte 134: the file is truncated: facet 1 of 4294967295 is not complete"}));
}

TEST(ReadStl, NamesTheByteOfABinaryVertexThatIsNotFinite) {
  const auto infinity = static_cast<float>(kInfinity);
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
  EXPECT_EQ(fault(".stl", "solid\n" + kFacet), "line 8: the file is truncated: expected 'facet' or 'endsolid'");
  EXPECT_EQ(fault(".stl", "solid\ncolour\nendsolid\n"), "line 2: expected 'facet' or 'endsolid', found 'colour'");
  EXPECT_EQ(fault(".stl", "solid\nendsolid\nfacet\n"), "line 3: expected 'solid', found 'facet'");
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

// ---- PLY

std::string ply_header(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nobj_info none\n" + rest + "end_header\n";
}

std::string vertex_element(const std::string& type, const std::string& count = "3") {
  return "element vertex " + count + "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\n";
}

const std::string kFaceElement = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kAsciiTriangle = ply_header("ascii", vertex_element("float") + kFaceElement);  // 13 lines

TEST(ReadPly, ReadsTextAsTheNearestDoublesWhateverTheDeclaredType) {
  const Mesh mesh = read(".ply", kAsciiTriangle + "0.1 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(points(mesh), (Points{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadPly, KeepsAFaceOfFiveVerticesAsOnePolygon) {
  const std::string header =
      ply_header("ascii", vertex_element("double", "5") + "element face 1\nproperty list int uint vertex_index\n");
  EXPECT_EQ(read(".ply", header + "0 0 0\r\n1 0 0\r\n2 1 0\n1 2 0\n\n0 1 0\n5 4 3 2 1 0\n").faces,
            (Faces{{4, 3, 2, 1, 0}}));
}

struct ByteOrder {
  const char* format;
  std::endian order;
};
constexpr std::array<ByteOrder, 2> kByteOrders{
    {{"binary_little_endian", std::endian::little}, {"binary_big_endian", std::endian::big}}};

TEST(ReadPly, ReadsBinaryOfEitherByteOrder) {
  for (const auto& [format, order] : kByteOrders) {
    const std::string corners = bytes(std::uint8_t{3}) + row<std::int32_t>({2, 1, 0}, order);
    const Mesh of_doubles = read(".ply", ply_header(format, vertex_element("double") + kFaceElement) +
                                             row({0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1e300, 0.0}, order) + corners);
    EXPECT_EQ(points(of_doubles), (Points{{0.1, 0, 0}, {1, 0, 0}, {0, -1e300, 0}}));
    EXPECT_EQ(of_doubles.faces, (Faces{{2, 1, 0}}));

    const Mesh of_floats =
        read(".ply", ply_header(format, vertex_element("float") + kFaceElement) +
                         row({0.1f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}, order) + corners);
    EXPECT_EQ(points(of_floats), (Points{{static_cast<double>(0.1f), 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(of_floats.faces, (Faces{{2, 1, 0}}));
  }
}

template <class Count, class Index>
void reads_lists_of(const std::string& count_type, const std::string& index_type) {
  for (const auto& [format, order] : kByteOrders) {
    const std::string header = ply_header(format, vertex_element("float") + "element face 1\nproperty list " +
                                                      count_type + " " + index_type + " vertex_indices\n");
    const Mesh mesh = read(".ply", header + row({0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}, order) +
                                       bytes(Count{4}, order) + row<Index>({0, 1, 2, 1}, order));
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2, 1}})) << count_type << " " << index_type;
  }
}

TEST(ReadPly, ReadsListsOfAnyTypes) {
  reads_lists_of<std::int8_t, std::uint8_t>("char", "uchar");
  reads_lists_of<std::uint8_t, std::int8_t>("uint8", "int8");
  reads_lists_of<std::int16_t, std::uint16_t>("short", "ushort");
  reads_lists_of<std::uint16_t, std::int16_t>("uint16", "int16");
  reads_lists_of<std::int32_t, std::uint32_t>("int", "uint");
  reads_lists_of<std::uint32_t, std::int32_t>("uint32", "int32");
  reads_lists_of<float, double>("float", "double");
  reads_lists_of<double, float>("float64", "float32");
}

TEST(ReadPly, ReadsCoordinatesOfWholeNumbers) {
  const std::string header =
      ply_header("binary_big_endian", "element vertex 1\nproperty short x\nproperty uchar y\nproperty int z\n");
  EXPECT_EQ(points(read(".ply", header + row<std::int16_t>({-2}, std::endian::big) + bytes(std::uint8_t{200}) +
                                    row<std::int32_t>({-70000}, std::endian::big))),
            (Points{{-2, 200, -70000}}));
}

const std::string kRichElements =
    "element camera 2\nproperty list uchar short tags\nproperty double focus\n"
    "element vertex 3\nproperty uchar red\nproperty double z\nproperty list uchar int rings\nproperty double "
    "y\nproperty double x\n"
    "element nothing 1000000000000\n"
    "element face 1\nproperty float area\nproperty list uchar float texcoord\nproperty list uchar uint "
    "vertex_indices\nproperty uchar flags\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\n";

TEST(ReadPly, PassesOverOtherElementsAndPropertiesInText) {
  const Mesh mesh =
      read(".ply", ply_header("ascii", kRichElements) +
                       "2 7 8 nan\n0 1\n255 3 0 2 1\n0 6 2 9 9 5 4\n0 9 1 9 8 7\nnan 2 .5 inf 3 2 1 0 1\n0 1\n");
  EXPECT_EQ(points(mesh), (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(mesh.faces, (Faces{{2, 1, 0}}));
}

TEST(ReadPly, PassesOverOtherElementsAndPropertiesInBinary) {
  for (const auto& [format, order] : kByteOrders) {
    const auto vertex = [order = order](double x, double y, double z, std::uint8_t rings) {
      std::string list = bytes(rings);
      for (int i = 0; i < rings; ++i) list += bytes(std::int32_t{-1}, order);
      return bytes(std::uint8_t{255}) + bytes(z, order) + list + bytes(y, order) + bytes(x, order);
    };
    const std::string cameras = bytes(std::uint8_t{2}) + row<std::int16_t>({7, 8}, order) + bytes(kNan, order) +
                                bytes(std::uint8_t{0}) + bytes(1.0, order);
    const std::string face = bytes(1.5f, order) + bytes(std::uint8_t{1}) + bytes(0.5f, order) + bytes(std::uint8_t{3}) +
                             row<std::uint32_t>({2, 1, 0}, order) + bytes(std::uint8_t{1});
    const Mesh mesh =
        read(".ply", ply_header(format, kRichElements) + cameras + vertex(1, 2, 3, 0) + vertex(4, 5, 6, 2) +
                         vertex(7, 8, 9, 1) + face + row<std::int32_t>({0, 1}, order));
    EXPECT_EQ(points(mesh), (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(mesh.faces, (Faces{{2, 1, 0}}));
  }
}

TEST(ReadPly, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(read(".ply", ply_header("ascii", kFaceElement + vertex_element("float")) + "3 2 1 0\n0 0 0\n1 0 0\n0 1 0\n")
                .faces,
            (Faces{{2, 1, 0}}));
}

// The values begin right after the header's last line, whatever their first byte is.
TEST(ReadPly, BinaryValuesMayBeginWithTheByteOfALineEnd) {
  const std::string header =
      ply_header("binary_little_endian", "element vertex 1\nproperty uchar x\nproperty uchar y\nproperty uchar z\n");
  EXPECT_EQ(points(read(".ply", header + "\n\r\n")), (Points{{10, 13, 10}}));
}

TEST(ReadPly, RefusesABadHeader) {
  const auto header_fault = [](const std::string& rest) { return fault(".ply", "ply\nformat ascii 1.0\n" + rest); };
  EXPECT_EQ(fault(".ply", "plot\n"), "line 1: expected 'ply', found 'plot'");
  EXPECT_EQ(fault(".ply", "ply\nformat utf8 1.0\n"), "line 2: the format 'utf8' is not known");
  EXPECT_EQ(fault(".ply", "ply\n" + vertex_element("float", "0") + "end_header\n"),
            "line 6: the header has no line 'format'");
  EXPECT_EQ(header_fault("element vertex\n"), "line 3: the line ends where a count is expected");
  EXPECT_EQ(header_fault("element vertex -1\n"), "line 3: the count -1 is negative");
  EXPECT_EQ(header_fault("element vertex 99999999999999999999\n"), "line 3: '99999999999999999999' is not a count");
  EXPECT_EQ(header_fault("element\n"), "line 3: the line ends where a name is expected");
  EXPECT_EQ(header_fault("property float x\n"), "line 3: a property comes before the first element");
  EXPECT_EQ(header_fault("element vertex 1\nproperty int64 x\n"), "line 4: 'int64' is not a type of numbers");
  EXPECT_EQ(header_fault("elephant\n"), "line 3: 'elephant' means nothing in a header");
  EXPECT_EQ(header_fault("element vertex 1\n"), "line 3: the file is truncated: its header has no end");
  EXPECT_EQ(header_fault("end_header\n"), "line 3: expected one element 'vertex', found 0");
  EXPECT_EQ(header_fault(vertex_element("float") + vertex_element("float") + "end_header\n"),
            "line 11: expected one element 'vertex', found 2");
  EXPECT_EQ(header_fault(vertex_element("float") + kFaceElement + kFaceElement + "end_header\n"),
            "line 11: expected one element 'face', found 2");
  EXPECT_EQ(header_fault("element vertex 1\nproperty float x\nproperty float y\nend_header\n"),
            "line 6: the element 'vertex' needs one property 'z', it has 0");
  EXPECT_EQ(header_fault(vertex_element("float") + "property float x\nend_header\n"),
            "line 8: the element 'vertex' needs one property 'x', it has 2");
  EXPECT_EQ(header_fault(vertex_element("float") + "element face 1\nproperty int flags\nend_header\n"),
            "line 9: the element 'face' needs one list 'vertex_indices' or 'vertex_index', it has 0");
}

TEST(ReadPly, RefusesWrongText) {
  const std::string vertices = kAsciiTriangle + "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0\n1 0\n"), "line 13: the line ends where a number is expected");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0 0\n"), "line 12: the line goes on after the last property");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 1e400\n"), "line 12: '1e400' is not a finite double");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 zero\n"), "line 12: 'zero' is not a number");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0\n"), "line 12: the file is truncated: vertex 1 of 3 is missing");
  EXPECT_EQ(fault(".ply", vertices), "line 14: the file is truncated: face 0 of 1 is missing");
  EXPECT_EQ(fault(".ply", vertices + "4 0 1 2\n"), "line 15: expected 4 vertex numbers, found 3");
  EXPECT_EQ(fault(".ply", vertices + "-1\n"), "line 15: the count -1 is negative");
  EXPECT_EQ(fault(".ply", vertices + "2 0 1\n"), "line 15: a face needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault(".ply", vertices + "3 0 1 3\n"),
            "line 15: vertex 3 is out of range: 3 vertices were read, numbered from 0");
  EXPECT_EQ(fault(".ply", vertices + "3 0 1 2\n3 0 1 2\n"), "line 16: the file goes on after what the counts promise");
}

TEST(ReadPly, SkipLeavesOutWrongLines) {
  const std::string header =
      ply_header("ascii", vertex_element("float", "4") + "element face 3\nproperty list uchar int vertex_indices\n");
  const ReadMesh result = skip(".ply", header + "0 0 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2\n3 0 2 3\n");
  EXPECT_EQ(points(result.mesh), kTrianglePoints);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 13: 'nan' is not a finite double", "line 17: expected 3 vertex numbers, found 2",
                       "line 16: the face needs vertex 1, which is left out"}));
}

/// Four vertices, of which the second is not finite, and three faces: the first needs that vertex, the second names one
/// that is not there.
struct BinaryPly {
  std::string header =
      ply_header("binary_little_endian",
                 vertex_element("double", "4") + "element face 3\nproperty list uchar char vertex_indices\n");
  std::string vertices = row({0.0, 0.0, 0.0, 0.0, kNan, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0});
  std::string faces = row<std::int8_t>({3, 0, 1, 2, 3, 0, 2, 4, 3, 0, 2, 3});

  [[nodiscard]] std::string whole() const { return header + vertices + faces; }
  [[nodiscard]] std::string byte(std::size_t after_header) const {
    return "byte " + std::to_string(header.size() + after_header) + ": ";
  }
};

TEST(ReadPly, NamesTheByteOfABinaryPartThatIsWrong) {
  const BinaryPly file;
  EXPECT_EQ(fault(".ply", file.whole()), file.byte(24) + "a coordinate is not a finite number");
  const ReadMesh result = skip(".ply", file.whole());
  EXPECT_EQ(points(result.mesh), kTrianglePoints);
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(result.left_out,
            (Sentences{file.byte(24) + "a coordinate is not a finite number",
                       file.byte(96) + "the face needs vertex 1, which is left out",
                       file.byte(100) + "vertex 4 is out of range: 4 vertices were read, numbered from 0"}));
}

TEST(ReadPly, EveryTruncationOfABinaryFileIsAFaultAndKeepsWhatCameBefore) {
  BinaryPly file;
  file.vertices = row({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0});
  file.faces = row<std::int8_t>({3, 0, 1, 2, 3, 0, 2, 1, 3, 0, 2, 3});
  const std::string whole = file.whole();
  EXPECT_EQ(read(".ply", whole).faces.size(), 3u);
  for (std::size_t size = file.header.size(); size < whole.size(); ++size) {
    EXPECT_NE(fault(".ply", whole.substr(0, size)).find("the file is truncated"), std::string::npos) << size;
    const ReadMesh result = skip(".ply", whole.substr(0, size));
    const std::size_t values = size - file.header.size();
    EXPECT_EQ(result.mesh.vertices.size(), std::min<std::size_t>(values / 24, 4));
    EXPECT_EQ(result.mesh.faces.size(), values < 96 ? 0 : (values - 96) / 4);
    EXPECT_EQ(result.left_out.size(), 1u);
  }
}

TEST(ReadPly, RefusesBytesAfterTheLastElement) {
  const std::string header = ply_header("binary_little_endian", vertex_element("float", "1"));
  EXPECT_EQ(fault(".ply", header + row({1.0f, 2.0f, 3.0f}) + "x"),
            "byte " + std::to_string(header.size() + 12) + ": 1 bytes follow what the counts promise");
}

// After the wrong count of a list nobody knows where the next element begins.
TEST(ReadPly, AWrongCountOfABinaryListEndsTheReading) {
  const std::string header = ply_header(
      "binary_little_endian", vertex_element("char") + "element face 2\nproperty list char float vertex_indices\n");
  const std::string good =
      row<std::int8_t>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes(std::int8_t{3}) + row({0.0f, 1.0f, 2.0f});
  const std::string at_count = "byte " + std::to_string(header.size() + good.size()) + ": ";
  const std::string at_value = "byte " + std::to_string(header.size() + good.size() + 1) + ": ";
  const auto expect_lost = [&](const std::string& second_face, const std::string& sentence) {
    EXPECT_EQ(fault(".ply", header + good + second_face), sentence);
    const ReadMesh result = skip(".ply", header + good + second_face);
    EXPECT_EQ(result.mesh.faces, (Faces{{0, 1, 2}}));
    EXPECT_EQ(result.left_out, (Sentences{sentence}));
  };
  expect_lost(bytes(std::int8_t{-1}), at_count + "the count -1 is negative");
  expect_lost(bytes(std::int8_t{100}) + row({0.0f, 1.0f, 2.0f}),
              at_count + "the file is truncated within a list of 100");
  expect_lost(bytes(std::int8_t{3}) + row({0.5f, 1.0f, 2.0f}),
              at_value + "a count or vertex number is not a whole number");
  expect_lost(bytes(std::int8_t{3}) + row({static_cast<float>(kNan), 1.0f, 2.0f}),
              at_value + "a count or vertex number is not a whole number");
}

TEST(ReadPly, AbsurdCountsCostNothing) {
  const std::string elements =
      vertex_element("float", "1000000000000") +
      "element nothing 9223372036854775807\nelement face 1000000000000\nproperty list uint int vertex_indices\n";
  EXPECT_EQ(fault(".ply", ply_header("ascii", elements) + "0 0 0\n"),
            "line 13: the file is truncated: vertex 1 of 1000000000000 is missing");
  const std::string header = ply_header("binary_little_endian", elements);
  EXPECT_EQ(
      fault(".ply", header + row({1.0f, 2.0f, 3.0f})),
      "byte " + std::to_string(header.size() + 12) + ": the file is truncated: vertex 1 of 1000000000000 is missing");

  const std::string one_vertex = ply_header(
      "binary_little_endian", vertex_element("float", "1") + "element face 1\nproperty list uint int vertex_indices\n");
  EXPECT_EQ(fault(".ply", one_vertex + row({1.0f, 2.0f, 3.0f}) + bytes(4294967295u)),
            "byte " + std::to_string(one_vertex.size() + 12) + ": the file is truncated within a list of 4294967295");
}

}  // namespace
}  // namespace touchstone
