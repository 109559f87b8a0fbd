// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace touchstone::cell {

/// A contact that should not be: the angle up to which a move is clear, what touches then, in words, and the names of
/// the parts, as in ModelPart or as Workcell::scene names the material.
struct Hindrance {
  double degrees;
  std::string what;
  std::vector<std::string> parts;
};

}  // namespace touchstone::cell
