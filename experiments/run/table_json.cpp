// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/table_json.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/run/input.h"

namespace touchstone::run {
namespace {

/// Takes the next line of fields from a CSV text, with its end.
std::vector<std::string> take_fields(std::string_view& csv) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  std::size_t i = 0;
  for (; i < csv.size() && (quoted || csv[i] != '\n'); ++i) {
    if (csv[i] == '"') {
      const bool doubled = quoted && i + 1 < csv.size() && csv[i + 1] == '"';
      if (doubled) fields.back() += csv[++i];
      if (!doubled) quoted = !quoted;
    } else if (csv[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += csv[i];
    }
  }
  csv.remove_prefix(std::min(i + 1, csv.size()));
  return fields;
}

/// Returns whether JSON has this number as it stands.
bool is_json_number(const std::string& field) {
  double number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  return error == std::errc() && end == field.data() + field.size() && std::isfinite(number) &&
         nlohmann::json::accept(field);
}

std::string json_of_field(const std::string& field) {
  if (field.empty()) return "null";
  return is_json_number(field) ? field : nlohmann::json(field).dump();
}

}  // namespace

std::string json_of_csv(std::string_view csv) {
  const std::vector<std::string> names = take_fields(csv);
  std::string json = "[";
  while (!csv.empty()) {
    const std::vector<std::string> fields = take_fields(csv);
    if (fields.size() != names.size()) throw std::runtime_error("a line has another number of fields than the heading");
    json += json.size() > 1 ? ",\n{" : "\n{";
    for (std::size_t i = 0; i < names.size(); ++i)
      json.append(i == 0 ? "" : ",")
          .append(nlohmann::json(names[i]).dump())
          .append(":")
          .append(json_of_field(fields[i]));
    json += "}";
  }
  return json + "]";
}

std::string tables_json(const std::filesystem::path& folder, const std::vector<TableDescription>& tables) {
  std::string json = "{";
  for (const TableDescription& table : tables) {
    const std::filesystem::path file = folder / table.file;
    if (!std::filesystem::exists(file)) continue;
    std::ifstream stream = open_file(file);
    const std::string csv{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) throw std::runtime_error(file.string() + ": cannot be read to its end");
    json.append(json.size() > 1 ? ",\n" : "")
        .append(nlohmann::json(table.file).dump())
        .append(":")
        .append(json_of_csv(csv));
  }
  return json + "}\n";
}

}  // namespace touchstone::run
