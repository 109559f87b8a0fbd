// SPDX-License-Identifier: Apache-2.0
// touchstone::exact: the answers of exact real arithmetic.
#pragma once

#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
