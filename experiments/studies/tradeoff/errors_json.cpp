// SPDX-License-Identifier: GPL-3.0-or-later
// Errors as JSON: lists by stratum and method; doubles are their bits, for JSON has no infinities.
#include <bit>

#include "experiments/studies/tradeoff/errors.h"

namespace touchstone::tradeoff {
namespace {

using List = nlohmann::ordered_json;

List json_of(const MethodErrors& errors) {
  List offsets = List::array(), quantities = List::array();
  for (const Tally& t : errors.offsets) offsets.push_back({t.wrong, t.unsure, t.trials, t.overflowed});
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const Worst& worst = errors.worst[q];
    quantities.push_back(
        {errors.ulps[q].asked, errors.ulps[q].known, std::bit_cast<std::uint64_t>(worst.ulps), worst.n, worst.stratum});
  }
  return {errors.samples, std::move(offsets), std::move(quantities)};
}

MethodErrors method_errors_of(const nlohmann::json& json) {
  MethodErrors errors;
  errors.samples = json.at(0).get<std::uint64_t>();
  for (const auto& t : json.at(1))
    errors.offsets.push_back({t.at(0).get<std::uint64_t>(), t.at(1).get<std::uint64_t>(), t.at(2).get<std::uint64_t>(),
                              t.at(3).get<std::uint64_t>()});
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const auto& quantity = json.at(2).at(q);
    errors.ulps[q] = {quantity.at(0).get<std::uint64_t>(), quantity.at(1).get<statistics::Distribution>()};
    errors.worst[q] = {std::bit_cast<double>(quantity.at(2).get<std::uint64_t>()), quantity.at(3).get<std::uint64_t>(),
                       quantity.at(4).get<std::size_t>()};
  }
  return errors;
}

}  // namespace

void to_json(nlohmann::ordered_json& json, const Errors& errors) {
  List strata = List::array();
  for (const auto& methods : errors.at) {
    List list = List::array();
    for (const MethodErrors& method : methods) list.push_back(json_of(method));
    strata.push_back(std::move(list));
  }
  json = {{"samples", errors.samples}, {"missing", errors.missing}, {"errors", std::move(strata)}};
}

void from_json(const nlohmann::json& json, Errors& errors) {
  errors = {};
  errors.samples = json.at("samples").get<std::uint64_t>();
  errors.missing = json.at("missing").get<std::uint64_t>();
  for (const auto& methods : json.at("errors")) {
    auto& list = errors.at.emplace_back();
    for (const auto& method : methods) list.push_back(method_errors_of(method));
  }
}

}  // namespace touchstone::tradeoff
