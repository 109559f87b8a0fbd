// SPDX-License-Identifier: Apache-2.0
// touchstone::Triangle.
#pragma once

#include "geometry/shapes/triangle.h"
