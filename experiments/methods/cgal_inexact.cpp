// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "experiments/methods/add_methods.h"
#include "experiments/methods/kernel_method.h"

namespace touchstone::methods {
namespace {

struct Doubles {
  static double nearest_double(double x) { return x; }
  static double nearest_root(double x) { return std::sqrt(x); }
};

template <class Kernel>
std::unique_ptr<Method> kernel_method(std::string_view name, std::string_view stage, std::string_view summary) {
  return std::make_unique<KernelMethod<Kernel, Doubles>>(name, stage, summary);
}

}  // namespace

void add_cgal_inexact(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(kernel_method<CGAL::Simple_cartesian<double>>(
      "cgal-double", "double", "CGAL's kernel of plain doubles, as its users write; loops are not lifted"));
  list.push_back(kernel_method<CGAL::Exact_predicates_inexact_constructions_kernel>(
      "cgal-epick", "epick", "the same over EPICK: exact predicates of rounded planes, feet and squared radii"));
}

}  // namespace touchstone::methods
