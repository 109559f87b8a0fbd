// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/unit.h"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "robust/exact/detail/nearest_double.h"

namespace touchstone::workloads {
namespace {

constexpr std::array<Unit, 6> kUnits{
    {{"um", 1}, {"mm", 1000}, {"cm", 10'000}, {"m", 1'000'000}, {"inch", 25'400}, {"foot", 304'800}}};

/// Returns length * times / over, rounded once.
double rational_quotient(double length, double times, double over) {
  const mpq_class quotient = mpq_class(length) * mpq_class(times) / mpq_class(over);
  return exact::detail::nearest_double(quotient.get_num(), quotient.get_den());
}

}  // namespace

Unit find_unit(std::string_view name) {
  std::string known;
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return unit;
    known.append(known.empty() ? "" : ", ").append(unit.name);
  }
  throw std::invalid_argument("there is no unit \"" + std::string(name) + "\"; there are " + known);
}

double converted(double length, const Unit& from, const Unit& to) {
  if (from == to) return length;
  const std::int64_t common = std::gcd(from.micrometres, to.micrometres);
  const std::int64_t numerator = from.micrometres / common, denominator = to.micrometres / common;  // exact
  const auto times = static_cast<double>(numerator), over = static_cast<double>(denominator);
  // Beyond these bounds, parts of the product, of the quotient or of its correction may not be doubles.
  const double magnitude = std::abs(length);
  if (length != 0 && !(magnitude >= 1e-280 && magnitude <= 1e300)) return rational_quotient(length, times, over);
  // The product is high + low, the quotient's remainder is exact, and what is added last is known far better than to
  // the 2^-21 units in the last place by which a quotient by a number below 2^20 misses a tie, if it does.
  const double high = length * times, low = std::fma(length, times, -high);
  const double quotient = high / over, rest = std::fma(-quotient, over, high);
  return quotient + (rest + low) / over;
}

void convert(Mesh& mesh, const Unit& from, const Unit& to) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (double& x : mesh.vertices[i]) {
      if (!std::isfinite(x)) continue;  // no face uses the vertex
      x = converted(x, from, to);
      if (!std::isfinite(x))
        throw std::range_error("vertex " + std::to_string(i) + " leaves the finite doubles from " +
                               std::string(from.name) + " to " + std::string(to.name));
    }
}

}  // namespace touchstone::workloads
