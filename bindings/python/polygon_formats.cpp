// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/polygon_formats.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

#include "bindings/python/doubles.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/detail/text_number.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

[[noreturn]] void malformed(const std::string& message) { throw Rejected({RejectionCode::MalformedCase, message}); }

/// Throws Rejected unless the name of a geometry is that of a polygon.
void expect_polygon(const std::string& name, bool is_polygon) {
  if (!is_polygon) malformed("expected the geometry of one Polygon, got '" + io::legible(name, 40) + "'");
}

/// A strict reader of POLYGON and POLYGON Z in well-known text. Keywords are in any case; hexadecimal numbers are read.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) { skip_blanks(); }

  std::vector<Loop> polygon() {
    const std::string name = word();
    expect_polygon(name, name == "POLYGON" || name == "POLYGONZ");
    const bool has_z = name == "POLYGONZ" || pass_word("Z");
    if (pass_word("EMPTY")) malformed("the polygon is empty");
    if (!at('(')) fail(has_z ? "expected '('" : "expected '(' or 'Z'");
    if (has_z) coordinates_ = 3;
    std::vector<Loop> loops = list<Loop>([this] { return list<Eigen::Vector3d>([this] { return point(); }); });
    if (position_ < text_.size()) fail("expected the end");
    return loops;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    const std::string found =
        position_ < text_.size() ? "'" + io::legible(text_.substr(position_), 20) + "'" : "the end";
    malformed("WKT, character " + std::to_string(position_) + ": " + expected + ", found " + found);
  }

  void skip_blanks() { position_ = std::min(text_.find_first_not_of(" \t\r\n", position_), text_.size()); }
  [[nodiscard]] bool at(char c) const { return position_ < text_.size() && text_[position_] == c; }
  bool pass(char c) {
    if (!at(c)) return false;
    ++position_;
    skip_blanks();
    return true;
  }
  void expect(char c) {
    if (!pass(c)) fail(std::string("expected '") + c + "'");
  }
  /// Takes letters, as capitals.
  std::string word() {
    std::string letters;
    for (; position_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[position_])); ++position_)
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[position_])));
    skip_blanks();
    return letters;
  }

  bool pass_word(std::string_view expected) {
    const std::size_t before = position_;
    if (word() == expected) return true;
    position_ = before;
    return false;
  }

  /// Takes elements in brackets, separated by commas.
  template <class Element, class Take>
  std::vector<Element> list(const Take& take) {
    std::vector<Element> elements;
    expect('(');
    do elements.push_back(take());
    while (pass(','));
    if (!at(')')) fail("expected ',' or ')'");
    expect(')');
    return elements;
  }

  Eigen::Vector3d point() {
    Eigen::Vector3d point(0, 0, 0);
    int count = 0;
    for (; !at(',') && !at(')'); ++count) {
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()", position_), text_.size());
      const std::optional<double> number = io::nearest_double(text_.substr(position_, end - position_));
      if (!number || count == 3) fail(count == 3 ? "expected ',' or ')'" : "expected a number");
      point[count] = *number;
      position_ = end;
      skip_blanks();
    }
    if (coordinates_ == 0) coordinates_ = std::max(count, 2);
    if (count != coordinates_) fail("expected " + std::to_string(coordinates_) + " numbers a point");
    return point;
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int coordinates_ = 0;  // of each point; 0 before it is known
};

/// Returns the points of a ring. Throws Rejected, which names the loop, for what NumPy cannot make rows of doubles of.
Doubles rows_of_ring(py::handle ring, std::size_t number) try {
  return doubles_of(ring);
} catch (const py::error_already_set& error) {
  if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_OverflowError)) throw;
  malformed(loop_name(number) + ": " + py::str(error.value()).cast<std::string>());
}

/// `coordinates`: of each point of the polygon; 0 before it is known.
Loop loop_of_ring(py::handle ring, std::size_t number, py::ssize_t& coordinates) {
  const Doubles rows = rows_of_ring(ring, number);
  if (rows.ndim() != 2 || (rows.shape(1) != 2 && rows.shape(1) != 3))
    malformed(loop_name(number) + " must be a list of points, each of two or of three numbers");
  if (coordinates == 0) coordinates = rows.shape(1);
  if (rows.shape(1) != coordinates)
    malformed(loop_name(number) + " has points of " + std::to_string(rows.shape(1)) +
              " numbers, but the outer loop of " + std::to_string(coordinates));
  Loop loop;
  const auto at = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i)
    loop.emplace_back(at(i, 0), at(i, 1), at.shape(1) == 3 ? at(i, 2) : 0.0);
  return loop;
}

std::vector<Loop> loops_of_geojson(const py::dict& geometry) {
  if (!geometry.contains("type")) malformed("the GeoJSON has no key \"type\"");
  const auto type = py::str(geometry["type"]).cast<std::string>();
  expect_polygon(type, type == "Polygon");
  if (!geometry.contains("coordinates")) malformed("the GeoJSON has no key \"coordinates\"");
  const py::object rings = geometry["coordinates"];
  if (!py::isinstance<py::iterable>(rings)) malformed("\"coordinates\" of the GeoJSON must be a list of rings");
  std::vector<Loop> loops;
  py::ssize_t coordinates = 0;
  for (const py::handle ring : rings) loops.push_back(loop_of_ring(ring, loops.size(), coordinates));
  if (loops.empty()) malformed("the polygon is empty");
  return loops;
}

}  // namespace

std::vector<Loop> closed_loops_of(py::handle object) {
  if (py::isinstance<py::str>(object)) return WktReader(object.cast<std::string>()).polygon();
  const py::object geometry = py::hasattr(object, "__geo_interface__") ? py::object(object.attr("__geo_interface__"))
                                                                       : py::reinterpret_borrow<py::object>(object);
  if (!py::isinstance<py::dict>(geometry))
    throw py::type_error("expected an object with `__geo_interface__`, a GeoJSON dict or WKT, got " +
                         py::str(py::type::of(object)).cast<std::string>());
  return loops_of_geojson(geometry);
}

}  // namespace touchstone::python
