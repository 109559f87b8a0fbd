// SPDX-License-Identifier: Apache-2.0
// What an answer consists of: sides, places, relations, features, distances.
#pragma once

#include "geometry/contact/answer.h"
