// SPDX-License-Identifier: GPL-3.0-or-later
// A summary as JSON: lists of rows, where doubles are their bits, for JSON has no infinities.
#include <bit>

#include "experiments/studies/stability/summary.h"

namespace touchstone::stability {
namespace {

using Rows = nlohmann::ordered_json;

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }
double real(const nlohmann::json& json) { return std::bit_cast<double>(json.get<std::uint64_t>()); }

/// `number(row, i)` is the whole number at place i.
std::size_t number(const nlohmann::json& row, std::size_t i) { return row.at(i).get<std::size_t>(); }

Rows json_of(const BoundSummary& b) { return {b.tightness, b.exceeded, b.failed, b.polygons}; }

BoundSummary bound_of(const nlohmann::json& json) {
  return {json.at(0).get<statistics::Distribution>(), number(json, 1), number(json, 2), number(json, 3)};
}

Rows json_of(const std::optional<WorstCase>& w) {
  return w ? Rows{w->level, w->method, w->rank, bits(w->error), w->block, w->line} : Rows();
}

std::optional<WorstCase> worst_of(const nlohmann::json& w) {
  if (w.is_null()) return std::nullopt;
  return WorstCase{number(w, 0),  number(w, 1), w.at(2).get<int>(),
                   real(w.at(3)), number(w, 4), w.at(5).get<std::string>()};
}

}  // namespace

void to_json(nlohmann::ordered_json& json, const Summary& summary) {
  Rows failures = Rows::array(), errors = Rows::array(), bounds = Rows::array(), all_bounds = Rows::array();
  Rows points = Rows::array(), worst = Rows::array();
  for (const auto& [cell, t] : summary.failures) {
    const auto& [axis, nearness, test, method, level] = cell;
    failures.push_back({axis, nearness, test, method, level, t.failed, t.samples, t.wrong, t.balls});
  }
  for (const auto& [cell, e] : summary.errors) {
    const auto& [axis, quantity, method, level] = cell;
    errors.push_back({axis, quantity, method, level, e.relative, e.ulps});
  }
  for (const auto& [cell, bound] : summary.bounds) {
    const auto& [quantity, axis, level] = cell;
    bounds.push_back({quantity, axis, level, json_of(bound)});
  }
  for (const auto& [quantity, bound] : summary.all_bounds) all_bounds.push_back({quantity, json_of(bound)});
  for (const auto& [block, list] : summary.points)
    for (const ConditionPoint& p : list)
      points.push_back({block, p.level, p.quantity, bits(p.condition), bits(p.relative_error)});
  for (const auto& methods : summary.worst) {
    Rows row = Rows::array();
    for (const auto& w : methods) row.push_back(json_of(w));
    worst.push_back(std::move(row));
  }
  json = {{"blocks", summary.blocks},     {"missing", summary.missing},          {"confirmed", summary.confirmed},
          {"disputed", summary.disputed}, {"failures", std::move(failures)},     {"errors", std::move(errors)},
          {"bounds", std::move(bounds)},  {"all_bounds", std::move(all_bounds)}, {"points", std::move(points)},
          {"worst", std::move(worst)}};
}

void from_json(const nlohmann::json& json, Summary& summary) {
  summary = {};
  summary.blocks = json.at("blocks").get<std::uint64_t>();
  summary.missing = json.at("missing").get<std::vector<std::uint64_t>>();
  summary.confirmed = json.at("confirmed").get<std::uint64_t>();
  summary.disputed = json.at("disputed").get<std::uint64_t>();
  for (const auto& r : json.at("failures"))
    summary.failures[{number(r, 0), r.at(1).get<Nearness>(), r.at(2).get<Test>(), number(r, 3), number(r, 4)}] = {
        number(r, 5), number(r, 6), number(r, 7), number(r, 8)};
  for (const auto& r : json.at("errors"))
    summary.errors[{number(r, 0), r.at(1).get<Quantity>(), number(r, 2), number(r, 3)}] = {
        r.at(4).get<statistics::Distribution>(), r.at(5).get<statistics::Distribution>()};
  for (const auto& r : json.at("bounds"))
    summary.bounds[{number(r, 0), number(r, 1), number(r, 2)}] = bound_of(r.at(3));
  for (const auto& r : json.at("all_bounds")) summary.all_bounds[number(r, 0)] = bound_of(r.at(1));
  for (const auto& r : json.at("points"))
    summary.points[number(r, 0)].push_back({number(r, 1), number(r, 2), real(r.at(3)), real(r.at(4))});
  for (const auto& row : json.at("worst")) {
    auto& methods = summary.worst.emplace_back();
    for (const auto& w : row) methods.push_back(worst_of(w));
  }
}

}  // namespace touchstone::stability
