// SPDX-License-Identifier: GPL-3.0-or-later
// All of CGAL's kernels in one file, because each file that includes them takes 6 s longer to compile.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/kernel_method.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::methods {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

struct Doubles {
  static double nearest_double(double x) { return x; }
  static double nearest_root(double x) { return std::sqrt(x); }
};

/// CGAL::to_double guarantees only five digits of a lazy number.
struct ExactNumbers {
  static mpq_class rational(const Epeck::FT& x) { return mpq_class(x.exact().backend().data()); }
  static double nearest_double(const Epeck::FT& x) {
    const mpq_class value = rational(x);
    return exact::detail::nearest_double(value.get_num(), value.get_den());
  }
  static double nearest_root(const Epeck::FT& x) {
    const mpq_class value = rational(x);
    return exact::detail::nearest_root(value.get_num(), value.get_den());
  }
};

}  // namespace

void add_cgal_kernels(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(std::make_unique<KernelMethod<CGAL::Simple_cartesian<double>, Doubles>>(
      "cgal-double", "double", "CGAL's kernel of plain doubles, as its users write; loops are not lifted"));
  list.push_back(std::make_unique<KernelMethod<Epick, Doubles>>(
      "cgal-epick", "epick", "the same over EPICK: exact predicates of rounded planes, feet and squared radii"));
  list.push_back(std::make_unique<KernelMethod<Epeck, ExactNumbers>>(
      "cgal-epeck", "epeck", "the same over EPECK: exact, and lifted; its numbers are lazy rationals"));
}

}  // namespace touchstone::methods
