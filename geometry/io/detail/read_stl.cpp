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
  for (const Eigen::Vector3d& point : triangle) builder.add_vertex(place, [&] { return point; });
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

/// Returns whether the facets, each with as many bytes after it as its attribute count announces, end where the file
/// does, blanks apart.
bool has_payload(const MeshSource& source, std::uint32_t count) {
  ByteReader bytes(source, kHeaderBytes, std::endian::little);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bytes.bytes_left() < kFacetBytes) return false;
    bytes.skip(kFacetBytes - sizeof(std::uint16_t));
    const std::size_t announced = bytes.take<std::uint16_t>();
    if (bytes.bytes_left() < announced) return false;
    bytes.skip(announced);
  }
  return bytes.only_blanks_left();
}

/// How many bytes lie between the facets. Attribute counts are other programs' colours, unless the size of the file
/// says otherwise. Where it fits neither, the facets after the first cannot be found.
enum class Layout { Dense, Payload, Unknown };

Layout layout_of(const MeshSource& source, std::uint32_t count) {
  const std::uint64_t body = source.bytes.size() - kHeaderBytes, facets = std::uint64_t{count} * kFacetBytes;
  if (body == facets) return Layout::Dense;
  if (has_payload(source, count)) return Layout::Payload;
  if (body < facets) return Layout::Unknown;
  const ByteReader after(source, static_cast<std::size_t>(kHeaderBytes + facets), std::endian::little);
  return after.only_blanks_left() ? Layout::Dense : Layout::Unknown;
}

void read_binary(const MeshSource& source, MeshBuilder& builder) {
  if (source.bytes.size() < kHeaderBytes)
    source.lost({SourceLocation::Unit::Byte, source.bytes.size()},
                "the file is truncated within its header of 84 bytes");
  ByteReader bytes(source, kTitleBytes, std::endian::little);
  const auto count = bytes.take<std::uint32_t>();
  const Layout layout = layout_of(source, count);
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
    const std::size_t announced = bytes.take<std::uint16_t>();
    builder.attempt([&] {
      for (std::size_t corner = 0; corner < 3; ++corner) (void)source.finite(places[corner], triangle[corner]);
      add_triangle(builder, facet, triangle);
    });
    if (layout == Layout::Payload) bytes.skip(announced);
    if (layout == Layout::Unknown && announced != 0 && bytes.bytes_left() >= kFacetBytes)
      source.lost(bytes.place(), "the size of the file fits neither its count nor the " + std::to_string(announced) +
                                     " bytes announced after facet " + std::to_string(i));
  }
  builder.end(bytes);
}

/// Reads the words of a text STL, on whatever lines they are. Keywords are in upper or lower case.
class WordReader {
 public:
  explicit WordReader(const MeshSource& source) : source_(source), lines_(source, {}) { advance(); }

  [[nodiscard]] bool at_end() const { return at_end_; }
  [[nodiscard]] bool at(std::string_view keyword) const { return keyword_ == keyword; }
  [[nodiscard]] bool at_end_of(const std::string& part) const {
    if (!at("end")) return at("end" + part);
    TextReader ahead(lines_);
    return ahead.next_word() && lower_case(ahead.peek()) == part;
  }
  [[nodiscard]] SourceLocation place() const { return lines_.place(); }

  void advance() {
    begins_line_ = lines_.line_is_done();
    at_end_ = !lines_.next_word();
    keyword_ = at_end_ ? "" : lower_case(lines_.take());
  }
  /// Moves past this keyword.
  void pass(const std::string& keyword) {
    if (!at(keyword)) expected("'" + keyword + "'");
    advance();
  }
  /// Moves past `endloop` or `end loop`, for example.
  void pass_end_of(const std::string& part) {
    if (!at_end_of(part)) expected("'end" + part + "'");
    if (at("end")) advance();
    advance();
  }
  /// Moves over a name: to the next line, or to a word on this line where something begins. Reports a fault if the name
  /// holds what only a facet has.
  template <class Begins>
  void pass_name(const Begins& begins) {
    for (; !at_end_ && !begins_line_ && !begins(); advance()) {
      const std::string next = lower_case(lines_.peek());
      if ((at("outer") && next == "loop") || (at("vertex") && nearest_double(next)) || at("endloop") || at("endfacet"))
        expected("a name");
    }
  }
  /// Moves over `normal` and three numbers, whatever their values are.
  void pass_normal() {
    if (!at("normal")) return;
    for (int i = 0; i <= 3; ++i, advance())
      if (at_end_ || at("outer") || at("vertex") || at("facet")) expected("three numbers after 'normal'");
  }
  /// Returns whether a solid begins here: the word alone may be a part of a name.
  [[nodiscard]] bool at_solid() {
    if (!at("solid") || begins_line_) return at("solid");
    if (line_without_facet_ == lines_.place().number) return false;
    const std::string rest = lower_case(lines_.rest_of_line());
    const bool begins = rest.find("outer") != std::string::npos && rest.find("loop") != std::string::npos;
    if (!begins) line_without_facet_ = lines_.place().number;
    return begins;
  }
  /// Returns whether a facet begins here: the word alone may be a part of a name.
  [[nodiscard]] bool at_facet() const {
    if (!at("facet") || begins_line_) return at("facet");
    TextReader ahead(lines_);
    const std::string next = lower_case(ahead.take());
    return next == "outer" || (next == "normal" && nearest_double(ahead.peek()));
  }

  Eigen::Vector3d take_vertex() {
    const SourceLocation vertex = place();
    Eigen::Vector3d point;
    for (int axis = 0; axis < 3; ++axis) {
      const bool on_line = !lines_.line_is_done();
      if (!lines_.next_word() || (!on_line && !nearest_double(lines_.peek())))
        source_.broken(vertex, "expected three numbers after 'vertex', found " + std::to_string(axis));
      point[axis] = lines_.take_number();
    }
    advance();
    if (!at_end_ && !begins_line_ && nearest_double(keyword_))
      source_.broken(vertex, "expected three numbers after 'vertex', found more");
    return point;
  }

  [[noreturn]] void expected(const std::string& what) const {
    if (at_end_) lines_.truncated("expected " + what);
    lines_.broken("expected " + what + ", found " + TextReader::quoted(keyword_));
  }

 private:
  static std::string lower_case(std::string_view word) {
    std::string lower(word);
    for (char& c : lower)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
  }

  const MeshSource& source_;
  TextReader lines_;
  std::string keyword_;
  bool at_end_ = false, begins_line_ = true;
  std::size_t line_without_facet_ = 0;  // from the current word on
};

void read_facet(const MeshSource& source, WordReader& words, MeshBuilder& builder) {
  const SourceLocation place = words.place();
  words.pass("facet");
  words.pass_normal();
  words.pass("outer");
  words.pass("loop");
  Triangle triangle;
  std::size_t count = 0;
  for (; words.at("vertex"); ++count) {
    const Eigen::Vector3d point = words.take_vertex();
    if (count < 3) triangle[count] = point;
  }
  words.pass_end_of("loop");
  if (count != 3) source.broken(place, "a facet has 3 vertices, this one has " + std::to_string(count));
  words.pass_end_of("facet");
  add_triangle(builder, place, triangle);
}

/// After a fault: moves to the next facet or end of a solid, past the end of a facet.
void leave_facet(WordReader& words) {
  while (!words.at_end() && !words.at_end_of("facet") && !words.at_facet() && !words.at_end_of("solid"))
    words.advance();
  if (words.at_end_of("facet")) words.pass_end_of("facet");
}

void read_text(const MeshSource& source, MeshBuilder& builder) {
  WordReader words(source);
  do {
    words.pass("solid");
    words.pass_name([&] { return words.at_facet() || words.at_end_of("solid"); });
    for (bool has_facet = false; !words.at_end_of("solid"); has_facet = true) {
      if (words.at_end() && has_facet) return builder.warn(words.place(), "the last 'endsolid' is missing");
      if (!builder.attempt([&] {
            if (!words.at("facet")) words.expected("'facet' or 'endsolid'");
            read_facet(source, words, builder);
          }))
        leave_facet(words);
    }
    words.pass_end_of("solid");
    words.pass_name([&] { return words.at_solid(); });
  } while (!words.at_end());
}

}  // namespace

void read_stl(const MeshSource& source, MeshBuilder& builder) {
  if (is_binary(source))
    read_binary(source, builder);
  else
    read_text(source, builder);
}

}  // namespace touchstone::io
