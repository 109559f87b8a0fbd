// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "experiments/cases/method.h"

// Each file of this folder adds its methods.
namespace touchstone::methods {

using cases::Method;
using cases::PartialAnswer;
using cases::PosedMesh;
using cases::PreparedMethod;
using cases::QueryKind;
using MethodList = std::vector<std::unique_ptr<Method>>;

void add_cgal_kernels(MethodList& list);
void add_exact(MethodList& list);
void add_fast(MethodList& list);
void add_fast_wide(MethodList& list);
void add_filtered(MethodList& list);
void add_plain(MethodList& list);
void add_thesis(MethodList& list);

}  // namespace touchstone::methods
