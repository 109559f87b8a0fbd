// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/rows.h"

#include <string>
#include <type_traits>

#include "geometry/shapes/rejection.h"

namespace touchstone::python {

static_assert(std::is_standard_layout_v<Ball> && sizeof(Ball) == 4 * sizeof(double) && alignof(Ball) == alignof(double),
              "a row x, y, z, r has the layout of a ball");
static_assert(std::is_standard_layout_v<Motion> && sizeof(Motion) == 7 * sizeof(double) &&
                  alignof(Motion) == alignof(double),
              "a row x, y, z, r, x', y', z' has the layout of a motion");

namespace {

constexpr const char* kForm[] = {
    "balls must be an array of 4 or of n x 4 numbers (x, y, z, r)",
    "motions must be an array of 7 or of n x 7 numbers (x, y, z, r and the end x', y', z')"};
constexpr const char* kName[] = {"ball ", "motion "};

}  // namespace

template <class Shape>
Rows<Shape>::Rows(const Doubles& rows) : rows_(rows) {
  constexpr bool moves = std::is_same_v<Shape, Motion>;
  const bool fits = (rows_.ndim() == 1 || rows_.ndim() == 2) && rows_.shape(rows_.ndim() - 1) == kColumns;
  if (!fits) throw Rejected({RejectionCode::MalformedCase, kForm[moves]});
  all_ = {reinterpret_cast<const Shape*>(rows_.data()), static_cast<std::size_t>(rows_.size() / kColumns)};
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (auto fault = find_fault(all_[i]))
      throw Rejected(
          {fault->code, (single() ? std::string() : kName[moves] + std::to_string(i) + ": ") + fault->message});
}

template class Rows<Ball>;
template class Rows<Motion>;

}  // namespace touchstone::python
