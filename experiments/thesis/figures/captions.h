// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace touchstone::figures {

/// A figure or table as the thesis's own lists name it, or one of ours on the errors of its method.
struct Caption {
  std::string_view id;    ///< `4.3`, `table 6.1`, `E.2`
  std::string_view text;  ///< as cited; for our own figures, their subject
  int page;               ///< of the thesis; 0 for our own
};

/// Returns all captions: figures 2.1 to 6.31 and tables 5.1 to 6.2 in the thesis's order, each chapter's tables after
/// its figures, then ours. [arshad2008, lists of figures and of tables]
[[nodiscard]] const std::vector<Caption>& captions();

}  // namespace touchstone::figures
