// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/model/cell.h"

#include <stdexcept>

namespace touchstone::cell {

Label Cell::label(const std::string& path) const {
  for (std::size_t length = path.size(); length > 0; --length) {
    if (length < path.size() && path[length] != '.' && path[length] != '[') continue;
    if (const auto found = labels.find(path.substr(0, length)); found != labels.end()) return found->second;
  }
  throw std::out_of_range("nothing is said of where " + path + " comes from");
}

Solid column_of(const Station& station) {
  const Station::Column& column = station.column.value();
  return {Box{{column.lower.x(), column.lower.y(), -station.height}, {column.upper.x(), column.upper.y(), column.top}}};
}

}  // namespace touchstone::cell
