// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>

#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/methods/registry.h"
#include "experiments/program/json.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::corpus {

using cases::Key;
using cases::PartialAnswer;

bool is_decisive(const Key& key) { return !key.holds_doubles(); }

WrongAnswer wrong_answer(const cases::Method& method, const cases::AnyShapes& shapes, const PartialAnswer& truth) {
  WrongAnswer wrong;
  try {
    wrong.answer = cases::prepare(method, shapes)->answer(question_of(shapes)).value_or(PartialAnswer{});
    wrong.keys = differing_keys(truth, wrong.answer);
  } catch (const methods::EngineNotStarted&) {
    throw;
  } catch (const std::exception&) {  // thrown by a third-party engine
    for (const Key& key : cases::kKeys)
      if (has(truth, key)) wrong.keys.push_back(key);
  }
  return wrong;
}

const std::vector<const cases::Method*>& witnesses() {
  static const auto found =
      methods::find_methods({"fast", "fast-float", "fast-double-double", "thesis", "cgal-double"});
  return found;
}

bool any_decisive(const std::vector<Key>& keys) { return std::ranges::any_of(keys, is_decisive); }

std::vector<const cases::Method*> failing_witnesses(const cases::AnyShapes& shapes, const PartialAnswer& truth) {
  std::vector<const cases::Method*> failing;
  for (const auto* method : witnesses())
    if (any_decisive(wrong_answer(*method, shapes, truth).keys)) failing.push_back(method);
  return failing;
}

std::string line_of(const CorpusCase& given, const PartialAnswer& truth) {
  std::vector<std::string> tags = given.tags;
  std::erase_if(tags, [](const std::string& tag) { return tag.starts_with("fails:"); });
  for (const auto* method : failing_witnesses(given.shapes, truth))
    tags.push_back("fails:" + std::string(method->name()));
  cases::Json object = cases::case_of(given.id, given.shapes, tags, cases::object_of(truth));
  object["origin"] = given.origin;
  return cases::to_line(object);
}

Labels labels_of(std::string_view line) {
  const auto value = program::read_strict_json(line).value;
  Labels labels;
  if (const auto tags = value.find("tags"); tags != value.end()) labels.tags = tags->get<std::vector<std::string>>();
  if (const auto origin = value.find("origin"); origin != value.end() && origin->is_string())
    labels.origin = origin->get<std::string>();
  return labels;
}

}  // namespace touchstone::corpus
