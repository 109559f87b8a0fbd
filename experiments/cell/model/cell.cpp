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

Solid stand_of(const Station& station) {
  const Station::Stand& stand = station.stand.value();
  return {Box{{stand.lower.x(), stand.lower.y(), -station.height}, {stand.upper.x(), stand.upper.y(), stand.top}}};
}

}  // namespace touchstone::cell
