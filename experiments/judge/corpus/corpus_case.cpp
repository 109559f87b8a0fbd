// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/corpus/corpus_case.h"

#include <algorithm>
#include <exception>

#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"

namespace touchstone::corpus {

using cases::Verdict;

Verdict exact_answer(const Ball& ball, const Polygon& polygon) {
  return cases::object_of(cases::PartialAnswer::of(exact::answer(ball, polygon), ""));
}

bool is_decisive(std::string_view key) {
  return cases::is_answer_key(key) && key != "point" && key != "distance" && key != "off_plane";
}

Verdict wrong_values(const cases::Method& method, const Ball& ball, const Polygon& polygon, const Verdict& truth) {
  Verdict given, wrong = Verdict::object();
  try {
    given = cases::object_of(method.prepare(polygon)->ask(ball, cases::QueryKind::Answer));
  } catch (const std::exception&) {  // thrown by a third-party engine
    for (const auto& [key, value] : truth.items()) wrong[key] = nullptr;
    return wrong;
  }
  for (const auto& [key, value] : given.items())
    if (truth.contains(key) && value != truth[key]) wrong[key] = value;
  return wrong;
}

const std::vector<const cases::Method*>& witnesses() {
  static const auto found =
      methods::find_methods({"fast", "fast-float", "fast-double-double", "thesis", "cgal-double"});
  return found;
}

bool any_decisive(const Verdict& wrong) {
  for (const auto& [key, value] : wrong.items())
    if (is_decisive(key)) return true;
  return false;
}

std::vector<const cases::Method*> failing_witnesses(const Ball& ball, const Polygon& polygon, const Verdict& truth) {
  std::vector<const cases::Method*> failing;
  for (const auto* method : witnesses())
    if (any_decisive(wrong_values(*method, ball, polygon, truth))) failing.push_back(method);
  return failing;
}

std::string line_of(const CorpusCase& given, const Verdict& truth) {
  std::vector<std::string> tags = given.tags;
  std::erase_if(tags, [](const std::string& tag) { return tag.starts_with("fails:"); });
  for (const auto* method : failing_witnesses(given.ball, given.polygon, truth))
    tags.push_back("fails:" + std::string(method->name()));
  Verdict object = cases::case_of(given.id, given.ball, given.polygon, tags, truth);
  object["origin"] = given.origin;
  return cases::to_line(object);
}

Labels labels_of(std::string_view line) {
  const auto value = harness::read_strict_json(line).value;
  Labels labels;
  if (const auto tags = value.find("tags"); tags != value.end()) labels.tags = tags->get<std::vector<std::string>>();
  if (const auto origin = value.find("origin"); origin != value.end() && origin->is_string())
    labels.origin = origin->get<std::string>();
  return labels;
}

}  // namespace touchstone::corpus
