// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace touchstone::python {

class SharedScene;

/// @{
/// Add a class or function to the module, with the functions that unpickling it needs.
void add_answer(pybind11::module_& module);
void add_first_contact(pybind11::module_& module);
void add_merge_faces(pybind11::module_& module);
void add_mesh(pybind11::module_& module);
void add_polygon(pybind11::module_& module);
void add_scene(pybind11::module_& module);
void add_solid(pybind11::module_& module);
void add_triangle_set(pybind11::module_& module);
/// @}

/// Adds the methods that ask about balls and motions to the class of scenes, and to the module the classes of their
/// answers.
void add_scene_questions(pybind11::module_& module, pybind11::class_<SharedScene>& type);

}  // namespace touchstone::python
