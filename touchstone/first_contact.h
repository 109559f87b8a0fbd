// SPDX-License-Identifier: Apache-2.0
// touchstone::FirstContact.
#pragma once

#include "geometry/contact/first_contact.h"
