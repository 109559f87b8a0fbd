// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/array_of_balls.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <istream>
#include <regex>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace touchstone::scenes {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::uint64_t kLongestHeader = 4096;  // of an array of numbers: std::regex descends once a character

/// Bytes of a stream, and what is wrong where they are not those that are expected.
class Bytes {
 public:
  Bytes(std::istream& stream, const std::string& name) : stream_(stream), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(name_ + ": " + what); }
  /// Returns false if fewer bytes are left.
  [[nodiscard]] bool read(std::span<char> bytes) {
    stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (stream_.bad()) fail("cannot be read to its end");
    return static_cast<std::size_t>(stream_.gcount()) == bytes.size();
  }
  [[nodiscard]] std::string text(std::size_t length) {
    std::string text(length, '\0');
    if (!read(text)) fail("the file ends within the array's header");
    return text;
  }
  [[nodiscard]] bool at_end() { return stream_.peek() == std::istream::traits_type::eof(); }

 private:
  std::istream& stream_;
  const std::string& name_;
};

/// Returns the unsigned number of these bytes, the lowest first.
std::uint64_t whole(std::span<const char> bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

double number(std::span<const char> bytes) {
  if (bytes.size() == sizeof(double)) return std::bit_cast<double>(whole(bytes));
  return std::bit_cast<float>(static_cast<std::uint32_t>(whole(bytes)));
}

struct Shape {
  std::uint64_t rows;
  std::size_t columns, bytes;  ///< bytes of a number
};

std::string value_of(const std::string& header, const char* key, const char* pattern) {
  std::smatch found;
  const std::regex entry(fmt::format("'{}'\\s*:\\s*{}", key, pattern));
  return std::regex_search(header, found, entry) ? found[1].str() : "";
}

Shape read_header(Bytes& bytes) {
  const std::string start = bytes.text(kMagic.size()), version = bytes.text(2);
  if (start != kMagic) bytes.fail("this is not a file of NPY, though its first byte is that of one");
  if (version[0] < 1 || version[0] > 3)
    bytes.fail(fmt::format("version {} of NPY is not known", static_cast<int>(static_cast<unsigned char>(version[0]))));
  const std::uint64_t length = whole(bytes.text(version[0] == 1 ? 2 : 4));
  if (length > kLongestHeader) bytes.fail("the array's header is too long");
  const std::string header = bytes.text(static_cast<std::size_t>(length));
  const std::string type = value_of(header, "descr", "'([^']*)'");
  if (type.empty()) bytes.fail("the array's header does not name the type of its numbers as numpy.save does");
  if (type != "<f8" && type != "<f4")
    bytes.fail("the numbers of the array are not doubles or floats, little-endian: save array.astype('<f8')");
  if (value_of(header, "fortran_order", "(True|False)") != "False")
    bytes.fail("the array is not stored row by row: save numpy.ascontiguousarray(array)");
  for (const std::size_t columns : {4U, 7U}) {
    const std::string rows =
        value_of(header, "shape", fmt::format("\\(\\s*(\\d+)\\s*,\\s*{}\\s*,?\\s*\\)", columns).c_str());
    Shape shape{0, columns, type == "<f8" ? sizeof(double) : sizeof(float)};
    if (std::from_chars(rows.data(), rows.data() + rows.size(), shape.rows).ec == std::errc()) return shape;
  }
  bytes.fail("the shape of the array is not (n, 4), for x y z r, or (n, 7), with the end of a way");
}

}  // namespace

bool begins_as_array(std::istream& stream) { return stream.peek() == static_cast<unsigned char>(kMagic[0]); }

std::vector<NamedBall> read_array_of_balls(std::istream& stream, const std::string& name) {
  Bytes bytes(stream, name);
  const Shape shape = read_header(bytes);
  std::vector<NamedBall> balls;
  std::vector<char> row(shape.columns * shape.bytes);
  for (std::uint64_t i = 0; i < shape.rows; ++i) {
    if (!bytes.read(row)) bytes.fail(fmt::format("row {}: the file ends, but the array has {} rows", i, shape.rows));
    double numbers[7];
    for (std::size_t k = 0; k < shape.columns; ++k)
      numbers[k] = number(std::span(row).subspan(k * shape.bytes, shape.bytes));
    NamedBall ball = ball_of(std::span(numbers).first(shape.columns), std::to_string(i));
    const auto fault = std::visit([](const auto& asked) { return find_fault(asked); }, ball.question);
    if (fault) bytes.fail(fmt::format("row {}: {}", i, fault->message));
    balls.push_back(std::move(ball));
  }
  if (!bytes.at_end()) bytes.fail("the file continues after the array");
  return balls;
}

}  // namespace touchstone::scenes
