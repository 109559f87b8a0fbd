// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <vector>

#include "experiments/cases/verdict.h"
#include "experiments/judge/show/case_view.h"
#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/program/table.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::judge {
namespace {

using show::xml_text;
using Named = std::pair<std::string, Count>;

double share(const Count& count) { return program::rate(count.wrong, count.given()).share; }

std::string percent(double share) { return statistics::percent_to_places(share, 2); }

std::string row(const std::string& what, const Count& count, bool coloured) {
  const program::Rate rate = program::rate(count.wrong, count.given());
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
  if (tally.all.known > 0) text += fmt::format("known failures: {}\n", program::counted(tally.all.known, "case"));
  if (tally.all.within > 0)
    text += fmt::format("not counted as wrong: {} within the margin\n", program::counted(tally.all.within, "case"));
  return text;
}

enum class Of { Cases, Keys };

nlohmann::ordered_json json_of(const Count& count, Of what) {
  const program::Rate rate = program::rate(count.wrong, count.given());
  nlohmann::ordered_json object{{"cases", count.cases}, {"wrong", count.wrong}, {"not_given", count.not_given}};
  if (what == Of::Cases) object["known"] = count.known, object["within"] = count.within;
  object.update({{"rate", rate.share}, {"lower", rate.lower}, {"upper", rate.upper}});
  return object;
}

nlohmann::ordered_json json_of(const Counts& counts, Of what) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const auto& [name, count] : counts) object[name] = json_of(count, what);
  return object;
}

std::string html_row(const std::string& name, const Count& count) {
  const program::Rate rate = program::rate(count.wrong, count.given());
  return fmt::format(
      "<tr><td>{}</td><td class=\"number{}\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td>"
      "<td class=\"number\">{}</td></tr>\n",
      xml_text(name), count.wrong > 0 ? " wrong" : "", count.wrong, count.given(),
      count.given() == 0 ? "" : percent(rate.share) + " %",
      count.given() == 0 ? "" : percent(rate.lower) + " % to " + percent(rate.upper) + " %", count.not_given);
}

std::string html_table(const std::string& title, const Counts& counts) {
  if (counts.empty()) return {};
  std::string text = fmt::format(
      "<table><tr><th>{}</th><th>wrong</th><th>of</th><th>rate</th><th>95 % limits</th><th>no answer</th></tr>\n",
      title);
  for (const auto& [name, count] : counts) text += html_row(name, count);
  return text + "</table>\n";
}

std::uint64_t size(std::int64_t doubles) {
  return doubles < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(doubles) : static_cast<std::uint64_t>(doubles);
}

}  // namespace

std::string family_of_file(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void Tally::add(const Judged& judged) {
  if (judged.compared.empty()) return;
  auto method = std::ranges::find(methods_, judged.method, &MethodTally::method);
  if (method == methods_.end()) {
    methods_.push_back({.method = judged.method, .all = {}, .by_key = {}, .by_file = {}, .by_tag = {}});
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
  const auto count_case = [&](Count& sum) {
    count(sum, any_wrong, any_missing);
    sum.known += judged.known ? 1 : 0;
    sum.within += judged.within && !any_wrong && !any_missing ? 1 : 0;
  };
  for (const auto& [key, outcome] : keys) count(method->by_key[key], outcome.wrong > 0, outcome.not_given > 0);
  count_case(method->all);
  count_case(method->by_file[family_of_file(judged.file)]);
  for (const std::string& tag : std::set(judged.tags.begin(), judged.tags.end())) count_case(method->by_tag[tag]);
}

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
                       {"all", json_of(method.all, Of::Cases)},
                       {"keys", json_of(method.by_key, Of::Keys)},
                       {"families", json_of(method.by_file, Of::Cases)},
                       {"tags", json_of(method.by_tag, Of::Cases)}});
  return nlohmann::ordered_json{{"methods", methods}}.dump() + "\n";
}

void JunitReport::add(const Judged& judged) {
  const std::string family = family_of_file(judged.file);
  Suite& suite = suites_[{judged.method, family}];
  ++suite.tests;
  suite.cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xml_text(family), xml_text(judged.id));
  std::string sentences;
  for (const cases::Difference& difference : judged.differences)
    sentences.append(sentences.empty() ? "" : "\n").append(to_string(difference));
  if (judged.known) {
    ++suite.skipped;
    suite.cases += fmt::format("><skipped message=\"known failure\">{}</skipped></testcase>\n",
                               xml_text(judged.fault.empty() ? sentences : judged.fault));
  } else if (!judged.fault.empty()) {
    ++suite.errors;
    suite.cases +=
        fmt::format("><error message=\"{}\">{}</error></testcase>\n", xml_text(judged.fault), xml_text(sentences));
  } else if (!judged.differences.empty()) {
    ++suite.failures;
    suite.cases += fmt::format("><failure message=\"{} of {} keys differ\">{}</failure></testcase>\n",
                               judged.differences.size(), judged.compared.size(), xml_text(sentences));
  } else {
    suite.cases += "/>\n";
  }
}

std::string JunitReport::text() const {
  Suite all;
  std::string suites;
  for (const auto& [names, suite] : suites_) {
    all.tests += suite.tests;
    all.failures += suite.failures;
    all.errors += suite.errors;
    all.skipped += suite.skipped;
    suites += fmt::format(
        "  <testsuite name=\"{}: {}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}"
        "  </testsuite>\n",
        xml_text(names.first), xml_text(names.second), suite.tests, suite.failures, suite.errors, suite.skipped,
        suite.cases);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"touchstone judge\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\" skipped=\"{}\">\n{}</testsuites>\n",
      all.tests, all.failures, all.errors, all.skipped, suites);
}

void Report::add(const Judged& judged) {
  if (judged.line.empty()) return;
  const bool contact = std::ranges::any_of(
      judged.differences, [](const auto& difference) { return difference.found && difference.key == "contact"; });
  auto& worst = worst_[judged.method];
  const auto before = [](const Wrong& a, const Wrong& b) {
    return std::tuple(a.contact, size(a.doubles)) > std::tuple(b.contact, size(b.doubles));
  };
  Wrong wrong{contact, judged.doubles, judged.line, judged.verdict};
  worst.insert(std::ranges::upper_bound(worst, wrong, before), std::move(wrong));
  if (worst.size() > kWorst) worst.pop_back();
}

std::string Report::text(const Tally& tally) const {
  std::string body;
  for (const MethodTally& method : tally.methods()) {
    const program::Rate rate = program::rate(method.all.wrong, method.all.given());
    body += fmt::format("<h1>{}</h1>\n<p>Wrong on {} of {}: {} ({} to {}, 95 % confidence). No answer on {}.{}{}</p>\n",
                        xml_text(method.method), method.all.wrong, program::counted(method.all.given(), "case"),
                        percent(rate.share) + " %", percent(rate.lower) + " %", percent(rate.upper) + " %",
                        method.all.not_given,
                        method.all.known > 0 ? fmt::format(" Known failures: {}.", method.all.known) : "",
                        method.all.within > 0 ? fmt::format(" Within the margin: {}.", method.all.within) : "");
    body += html_table("key", method.by_key) + html_table("family (file)", method.by_file);
    if (!method.by_tag.empty())
      body += "<details><summary>By tag</summary>\n" + html_table("tag", method.by_tag) + "</details>\n";
    const auto worst = worst_.find(method.method);
    if (worst == worst_.end()) continue;
    body +=
        fmt::format("<p>The worst {} cases follow, the furthest from the threshold first.</p>\n", worst->second.size());
    for (const Wrong& wrong : worst->second) {
      const cases::Case given = cases::read_case(wrong.line);
      show::CaseView view = show::view_of(*given.id, given.tags, given.shapes());
      view.verdicts.push_back({method.method, cases::stated_in(nlohmann::json::parse(wrong.verdict)), {}, {}});
      body += show::section_of(view);
    }
  }
  if (body.empty()) body = "<p>No case has an expectation.</p>\n";
  return show::page_of("Report of touchstone judge", body);
}

}  // namespace touchstone::judge
