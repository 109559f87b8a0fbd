// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace touchstone::run {

/// A text that is not JSON.
class NotJson : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The limit of nested arrays and objects, because values are copied, written and freed by recursion.
inline constexpr int kMostLevels = 64;

}  // namespace touchstone::run
