// SPDX-License-Identifier: Apache-2.0
// touchstone::filtered: the answers of `exact` at about the price of `fast`.
#pragma once

#include "robust/filtered/filtered.h"
