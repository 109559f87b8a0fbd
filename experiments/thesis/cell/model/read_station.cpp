// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_station.h"

#include <fmt/core.h>

#include <set>
#include <utility>

namespace touchstone::cell {

Station read_station(const CellEntry& entry, std::string name, const SolidContext& context) {
  Station station{entry.at("home").number(),
                  entry.at("angle").number(),
                  entry.at("radius").positive(),
                  entry.at("height").not_negative(),
                  {},
                  read_parts(entry.at("parts"), context),
                  {}};
  station.name = std::move(name);
  station.key = entry.path();
  if (const auto turn = entry.find("turn")) station.turn = turn->number();
  for (const CellEntry& item : entry.at("parts").items())
    if (item.at("name").name() == "stand") item.at("name").bad("only the stand has this name");
  std::set<std::string> names;
  for (const CellEntry& item : entry.at("slots").items()) {
    item.has_only({"name", "place", "aim"});
    const Eigen::Vector3d place = item.at("place").point();
    const auto aim = item.find("aim");
    station.slots.push_back({item.at("name").text(), place, aim ? aim->point2() : Eigen::Vector2d(place.head<2>())});
    if (!names.insert(station.slots.back().name).second) item.at("name").bad("this name is taken");
  }
  if (station.slots.empty()) entry.at("slots").bad("must not be empty");
  if (const auto stand = entry.find("stand")) {
    stand->has_only({"from", "to", "top"});
    station.stand = {stand->at("from").point2(), stand->at("to").point2(), stand->at("top").number()};
    const Station::Stand& given = *station.stand;
    if (!(given.lower.x() < given.upper.x() && given.lower.y() < given.upper.y()))
      stand->bad("\"from\" must be less than \"to\" in each coordinate");
    if (!(given.top > -station.height)) stand->at("top").bad("lies at or below the floor");
  }
  return station;
}

std::size_t slot_named(const Station& station, const CellEntry& entry) {
  const std::string name = entry.text();
  for (std::size_t i = 0; i < station.slots.size(); ++i)
    if (station.slots[i].name == name) return i;
  entry.bad(fmt::format("there is no slot \"{}\"", name));
}

}  // namespace touchstone::cell
