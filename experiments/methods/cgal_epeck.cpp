// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/kernel_method.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// CGAL::to_double guarantees only five digits of a lazy number.
struct ExactNumbers {
  static mpq_class rational(const Kernel::FT& x) { return mpq_class(x.exact().backend().data()); }
  static double nearest_double(const Kernel::FT& x) {
    const mpq_class value = rational(x);
    return exact::nearest_double(value.get_num(), value.get_den());
  }
  static double nearest_root(const Kernel::FT& x) {
    const mpq_class value = rational(x);
    return exact::nearest_root(value.get_num(), value.get_den());
  }
};

}  // namespace

void add_cgal_epeck(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(std::make_unique<KernelMethod<Kernel, ExactNumbers>>(
      "cgal-epeck", "epeck", "the same over EPECK: exact, and lifted; its numbers are lazy rationals"));
}

}  // namespace touchstone::methods
