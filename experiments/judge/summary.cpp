// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/run/statistics/percent.h"
#include "experiments/run/table.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

using Named = std::pair<std::string, Count>;

double share(const Count& count) { return run::rate(count.wrong, count.given()).share; }

std::string percent(double share) { return statistics::percent_to_places(share, 2); }

std::string row(const std::string& what, const Count& count, bool coloured) {
  const run::Rate rate = run::rate(count.wrong, count.given());
  std::string wrong = fmt::format("{:>8}", count.wrong);
  if (coloured) wrong = fmt::format("\033[{}m{}\033[0m", count.wrong > 0 ? "31" : "32", wrong);
  std::string text =
      fmt::format("  {:<28}{} {:>8} {:>9}   {:<18}", what, wrong, count.given(),
                  count.given() == 0 ? "" : percent(rate.share) + " %",
                  count.given() == 0 ? "" : fmt::format("{} to {} %", percent(rate.lower), percent(rate.upper)));
  text += count.not_given > 0 ? fmt::format("{:>8}", count.not_given) : "";
  text.resize(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string rows(const char* title, const std::vector<Named>& counts, bool coloured) {
  std::string text = fmt::format("{}\n", title);
  for (const auto& [name, count] : counts) text += row(io::legible(name, 28), count, coloured);
  return text;
}

/// Returns the tags with the highest shares of wrong cases, and of equals those with the most cases.
std::vector<Named> worst_tags(const Counts& tags, std::size_t most) {
  std::vector<Named> sorted(tags.begin(), tags.end());
  std::ranges::stable_sort(sorted, [](const Named& a, const Named& b) {
    const double first = share(a.second), second = share(b.second);
    return first != second ? first > second : a.second.cases > b.second.cases;
  });
  std::erase_if(sorted, [](const Named& tag) { return tag.second.wrong == 0; });
  if (sorted.size() > most) sorted.resize(most);
  return sorted;
}

std::string text_of(const MethodTally& tally, bool coloured, std::size_t most_tags) {
  std::string text = fmt::format("{}\n  {:<28}{:>8} {:>8} {:>9}   {:<18}{:>8}\n", io::legible(tally.method), "",
                                 "wrong", "of", "rate", "95 % limits", "no answer");
  text += row("all cases", tally.all, coloured);
  text += rows("by key", {tally.by_key.begin(), tally.by_key.end()}, coloured);
  text += rows("by family (file)", {tally.by_file.begin(), tally.by_file.end()}, coloured);
  const auto tags = worst_tags(tally.by_tag, most_tags);
  if (!tags.empty()) text += rows("by tag, the highest rates", tags, coloured);
  return text;
}

nlohmann::ordered_json json_of(const Count& count) {
  const run::Rate rate = run::rate(count.wrong, count.given());
  return {{"cases", count.cases}, {"wrong", count.wrong}, {"not_given", count.not_given},
          {"rate", rate.share},   {"lower", rate.lower},  {"upper", rate.upper}};
}

nlohmann::ordered_json json_of(const Counts& counts) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& [name, count] : counts) object[name] = json_of(count);
  return object;
}

}  // namespace

std::string summary_text(const Tally& tally, bool coloured, std::size_t most_tags) {
  std::string text;
  for (const MethodTally& method : tally.methods())
    text += (text.empty() ? "" : "\n") + text_of(method, coloured, most_tags);
  return text.empty() ? "no case has an expectation\n" : text;
}

std::string summary_json(const Tally& tally) {
  nlohmann::ordered_json methods = nlohmann::ordered_json::array();
  for (const MethodTally& method : tally.methods())
    methods.push_back({{"method", method.method},
                       {"all", json_of(method.all)},
                       {"keys", json_of(method.by_key)},
                       {"families", json_of(method.by_file)},
                       {"tags", json_of(method.by_tag)}});
  return nlohmann::ordered_json{{"methods", methods}}.dump() + "\n";
}

}  // namespace touchstone::judge
