// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/tally.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace touchstone::judge {

std::string family_of_file(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void Tally::add(const Judged& judged) {
  if (judged.compared.empty()) return;
  auto method = std::ranges::find(methods_, judged.method, &MethodTally::method);
  if (method == methods_.end()) {
    methods_.push_back({.method = std::string(judged.method), .all = {}, .by_key = {}, .by_file = {}, .by_tag = {}});
    method = methods_.end() - 1;
  }
  const bool no_answer = judged.differences.empty() && !judged.fault.empty();
  bool any_wrong = false, any_missing = no_answer;
  std::map<std::string, Count> keys;
  for (const std::string& key : judged.compared) keys[key] = {.cases = 1, .wrong = 0, .not_given = no_answer ? 1U : 0U};
  for (const cases::Difference& difference : judged.differences) {
    (difference.found ? keys[difference.key].wrong : keys[difference.key].not_given) = 1;
    (difference.found ? any_wrong : any_missing) = true;
  }
  const auto count = [](Count& sum, bool wrong, bool not_given) {
    ++sum.cases;
    sum.wrong += wrong ? 1 : 0;
    sum.not_given += not_given && !wrong ? 1 : 0;
  };
  for (const auto& [key, outcome] : keys) count(method->by_key[key], outcome.wrong > 0, outcome.not_given > 0);
  count(method->all, any_wrong, any_missing);
  count(method->by_file[family_of_file(judged.line.file)], any_wrong, any_missing);
  const auto& tags = judged.line.read->tags;
  for (const std::string& tag : std::set(tags.begin(), tags.end())) count(method->by_tag[tag], any_wrong, any_missing);
}

}  // namespace touchstone::judge
