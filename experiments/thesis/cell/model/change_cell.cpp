// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/change_cell.h"

#include <fmt/core.h>

#include <cctype>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "experiments/run/json.h"
#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

using Key = std::variant<std::string, std::size_t>;

/// The keys of `storage.slots[1].place`.
std::vector<Key> keys_of(const std::string& path) {
  const auto bad = [&]() -> void { throw BadCell(fmt::format("{}: is not a path of keys", path)); };
  std::vector<Key> keys;
  std::size_t at = 0;
  while (at < path.size()) {
    if (path[at] == '[') {
      std::size_t number = 0;
      const auto [end, error] = std::from_chars(path.data() + at + 1, path.data() + path.size(), number);
      if (error != std::errc() || end == path.data() + path.size() || *end != ']' || keys.empty()) bad();
      keys.emplace_back(number);
      at = static_cast<std::size_t>(end - path.data()) + 1;
      continue;
    }
    if (path[at] == '.' && !keys.empty())
      ++at;
    else if (!keys.empty())
      bad();
    const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
    if (end == at) bad();
    keys.emplace_back(path.substr(at, end - at));
    at = end;
  }
  if (keys.empty() || path.back() == '.') bad();
  return keys;
}

nlohmann::json value_of(const std::string& path, const std::string& text) {
  try {
    run::StrictJson json = run::read_strict_json(text);
    if (json.duplicate_key) throw BadCell(fmt::format("{}: duplicate key \"{}\"", path, *json.duplicate_key));
    if (json.too_deep) throw BadCell(path + ": is nested too deep");
    return std::move(json.value);
  } catch (const run::NotJson&) {
    return text;
  }
}

struct Change {
  std::string path;
  std::vector<Key> keys;              ///< of the path
  std::optional<std::string> source;  ///< the path of what is copied, if it is a copy
  nlohmann::json value;               ///< otherwise
};

Change parsed(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) throw BadCell(fmt::format("{}: has no \"=\"", assignment));
  Change change{assignment.substr(0, equals), {}, std::nullopt, {}};
  change.keys = keys_of(change.path);
  const std::string text = assignment.substr(equals + 1);
  if (text.starts_with('@'))
    change.source = text.substr(1);
  else
    change.value = value_of(change.path, text);
  return change;
}

void add_names(std::set<std::string>& names, const std::vector<Key>& keys) {
  for (const Key& key : keys)
    if (const auto* name = std::get_if<std::string>(&key)) names.insert(*name);
}

void add_names(std::set<std::string>& names, const nlohmann::json& value) {
  for (const auto& [key, member] : value.items()) {
    if (value.is_object()) names.insert(key);
    if (member.is_structured()) add_names(names, member);
  }
}

/// Returns the value of the path that is copied to another.
nlohmann::json value_at(const nlohmann::json& cell, const std::string& to, const std::string& from) {
  const nlohmann::json* at = &cell;
  for (const Key& key : keys_of(from)) {
    const auto* name = std::get_if<std::string>(&key);
    const bool there = name != nullptr ? at->is_object() && at->contains(*name)
                                       : at->is_array() && std::get<std::size_t>(key) < at->size();
    if (!there) throw BadCell(fmt::format("{}: there is no value at {}", to, from));
    at = name != nullptr ? &at->at(*name) : &at->at(std::get<std::size_t>(key));
  }
  return *at;
}

/// Returns whether it is the path, or below it.
bool below(const std::string& label, const std::string& path) {
  return label.compare(0, path.size(), path) == 0 &&
         (label.size() == path.size() || label[path.size()] == '.' || label[path.size()] == '[');
}

}  // namespace

void change_cell(nlohmann::json& cell, const std::string& assignment) {
  Change change = parsed(assignment);
  const std::string& path = change.path;
  const std::vector<Key>& keys = change.keys;
  nlohmann::json value = change.source ? value_at(cell, path, *change.source) : std::move(change.value);

  // The first element of a list that is not there begins it.
  if (keys.size() == 2 && std::holds_alternative<std::size_t>(keys[1]) && std::get<std::size_t>(keys[1]) == 0 &&
      cell.is_object() && !value.is_null()) {
    const std::string& list = std::get<std::string>(keys[0]);
    if (!cell.contains(list)) cell[list] = nlohmann::json::array();
  }

  nlohmann::json* at = &cell;
  const auto missing = [&](const std::string& what) { throw BadCell(fmt::format("{}: {}", path, what)); };
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    if (const auto* name = std::get_if<std::string>(&keys[i])) {
      if (!at->is_object() || !at->contains(*name)) missing(fmt::format("there is no key \"{}\"", *name));
      at = &(*at)[*name];
    } else {
      const std::size_t number = std::get<std::size_t>(keys[i]);
      if (!at->is_array() || number >= at->size()) missing(fmt::format("there is no element {}", number));
      at = &(*at)[number];
    }
  }

  const bool remove = value.is_null();
  std::string moved_up;  // the array whose later elements change their numbers
  if (const auto* name = std::get_if<std::string>(&keys.back())) {
    if (!at->is_object() || (remove && !at->contains(*name))) missing(fmt::format("there is no key \"{}\"", *name));
    if (remove)
      at->erase(*name);
    else
      (*at)[*name] = std::move(value);
  } else {
    const std::size_t number = std::get<std::size_t>(keys.back());
    if (!at->is_array() || number > at->size() || (remove && number == at->size()))
      missing(fmt::format("there is no element {}", number));
    if (remove) {
      at->erase(number);
      moved_up = path.substr(0, path.rfind('['));
    } else if (number == at->size()) {
      at->push_back(std::move(value));
    } else {
      (*at)[number] = std::move(value);
    }
  }

  nlohmann::json& labels = cell["labels"];
  if (!labels.is_object() || below(path, "labels")) return;
  for (auto label = labels.begin(); label != labels.end();) {
    const bool gone = below(label.key(), path) || (!moved_up.empty() && label.key().starts_with(moved_up + "["));
    label = gone ? labels.erase(label) : std::next(label);
  }
  if (!remove) labels[path] = "C";
}

std::set<std::string> keys_of_change(const std::string& assignment) {
  const Change change = parsed(assignment);
  std::set<std::string> names;
  add_names(names, change.keys);
  if (change.source) add_names(names, keys_of(*change.source));
  if (change.value.is_structured()) add_names(names, change.value);
  return names;
}

std::optional<double> number_of_change(const std::string& assignment, const std::string& path) {
  const Change change = parsed(assignment);
  if (change.path != path || !change.value.is_number()) return std::nullopt;
  return change.value.get<double>();
}

}  // namespace touchstone::cell
