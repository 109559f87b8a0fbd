// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/browser/setting.h"

#include <fmt/core.h>

#include <algorithm>

#include "experiments/cell/model/cell_entry.h"
#include "experiments/cell/model/reach.h"
#include "experiments/cell/model/read_station.h"
#include "experiments/cell/model/stops.h"
#include "experiments/harness/json/strict_json.h"
#include "experiments/methods/registry.h"

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
  whole.has_only({"storage", "slot", "step", "drive", "changes", "piece"});
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
  if (const auto drive = whole.find("drive")) {
    setting.drive = drive->text();
    // Programs of the user's own are not run for a page.
    if (std::ranges::none_of(methods::all_methods(), [&](const auto& each) { return each->name() == setting.drive; }))
      drive->bad(fmt::format("there is no method \"{}\"", setting.drive));
  }
  return setting;
}

/// Reads the checked JSON of a request.
template <class Read>
auto read_request(std::string_view text, const Read& read_whole) {
  try {
    const harness::StrictJson json = harness::read_strict_json(text);
    const CellEntry whole("request", "", json.value);
    if (json.duplicate_key) whole.bad(fmt::format("the key \"{}\" is given twice", *json.duplicate_key));
    if (json.too_deep) whole.bad("is nested too deep");
    return read_whole(whole);
  } catch (const harness::NotJson& error) {
    throw BadSetting(fmt::format("request: is not JSON: {}", error.what()));
  } catch (const BadCell& error) {
    throw BadSetting(error.what());
  }
}

}  // namespace

Setting setting_of(const Cell& cell) {
  return {cell.storage.angle, cell.storage.radius, cell.storage.height, cell.material.slot, cell.step, "exact"};
}

double longest(const Cell& cell) {
  const Reach reach = reach_of(cell);
  return 4 * (reach.radius + reach.outer);
}

Setting read_setting(std::string_view text, const Cell& cell) {
  return read_request(text, [&](const CellEntry& whole) { return read(whole, cell); });
}

Variation read_variation(std::string_view text) {
  return read_request(text, [&](const CellEntry& whole) {
    Variation variation;
    if (const auto piece = whole.find("piece")) variation.piece = piece->name();
    const auto changes = whole.find("changes");
    if (!changes) return variation;
    for (const CellEntry& change : changes->items()) {
      for (const char* key : {"urdf", "mesh", "file", "packages"})
        if (change.text().find(key) != std::string::npos)
          change.bad(fmt::format("names \"{}\": the page changes no files", key));
      variation.changes.push_back(change.text());
    }
    if (variation.changes.size() > kMostChanges) changes->bad(fmt::format("are more than {}", kMostChanges));
    return variation;
  });
}

PoseRequest read_pose(std::string_view text, const Cell& cell, std::size_t joints) {
  return read_request(text, [&](const CellEntry& whole) {
    whole.has_only({"setting", "commanded", "changes", "piece"});
    PoseRequest pose{read(whole.at("setting"), cell), {}};
    for (const CellEntry& command : whole.at("commanded").items()) pose.commanded.push_back(command.number());
    if (pose.commanded.size() != joints)
      whole.at("commanded").bad(fmt::format("must hold {} numbers, one for each joint that turns", joints));
    return pose;
  });
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
    throw BadCell(fmt::format("{}: {}.height: the stand's top, {:g} from there, lies at or below the floor",
                              cell.file.string(), cell.storage.key, stand->top));
  check_stops(result);
  check_reach(result);
  return result;
}

}  // namespace touchstone::cell::browser
