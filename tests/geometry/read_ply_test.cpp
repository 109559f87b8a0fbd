// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "geometry/io/read_mesh.h"
#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

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

// The first byte of the data may be that of "\n", which is data unless the header ends its lines with it.
TEST(ReadPly, EndsTheHeaderAsItsOtherLinesEnd) {
  constexpr double first = std::bit_cast<double>(std::uint64_t{0x3ff0'0000'0000'000a});  // the low byte is 0x0a
  const std::string data = row({first, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, std::endian::little) +
                           bytes(std::uint8_t{3}) + row<std::int32_t>({0, 1, 2}, std::endian::little);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string header;
    for (const char c : ply_header("binary_little_endian", vertex_element("double") + kFaceElement))
      header += c == '\n' ? end : std::string(1, c);
    const Mesh mesh = read(".ply", header + data);
    EXPECT_EQ(points(mesh), (Points{{first, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
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

TEST(ReadPly, ReadsWholeNumbersWrittenAsDecimalsWhereTheHeaderSaysSo) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const auto header = [](const std::string& types) {
    return ply_header("ascii",
                      vertex_element("float") + "element face 1\nproperty list " + types + " vertex_indices\n");
  };
  EXPECT_EQ(read(".ply", header("uchar float") + vertices + "3 0.0 1.0 2e0\n").faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(read(".ply", header("double double") + vertices + "3.0 2 1 0\n").faces, (Faces{{2, 1, 0}}));
  EXPECT_THROW((void)read(".ply", header("uchar float") + vertices + "3 0.0 1.5 2.0\n"), BrokenMesh);
  EXPECT_THROW((void)read(".ply", header("uchar int") + vertices + "3 0.0 1.0 2.0\n"), BrokenMesh);
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

TEST(ReadPly, ReadsWordsWhereLinesDoNotHoldTheElementsOneByOne) {
  const std::string header =
      ply_header("ascii", vertex_element("float") +
                              "element tag 2\nproperty list uchar int words\nproperty float weight\n"
                              "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n");
  EXPECT_EQ(read(".ply", header + "0 0 0 1 0 0\n0 1\n0 2 7 8 nan 0 1\n3 0 1 2 9 3 2 1 0 9\n").faces,
            (Faces{{0, 1, 2}, {2, 1, 0}}));
  const ReadMesh result = skip(".ply", header + "0 0 0 1 0 0 0 1 0 0 1 0 1 3 0 1 2 9 3 2 1 x 9\n");
  EXPECT_EQ(result.mesh.faces, Faces{});
  // What follows a faulty word might be anything.
  const ReadMesh rest = skip(".ply", header + "0 0 0 1 0 0 0 1 0 0 1 0 1 5 .5 3 0 1 2 9 3 2 1 0 9\n");
  EXPECT_EQ(rest.mesh.faces, Faces{});
  EXPECT_EQ(rest.left_out, (Sentences{"line 16: '.5' is not a vertex number"}));
}

TEST(ReadPly, RefusesElementsItPassesOverThatAreNotAsDeclared) {
  const std::string camera = "element camera 1\nproperty int id\n", values = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(
      fault(".ply", ply_header("ascii", camera + vertex_element("float") + kFaceElement) + values + "0 0 1\n3 0 1 2\n"),
      "line 14: unexpected values after the last property");
}

TEST(ReadPly, RefusesOtherElementsThatHoldVertexNumbers) {
  EXPECT_EQ(fault(".ply", ply_header("ascii", vertex_element("float") +
                                                  "element tristrips 1\nproperty list int int vertex_indices\n")),
            "line 11: the element 'tristrips' holds vertex numbers, and only faces are read");
}

TEST(ReadPly, WarnsOfBlankBytesAfterBinaryValues) {
  const std::string whole = ply_header("binary_little_endian", vertex_element("float") + kFaceElement) +
                            row({0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) + bytes(std::uint8_t{3}) +
                            row<std::int32_t>({0, 1, 2});
  EXPECT_EQ(warnings(".ply", whole + "\n"),
            (Sentences{"byte " + std::to_string(whole.size()) +
                       ": 1 blank bytes left over after the elements that the counts declare"}));
}

TEST(ReadPly, RefusesABadHeader) {
  const auto header_fault = [](const std::string& rest) { return fault(".ply", "ply\nformat ascii 1.0\n" + rest); };
  EXPECT_EQ(fault(".ply", "plot\n"), "line 1: expected 'ply', found 'plot'");
  EXPECT_EQ(fault(".ply", "ply\nformat utf8 1.0\n"), "line 2: unknown format 'utf8'");
  EXPECT_EQ(fault(".ply", "ply\n" + vertex_element("float", "0") + "end_header\n"),
            "line 6: the header has no line 'format'");
  EXPECT_EQ(header_fault("element vertex\n"), "line 3: expected a count, found the end of the line");
  EXPECT_EQ(header_fault("element vertex -1\n"), "line 3: the count -1 is negative");
  EXPECT_EQ(header_fault("element vertex 99999999999999999999\n"), "line 3: '99999999999999999999' is not a count");
  EXPECT_EQ(header_fault("element\n"), "line 3: expected a name, found the end of the line");
  EXPECT_EQ(header_fault("property float x\n"), "line 3: a property comes before the first element");
  EXPECT_EQ(header_fault("element vertex 1\nproperty int64 x\n"), "line 4: 'int64' is not a number type");
  EXPECT_EQ(header_fault("elephant\n"), "line 3: 'elephant' is not a PLY header keyword");
  EXPECT_EQ(header_fault("element vertex 1\n"), "line 3: the file is truncated: its header has no 'end_header'");
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

TEST(ReadPly, RefusesWordsAtTheEndOfAHeaderLine) {
  const std::string whole = kAsciiTriangle + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto changed_fault = [&](const std::string& line, const std::string& other) {
    std::string changed = whole;
    return fault(".ply", changed.replace(changed.find(line + "\n"), line.size(), other));
  };
  EXPECT_EQ(changed_fault("ply", "ply 2"), "line 1: unexpected '2' at the end of a header line");
  EXPECT_EQ(changed_fault("format ascii 1.0", "format ascii 1.0 utf8"),
            "line 2: unexpected 'utf8' at the end of a header line");
  EXPECT_EQ(changed_fault("element vertex 3", "element vertex 3 4"),
            "line 5: unexpected '4' at the end of a header line");
  EXPECT_EQ(changed_fault("property float x", "property float x y"),
            "line 6: unexpected 'y' at the end of a header line");
  EXPECT_EQ(changed_fault("property list uchar int vertex_indices", "property list uchar int vertex_indices red"),
            "line 10: unexpected 'red' at the end of a header line");
  EXPECT_EQ(changed_fault("end_header", "end_header 0"), "line 11: unexpected '0' at the end of a header line");
  EXPECT_EQ(changed_fault("obj_info none", "obj_info none of it"), "no fault");
}

TEST(ReadPly, KnowsOneVersionAndOneFormat) {
  const std::string rest = vertex_element("float", "0") + "end_header\n";
  EXPECT_EQ(fault(".ply", "ply\nformat ascii 1.1\n" + rest), "line 2: expected the version 1.0, found '1.1'");
  EXPECT_EQ(fault(".ply", "ply\nformat ascii\n" + rest), "line 2: expected the version 1.0, found the end of the line");
  EXPECT_EQ(fault(".ply", "ply\nformat ascii 1.0\nformat binary_big_endian 1.0\n" + rest),
            "line 3: a second line 'format'");
}

TEST(ReadPly, RefusesWrongText) {
  const std::string vertices = kAsciiTriangle + "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0\n1 0\n"), "line 13: expected a number, found the end of the line");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0 0\n"), "line 12: unexpected values after the last property");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 1e400\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "line 15: the face uses vertex 0, whose coordinates (line 12) are not finite doubles");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 zero\n"), "line 12: 'zero' is not a number");
  EXPECT_EQ(fault(".ply", kAsciiTriangle + "0 0 0\n"), "line 12: the file is truncated: vertex 1 of 3 is missing");
  EXPECT_EQ(fault(".ply", vertices), "line 14: the file is truncated: face 0 of 1 is missing");
  EXPECT_EQ(fault(".ply", vertices + "4 0 1 2\n"), "line 15: expected 4 vertex numbers, found 3");
  EXPECT_EQ(fault(".ply", vertices + "-1\n"), "line 15: the count -1 is negative");
  EXPECT_EQ(fault(".ply", vertices + "2 0 1\n"), "line 15: a face needs at least 3 vertices, this one has 2");
  EXPECT_EQ(fault(".ply", vertices + "3 0 1 3\n"),
            "line 15: vertex 3 is out of range: 3 vertices were read, numbered from 0");
  EXPECT_EQ(fault(".ply", vertices + "3 0 1 2\n3 0 1 2\n"),
            "line 16: unexpected data after the elements that the counts declare");
}

TEST(ReadPly, SkipLeavesOutWrongLines) {
  const std::string header =
      ply_header("ascii", vertex_element("float", "4") + "element face 3\nproperty list uchar int vertex_indices\n");
  const ReadMesh result = skip(".ply", header + "0 0 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2\n3 0 2 3\n");
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 2, 3}}));
  EXPECT_EQ(result.left_out,
            (Sentences{"line 17: expected 3 vertex numbers, found 2",
                       "line 16: the face uses vertex 1, whose coordinates (line 13) are not finite doubles"}));
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
  const std::string not_finite = file.byte(96) + "the face uses vertex 1, whose coordinates (byte " +
                                 std::to_string(file.header.size() + 24) + ") are not finite doubles";
  EXPECT_EQ(fault(".ply", file.whole()), not_finite);
  const ReadMesh result = skip(".ply", file.whole());
  EXPECT_EQ(result.mesh.faces, (Faces{{0, 2, 3}}));
  EXPECT_EQ(
      result.left_out,
      (Sentences{not_finite, file.byte(100) + "vertex 4 is out of range: 4 vertices were read, numbered from 0"}));
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
  EXPECT_EQ(
      fault(".ply", header + row({1.0f, 2.0f, 3.0f}) + "x"),
      "byte " + std::to_string(header.size() + 12) + ": 1 bytes left over after the elements that the counts declare");
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
  expect_lost(bytes(std::int8_t{3}) + row({0.5f, 1.0f, 2.0f}), at_value + "a count or vertex number is not an integer");
  expect_lost(bytes(std::int8_t{3}) + row({static_cast<float>(kNan), 1.0f, 2.0f}),
              at_value + "a count or vertex number is not an integer");
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
}  // namespace touchstone::geometry_tests
