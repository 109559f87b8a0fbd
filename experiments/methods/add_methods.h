// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "experiments/cases/method.h"

// Each file of this folder adds its methods.
namespace touchstone::methods {

using cases::Method;
using cases::PartialAnswer;
using cases::PreparedMethod;
using cases::QueryKind;

void add_cgal_kernels(std::vector<std::unique_ptr<Method>>& list);
void add_convex(std::vector<std::unique_ptr<Method>>& list);
void add_exact(std::vector<std::unique_ptr<Method>>& list);
void add_fast(std::vector<std::unique_ptr<Method>>& list);
void add_fast_double_double(std::vector<std::unique_ptr<Method>>& list);
void add_fast_mpfr(std::vector<std::unique_ptr<Method>>& list);
void add_filtered(std::vector<std::unique_ptr<Method>>& list);
void add_interval(std::vector<std::unique_ptr<Method>>& list);
void add_rational(std::vector<std::unique_ptr<Method>>& list);
void add_thesis(std::vector<std::unique_ptr<Method>>& list);

}  // namespace touchstone::methods
