// SPDX-License-Identifier: Apache-2.0
// touchstone::exact::validate: decides whether loops bound a region.
#pragma once

#include "robust/exact/validate.h"
