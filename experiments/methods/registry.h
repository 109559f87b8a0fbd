// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"

namespace touchstone::methods {

using cases::Method;

/// Returns every method of this build, in the order of `touchstone methods`.
[[nodiscard]] const std::vector<std::unique_ptr<Method>>& all_methods();

/// Returns the method of that name, or nullptr. `exec:COMMAND` is the external method of that command, which lasts
/// until the program ends. Throws std::invalid_argument if it is not printable text in UTF-8, is blank, or has a comma
/// or a quotation mark `"`: names are separated by commas, and written to tables as they are.
[[nodiscard]] const Method* find_method(std::string_view name);

/// Returns the methods of these names, in this order; `all` selects every method of this build. Throws
/// std::invalid_argument, which names the first unknown one.
[[nodiscard]] std::vector<const Method*> find_methods(const std::vector<std::string>& names);
/// Returns the names of the methods that find_methods selects, joined by commas. Throws as it does.
[[nodiscard]] std::string selected_names(const std::vector<std::string>& names);

}  // namespace touchstone::methods
