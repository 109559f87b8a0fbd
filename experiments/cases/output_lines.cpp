// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/output_lines.h"

#include <cmath>

#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/ulp.h"

namespace touchstone::cases {
namespace {

Verdict begin(const Verdict& id, std::string_view method) {
  Verdict verdict = Verdict::object();
  verdict["id"] = id;
  verdict["method"] = method;
  return verdict;
}

}  // namespace

std::string verdict_line(const std::string& id, std::string_view method, const PartialAnswer& answer,
                         std::optional<double> explained_radius) {
  Verdict verdict = begin(id, method);
  verdict.update(object_of(answer));
  if (explained_radius) {
    if (!answer.stage.empty()) verdict["stage"] = answer.stage;
    if (answer.first) return to_line(verdict);
    if (answer.distance && !std::isnan(*answer.distance))
      verdict["margin"] = workloads::doubles_between(*answer.distance, *explained_radius);
    else
      verdict["margin"] = nullptr;
  }
  return to_line(verdict);
}

std::string unanswered_line(const std::string& id, std::string_view method) {
  Verdict verdict = begin(id, method);
  verdict["unanswered"] = "motion";
  return to_line(verdict);
}

std::string verdict_line(const std::string& id, std::string_view method, const StatedAnswer& answer) {
  std::string line = to_line(begin(id, method));
  line.resize(line.size() - 2);  // the end of the object and of the line
  const auto add = [&](std::string_view name) {
    if (const auto found = answer.texts.find(std::string(name)); found != answer.texts.end())
      line.append(",\"").append(name).append("\":").append(found->second);
  };
  for (const Key key : kKeys) add(to_string(key));
  add("error");
  add("message");
  return line + "}\n";
}

std::string verdict_line(const std::optional<std::string>& id, std::string_view method, const Rejection& rejection) {
  Verdict verdict = begin(id ? Verdict(*id) : Verdict(nullptr), method);
  verdict["error"] = to_string(rejection.code);
  verdict["message"] = (id ? "case " + *id + ": " : "") + rejection.message;
  return to_line(verdict);
}

std::string case_line(const std::string& id, const Shapes& shapes, const std::vector<std::string>& tags,
                      const std::optional<PartialAnswer>& expected) {
  return to_line(case_of(id, shapes, tags, expected ? object_of(*expected) : Verdict(nullptr)));
}

std::string case_line(const std::string& id, const Ball& ball, const Polygon& polygon,
                      const std::vector<std::string>& tags, const std::optional<PartialAnswer>& expected) {
  return case_line(id, Shapes{ball, polygon}, tags, expected);
}

}  // namespace touchstone::cases
