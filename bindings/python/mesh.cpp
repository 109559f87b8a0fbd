// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/mesh.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/bindings.h"
#include "bindings/python/doubles.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/words.h"
#include "geometry/same_number.h"
#include "geometry/shapes/rejection.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;
using Face = std::vector<std::uint32_t>;
using Indices = Numbers<std::int64_t>;

[[noreturn]] void reject(const std::string& message) { throw Rejected({RejectionCode::MalformedCase, message}); }

/// Returns whole numbers as an array of one or two dimensions. Of other numbers NumPy would drop the fraction, and of
/// large ones a bit.
Indices indices_of(py::handle numbers, const std::string& name) {
  expect_unmasked(numbers);
  const py::array array = py::module_::import("numpy").attr("asarray")(numbers);
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u')
    throw py::type_error(name + ": expected whole numbers below 2**63, got " +
                         py::str(array.dtype()).cast<std::string>());
  if (array.size() > 0 && kind == 'u' &&
      py::int_(array.attr("max")()) > py::int_(std::numeric_limits<std::int64_t>::max()))
    reject(name + ": a vertex number is 2**63 or more");
  return Indices(array);
}

/// Returns a face with these vertex numbers, bad or not.
Face unchecked_face_of(const std::int64_t* numbers, py::ssize_t count, std::size_t face) {
  Face loop;
  for (const std::int64_t number : std::span(numbers, static_cast<std::size_t>(count))) {
    if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
      reject("face " + std::to_string(face) + " has vertex " + std::to_string(number) +
             ", which is not a number of 32 bits");
    loop.push_back(static_cast<std::uint32_t>(number));
  }
  return loop;
}

/// Returns a face with these vertex numbers.
Face face_of(const std::int64_t* numbers, py::ssize_t count, const std::vector<Eigen::Vector3d>& points,
             std::size_t face) {
  const std::size_t vertices = points.size();
  const std::string name = "face " + std::to_string(face);
  if (count < 3) reject(name + " has " + std::to_string(count) + " vertices; a face has at least 3");
  Face loop(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (numbers[i] < 0 || static_cast<std::uint64_t>(numbers[i]) >= vertices)
      reject(name + " has vertex " + std::to_string(numbers[i]) + ", but there are " + std::to_string(vertices) +
             " vertices, numbered from 0");
    loop[i] = static_cast<std::uint32_t>(numbers[i]);
    if (!points[loop[i]].allFinite())
      throw Rejected({RejectionCode::NotFinite,
                      name + " has vertex " + std::to_string(loop[i]) + ", which has a coordinate that is not finite"});
  }
  return loop;
}

/// Returns the faces, n x 3 if all are triangles, else a list of lists.
py::object numbers_of_faces(const HeldMesh& mesh) {
  const auto is_triangle = [](const Face& face) { return face.size() == 3; };
  if (!std::ranges::all_of(mesh.faces, is_triangle)) return py::cast(mesh.faces);
  py::array_t<Number> rows({static_cast<py::ssize_t>(mesh.faces.size()), py::ssize_t{3}});
  Number* row = rows.mutable_data();
  for (const Face& face : mesh.faces) row = std::ranges::copy(face, row).out;
  return rows;
}

Doubles vertices_of(const HeldMesh& mesh) {
  Doubles rows({static_cast<py::ssize_t>(mesh.vertices.size()), py::ssize_t{3}});
  double* number = rows.mutable_data();
  for (const Eigen::Vector3d& vertex : mesh.vertices) number = std::copy_n(vertex.data(), 3, number);
  return rows;
}

/// What a call of Mesh.read names: a path, bytes, or an object with `read`, such as an open file.
struct MeshInput {
  std::optional<std::filesystem::path> path{};  ///< either this
  std::string content{}, format{}, name{};      ///< or these
};

MeshInput input_of(const py::object& file, const std::optional<std::string>& format) {
  if (!py::isinstance<py::bytes>(file) && !py::hasattr(file, "read")) {
    auto path = py::module_::import("os").attr("fspath")(file).cast<std::filesystem::path>();
    if (!format) return {.path = std::move(path)};
    const py::object opened = py::module_::import("pathlib").attr("Path")(file);
    try {
      return {.content = opened.attr("read_bytes")().cast<std::string>(), .format = *format, .name = path.string()};
    } catch (const py::error_already_set& error) {
      if (!error.matches(PyExc_OSError)) throw;
      throw BrokenMesh(path.string() + ": " + py::str(error.value().attr("strerror")).cast<std::string>());
    }
  }
  MeshInput input{.name = "the bytes"};
  py::object content = file;
  if (!py::isinstance<py::bytes>(file)) {
    content = file.attr("read")();
    input.name = "the file";
    if (py::hasattr(file, "name") && py::isinstance<py::str>(file.attr("name")))
      input.name = file.attr("name").cast<std::string>();
  }
  if (!py::isinstance<py::bytes>(content) && !py::isinstance<py::str>(content))
    throw py::type_error(input.name + ": read() must return bytes or str");
  input.content = content.cast<std::string>();
  input.format = format.value_or(std::filesystem::path(input.name).extension().string());
  if (input.format.starts_with('.')) input.format.erase(0, 1);
  if (input.format.empty()) throw py::value_error(input.name + ": give the format: 'obj', 'off', 'stl' or 'ply'");
  return input;
}

HeldMesh read(const py::object& file, const std::optional<std::string>& format, const std::string& bad_faces) {
  const bool refuses = bad_faces_policy(bad_faces) == mesh::OnBadFace::Refuse;
  const OnFault on_fault = refuses ? OnFault::Refuse : OnFault::Skip;
  MeshInput input = input_of(file, format);
  ReadMesh read;
  {
    const py::gil_scoped_release release;
    read = input.path ? read_mesh(*input.path, on_fault)
                      : read_mesh(std::move(input.content), input.format, input.name, on_fault);
  }
  for (const std::string& warning : read.warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  return {std::move(read.mesh), std::move(read.places), std::move(read.left_out)};
}

std::vector<std::string> places_of(const HeldMesh& mesh) {
  std::vector<std::string> places;
  for (const io::SourceLocation& place : mesh.places) places.push_back(io::text_of(place));
  return places;
}

/// Returns the faces of an array that states the number of vertices before each face.
py::list faces_of_counts(py::handle numbers) {
  const Indices flat = indices_of(numbers, "faces");
  const std::int64_t* const all = flat.data();
  py::list faces;
  for (py::ssize_t i = 0; i < flat.size();) {
    const std::int64_t count = all[i++];
    if (count < 0 || count > flat.size() - i)
      reject("faces: face " + std::to_string(faces.size()) + " is to have " + std::to_string(count) +
             " vertices, but " + std::to_string(flat.size() - i) + " numbers follow");
    faces.append(Indices(static_cast<py::ssize_t>(count), all + i));
    i += count;
  }
  return faces;
}

/// Returns the faces of blocks with `type` and `data`. Throws pybind11::type_error for a block of other cells than
/// faces, vertices and lines.
py::list faces_of_blocks(py::handle blocks) {
  py::list faces;
  for (const py::handle block : blocks) {
    if (!py::hasattr(block, "type") || !py::hasattr(block, "data"))
      throw py::type_error("cells: expected blocks with `type` and `data`, got " +
                           py::str(py::type::of(block)).cast<std::string>());
    const auto type = py::str(block.attr("type")).cast<std::string>();
    if (type == "vertex" || type == "line") continue;
    if (type != "triangle" && type != "quad" && !type.starts_with("polygon"))
      throw py::type_error("cells: those of type '" + type + "' are not polygons");
    for (const py::handle face : block.attr("data")) faces.append(face);
  }
  return faces;
}

/// Compares vertices by `same_number`, and NaN with NaN: vertices that no face uses may be anything.
bool equal(const HeldMesh& a, const HeldMesh& b) {
  const auto same = [](double x, double y) { return same_number(x, y) || (std::isnan(x) && std::isnan(y)); };
  const auto same_vertices = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::ranges::equal(p, q, same);
  };
  return a.faces == b.faces && std::ranges::equal(a.vertices, b.vertices, same_vertices);
}

/// Translates BrokenMesh to the Python exception BrokenMesh, a ValueError.
void add_broken_mesh(py::module_& module) {
  py::register_exception<BrokenMesh>(module, "BrokenMesh", PyExc_ValueError).doc() =
      "A mesh file that cannot be read: names the file and the line or byte.";
}

bool has(py::handle object, const char* points, const char* faces) {
  return py::hasattr(object, points) && py::hasattr(object, faces);
}

}  // namespace

mesh::OnBadFace bad_faces_policy(const std::string& name, bool may_be_segments) {
  if (name == "refuse") return mesh::OnBadFace::Refuse;
  if (name == "leave out") return mesh::OnBadFace::LeaveOut;
  if (may_be_segments && name == "as segments") return mesh::OnBadFace::AsSegments;
  if (may_be_segments && name == "as segments or leave out") return mesh::OnBadFace::AsSegmentsOrLeaveOut;
  throw py::value_error(
      std::string("bad_faces must be 'refuse'") +
      (may_be_segments ? ", 'leave out', 'as segments' or 'as segments or leave out', not " : " or 'leave out', not ") +
      py::repr(py::str(name)).cast<std::string>());
}

py::object named_faces(const std::vector<mesh::RejectedFace>& faces) {
  py::list named;
  for (const auto& [face, rejection] : faces)
    named.append(py::dict(py::arg("face") = face, py::arg("code") = text(to_string(rejection.code)),
                          py::arg("message") = rejection.message));
  return named;
}

HeldMesh mesh_of(py::handle vertices, py::handle faces, mesh::OnBadFace on_bad_face) {
  const Doubles rows = doubles_of(vertices);
  if (rows.size() > 0 && (rows.ndim() != 2 || rows.shape(1) != 3)) reject("vertices must be an array of n x 3 numbers");
  HeldMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(rows.size() / 3));
  for (const double* v = rows.data(); v != rows.data() + rows.size(); v += 3) {
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
  }
  const auto add = [&](const std::int64_t* numbers, py::ssize_t count) {
    const std::size_t face = mesh.faces.size();
    mesh.faces.push_back(on_bad_face == mesh::OnBadFace::Refuse ? face_of(numbers, count, mesh.vertices, face)
                                                                : unchecked_face_of(numbers, count, face));
  };
  if (py::isinstance<py::list>(faces) || py::isinstance<py::tuple>(faces)) {
    for (const py::handle face : faces) {
      const Indices numbers = indices_of(face, "face " + std::to_string(mesh.faces.size()));
      if (numbers.ndim() != 1)
        reject("face " + std::to_string(mesh.faces.size()) + " must be a list of vertex numbers");
      add(numbers.data(), numbers.size());
    }
    return mesh;
  }
  const Indices numbers = indices_of(faces, "faces");
  if (numbers.ndim() != 2) reject("faces must be an array of n x k vertex numbers, or a list of lists");
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i) add(numbers.data(i, 0), numbers.shape(1));
  return mesh;
}

bool is_mesh(py::handle object) {
  return py::isinstance<HeldMesh>(object) || py::hasattr(object, "faces") || has(object, "vertices", "triangles") ||
         has(object, "points", "cells");
}

const HeldMesh* held_mesh(py::handle object) {
  return py::isinstance<HeldMesh>(object) ? &object.cast<const HeldMesh&>() : nullptr;
}

HeldMesh mesh_of(py::handle object, mesh::OnBadFace on_bad_face) {
  const auto made = [&](py::handle vertices, py::handle faces) { return mesh_of(vertices, faces, on_bad_face); };
  if (const HeldMesh* held = held_mesh(object)) return *held;
  if (has(object, "vertices", "faces")) return made(object.attr("vertices"), object.attr("faces"));
  if (has(object, "vertices", "triangles")) return made(object.attr("vertices"), object.attr("triangles"));
  if (has(object, "points", "faces")) {
    if (py::hasattr(object, "strips") && py::len(object.attr("strips")) > 0)
      throw py::type_error("a mesh with strips is not supported: triangulate it");
    return made(object.attr("points"), faces_of_counts(object.attr("faces")));
  }
  if (has(object, "points", "cells")) return made(object.attr("points"), faces_of_blocks(object.attr("cells")));
  throw py::type_error(
      "expected a mesh: an object with `vertices` and `faces` or `triangles`, or with `points` and "
      "`faces` or `cells`, got " +
      py::str(py::type::of(object)).cast<std::string>());
}

void add_mesh(py::module_& module) {
  add_broken_mesh(module);
  py::class_<HeldMesh> type(
      module, "Mesh",
      "Vertices, an array of m x 3, and faces, an array of n x k or a list of lists of vertex "
      "numbers from 0. Nothing is\n"
      "welded, triangulated or repaired. Raises Rejected, which names the face, for a vertex that is "
      "not finite, a\n"
      "number out of range and a face of fewer than three vertices. Vertices that no face uses may "
      "be anything. Two\n"
      "meshes are equal if vertices and faces are, one by one; pickles keep these alone.");
  make_picklable(type, [](const HeldMesh& mesh) { return py::make_tuple(vertices_of(mesh), numbers_of_faces(mesh)); });
  type.def(py::init([](const py::object& vertices, const py::object& faces) { return mesh_of(vertices, faces); }),
           py::arg("vertices"), py::arg("faces"))
      .def_static("read", read, py::arg("path"), py::arg("format") = py::none(), py::arg("bad_faces") = "refuse",
                  "Reads Wavefront OBJ, Geomview OFF, STL or PLY; each number becomes the nearest double. `path` is a\n"
                  "path, bytes or an open file; `format` is needed where no name ends in it. Raises BrokenMesh, a\n"
                  "ValueError that names the file and the line or byte. With bad_faces='leave out' faulty lines,\n"
                  "vertices and faces are left out, and `left_out` names them.")
      .def_static(
          "of",
          [](const py::object& object) { return held_mesh(object) != nullptr ? object : py::cast(mesh_of(object)); },
          py::arg("object"),
          "Returns the mesh of any object with `vertices` and `faces`, such as one of trimesh, or with `triangles`\n"
          "(Open3D), with `points` and flat `faces` (PyVista) or blocks of `cells` (meshio).")
      .def_property_readonly("places", places_of,
                             "The place in the file of each face, such as 'line 12'; empty without a file.")
      .def_readonly("left_out", &HeldMesh::left_out,
                    "A sentence for each of the first 1000 parts of the file that were left out.")
      .def_property_readonly(
          "vertices",
          [](const py::object& object) {
            const HeldMesh& mesh = object.cast<const HeldMesh&>();
            const double* const first = mesh.vertices.empty() ? nullptr : mesh.vertices.front().data();
            return view_of(first, {static_cast<py::ssize_t>(mesh.vertices.size()), 3}, object);
          },
          "The vertices, m x 3: a view that cannot be written to.")
      .def_property_readonly("faces", numbers_of_faces,
                             "A copy of the faces: n x 3 if all are triangles, else a list of lists.")
      .def("__len__", [](const HeldMesh& mesh) { return mesh.faces.size(); })
      .def("__eq__", equal, py::is_operator())
      .def("__repr__", [](const HeldMesh& mesh) {
        return "Mesh(" + std::to_string(mesh.vertices.size()) + " vertices, " + std::to_string(mesh.faces.size()) +
               (mesh.faces.size() == 1 ? " face)" : " faces)");
      });
  type.attr("__hash__") = py::none();
}

}  // namespace touchstone::python
