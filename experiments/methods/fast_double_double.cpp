// SPDX-License-Identifier: GPL-3.0-or-later
#include <qd/dd_real.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/fast_method.h"
#include "geometry/contact/detail/fast_motion_definitions.h"

namespace touchstone::methods {

// With QD as configured by Debian, sums that cancel keep the error of their larger term, and quotients are not fully
// rounded. The range is that of double. QD assumes rounding to nearest; x87 would also need fpu_fix_start, but
// FLT_EVAL_METHOD is 0.
void add_fast_double_double(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(std::make_unique<Fast<dd_real>>("fast-double-double", "double-double",
                                                 "the code of fast over double-doubles (QD), 104 bits"));
}

}  // namespace touchstone::methods
