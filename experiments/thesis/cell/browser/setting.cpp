// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/browser/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "experiments/methods/registry.h"
#include "experiments/program/json.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "experiments/thesis/cell/model/change_cell.h"
#include "experiments/thesis/cell/model/reach.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/cell/model/read_things.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::cell::browser {
namespace {

/// The keys of a cell file that the page sets. None of them names a file or a folder.
constexpr std::array<std::string_view, 40> kKeys{
    "about",     "aim",    "angle", "at",      "box",          "capsule",  "clearance", "cylinder",  "face",  "from",
    "gripper",   "height", "home",  "machine", "machine_slot", "machines", "material",  "materials", "move",  "name",
    "obstacles", "parts",  "place", "radius",  "robot",        "robots",   "sides",     "slot",      "slots", "solid",
    "sphere",    "stand",  "step",  "stops",   "storage",      "storages", "to",        "top",       "turn",  "zones"};

void require_within(const std::string& key, double number, double least, double most) {
  if (number < least || number > most)
    throw BadSetting(fmt::format("request: {}: must be from {:g} to {:g}, is {:g}", key, least, most, number));
}

/// Whatever set the numbers: the request, a change of the cell, or its file.
void require_bounds(const Setting& setting, const Cell& cell) {
  require_within("storage.angle", setting.angle, -kMostDegrees, kMostDegrees);
  require_within("storage.radius", setting.radius, 0, longest(cell));
  require_within("storage.height", setting.height, 0, longest(cell));
  require_within("step", setting.step, kLeastStep, kMostStep);
}

Setting read(const CellEntry& whole, const Cell& cell) {
  Setting setting = setting_of(cell);
  whole.has_only({"storage", "slot", "step", "drive", "changes", "piece"});
  if (const auto storage = whole.find("storage")) {
    storage->has_only({"angle", "radius", "height"});
    if (const auto angle = storage->find("angle")) setting.angle = angle->number();
    if (const auto radius = storage->find("radius")) setting.radius = radius->positive();
    if (const auto height = storage->find("height")) setting.height = height->number();
  }
  if (const auto slot = whole.find("slot")) setting.slot = slot_named(cell.storage, *slot);
  if (const auto step = whole.find("step")) setting.step = step->number();
  if (const auto drive = whole.find("drive")) {
    setting.drive = drive->text();
    // Programs of the user's own are not run for a page.
    if (std::ranges::none_of(methods::all_methods(), [&](const auto& each) { return each->name() == setting.drive; }))
      drive->bad(fmt::format("there is no method \"{}\"", setting.drive));
  }
  require_bounds(setting, cell);
  return setting;
}

std::set<std::string> keys_named(const CellEntry& change) {
  const std::string text = change.text();
  try {
    return keys_of_change(text);
  } catch (const BadCell& error) {
    change.bad(error.what());
  }
}

/// Reads the checked JSON of a request.
template <class Read>
auto read_request(std::string_view text, const Read& read_whole) {
  try {
    const program::StrictJson json = program::read_strict_json(text);
    const CellEntry whole("request", "", json.value);
    if (json.duplicate_key) whole.bad(fmt::format("the key \"{}\" is given twice", *json.duplicate_key));
    if (json.too_deep) whole.bad("is nested too deep");
    return read_whole(whole);
  } catch (const program::NotJson& error) {
    throw BadSetting(fmt::format("request: is not JSON: {}", error.what()));
  } catch (const BadCell& error) {
    throw BadSetting(error.what());
  }
}

}  // namespace

Setting setting_of(const Cell& cell) {
  return {cell.storage.angle, cell.storage.radius, cell.storage.height, cell.material.slot, cell.step, "exact"};
}

double longest(const Cell& cell) { return 4 * reach_of(cell).furthest(); }

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
      for (const std::string& key : keys_named(change))
        if (std::ranges::find(kKeys, key) == kKeys.end())
          change.bad(fmt::format("the page does not set \"{}\"; it sets {}", io::legible(key), fmt::join(kKeys, ", ")));
      if (const auto step = number_of_change(change.text(), "step"))
        require_within(change.path() + ": step", *step, kLeastStep, kMostStep);
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
  check_cell(result);
  return result;
}

}  // namespace touchstone::cell::browser
