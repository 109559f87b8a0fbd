// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/simulation_terms.h"

#include <array>

namespace touchstone::kinematics {

std::string_view to_string(Until until) {
  constexpr std::array<std::string_view, 4> words{"planned", "facing", "contact", "cleared"};
  return words[static_cast<std::size_t>(until)];
}

std::string_view to_string(FailureCause cause) {
  constexpr std::array<std::string_view, 6> words{"out-of-reach", "beyond-limits", "no-contact",
                                                  "not-held",     "misplaced",     "in-the-way"};
  return words[static_cast<std::size_t>(cause)];
}

}  // namespace touchstone::kinematics
