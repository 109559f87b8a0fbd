// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Interval_nt.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/plain_formulas.h"

namespace touchstone::methods {
namespace {

struct Intervals {
  using Number = CGAL::Interval_nt_advanced;  // rounds upwards only within a Guard
  using Guard = Number::Protector;
  static constexpr std::string_view kName = "interval", kStage = "interval",
                                    kSummary = "the contract's formulas over intervals of doubles: sure, or don't know";
  static constexpr bool kSlow = false;

  static std::optional<double> nearest_double(const Number& x) {
    return x.is_point() ? std::optional(x.inf()) : std::nullopt;
  }
  static std::optional<double> nearest_root(const Number& x) { return nearest_double(CGAL::sqrt(x)); }
};

}  // namespace

void add_interval(std::vector<std::unique_ptr<Method>>& list) { list.push_back(std::make_unique<Plain<Intervals>>()); }

}  // namespace touchstone::methods
