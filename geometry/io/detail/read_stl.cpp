// SPDX-License-Identifier: Apache-2.0
// STL: triangles without shared vertices, so each adds three vertices. Normals are ignored.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

constexpr std::size_t kTitleBytes = 80;
constexpr std::size_t kHeaderBytes = kTitleBytes + sizeof(std::uint32_t);
constexpr std::size_t kFacetBytes = 12 * sizeof(float) + sizeof(std::uint16_t);

using Triangle = std::array<Eigen::Vector3d, 3>;

void add_triangle(MeshBuilder& builder, SourceLocation place, const Triangle& triangle) {
  const auto first = static_cast<std::int64_t>(builder.vertices_so_far());
  for (const Eigen::Vector3d& point : triangle) builder.add_vertex([&] { return point; });
  builder.add_face(place, std::array{first, first + 1, first + 2});
}

/// Returns whether the file is binary. A binary file may begin with "solid", as text does. It has exactly the size that
/// its count requires or, if it is damaged, a zero byte in its header, because a count below 2^24 facets has one. Text
/// in UTF-16 has zero bytes, too; the text reader refuses it.
bool is_binary(const MeshSource& source) {
  if (source.bytes.size() >= kHeaderBytes) {
    const std::uint64_t count = ByteReader(source, kTitleBytes, std::endian::little).take<std::uint32_t>();
    if (source.bytes.size() - kHeaderBytes == count * kFacetBytes) return true;
  }
  if (source.has_wide_byte_order_mark()) return false;
  return std::string_view(source.bytes).substr(0, kHeaderBytes).find('\0') != std::string_view::npos;
}

void read_binary(const MeshSource& source, MeshBuilder& builder) {
  if (source.bytes.size() < kHeaderBytes)
    source.lost({SourceLocation::Unit::Byte, source.bytes.size()},
                "the file is truncated within its header of 84 bytes");
  ByteReader bytes(source, kTitleBytes, std::endian::little);
  const auto count = bytes.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const SourceLocation facet = bytes.place();
    if (bytes.bytes_left() < kFacetBytes)
      source.lost(facet, "the file is truncated: facet " + std::to_string(i) + " of " + std::to_string(count) +
                             " is not complete");
    bytes.skip(3 * sizeof(float));
    std::array<SourceLocation, 3> places;
    Triangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      places[corner] = bytes.place();
      for (int axis = 0; axis < 3; ++axis) triangle[corner][axis] = static_cast<double>(bytes.take<float>());
    }
    bytes.skip(sizeof(std::uint16_t));
    builder.attempt([&] {
      for (std::size_t corner = 0; corner < 3; ++corner) (void)source.finite(places[corner], triangle[corner]);
      add_triangle(builder, facet, triangle);
    });
  }
  bytes.file_is_done();
}

/// Reads the lines of a text STL, which are recognised by their first word, in upper or lower case.
class StatementReader {
 public:
  explicit StatementReader(const MeshSource& source) : lines_(source, {}) { advance(); }

  [[nodiscard]] bool at_end() const { return at_end_; }
  [[nodiscard]] bool at(std::string_view keyword) const { return keyword_ == keyword; }
  [[nodiscard]] TextReader& line() { return lines_; }

  void advance() {
    at_end_ = !lines_.next_line();
    keyword_ = at_end_ ? "" : std::string(lines_.take());
    for (char& c : keyword_)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }

  /// Moves past the line of this keyword, whatever follows on that line.
  void pass(const std::string& keyword) {
    if (!at(keyword)) expected("'" + keyword + "'");
    advance();
  }

  [[noreturn]] void expected(const std::string& what) const {
    if (at_end_) lines_.truncated("expected " + what);
    lines_.broken("expected " + what + ", found " + TextReader::quoted(keyword_));
  }

 private:
  TextReader lines_;
  std::string keyword_;
  bool at_end_ = false;
};

void read_facet(const MeshSource& source, StatementReader& statements, MeshBuilder& builder) {
  const SourceLocation place = statements.line().place();
  statements.pass("facet");
  statements.pass("outer");
  Triangle triangle;
  std::size_t count = 0;
  for (; statements.at("vertex"); ++count) {
    const Eigen::Vector3d point = statements.line().take_point("after 'vertex'");
    if (!statements.line().line_is_done())
      statements.line().broken("expected three numbers after 'vertex', found more");
    if (count < 3) triangle[count] = point;
    statements.advance();
  }
  statements.pass("endloop");
  if (count != 3) source.broken(place, "a facet has 3 vertices, this one has " + std::to_string(count));
  statements.pass("endfacet");
  add_triangle(builder, place, triangle);
}

/// After a fault in a facet: moves past its end, or to the next keyword that can only follow it.
void leave_facet(StatementReader& statements) {
  while (!statements.at_end() && !statements.at("endfacet") && !statements.at("facet") && !statements.at("endsolid"))
    statements.advance();
  if (statements.at("endfacet")) statements.advance();
}

void read_text(const MeshSource& source, MeshBuilder& builder) {
  StatementReader statements(source);
  do {
    statements.pass("solid");
    while (!statements.at("endsolid")) {
      if (statements.at("facet")) {
        if (!builder.attempt([&] { read_facet(source, statements, builder); })) leave_facet(statements);
      } else if (!builder.attempt([&] { statements.expected("'facet' or 'endsolid'"); })) {
        statements.advance();
      }
    }
    statements.advance();
  } while (!statements.at_end());
}

}  // namespace

void read_stl(const MeshSource& source, MeshBuilder& builder) {
  if (is_binary(source))
    read_binary(source, builder);
  else
    read_text(source, builder);
}

}  // namespace touchstone::io
