// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "geometry/contact/answer.h"

namespace touchstone {

/// How GoogleTest and RapidCheck show an answer: every key in the words of the contract, numbers to the last bit.
void PrintTo(const Answer& answer, std::ostream* out);
void showValue(const Answer& answer, std::ostream& out);

}  // namespace touchstone
