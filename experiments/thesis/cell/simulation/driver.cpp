// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/driver.h"

namespace touchstone::cell {
namespace {

std::size_t index(StationSlot slot, bool virtual_copy) {
  return 2 * static_cast<std::size_t>(slot) + (virtual_copy ? 1 : 0);
}

}  // namespace

Driver::Driver(const Workcell& workcell, const cases::Method& method) {
  for (const StationSlot slot : {StationSlot::Storage, StationSlot::Machine})
    for (const bool copy : {false, true}) {
      const scene::Faces& faces = copy ? workcell.at(slot).virtual_faces : workcell.at(slot).faces;
      auto& prepared = faces_[index(slot, copy)];
      for (const Triangle& t : faces.triangles) prepared.push_back(method.prepare(Polygon({t.a, t.b, t.c})));
      for (const Polygon& polygon : faces.polygons) prepared.push_back(method.prepare(polygon));
    }
}

std::optional<std::size_t> Driver::touched(const Ball& ball, StationSlot slot, bool virtual_copy) const {
  const auto& faces = faces_[index(slot, virtual_copy)];
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (faces[i]->ask(ball, cases::QueryKind::Contact).contact.value_or(false)) return i;
  return std::nullopt;
}

}  // namespace touchstone::cell
