// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/method.h"

namespace touchstone::methods {

using cases::Method;

/// Every method of this build, in the order in which `touchstone methods` lists them.
[[nodiscard]] const std::vector<std::unique_ptr<Method>>& all_methods();

/// The method of that name, or nullptr.
[[nodiscard]] const Method* find_method(std::string_view name);

/// The methods of these names, in this order; `all` stands for every one.
/// Throws std::invalid_argument, which names the one that is unknown.
[[nodiscard]] std::vector<const Method*> find_methods(const std::vector<std::string>& names);

}  // namespace touchstone::methods
