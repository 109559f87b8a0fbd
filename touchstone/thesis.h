// SPDX-License-Identifier: Apache-2.0
// touchstone::thesis: the method of a 2008 thesis, errors included.
#pragma once

#include "geometry/contact/thesis.h"
