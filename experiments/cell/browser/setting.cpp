// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/setting.h"

#include <fmt/core.h>

#include "experiments/cell/model/cell_entry.h"
#include "experiments/cell/model/reach.h"
#include "experiments/cell/model/read_cell.h"
#include "experiments/cell/model/stops.h"
#include "experiments/harness/json/strict_json.h"

namespace touchstone::cell::browser {
namespace {

double within(const CellEntry& entry, double least, double most) {
  const double number = entry.number();
  if (number < least || number > most)
    entry.bad(fmt::format("must be from {:g} to {:g}, is {:g}", least, most, number));
  return number;
}

Setting read(const CellEntry& whole, const Cell& cell) {
  Setting setting = setting_of(cell);
  whole.has_only({"storage", "slot", "step"});
  if (const auto storage = whole.find("storage")) {
    storage->has_only({"angle", "radius", "height"});
    const double most = longest(cell);
    if (const auto angle = storage->find("angle")) setting.angle = within(*angle, -kMostDegrees, kMostDegrees);
    if (const auto radius = storage->find("radius")) {
      if (radius->positive() > most) (void)within(*radius, 0, most);
      setting.radius = radius->positive();
    }
    if (const auto height = storage->find("height")) setting.height = within(*height, 0, most);
  }
  if (const auto slot = whole.find("slot")) setting.slot = slot_named(cell.storage, *slot);
  if (const auto step = whole.find("step")) setting.step = within(*step, kLeastStep, kMostStep);
  return setting;
}

}  // namespace

Setting setting_of(const Cell& cell) {
  return {cell.storage.angle, cell.storage.radius, cell.storage.height, cell.material.slot, cell.step};
}

double longest(const Cell& cell) {
  const Reach reach = reach_of(cell);
  return 4 * (reach.radius + reach.outer);
}

Setting read_setting(std::string_view text, const Cell& cell) {
  try {
    const harness::StrictJson json = harness::read_strict_json(text);
    const CellEntry whole("request", "", json.value);
    if (json.duplicate_key) whole.bad(fmt::format("the key \"{}\" is given twice", *json.duplicate_key));
    if (json.too_deep) whole.bad("is nested too deep");
    return read(whole, cell);
  } catch (const harness::NotJson& error) {
    throw BadSetting(fmt::format("request: is not JSON: {}", error.what()));
  } catch (const BadCell& error) {
    throw BadSetting(error.what());
  }
}

Cell changed(const Cell& cell, const Setting& setting) {
  Cell result = cell;
  const auto set = [&](double& value, double wanted, const char* path) {
    if (value != wanted) result.labels[path] = Label::Chosen;
    value = wanted;
  };
  set(result.storage.angle, setting.angle, "storage.angle");
  set(result.storage.radius, setting.radius, "storage.radius");
  set(result.storage.height, setting.height, "storage.height");
  set(result.step, setting.step, "step");
  result.material.slot = setting.slot;
  if (const auto& stand = result.storage.stand; stand && stand->top <= -result.storage.height)
    throw BadCell(fmt::format("{}: storage.height: the stand's top, {:g} from there, lies at or below the floor",
                              cell.file.string(), stand->top));
  check_stops(result);
  check_reach(result);
  return result;
}

}  // namespace touchstone::cell::browser
