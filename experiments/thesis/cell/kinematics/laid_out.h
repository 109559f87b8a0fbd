// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/simulation/process.h"

/// Layouts as cells, whose process is simulated by the thesis's rule: the sphere alone, from home by the storage to the
/// machine.
namespace touchstone::kinematics {

/// Returns the cell with the joints' couplings and home, the sphere, the material, its slots and the places of the
/// stations as in a layout. Requires a cell of the Aristo's joints. Bodies of gripper and stations stay as they are.
[[nodiscard]] cell::Cell laid_out(cell::Cell cell, const Layout& layout, const Station& storage);

/// Simulates a layout in the Aristo's cell with the storage at a place. If the arm cannot be simulated, the process has
/// no moves and says why.
[[nodiscard]] cell::Process rehearse(const Layout& layout, const Station& storage);
/// The same with the storage as in case 0 or 1.
[[nodiscard]] cell::Process rehearse_case(const Layout& layout, std::size_t number);

/// Returns how the captions of a case differ from a process up to the machine; empty if they agree to the degree.
[[nodiscard]] std::string difference(const cell::Process& process, const Captions& captions);

}  // namespace touchstone::kinematics
