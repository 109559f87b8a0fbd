// SPDX-License-Identifier: Apache-2.0
// touchstone::Motion.
#pragma once

#include "geometry/shapes/motion.h"
