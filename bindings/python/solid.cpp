// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/solid.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "bindings/python/answer_arrays.h"
#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/mesh.h"
#include "bindings/python/pickling.h"
#include "bindings/python/rows.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;
using scene::Solid;

/// Rows of three numbers, used as points without a copy.
class Points {
 public:
  /// Takes one row or many (n x 3). Throws what doubles_of throws, and Rejected for another shape, and for a point that
  /// is not finite, naming the row.
  explicit Points(py::handle object) : rows_(doubles_of(object)) {
    static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double) && alignof(Eigen::Vector3d) == alignof(double),
                  "a row x, y, z has the layout of a point");
    if ((rows_.ndim() != 1 && rows_.ndim() != 2) || rows_.shape(rows_.ndim() - 1) != 3)
      throw Rejected({RejectionCode::MalformedCase, "points must be an array of 3 or of n x 3 numbers (x, y, z)"});
    all_ = {reinterpret_cast<const Eigen::Vector3d*>(rows_.data()), static_cast<std::size_t>(rows_.size() / 3)};
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!all_[i].allFinite())
        throw Rejected({RejectionCode::NotFinite, (single() ? "the point" : "point " + std::to_string(i)) +
                                                      " has a coordinate that is not finite"});
  }

  [[nodiscard]] bool single() const { return rows_.ndim() == 1; }
  [[nodiscard]] std::span<const Eigen::Vector3d> all() const { return all_; }
  [[nodiscard]] const Doubles& array() const { return rows_; }

 private:
  Doubles rows_;
  std::span<const Eigen::Vector3d> all_;
};

py::object locate(const Solid& solid, const py::object& rows, const py::object& out) {
  const Points points(rows);
  AnswerArrays arrays(points.all().size(), points.single(), out, points.array());
  const std::span<Code> codes = arrays.add<Code>();
  std::vector<PointLocation> locations(points.all().size());
  {
    const py::gil_scoped_release release;
    solid.locate(points.all(), locations);
    std::ranges::transform(locations, codes.begin(), code_of<PointLocation>);
  }
  if (points.single()) return text(to_string(locations[0]));
  return arrays.result();
}

py::object touches_solid(const Solid& solid, const py::object& rows, const py::object& out) {
  const Balls balls(rows);
  AnswerArrays arrays(balls.all().size(), balls.single(), out, balls.array());
  const std::span<bool> answers = arrays.add<bool>();
  {
    const py::gil_scoped_release release;
    solid.touches(balls.all(), answers);
  }
  if (balls.single()) return py::bool_(answers[0]);
  return arrays.result();
}

py::object signed_distance(const Solid& solid, const py::object& rows, const py::object& out) {
  const Points points(rows);
  AnswerArrays arrays(points.all().size(), points.single(), out, points.array());
  const std::span<double> answers = arrays.add<double>();
  {
    const py::gil_scoped_release release;
    solid.signed_distance(points.all(), answers);
  }
  if (points.single()) return py::float_(answers[0]);
  return arrays.result();
}

Solid solid_of(const Mesh& mesh) {
  const py::gil_scoped_release release;
  return Solid(mesh);
}

}  // namespace

void add_solid(py::module_& module) {
  py::class_<Solid> type(module, "Solid",
                         "What closed triangles bound, and exact questions about it: a Mesh or any object with "
                         "`vertices` and `faces`, or\n"
                         "these two. A point is inside if the winding number of the surface about it is not 0. Raises "
                         "ValueError, which\n"
                         "names the face and the edge, for faces that are not closed, and Rejected for what a Scene "
                         "rejects. A solid cannot\n"
                         "be pickled or copied: keep its mesh.");
  refuse_pickling(type, "cannot pickle or copy a Solid: make another one of its mesh");
  const py::arg points("points"), balls("balls");
  const auto out = py::arg("out") = py::none();
  type.def(py::init([](const py::object& mesh) { return with_mesh(mesh, mesh::OnBadFace::Refuse, solid_of); }),
           py::arg("mesh"))
      .def(py::init(
               [](const py::object& vertices, const py::object& faces) { return solid_of(mesh_of(vertices, faces)); }),
           py::arg("vertices"), py::arg("faces"))
      .def("locate", locate, points, out,
           "Returns where a point lies: 'inside', 'boundary' or 'outside'; for n points an array of the codes of\n"
           "PointLocation.")
      .def("touches", touches_solid, balls, out,
           "Returns whether the ball touches the solid: a bool, or an array of them.")
      .def("signed_distance", signed_distance, points, out,
           "Returns the distance of a point from the surface, the nearest double, negative inside: a float, or an\n"
           "array of them.")
      .def("__repr__", [](const Solid& solid) { return "Solid(" + std::to_string(solid.face_count()) + " faces)"; });
}

}  // namespace touchstone::python
