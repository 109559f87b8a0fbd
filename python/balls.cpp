// SPDX-License-Identifier: Apache-2.0
#include "python/balls.h"

#include <string>
#include <type_traits>

#include "geometry/shapes/rejection.h"

namespace touchstone::python {

static_assert(std::is_standard_layout_v<Ball> && sizeof(Ball) == 4 * sizeof(double) && alignof(Ball) == alignof(double),
              "a row x, y, z, r has the layout of a ball");

Balls::Balls(pybind11::handle rows) : rows_(doubles_of(rows)) {
  const bool fits = (rows_.ndim() == 1 || rows_.ndim() == 2) && rows_.shape(rows_.ndim() - 1) == 4;
  if (!fits)
    throw Rejected({RejectionCode::MalformedCase, "balls must be an array of 4 or of n x 4 numbers (x, y, z, r)"});
  all_ = {reinterpret_cast<const Ball*>(rows_.data()), static_cast<std::size_t>(rows_.size() / 4)};
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (auto fault = find_fault(all_[i]))
      throw Rejected({fault->code, (single() ? std::string() : "ball " + std::to_string(i) + ": ") + fault->message});
}

}  // namespace touchstone::python
