// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/cell_entry.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace touchstone::cell {

bool is_name(std::string_view word) {
  return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
                              std::string_view::npos;
}

void CellEntry::bad(const std::string& reason) const {
  throw BadCell(fmt::format("{}: {}: {}", file_, path_.empty() ? "the whole" : path_, reason));
}

void CellEntry::has_only(const std::vector<std::string_view>& keys) const {
  std::string known;
  for (const std::string_view key : keys) known.append(known.empty() ? "" : ", ").append(key);
  for (const auto& [key, entry] : members())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) entry.bad("is an unknown key; there are " + known);
}

CellEntry CellEntry::at(const std::string& key) const {
  if (const std::optional<CellEntry> entry = find(key)) return *entry;
  bad(fmt::format("the key \"{}\" is missing", key));
}

std::optional<CellEntry> CellEntry::find(const std::string& key) const {
  if (!value_->is_object()) bad("must be an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return CellEntry(file_, path_.empty() ? key : path_ + "." + key, *found);
}

std::vector<std::pair<std::string, CellEntry>> CellEntry::members() const {
  if (!value_->is_object()) bad("must be an object");
  std::vector<std::pair<std::string, CellEntry>> result;
  for (const auto& member : value_->items()) result.emplace_back(member.key(), at(member.key()));
  return result;
}

std::vector<CellEntry> CellEntry::items() const {
  if (!value_->is_array()) bad("must be an array");
  std::vector<CellEntry> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back(file_, fmt::format("{}[{}]", path_, i), (*value_)[i]);
  return result;
}

bool CellEntry::is_number() const { return value_->is_number(); }
bool CellEntry::is_object() const { return value_->is_object(); }
bool CellEntry::is_array() const { return value_->is_array(); }

std::string CellEntry::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) bad("must be a text that is not empty");
  std::string text = value_->get<std::string>();
  if (io::all_legible(text) != text) bad("must have no control character, is \"" + io::legible(text) + "\"");
  return text;
}

std::string CellEntry::name() const {
  std::string name = text();
  if (!is_name(name)) bad("must be a name of letters, digits, '-' and '_'");
  return name;
}

bool CellEntry::yes() const {
  if (!value_->is_boolean()) bad("must be true or false");
  return value_->get<bool>();
}

double CellEntry::number() const {
  if (!value_->is_number()) bad("must be a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) bad("is beyond the finite doubles");
  return number;
}

double CellEntry::positive() const {
  const double value = number();
  if (!(value > 0)) bad(fmt::format("must be positive, is {}", value));
  return value;
}

double CellEntry::not_negative() const {
  const double value = number();
  if (!(value >= 0)) bad(fmt::format("must not be negative, is {}", value));
  return value;
}

double CellEntry::seconds() const {
  constexpr double kMost = 1e9;
  const double seconds = positive();
  if (seconds > kMost) bad(fmt::format("must be at most {} seconds, is {}", kMost, seconds));
  return seconds;
}

int CellEntry::whole(int least, int most) const {
  const double value = number();
  if (value != std::floor(value) || value < least || value > most)
    bad(fmt::format("must be a whole number from {} to {}, is {}", least, most, value));
  return static_cast<int>(value);
}

std::vector<double> CellEntry::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) bad(fmt::format("must be an array of {} numbers", count));
  std::vector<double> result;
  for (const CellEntry& item : items()) result.push_back(item.number());
  return result;
}

Eigen::Vector3d CellEntry::point() const {
  const std::vector<double> x = numbers(3);
  return {x[0], x[1], x[2]};
}

Eigen::Vector2d CellEntry::point2() const {
  const std::vector<double> x = numbers(2);
  return {x[0], x[1]};
}

}  // namespace touchstone::cell
