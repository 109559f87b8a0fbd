// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/read_solid.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "experiments/thesis/cell/model/poses.h"

namespace touchstone::cell {
namespace {

using Operation = Boolean::Operation;

Box read_box(const CellEntry& entry) {
  entry.has_only({"from", "to"});
  Box box{entry.at("from").point(), entry.at("to").point()};
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.lower[axis] < box.upper[axis]))
      entry.bad(fmt::format("\"from\" must be less than \"to\" in coordinate {}: {} and {}", axis, box.lower[axis],
                            box.upper[axis]));
  return box;
}

Cylinder read_cylinder(const CellEntry& entry) {
  entry.has_only({"from", "to", "radius", "sides"});
  Cylinder cylinder{-1, entry.at("from").point(), entry.at("to").point(), entry.at("radius").positive(),
                    entry.at("sides").whole(3, 1000)};
  for (int axis = 0; axis < 3; ++axis) {
    if (cylinder.from[axis] == cylinder.to[axis]) continue;
    if (cylinder.axis >= 0) entry.bad("\"from\" and \"to\" must differ in one coordinate only");
    cylinder.axis = axis;
  }
  if (cylinder.axis < 0) entry.bad("\"from\" and \"to\" are the same point");
  return cylinder;
}

Sphere read_sphere(const CellEntry& entry) {
  entry.has_only({"at", "radius", "sides"});
  return {entry.at("at").point(), entry.at("radius").positive(), static_cast<int>(entry.at("sides").whole(3, 1000))};
}

MeshFile read_mesh_file(const CellEntry& entry, const SolidContext& context) {
  entry.has_only({"file", "unit"});
  const CellEntry unit = entry.at("unit");
  const std::filesystem::path file = context.mesh_folder / entry.at("file").text();
  if (!std::filesystem::is_regular_file(file)) entry.at("file").bad("there is no file " + file.string());
  return {file, read_unit(unit), context.unit};
}

Boolean read_boolean(Operation operation, const CellEntry& entry, const SolidContext& context) {
  Boolean result{operation, {}};
  for (const CellEntry& item : entry.items()) {
    result.parts.push_back(read_solid(item, context));
    if (std::holds_alternative<MeshFile>(result.parts.back().shape)) item.bad("a mesh cannot be part of a Boolean");
  }
  if (result.parts.size() < 2) entry.bad("needs at least two solids");
  return result;
}

Eigen::Matrix3d read_turn(const CellEntry& entry) {
  entry.has_only({"axis", "degrees"});
  const std::string axis = entry.at("axis").text();
  if (axis != "x" && axis != "y" && axis != "z") entry.at("axis").bad("must be \"x\", \"y\" or \"z\"");
  const double quarters = entry.at("degrees").number() / 90;
  if (quarters != std::floor(quarters) || std::abs(quarters) > 4)
    entry.at("degrees").bad("must be a multiple of 90 from -360 to 360");
  return quarter_turns(axis[0] - 'x', static_cast<int>(quarters));
}

Solid read_shape(const CellEntry& entry, const SolidContext& context) {
  entry.has_only({"name", "box", "cylinder", "sphere", "mesh", "union", "difference", "intersection", "turn", "move"});
  std::optional<Solid> solid;
  const auto take = [&](const char* key, const auto& read) {
    const std::optional<CellEntry> shape = entry.find(key);
    if (!shape) return;
    if (solid) entry.bad("has more than one shape");
    solid = Solid{read(*shape)};
  };
  take("box", read_box);
  take("cylinder", read_cylinder);
  take("sphere", read_sphere);
  take("mesh", [&](const CellEntry& shape) { return read_mesh_file(shape, context); });
  take("union", [&](const CellEntry& shape) { return read_boolean(Operation::Union, shape, context); });
  take("difference", [&](const CellEntry& shape) { return read_boolean(Operation::Difference, shape, context); });
  take("intersection", [&](const CellEntry& shape) { return read_boolean(Operation::Intersection, shape, context); });
  if (!solid) entry.bad("has no shape: box, cylinder, sphere, mesh, union, difference or intersection");
  if (const auto turn = entry.find("turn")) solid->pose.rotation = read_turn(*turn);
  if (const auto move = entry.find("move")) solid->pose.translation = move->point();
  return std::move(*solid);
}

}  // namespace

workloads::Unit read_unit(const CellEntry& entry) {
  try {
    return workloads::find_unit(entry.text());
  } catch (const std::invalid_argument& error) {
    entry.bad(error.what());
  }
}

Solid read_solid(const CellEntry& entry, const SolidContext& context) {
  if (const auto name = entry.find("name")) name->bad("only whole parts have names");
  return read_shape(entry, context);
}

std::vector<Part> read_parts(const CellEntry& entry, const SolidContext& context) {
  std::vector<Part> parts;
  std::set<std::string> names;
  for (const CellEntry& item : entry.items()) {
    const CellEntry name = item.at("name");
    if (!names.insert(name.name()).second) name.bad(fmt::format("the name \"{}\" is taken", name.name()));
    parts.push_back({name.name(), read_shape(item, context)});
  }
  if (parts.empty()) entry.bad("must not be empty");
  return parts;
}

}  // namespace touchstone::cell
