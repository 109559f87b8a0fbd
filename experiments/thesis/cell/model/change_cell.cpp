// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/change_cell.h"

#include <fmt/core.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <utility>

#include "experiments/program/json.h"
#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

bool is_index(const std::string& key) { return key.find_first_not_of("0123456789") == std::string::npos; }

/// Returns `/storage/slots/1` of `storage.slots[1]`.
Pointer pointer_to(const std::string& path) {
  static const std::string name = R"((?!\d+(?:[.[]|$))[^.[\]]+)";
  static const std::regex whole(name + R"((?:\.)" + name + R"(|\[(?:0|[1-9]\d{0,8})\])*)"), key(R"([^.[\]]+)");
  constexpr std::size_t kLongest = 1000;  // std::regex recurses
  if (path.size() > kLongest || !std::regex_match(path, whole))
    throw BadCell(fmt::format("{}: is not a path of keys", path));
  Pointer pointer;
  for (std::sregex_iterator at(path.begin(), path.end(), key), end; at != end; ++at) pointer.push_back(at->str());
  return pointer;
}

json value_of(const std::string& path, const std::string& text) {
  try {
    program::StrictJson read = program::read_strict_json(text);
    if (read.duplicate_key) throw BadCell(fmt::format("{}: duplicate key \"{}\"", path, *read.duplicate_key));
    if (read.too_deep) throw BadCell(path + ": is nested too deep");
    return std::move(read.value);
  } catch (const program::NotJson&) {
    return text;
  }
}

struct Change {
  std::string path;
  Pointer to;
  std::optional<std::string> source;  ///< the path of what is copied, if it is a copy
  json value;                         ///< otherwise
};

Change parsed(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) throw BadCell(fmt::format("{}: has no \"=\"", assignment));
  const std::string path = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  Change change{path, pointer_to(path), std::nullopt, {}};
  if (text.starts_with('@'))
    change.source = text.substr(1);
  else
    change.value = value_of(path, text);
  return change;
}

/// Refuses a path through a missing entry, or through one that is neither object nor array. `may_add`: the last key may
/// be new, or the element after the last.
void require_place(const json& cell, const Pointer& pointer, const std::string& path, bool may_add) {
  if (pointer.empty()) return;
  const Pointer above = pointer.parent_pointer();
  require_place(cell, above, path, false);
  const json& holder = cell.at(above);
  const std::string& key = pointer.back();
  if (is_index(key)) {
    if (!holder.is_array() || std::stoul(key) >= holder.size() + (may_add ? 1 : 0))
      throw BadCell(fmt::format("{}: there is no element {}", path, key));
  } else if (!holder.is_object() || (!may_add && !holder.contains(key))) {
    throw BadCell(fmt::format("{}: there is no key \"{}\"", path, key));
  }
}

void add_names(std::set<std::string>& names, Pointer pointer) {
  for (; !pointer.empty(); pointer.pop_back())
    if (!is_index(pointer.back())) names.insert(pointer.back());
}

void add_names(std::set<std::string>& names, const json& value) {
  for (const auto& [key, member] : value.items()) {
    if (value.is_object()) names.insert(key);
    if (member.is_structured()) add_names(names, member);
  }
}

/// Returns whether it is the path, or below it.
bool below(const std::string& label, const std::string& path) {
  return label.starts_with(path) &&
         (label.size() == path.size() || label[path.size()] == '.' || label[path.size()] == '[');
}

/// Labels what was set as chosen. `moved_up`: the array whose later elements changed their numbers, if any.
void relabel(json& labels, const std::string& path, bool removed, const std::string& moved_up) {
  if (!labels.is_object() || below(path, "labels")) return;
  for (auto label = labels.begin(); label != labels.end();) {
    const bool gone = below(label.key(), path) || (!moved_up.empty() && label.key().starts_with(moved_up + "["));
    label = gone ? labels.erase(label) : std::next(label);
  }
  if (!removed) labels[path] = "C";
}

}  // namespace

void change_cell(json& cell, const std::string& assignment) {
  Change change = parsed(assignment);
  if (change.source) {
    const Pointer from = pointer_to(*change.source);
    if (!cell.contains(from)) throw BadCell(fmt::format("{}: there is no value at {}", change.path, *change.source));
    change.value = json(cell.at(from));
  }
  const bool removes = change.value.is_null();
  const Pointer above = change.to.parent_pointer();

  // The first element of a list that is not there begins it.
  if (!removes && change.to.back() == "0" && above.parent_pointer().empty() && cell.is_object() &&
      !cell.contains(above))
    cell[above] = json::array();
  require_place(cell, change.to, change.path, !removes);

  std::string moved_up;
  if (!removes) {
    cell[change.to] = std::move(change.value);
  } else if (is_index(change.to.back())) {
    cell[above].erase(std::stoul(change.to.back()));
    moved_up = change.path.substr(0, change.path.rfind('['));
  } else {
    cell[above].erase(change.to.back());
  }
  relabel(cell["labels"], change.path, removes, moved_up);
}

std::set<std::string> keys_of_change(const std::string& assignment) {
  const Change change = parsed(assignment);
  std::set<std::string> names;
  add_names(names, change.to);
  if (change.source) add_names(names, pointer_to(*change.source));
  if (change.value.is_structured()) add_names(names, change.value);
  return names;
}

std::optional<double> number_of_change(const std::string& assignment, const std::string& path) {
  const Change change = parsed(assignment);
  if (change.path != path || !change.value.is_number()) return std::nullopt;
  return change.value.get<double>();
}

}  // namespace touchstone::cell
