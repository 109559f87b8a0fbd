// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/read_mesh.h"

namespace touchstone::geometry_tests {

using Faces = std::vector<std::vector<std::uint32_t>>;
using Points = std::vector<std::array<double, 3>>;
using Sentences = std::vector<std::string>;

inline const Points kTrianglePoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// A file in the test's folder, removed at the end of its scope.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& extension, std::string_view content);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The mesh of a file in which nothing is wrong, though it be without a face.
[[nodiscard]] Mesh read(const std::string& extension, std::string_view content);

/// Returns the message with which the file is refused, from the line or byte on.
[[nodiscard]] std::string fault(const std::string& extension, std::string_view content,
                                OnFault on_fault = OnFault::Refuse);

/// The mesh with OnFault::Skip, though it be without a face, and what is left out from the line or byte on.
[[nodiscard]] ReadMesh skip(const std::string& extension, std::string_view content);

/// The warnings about a file that is read, from the line or byte on.
[[nodiscard]] Sentences warnings(const std::string& extension, std::string_view content);

/// The sentence without the file that it begins with.
[[nodiscard]] std::string after_file(const TemporaryFile& file, const std::string& sentence);

[[nodiscard]] Points points(const Mesh& mesh);

/// Expects one face, of the vertices kTrianglePoints in their order.
void expect_triangle(const Mesh& mesh);

template <class Number>
[[nodiscard]] std::string bytes(Number number, std::endian order = std::endian::little) {
  auto result = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native) std::reverse(result.begin(), result.end());
  return {result.begin(), result.end()};
}

template <class Number>
[[nodiscard]] std::string row(std::initializer_list<Number> numbers, std::endian order = std::endian::little) {
  std::string result;
  for (const Number number : numbers) result += bytes(number, order);
  return result;
}

[[nodiscard]] std::string binary_facet(const std::array<float, 9>& coordinates);
/// Promises `count` facets.
[[nodiscard]] std::string binary_stl(std::string title, std::uint32_t count, const std::string& facets);

}  // namespace touchstone::geometry_tests
