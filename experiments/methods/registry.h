// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/process/engine.h"

namespace touchstone::methods {

/// Adds the methods of a room above this one, which all_methods has before the engines. Call it at the start of the
/// program: throws std::logic_error if anything has asked for a method, because nobody would then see them.
void add_methods(void (*add)(MethodList& list));

/// Returns every method of this build, in the order of `touchstone methods`.
[[nodiscard]] const MethodList& all_methods();

/// Returns the method of that name, one of this build or an engine that add_engine has added, or nullptr.
[[nodiscard]] const Method* find_method(std::string_view name);

/// Adds an engine as a method, which lasts until the program ends, and returns it; the same engine is added once.
/// Throws std::invalid_argument, which names the engine, if its name is that of another method or engine, or has
/// control bytes.
const Method& add_engine(const Engine& engine);

/// Returns the methods of these names, in this order; `all` selects every method of this build. Throws
/// std::invalid_argument, which names the first unknown one.
[[nodiscard]] std::vector<const Method*> find_methods(const std::vector<std::string>& names);

}  // namespace touchstone::methods
