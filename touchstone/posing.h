// SPDX-License-Identifier: Apache-2.0
// touchstone::scene::posed: points, triangles and polygons under a pose, correctly rounded.
#pragma once

#include "robust/scene/posing.h"
