// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.Math inverts the incomplete beta function; the limits follow from that and need no code of ours beyond the
// ends.
#include "experiments/run/statistics/clopper_pearson.h"

#include <boost/math/special_functions/beta.hpp>

namespace touchstone::statistics {
namespace {

// Boost.Math warms up with long doubles far below the range of double. Valgrind computes them as doubles, which
// overflow; the error would end the program before main. No limit overflows.
using Policy =
    boost::math::policies::policy<boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;

}  // namespace

Limits clopper_pearson(std::uint64_t failures, std::uint64_t trials, double confidence) {
  const auto failed = static_cast<double>(failures), passed = static_cast<double>(trials - failures);
  const double tail = (1 - confidence) / 2;
  return {failures == 0 ? 0 : boost::math::ibeta_inv(failed, passed + 1, tail, Policy{}),
          failures == trials ? 1 : boost::math::ibetac_inv(failed + 1, passed, tail, Policy{})};
}

}  // namespace touchstone::statistics
