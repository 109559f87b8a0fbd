// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/mesh.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <string>

#include "bindings/python/bindings.h"
#include "bindings/python/doubles.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "geometry/io/read_mesh.h"
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

/// Returns a face with these vertex numbers.
Face face_of(const std::int64_t* numbers, py::ssize_t count, std::size_t vertices, std::size_t face) {
  const std::string name = "face " + std::to_string(face);
  if (count < 3) reject(name + " has " + std::to_string(count) + " vertices; a face has at least 3");
  Face loop(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (numbers[i] < 0 || static_cast<std::uint64_t>(numbers[i]) >= vertices)
      reject(name + " has vertex " + std::to_string(numbers[i]) + ", but there are " + std::to_string(vertices) +
             " vertices, numbered from 0");
    loop[i] = static_cast<std::uint32_t>(numbers[i]);
  }
  return loop;
}

/// Returns the faces, n x 3 if all are triangles, else a list of lists.
py::object numbers_of_faces(const Mesh& mesh) {
  const auto is_triangle = [](const Face& face) { return face.size() == 3; };
  if (!std::ranges::all_of(mesh.faces, is_triangle)) return py::cast(mesh.faces);
  py::array_t<std::uint32_t> rows({static_cast<py::ssize_t>(mesh.faces.size()), py::ssize_t{3}});
  std::uint32_t* row = rows.mutable_data();
  for (const Face& face : mesh.faces) row = std::ranges::copy(face, row).out;
  return rows;
}

Doubles vertices_of(const Mesh& mesh) {
  Doubles rows({static_cast<py::ssize_t>(mesh.vertices.size()), py::ssize_t{3}});
  double* number = rows.mutable_data();
  for (const Eigen::Vector3d& vertex : mesh.vertices) number = std::copy_n(vertex.data(), 3, number);
  return rows;
}

Mesh read(const std::filesystem::path& file) {
  ReadMesh read;
  {
    const py::gil_scoped_release release;
    read = read_mesh(file);
  }
  for (const std::string& warning : read.warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  return std::move(read.mesh);
}

bool equal(const Mesh& a, const Mesh& b) {
  return a.faces == b.faces && std::ranges::equal(a.vertices, b.vertices, same_point);
}

/// Translates BrokenMesh to the Python exception BrokenMesh, a ValueError.
void add_broken_mesh(py::module_& module) {
  py::register_exception<BrokenMesh>(module, "BrokenMesh", PyExc_ValueError);
}

}  // namespace

Mesh mesh_of(py::handle vertices, py::handle faces) {
  const Doubles rows = doubles_of(vertices);
  if (rows.size() > 0 && (rows.ndim() != 2 || rows.shape(1) != 3)) reject("vertices must be an array of n x 3 numbers");
  Mesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(rows.size() / 3));
  for (const double* v = rows.data(); v != rows.data() + rows.size(); v += 3) {
    mesh.vertices.emplace_back(v[0], v[1], v[2]);
    if (!mesh.vertices.back().allFinite())
      throw Rejected({RejectionCode::NotFinite,
                      "vertex " + std::to_string(mesh.vertices.size() - 1) + " has a coordinate that is not finite"});
  }
  const auto add = [&](const std::int64_t* numbers, py::ssize_t count) {
    mesh.faces.push_back(face_of(numbers, count, mesh.vertices.size(), mesh.faces.size()));
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

Mesh mesh_of(py::handle object) {
  if (py::isinstance<Mesh>(object)) return object.cast<const Mesh&>();
  if (!py::hasattr(object, "vertices") || !py::hasattr(object, "faces"))
    throw py::type_error("expected a mesh with `vertices` and `faces`, got " +
                         py::str(py::type::of(object)).cast<std::string>());
  return mesh_of(object.attr("vertices"), object.attr("faces"));
}

void add_mesh(py::module_& module) {
  add_broken_mesh(module);
  py::class_<Mesh> type(module, "Mesh",
                        "Vertices, an array of m x 3, and faces, an array of n x k or a list of lists of vertex "
                        "numbers from 0. Nothing is\n"
                        "welded, triangulated or repaired. Raises Rejected, which names the vertex or face, for a "
                        "coordinate that is not\n"
                        "finite, a number out of range and a face of fewer than three vertices. Two meshes are equal "
                        "if vertices and faces\n"
                        "are, one by one.");
  make_picklable(type, [](const Mesh& mesh) { return py::make_tuple(vertices_of(mesh), numbers_of_faces(mesh)); });
  type.def(py::init([](const py::object& vertices, const py::object& faces) { return mesh_of(vertices, faces); }),
           py::arg("vertices"), py::arg("faces"))
      .def_static("read", read, py::arg("path"),
                  "Reads Wavefront OBJ, Geomview OFF, STL or PLY; each number becomes the nearest double. Raises\n"
                  "BrokenMesh, a ValueError that names the file and the line or byte.")
      .def_static(
          "of", [](const py::object& object) { return mesh_of(object); }, py::arg("object"),
          "Returns the mesh of any object with `vertices` and `faces`, such as one of trimesh.")
      .def_property_readonly("vertices", vertices_of, "A copy of the vertices, m x 3.")
      .def_property_readonly("faces", numbers_of_faces,
                             "A copy of the faces: n x 3 if all are triangles, else a list of lists.")
      .def("__len__", [](const Mesh& mesh) { return mesh.faces.size(); })
      .def("__eq__", equal, py::is_operator())
      .def("__repr__", [](const Mesh& mesh) {
        return "Mesh(" + std::to_string(mesh.vertices.size()) + " vertices, " + std::to_string(mesh.faces.size()) +
               (mesh.faces.size() == 1 ? " face)" : " faces)");
      });
  type.attr("__hash__") = py::none();
}

}  // namespace touchstone::python
