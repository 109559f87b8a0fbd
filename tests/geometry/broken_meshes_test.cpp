// SPDX-License-Identifier: GPL-3.0-or-later
// Broken files of every format: an error that names the place, or a report of what was left out; never more memory
// than the file's size allows, whatever it promises.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "geometry/io/detail/mesh_builder.h"
#include "tests/experiments/support/address_sanitizer.h"
#include "tests/geometry/mesh_fixture.h"

namespace touchstone::geometry_tests {
namespace {

constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

std::string stl_text(const std::string& third_vertex) {
  return "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + third_vertex +
         "\nendloop\nendfacet\nendsolid\n";
}
std::string stl_binary(std::uint32_t count, float x) {
  return binary_stl("", count, binary_facet({0, 0, 0, 1, 0, 0, x, 1, 0}));
}
std::string ply_head(const std::string& format, const std::string& vertices, const std::string& faces) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uint int vertex_indices\nend_header\n";
}
const std::string kText = "ascii", kBinary = "binary_little_endian", kTwoGigabytes = "2000000000";
std::string ply_text(const std::string& third_vertex, const std::string& face, const std::string& faces = "1") {
  return ply_head(kText, "3", faces) + "0 0 0\n1 0 0\n" + third_vertex + "\n" + face + "\n";
}
std::string ply_binary(float x, int corner, const std::string& faces = "1", std::uint32_t corners = 3) {
  return ply_head(kBinary, "3", faces) + row({0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, x, 1.0f, 0.0f}) + bytes(corners) +
         row({0, 1, corner});
}
std::string off(const std::string& third_vertex, const std::string& face, const std::string& faces = "1") {
  return "OFF 3 " + faces + " 0\n0 0 0\n1 0 0\n" + third_vertex + "\n" + face + "\n";
}
std::string obj(const std::string& third_vertex, const std::string& face) {
  return "v 0 0 0\nv 1 0 0\nv " + third_vertex + "\nf " + face + "\n";
}

/// One whole file of each format, encoding by encoding.
struct Whole {
  std::string extension, content;
};
const std::vector<Whole>& whole_files() {
  static const std::vector<Whole> files{
      {".obj", obj("0 1 0", "1 2 3")}, {".off", off("0 1 0", "3 0 1 2")},      {".stl", stl_text("0 1 0")},
      {".stl", stl_binary(1, 0)},      {".ply", ply_text("0 1 0", "3 0 1 2")}, {".ply", ply_binary(0, 2)}};
  return files;
}

TEST(BrokenMeshes, AreWholeWhereNothingIsWrong) {
  for (const auto& [extension, content] : whole_files()) {
    SCOPED_TRACE(content);
    expect_triangle(read(extension, content));
  }
}

// The faults that the issue names, in every format that can have them.
TEST(BrokenMeshes, AreRefusedWithThePlaceOfTheFault) {
  const std::string third = "(byte " + std::to_string(ply_head(kBinary, "3", "1").size() + 24) + ")";
  const std::string list = std::to_string(ply_head(kBinary, "3", "1").size() + 36);
  const std::string later = std::to_string(ply_head(kBinary, "3", kTwoGigabytes).size() + 52);
  struct Fault {
    std::string extension, content, place;
  };
  const std::vector<Fault> faults{
      // Vertices that are not numbers.
      {".obj", obj("nan 1 0", "1 2 3"), "line 4: the face uses vertex 3, whose coordinates (line 3)"},
      {".off", off("nan 1 0", "3 0 1 2"), "line 5: the face uses vertex 2, whose coordinates (line 4)"},
      {".stl", stl_text("nan 1 0"), "line 6: "},
      {".stl", stl_binary(1, kNanF), "byte 120: "},
      {".ply", ply_text("nan 1 0", "3 0 1 2"), "line 13: the face uses vertex 2, whose coordinates (line 12)"},
      {".ply", ply_binary(kNanF, 2), "byte " + list + ": the face uses vertex 2, whose coordinates " + third},
      // Indices out of range. STL has none.
      {".obj", obj("0 1 0", "1 2 4"), "line 4: "},
      {".obj", obj("0 1 0", "1 2 99999999999"), "line 4: "},
      {".off", off("0 1 0", "3 0 1 3"), "line 5: "},
      {".ply", ply_text("0 1 0", "3 0 1 -1"), "line 13: "},
      {".ply", ply_binary(0, 3), "byte " + list + ": "},
      {".ply", ply_binary(0, std::numeric_limits<int>::min()), "byte " + list + ": "},
      // Two billion faces promised, one there. OBJ and the text of STL promise nothing.
      {".off", off("0 1 0", "3 0 1 2", kTwoGigabytes), "line 5: the file is truncated"},
      {".stl", stl_binary(2'000'000'000, 0), "byte 134: the file is truncated"},
      {".ply", ply_text("0 1 0", "3 0 1 2", kTwoGigabytes), "line 13: the file is truncated"},
      {".ply", ply_binary(0, 2, kTwoGigabytes), "byte " + later + ": the file is truncated"},
      // One face that promises two billion corners.
      {".off", off("0 1 0", "2000000000 0 1 2"), "line 5: "},
      {".ply", ply_text("0 1 0", "2000000000 0 1 2"), "line 13: "},
      {".ply", ply_binary(0, 2, "1", 2'000'000'000), "byte " + list + ": the file is truncated"},
      // Two billion vertices promised.
      {".off", "OFF 2000000000 1 0\n0 0 0\n", "line 2: the file is truncated"},
      {".ply", ply_head(kBinary, kTwoGigabytes, "0"),
       "byte " + std::to_string(ply_head(kBinary, kTwoGigabytes, "0").size()) + ": the file is truncated"},
  };
  for (const auto& [extension, content, place] : faults) {
    EXPECT_TRUE(fault(extension, content).starts_with(place)) << fault(extension, content) << "\n" << content;
    const ReadMesh rest = skip(extension, content);
    ASSERT_GE(rest.parts_left_out, 1U) << content;
    EXPECT_TRUE(rest.left_out.front().starts_with(place)) << rest.left_out.front() << "\n" << content;
  }
}

// Wherever a file ends, it is whole, or refused; and what is kept is what came before.
TEST(BrokenMeshes, AreNeverMoreThanWhatIsThere) {
  for (const auto& [extension, content] : whole_files())
    for (std::size_t size = 0; size < content.size(); ++size) {
      const std::string begin = content.substr(0, size);
      const TemporaryFile file(extension, begin);
      try {
        EXPECT_LE(io::read_content(file.path(), OnFault::Refuse).mesh.faces.size(), 1U) << begin;
      } catch (const BrokenMesh& broken) {
        EXPECT_TRUE(std::string(broken.what()).starts_with(file.path().string() + ": ")) << broken.what();
      }
      EXPECT_LE(io::read_content(file.path(), OnFault::Skip).mesh.faces.size(), 1U) << begin;
    }
}

// A byte in place of another, anywhere: refused or read, never worse; every index is in range, every number of a face
// finite.
TEST(BrokenMeshes, AreReadOrRefusedWhateverAByteIsChangedTo) {
  for (const auto& [extension, content] : whole_files())
    for (std::size_t i = 0; i < content.size(); ++i)
      for (const char c : {'\0', '\xff', '9', '-', '\n'}) {
        std::string changed = content;
        changed[i] = c;
        const TemporaryFile file(extension, changed);
        for (const OnFault on_fault : {OnFault::Refuse, OnFault::Skip}) {
          try {
            const ReadMesh result = io::read_content(file.path(), on_fault);
            ASSERT_EQ(result.places.size(), result.mesh.faces.size()) << changed;
            for (const auto& face : result.mesh.faces) {
              ASSERT_GE(face.size(), 3U) << changed;
              for (const std::uint32_t corner : face) {
                ASSERT_LT(corner, result.mesh.vertices.size()) << changed;
                ASSERT_TRUE(result.mesh.vertices[corner].allFinite()) << changed;
              }
            }
          } catch (const BrokenMesh&) {
            EXPECT_EQ(on_fault, OnFault::Refuse) << changed;
          }
        }
      }
}

TEST(BrokenMeshes, SayWhereTheFacesThatAreKeptStand) {
  const ReadMesh text = skip(".obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\nv 0 1 0\nf 1 2 3\n\nf 1 x\nf 3 2 1\n");
  ASSERT_EQ(text.places.size(), 2U);
  EXPECT_EQ(text.places[0].number, 5U);
  EXPECT_EQ(text.places[1].number, 8U);
  EXPECT_EQ(text.places[0].unit, io::SourceLocation::Unit::Line);
  const ReadMesh binary = skip(".stl", stl_binary(1, 0));
  ASSERT_EQ(binary.places.size(), 1U);
  EXPECT_EQ(binary.places[0].number, 84U);
  EXPECT_EQ(binary.places[0].unit, io::SourceLocation::Unit::Byte);
}

TEST(BrokenMeshes, CountAllPartsLeftOutAndDescribeTheFirst) {
  std::string text;
  for (std::size_t i = 0; i < kMostSentences + 7; ++i) text += "f\n";
  const ReadMesh result = skip(".obj", text);
  EXPECT_EQ(result.left_out.size(), kMostSentences);
  EXPECT_EQ(result.parts_left_out, kMostSentences + 7);
}

/// Ends the process: with 0 if the file can be read, or is refused, in no more than `allowed` bytes of further memory.
[[noreturn]] void read_within(const std::filesystem::path& file, std::size_t allowed) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + allowed;
  const rlimit limit{most, most};
  if (pages == 0 || setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(3);
  try {
    (void)io::read_content(file, OnFault::Skip);
  } catch (const std::bad_alloc&) {
    std::_Exit(1);
  }
  std::_Exit(0);
}

// 16 MB are far less than any of the counts asks for, and 40 times what the longest of the files has.
TEST(BrokenMeshes, TakeMemoryForWhatIsThereAlone) {
  if (run_tests::kAddressSanitizer) GTEST_SKIP() << "the address sanitizer takes terabytes of addresses";
  std::string faults, corners = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n150000";
  for (int i = 0; i < 150'000; ++i) faults += "f\n", corners += " 1";
  const std::vector<Whole> files{
      {".off", off("0 1 0", "3 0 1 2", kTwoGigabytes)},
      {".off", off("0 1 0", "2000000000 0 1 2")},
      {".off", "OFF 2000000000 2000000000 0\n"},
      {".stl", stl_binary(2'000'000'000, 0)},
      {".ply", ply_text("0 1 0", "3 0 1 2", kTwoGigabytes)},
      {".ply", ply_binary(0, 2, kTwoGigabytes)},
      {".ply", ply_binary(0, 2, "1", 2'000'000'000)},
      {".ply", ply_head(kBinary, kTwoGigabytes, kTwoGigabytes)},
      {".obj", obj("0 1 0", "1 2 2000000000")},
      {".obj", faults},
      {".off", corners + "\n"},
  };
  for (const auto& [extension, content] : files) {
    const TemporaryFile file(extension, content);
    EXPECT_EXIT(read_within(file.path(), std::size_t{16} << 20), testing::ExitedWithCode(0), "")
        << content.substr(0, 200);
  }
}

}  // namespace
}  // namespace touchstone::geometry_tests
