// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/mesh_fixture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "geometry/io/detail/mesh_builder.h"

namespace touchstone::geometry_tests {
namespace {

std::string test_name() {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& extension, std::string_view content)
    : path_(std::filesystem::path(testing::TempDir()) / (test_name() + extension)) {
  std::ofstream(path_, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

Mesh read(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  const ReadMesh result = io::read_content(file.path(), OnFault::Refuse);
  EXPECT_EQ(result.left_out, Sentences{});
  EXPECT_EQ(result.warnings, Sentences{});
  return result.mesh;
}

std::string fault(const std::string& extension, std::string_view content, OnFault on_fault) {
  const TemporaryFile file(extension, content);
  try {
    (void)read_mesh(file.path(), on_fault);
  } catch (const BrokenMesh& broken) {
    return after_file(file, broken.what());
  }
  return "no fault";
}

ReadMesh skip(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  ReadMesh result = io::read_content(file.path(), OnFault::Skip);
  for (std::string& sentence : result.left_out) sentence = after_file(file, sentence);
  return result;
}

Sentences warnings(const std::string& extension, std::string_view content) {
  const TemporaryFile file(extension, content);
  ReadMesh result = read_mesh(file.path());
  for (std::string& sentence : result.warnings) sentence = after_file(file, sentence);
  return result.warnings;
}

std::string after_file(const TemporaryFile& file, const std::string& sentence) {
  const std::string prefix = file.path().string() + ": ";
  EXPECT_TRUE(sentence.starts_with(prefix)) << sentence;
  return sentence.substr(std::min(prefix.size(), sentence.size()));
}

Points points(const Mesh& mesh) {
  Points result;
  for (const auto& vertex : mesh.vertices) result.push_back({vertex[0], vertex[1], vertex[2]});
  return result;
}

void expect_triangle(const Mesh& mesh) {
  EXPECT_EQ(points(mesh), kTrianglePoints);
  EXPECT_EQ(mesh.faces, (Faces{{0, 1, 2}}));
}

std::string binary_facet(const std::array<float, 9>& coordinates) {
  std::string result = row({0.0f, 0.0f, 1.0f});
  for (const float coordinate : coordinates) result += bytes(coordinate);
  return result + bytes(std::uint16_t{0x0a0d});
}

std::string binary_stl(std::string title, std::uint32_t count, const std::string& facets) {
  title.resize(80, '\0');
  return title + bytes(count) + facets;
}

}  // namespace touchstone::geometry_tests
