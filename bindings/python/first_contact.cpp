// SPDX-License-Identifier: Apache-2.0
#include "geometry/contact/first_contact.h"

#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <string>

#include "bindings/python/bindings.h"
#include "bindings/python/initialised.h"
#include "bindings/python/pickling.h"
#include "bindings/python/words.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

bool is_time_of(FirstContactKind kind, double time) {
  switch (kind) {
    case FirstContactKind::Start: return time == 0;
    case FirstContactKind::Way: return time >= 0 && time <= 1;
    case FirstContactKind::None: break;
  }
  return time == FirstContact().time;
}

/// From its members, enumerators as numbers. Throws pybind11::value_error, which names the member, for members that no
/// first contact has together.
FirstContact first_contact_from(int kind, double time, bool momentary, int feature, std::size_t index,
                                const Coordinates& point, const Coordinates& contact_normal, double depth) {
  FirstContact first{enumerator_of<FirstContactKind>(kind, "kind"),
                     time,
                     momentary,
                     feature_from(feature, index, "feature"),
                     vector_of(point),
                     vector_of(contact_normal),
                     depth};
  require_member(is_time_of(first.kind, time), "time", "is 0 for 'start', 0 to 1 for 'way' and infinite for 'none'");
  require_member(!momentary || first.kind == FirstContactKind::Way, "momentary", "is for 'way' alone");
  require_member(first.contact() || first.feature == FirstContact().feature, "feature", "is the face for 'none'");
  require_member(first.contact() || first.point == FirstContact().point, "point", "is the origin for 'none'");
  require_member(first.contact() || first.contact_normal == FirstContact().contact_normal, "contact_normal",
                 "is zero for 'none'");
  require_member(first.kind == FirstContactKind::Start || depth == 0, "depth",
                 "is 0 unless the ball touches at 'start'");
  return first;
}

}  // namespace

void add_first_contact(py::module_& module) {
  py::class_<FirstContact> type(
      module, "FirstContact",
      "The first contact of a moving ball, in the words of the contract: `kind` is 'start', 'way'\n"
      "or 'none'. Without a contact `time` is infinite.");
  make_picklable(type, [](const FirstContact& f) {
    return py::make_tuple(static_cast<int>(f.kind), f.time, f.momentary, static_cast<int>(f.feature.kind),
                          f.feature.index, coordinates_of(f.point), coordinates_of(f.contact_normal), f.depth);
  });
  type.def(py::init(&first_contact_from), "Takes what `pickle` kept.")
      .def_property_readonly("kind", [](const FirstContact& f) { return text(to_string(f.kind)); })
      .def_property_readonly("contact", &FirstContact::contact)
      .def_readonly("time", &FirstContact::time)
      .def_readonly("momentary", &FirstContact::momentary)
      .def_property_readonly("feature", [](const FirstContact& f) { return feature_of(f.feature); })
      .def_readonly("point", &FirstContact::point)
      .def_readonly("contact_normal", &FirstContact::contact_normal)
      .def_readonly("depth", &FirstContact::depth)
      .def(py::self == py::self)
      .def("__repr__",
           [](const FirstContact& f) {
             return "FirstContact(" + std::string(to_string(f.kind)) +
                    (f.contact() ? " at " + py::repr(py::float_(f.time)).cast<std::string>() : "") +
                    (f.momentary ? ", momentary)" : ")");
           })
      .attr("__hash__") = py::none();
}

}  // namespace touchstone::python
