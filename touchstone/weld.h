// SPDX-License-Identifier: Apache-2.0
// touchstone::mesh::weld: one vertex for every point of a mesh.
#pragma once

#include "robust/mesh/weld.h"
