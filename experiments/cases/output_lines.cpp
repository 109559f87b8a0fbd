// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/output_lines.h"

#include <cmath>

#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"

namespace touchstone::cases {
namespace {

Json begin(const Json& id, std::string_view method) {
  Json verdict = Json::object();
  verdict["id"] = id;
  verdict["method"] = method;
  return verdict;
}

}  // namespace

std::string unanswered_line(const std::string& id, std::string_view method) {
  Json verdict = begin(id, method);
  verdict["unanswered"] = "motion";
  return to_line(verdict);
}

std::string verdict_line(const std::string& id, std::string_view method, const StatedAnswer& answer,
                         std::optional<double> explained_radius) {
  std::string line = to_line(begin(id, method));
  line.resize(line.size() - 2);  // the end of the object and of the line
  const auto add = [&](std::string_view name, const std::string& text) {
    line.append(",\"").append(name).append("\":").append(text);
  };
  const auto add_stated = [&](std::string_view name) {
    if (const auto found = answer.texts.find(std::string(name)); found != answer.texts.end()) add(name, found->second);
  };
  for (const Key& key : kKeys) add_stated(key.name);
  add_stated("error");
  add_stated("message");
  const PartialAnswer& values = answer.values;
  if (explained_radius && !values.stage.empty()) add("stage", Json(values.stage).dump());
  if (explained_radius && !values.first)
    add("margin", values.distance && !std::isnan(*values.distance)
                      ? std::to_string(workloads::doubles_between(*values.distance, *explained_radius))
                      : "null");
  return line + "}\n";
}

std::string verdict_line(const std::optional<std::string>& id, std::string_view method, const Rejection& rejection) {
  Json verdict = begin(id ? Json(*id) : Json(nullptr), method);
  verdict["error"] = to_string(rejection.code);
  verdict["message"] = (id ? "case " + *id + ": " : "") + rejection.message;
  return to_line(verdict);
}

std::string case_line(const std::string& id, const AnyShapes& shapes, const std::vector<std::string>& tags,
                      const std::optional<PartialAnswer>& expected) {
  return to_line(case_of(id, shapes, tags, expected ? object_of(*expected) : Json(nullptr)));
}

}  // namespace touchstone::cases
