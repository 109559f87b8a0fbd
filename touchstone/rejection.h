// SPDX-License-Identifier: Apache-2.0
// touchstone::Rejection: why an input is not a ball or not a polygon.
#pragma once

#include "geometry/shapes/rejection.h"
