// SPDX-License-Identifier: Apache-2.0
// touchstone::Ball.
#pragma once

#include "geometry/shapes/ball.h"
