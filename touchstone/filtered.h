// SPDX-License-Identifier: Apache-2.0
// touchstone::filtered: the answers of `exact` at about the price of `fast`, and at a fraction of it for sets of
// triangles.
#pragma once

#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"
