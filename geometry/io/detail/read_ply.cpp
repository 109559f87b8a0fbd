// SPDX-License-Identifier: Apache-2.0
// PLY: the header declares elements (vertex, face, others) and their properties; the values follow as text or binary.
// Reads x, y and z of each vertex and the vertex numbers of each face, and ignores the rest.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/mesh_builder.h"
#include "geometry/io/detail/text_reader.h"

namespace touchstone::io {
namespace {

enum class Scalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(Scalar type) {
  switch (type) {
    case Scalar::Int8:
    case Scalar::Uint8: return 1;
    case Scalar::Int16:
    case Scalar::Uint16: return 2;
    case Scalar::Int32:
    case Scalar::Uint32:
    case Scalar::Float32: return 4;
    case Scalar::Float64: return 8;
  }
  return 0;
}

struct Property {
  std::string name;
  Scalar type;
  std::optional<Scalar> count_type;  ///< lists only
};

struct Element {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties;
};

enum class Encoding { Text, LittleEndian, BigEndian };

struct PlyHeader {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
};

/// Returns 0, 1 or 2 for the properties x, y and z.
std::optional<int> axis_of(const Property& property) {
  if (property.count_type || property.name.size() != 1 || property.name[0] < 'x' || property.name[0] > 'z')
    return std::nullopt;
  return property.name[0] - 'x';
}

bool holds_corners(const Property& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// The header

Scalar take_type(TextReader& lines) {
  struct Name {
    std::string_view name;
    Scalar type;
  };
  static constexpr std::array<Name, 16> kNames{{{"char", Scalar::Int8},
                                                {"int8", Scalar::Int8},
                                                {"uchar", Scalar::Uint8},
                                                {"uint8", Scalar::Uint8},
                                                {"short", Scalar::Int16},
                                                {"int16", Scalar::Int16},
                                                {"ushort", Scalar::Uint16},
                                                {"uint16", Scalar::Uint16},
                                                {"int", Scalar::Int32},
                                                {"int32", Scalar::Int32},
                                                {"uint", Scalar::Uint32},
                                                {"uint32", Scalar::Uint32},
                                                {"float", Scalar::Float32},
                                                {"float32", Scalar::Float32},
                                                {"double", Scalar::Float64},
                                                {"float64", Scalar::Float64}}};
  const std::string_view word = lines.take();
  const auto* const found =
      std::find_if(kNames.begin(), kNames.end(), [&](const Name& known) { return known.name == word; });
  if (found == kNames.end()) lines.broken(TextReader::quoted(word) + " is not a number type");
  return found->type;
}

/// Takes a format and its version, of which there is one.
Encoding take_encoding(TextReader& lines) {
  const std::string_view word = lines.take();
  if (word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
    lines.broken("unknown format " + TextReader::quoted(word));
  if (const std::string_view version = lines.take(); version != "1.0")
    lines.broken("expected the version 1.0, found " +
                 (version.empty() ? "the end of the line" : TextReader::quoted(version)));
  return word == "ascii" ? Encoding::Text : word == "binary_big_endian" ? Encoding::BigEndian : Encoding::LittleEndian;
}

std::string take_name(TextReader& lines) {
  const std::string_view word = lines.take();
  if (word.empty()) lines.broken("expected a name, found the end of the line");
  return std::string(word);
}

Property take_property(TextReader& lines) {
  Property property{};
  if (lines.peek() == "list") {
    lines.take();
    property.count_type = take_type(lines);
  }
  property.type = take_type(lines);
  property.name = take_name(lines);
  return property;
}

void check_elements(const std::vector<Element>& elements, const TextReader& lines) {
  std::size_t vertex_elements = 0;
  std::size_t face_elements = 0;
  for (const Element& element : elements) {
    if (element.name == "vertex") {
      ++vertex_elements;
      std::array<int, 3> declared{};
      for (const Property& property : element.properties)
        if (const auto axis = axis_of(property)) ++declared[static_cast<std::size_t>(*axis)];
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (declared[axis] != 1)
          lines.broken("the element 'vertex' needs one property '" + std::string(1, "xyz"[axis]) + "', it has " +
                       std::to_string(declared[axis]));
    }
    if (element.name == "face") {
      ++face_elements;
      const auto lists = std::count_if(element.properties.begin(), element.properties.end(), holds_corners);
      if (lists != 1)
        lines.broken("the element 'face' needs one list 'vertex_indices' or 'vertex_index', it has " +
                     std::to_string(lists));
    }
  }
  for (const Element& element : elements)
    if (element.name != "face" && std::ranges::any_of(element.properties, holds_corners))
      lines.broken("the element " + TextReader::quoted(element.name) +
                   " holds vertex numbers, and only faces are read");
  if (vertex_elements != 1) lines.broken("expected one element 'vertex', found " + std::to_string(vertex_elements));
  if (face_elements > 1) lines.broken("expected one element 'face', found " + std::to_string(face_elements));
}

PlyHeader take_ply_header(TextReader& lines) {
  const auto need_line = [&] {
    if (!lines.next_line()) lines.truncated("its header has no 'end_header'");
  };
  const auto end_line = [&] {
    if (!lines.line_is_done())
      lines.broken("unexpected " + TextReader::quoted(lines.peek()) + " at the end of a header line");
  };
  need_line();
  if (const std::string_view word = lines.take(); word != "ply")
    lines.broken("expected 'ply', found " + TextReader::quoted(word));
  end_line();

  PlyHeader header;
  bool has_format = false;
  for (;;) {
    need_line();
    const std::string_view keyword = lines.take();
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") break;
    if (keyword == "format") {
      if (has_format) lines.broken("a second line 'format'");
      header.encoding = take_encoding(lines);
      has_format = true;
    } else if (keyword == "element") {
      std::string name = take_name(lines);
      header.elements.push_back({std::move(name), lines.take_count(), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) lines.broken("a property comes before the first element");
      header.elements.back().properties.push_back(take_property(lines));
    } else {
      lines.broken(TextReader::quoted(keyword) + " is not a PLY header keyword");
    }
    end_line();
  }
  end_line();
  if (!has_format) lines.broken("the header has no line 'format'");
  check_elements(header.elements, lines);
  return header;
}

// The values, which are in the same order in text and binary files

/// Returns whether the values fill the rest of the file as words, but not the lines one by one, so that no element can
/// be skipped whose values are faulty.
bool is_words(const MeshSource& source, const PlyHeader& header, const TextReader& after_header) {
  TextReader lines(after_header), words(after_header);
  const auto most = static_cast<std::int64_t>(source.bytes.size());
  std::int64_t elements = 0;
  for (const Element& element : header.elements)
    if (!element.properties.empty()) elements += std::min(element.count, most);
  if (elements > most || lines.count_lines() == elements) return false;
  for (const Element& element : header.elements)
    for (std::int64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const Property& property : element.properties)
        if (!(property.count_type ? words.take_list_of_words() : words.take_words(1))) return false;
  return !words.next_word();
}

/// Reads values as text: as words, or from lines of which each holds an element, so that a faulty one can be skipped.
class TextValues {
 public:
  TextValues(TextReader& lines, bool is_words) : lines_(lines), is_words_(is_words) {
    if (is_words) lines.read_words();
  }

  void begin_element(const Element& element, std::int64_t index) {
    if (!(is_words_ ? lines_.next_word() : lines_.next_line()))
      lines_.truncated(legible(element.name) + " " + std::to_string(index) + " of " + std::to_string(element.count) +
                       " is missing");
  }
  void end_element() {
    if (!is_words_ && !lines_.line_is_done()) lines_.broken("unexpected values after the last property");
  }
  void pass_element(const Element& element) {
    for (const Property& property : element.properties)
      skip(property.type, property.count_type ? take_count(property) : 1);
    end_element();
  }

  [[nodiscard]] SourceLocation place() const { return lines_.place(); }
  double take_number(Scalar) {
    seek();
    return lines_.take_double();
  }
  std::int64_t take_count(const Property& list) {
    seek();
    return lines_.take_count(written(*list.count_type));
  }
  void take_corners(const Property& list, std::int64_t count, std::vector<std::int64_t>& corners) {
    if (!is_words_) return lines_.take_corners(count, corners, written(list.type));
    corners.resize(static_cast<std::size_t>(count));
    for (std::int64_t& corner : corners) seek(), corner = lines_.take_whole("vertex number", written(list.type));
  }
  void skip(Scalar, std::int64_t count) {
    if (is_words_)
      (void)lines_.take_words(count);
    else
      lines_.skip_fields(count);
  }

 private:
  static TextReader::Whole written(Scalar type) {
    const bool whole = type != Scalar::Float32 && type != Scalar::Float64;
    return whole ? TextReader::Whole::Digits : TextReader::Whole::Decimal;
  }

  /// Moves to the next word.
  void seek() {
    if (is_words_) (void)lines_.next_word();
  }

  TextReader& lines_;
  bool is_words_;
};

/// Reads values as binary. Elements end with their last property, so after a wrong list count the rest of the file is
/// lost.
class BinaryValues {
 public:
  BinaryValues(const MeshSource& source, ByteReader& bytes) : source_(source), bytes_(bytes) {}

  void begin_element(const Element& element, std::int64_t index) {
    if (bytes_.bytes_left() == 0)
      source_.lost(place(), "the file is truncated: " + legible(element.name) + " " + std::to_string(index) + " of " +
                                std::to_string(element.count) + " is missing");
  }
  void end_element() {}
  void pass_element(const Element& element) {
    for (const Property& property : element.properties)
      skip(property.type, property.count_type ? take_count(property) : 1);
  }

  [[nodiscard]] SourceLocation place() const { return bytes_.place(); }

  double take_number(Scalar type) {
    switch (type) {
      case Scalar::Int8: return bytes_.take<std::int8_t>();
      case Scalar::Uint8: return bytes_.take<std::uint8_t>();
      case Scalar::Int16: return bytes_.take<std::int16_t>();
      case Scalar::Uint16: return bytes_.take<std::uint16_t>();
      case Scalar::Int32: return bytes_.take<std::int32_t>();
      case Scalar::Uint32: return bytes_.take<std::uint32_t>();
      case Scalar::Float32: return static_cast<double>(bytes_.take<float>());
      case Scalar::Float64: return bytes_.take<double>();
    }
    return 0;
  }

  std::int64_t take_count(const Property& list) {
    const SourceLocation count_place = place();
    const std::int64_t count = take_whole(*list.count_type);
    if (count < 0) source_.lost(count_place, "the count " + std::to_string(count) + " is negative");
    if (static_cast<std::uint64_t>(count) > bytes_.bytes_left() / size_of(list.type))
      source_.lost(count_place, "the file is truncated within a list of " + std::to_string(count));
    return count;
  }

  void take_corners(const Property& list, std::int64_t count, std::vector<std::int64_t>& corners) {
    corners.clear();
    for (; count > 0; --count) corners.push_back(take_whole(list.type));
  }

  void skip(Scalar type, std::int64_t count) { bytes_.skip(size_of(type) * static_cast<std::size_t>(count)); }

 private:
  std::int64_t take_whole(Scalar type) {
    constexpr double kLimit = 1e15;  // integers up to here are exact doubles
    const SourceLocation number_place = place();
    const double value = take_number(type);
    if (!(std::abs(value) < kLimit) || value != std::floor(value))
      source_.lost(number_place, "a count or vertex number is not an integer");
    return static_cast<std::int64_t>(value);
  }

  const MeshSource& source_;
  ByteReader& bytes_;
};

template <class Values>
Eigen::Vector3d take_vertex(const Element& element, Values& values) {
  Eigen::Vector3d point;
  for (const Property& property : element.properties)
    if (const auto axis = axis_of(property))
      point[*axis] = values.take_number(property.type);
    else
      values.skip(property.type, property.count_type ? values.take_count(property) : 1);
  values.end_element();
  return point;
}

template <class Values>
void take_corners(const Element& element, Values& values, std::vector<std::int64_t>& corners) {
  for (const Property& property : element.properties) {
    const std::int64_t count = property.count_type ? values.take_count(property) : 1;
    if (holds_corners(property))
      values.take_corners(property, count, corners);
    else
      values.skip(property.type, count);
  }
  values.end_element();
}

template <class Values>
void read_elements(const PlyHeader& header, Values values, MeshBuilder& builder) {
  std::vector<std::int64_t> corners;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no space in the file, whatever its count
    for (std::int64_t i = 0; i < element.count; ++i) {
      values.begin_element(element, i);
      const SourceLocation place = values.place();
      if (element.name == "vertex")
        builder.add_vertex(place, [&] { return take_vertex(element, values); });
      else if (element.name == "face")
        builder.attempt([&] {
          take_corners(element, values, corners);
          builder.add_face(place, corners);
        });
      else
        builder.attempt([&] { values.pass_element(element); });
    }
  }
}

}  // namespace

void read_ply(const MeshSource& source, MeshBuilder& builder) {
  TextReader lines(source, {});
  const PlyHeader header = take_ply_header(lines);
  if (header.encoding == Encoding::Text) {
    read_elements(header, TextValues(lines, is_words(source, header, lines)), builder);
    if (lines.next_line()) lines.broken("unexpected data after the elements that the counts declare");
  } else {
    ByteReader bytes(source, lines.position(),
                     header.encoding == Encoding::LittleEndian ? std::endian::little : std::endian::big);
    read_elements(header, BinaryValues(source, bytes), builder);
    builder.end(bytes);
  }
}

}  // namespace touchstone::io
