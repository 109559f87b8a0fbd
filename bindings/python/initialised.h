// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "bindings/python/mesh.h"
#include "bindings/python/shared_scene.h"
#include "bindings/python/valid_polygon.h"
#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "robust/filtered/triangle_set.h"
#include "robust/scene/solid.h"

namespace touchstone::python {

/// How pybind11 finds the T in a Python object. `T.__new__(T)` makes an object without a T; for such an object pybind11
/// alone would return uninitialised memory.
template <class T>
class InitialisedCaster : public pybind11::detail::type_caster_base<T> {
 public:
  /// Throws pybind11::type_error for an object whose `__init__` was not called.
  bool load(pybind11::handle source, bool convert) {
    const auto* const type = this->typeinfo;
    if (type != nullptr && pybind11::isinstance(source, reinterpret_cast<PyObject*>(type->type)) &&
        !reinterpret_cast<pybind11::detail::instance*>(source.ptr())->get_value_and_holder(type).holder_constructed())
      throw pybind11::type_error(std::string(type->type->tp_name) + ".__init__ was not called");
    return pybind11::detail::type_caster_base<T>::load(source, convert);
  }
};

}  // namespace touchstone::python

namespace pybind11::detail {

// Every class that the module defines.
template <>
class type_caster<touchstone::Answer> : public touchstone::python::InitialisedCaster<touchstone::Answer> {};
template <>
class type_caster<touchstone::FirstContact> : public touchstone::python::InitialisedCaster<touchstone::FirstContact> {};
template <>
class type_caster<touchstone::python::HeldMesh>
    : public touchstone::python::InitialisedCaster<touchstone::python::HeldMesh> {};
template <>
class type_caster<touchstone::filtered::TriangleSet>
    : public touchstone::python::InitialisedCaster<touchstone::filtered::TriangleSet> {};
template <>
class type_caster<touchstone::python::SharedScene>
    : public touchstone::python::InitialisedCaster<touchstone::python::SharedScene> {};
template <>
class type_caster<touchstone::python::ValidPolygon>
    : public touchstone::python::InitialisedCaster<touchstone::python::ValidPolygon> {};
template <>
class type_caster<touchstone::scene::FirstFace>
    : public touchstone::python::InitialisedCaster<touchstone::scene::FirstFace> {};
template <>
class type_caster<touchstone::scene::NearestFace>
    : public touchstone::python::InitialisedCaster<touchstone::scene::NearestFace> {};
template <>
class type_caster<touchstone::scene::Solid> : public touchstone::python::InitialisedCaster<touchstone::scene::Solid> {};

}  // namespace pybind11::detail
