// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/statistics/errors.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace touchstone::statistics {
namespace {

double error(double difference, double unit) {
  return std::isfinite(difference) ? std::abs(difference) / unit : std::numeric_limits<double>::infinity();
}

}  // namespace

double unit_in_last_place(double value) {
  constexpr int kLowest = std::numeric_limits<double>::min_exponent - 1;
  if (std::abs(value) < std::numeric_limits<double>::min()) return std::numeric_limits<double>::denorm_min();
  return std::ldexp(std::numeric_limits<double>::epsilon(), std::max(std::ilogb(value), kLowest));
}

double number_error(double computed, double exact) { return error(computed - exact, unit_in_last_place(exact)); }

double point_error(const Eigen::Vector3d& computed, const Eigen::Vector3d& exact) {
  const double unit = unit_in_last_place(exact.cwiseAbs().maxCoeff());
  double largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max(largest, error(computed[k] - exact[k], unit));
  return largest;
}

namespace {

constexpr int kBitsCut = 52 - 6;

std::uint32_t leading_bits(double number) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(number + 0.0) >> kBitsCut);  // -0 becomes 0
}

double number_of(std::uint32_t bits) { return std::bit_cast<double>(std::uint64_t{bits} << kBitsCut); }

}  // namespace

void Distribution::add(double number) {
  assert(number >= 0);
  ++counts_[leading_bits(number)];
  largest_ = std::max(largest_, number);
}

Distribution& Distribution::operator+=(const Distribution& other) {
  for (const auto& [bits, count] : other.counts_) counts_[bits] += count;
  largest_ = std::max(largest_, other.largest_);
  return *this;
}

std::uint64_t Distribution::count() const {
  std::uint64_t sum = 0;
  for (const auto& [bits, count] : counts_) sum += count;
  return sum;
}

std::uint64_t Distribution::zeros() const {
  const auto found = counts_.find(leading_bits(0));
  return found == counts_.end() ? 0 : found->second;
}

std::uint64_t Distribution::infinite() const {
  const auto found = counts_.find(leading_bits(std::numeric_limits<double>::infinity()));
  return found == counts_.end() ? 0 : found->second;
}

double Distribution::quantile(double share) const {
  if (share >= 1) return largest_;
  const auto place = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count())));
  std::uint64_t sum = 0;
  for (const auto& [bits, count] : counts_)
    if ((sum += count) >= std::max<std::uint64_t>(place, 1)) return number_of(bits);
  return largest_;
}

}  // namespace touchstone::statistics
