// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/radii.h"

#include <algorithm>
#include <limits>
#include <set>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::show {
namespace {

constexpr std::int64_t kLast = workloads::ordinal(std::numeric_limits<double>::max());
constexpr std::int64_t kNear = 20, kAround = 8;

/// Returns the least number from 0 to `last` for which the rising predicate holds, or nothing.
template <class Holds>
std::optional<std::int64_t> least(std::int64_t last, const Holds& holds) {
  if (!holds(last)) return std::nullopt;
  std::int64_t low = -1;  // does not hold
  while (last - low > 1) {
    const std::int64_t middle = low + (last - low) / 2;
    (holds(middle) ? last : low) = middle;
  }
  return last;
}

/// Returns the offsets to show, where the answer first is yes at `change`.
std::vector<std::int64_t> offsets_to(std::optional<std::int64_t> change) {
  std::set<std::int64_t> offsets{0};
  if (!change || std::abs(*change) <= kNear) {
    const std::int64_t at = change.value_or(0);
    for (std::int64_t k = std::min<std::int64_t>(at, 0) - kAround; k <= std::max<std::int64_t>(at, 0) + kAround; ++k)
      offsets.insert(k);
  } else {
    const std::int64_t side = *change < 0 ? -1 : 1;
    for (std::int64_t k = 1; k <= std::abs(*change); k = k > kLast / 16 ? kLast : k * 16) offsets.insert(side * k);
    for (const std::int64_t k : {1, 16}) offsets.insert(-side * k);
    for (std::int64_t k = -2; k < 2; ++k) offsets.insert(*change + k);
  }
  return {offsets.begin(), offsets.end()};
}

}  // namespace

double Radii::radius(const cases::Shapes& shapes, std::size_t i) const {
  return workloads::move_radius_by_doubles(shapes.ball().radius, offsets[i]);
}

Radii radii_around(const cases::Shapes& shapes) {
  const exact::PreparedPolygon polygon(shapes.polygon);
  const auto touches = [&](double radius) {
    return std::visit([&](const auto& asked) { return exact::contact(asked, polygon); },
                      cases::with_radius(shapes.question, radius));
  };
  const std::int64_t own = workloads::ordinal(shapes.ball().radius);
  const auto first = least(kLast, [&](std::int64_t rank) { return touches(workloads::from_ordinal(rank)); });
  Radii radii;
  std::optional<std::int64_t> change;
  if (first) {
    if (*first > 0) change = *first - own;  // else even a point touches
    radii.margin = own - *first;
    const Ball ball{shapes.ball().center, workloads::from_ordinal(*first)};
    radii.exactly_touching = shapes.motion() == nullptr && exact::relation(ball, polygon) == Relation::Touching;
  }
  for (const std::int64_t offset : offsets_to(change)) {
    if (own + offset < 0 || offset > kLast - own) continue;
    radii.offsets.push_back(offset);
    radii.contact.push_back(first && offset >= *first - own);
  }
  radii.every_double =
      radii.offsets.back() - radii.offsets.front() + 1 == static_cast<std::int64_t>(radii.offsets.size());
  return radii;
}

}  // namespace touchstone::show
