// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// A method that is asked about every face of the material, real or virtual, at a stop, as the exact answer is.
class Driver {
 public:
  Driver(const Workcell& workcell, const cases::Method& method);

  /// Returns the lowest face of the material in a slot, or of its virtual copy, for which the method says contact.
  [[nodiscard]] std::optional<std::size_t> touched(const Ball& ball, StationSlot slot, bool virtual_copy) const;

 private:
  std::array<std::vector<std::unique_ptr<cases::PreparedMethod>>, 4> faces_;  // by slot, real then virtual
};

}  // namespace touchstone::cell
