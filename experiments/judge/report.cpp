// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/judge/show/page.h"
#include "experiments/run/counted.h"
#include "experiments/run/statistics/percent.h"
#include "experiments/run/table.h"
#include "experiments/run/xml_text.h"

namespace touchstone::judge {
namespace {

using run::xml_text;

std::string percent(double share) { return statistics::percent_to_places(share, 2) + " %"; }

std::string row(const std::string& name, const Count& count) {
  const run::Rate rate = run::rate(count.wrong, count.given());
  return fmt::format(
      "<tr><td>{}</td><td class=\"number{}\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td>"
      "<td class=\"number\">{}</td></tr>\n",
      xml_text(name), count.wrong > 0 ? " wrong" : "", count.wrong, count.given(),
      count.given() == 0 ? "" : percent(rate.share),
      count.given() == 0 ? "" : percent(rate.lower) + " to " + percent(rate.upper), count.not_given);
}

std::string table(const std::string& title, const Counts& counts) {
  if (counts.empty()) return {};
  std::string text = fmt::format(
      "<table><tr><th>{}</th><th>wrong</th><th>of</th><th>rate</th><th>95 % limits</th><th>no answer</th></tr>\n",
      title);
  for (const auto& [name, count] : counts) text += row(name, count);
  return text + "</table>\n";
}

std::uint64_t size(std::int64_t doubles) {
  return doubles < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(doubles) : static_cast<std::uint64_t>(doubles);
}

}  // namespace

void Report::add(const Judged& judged) {
  const auto is_wrong = [](const cases::Difference& difference) { return difference.found.has_value(); };
  if (std::ranges::none_of(judged.differences, is_wrong)) return;
  const cases::Case& given = *judged.line.read;
  const auto& shapes = std::get<cases::Shapes>(given.content);
  const bool contact = std::ranges::any_of(
      judged.differences, [&](const auto& difference) { return is_wrong(difference) && difference.key == "contact"; });
  const auto& distance = given.expected->values.distance;
  const std::int64_t doubles =
      distance && std::isfinite(*distance) ? workloads::doubles_between(*distance, shapes.ball.radius) : 0;
  auto& worst = worst_[std::string(judged.method)];
  const auto before = [](const Wrong& a, const Wrong& b) {
    return std::tuple(a.contact, size(a.doubles)) > std::tuple(b.contact, size(b.doubles));
  };
  Wrong wrong{contact, doubles, *given.id, given.tags, shapes, judged.answer};
  worst.insert(std::ranges::upper_bound(worst, wrong, before), std::move(wrong));
  if (worst.size() > kWorst) worst.pop_back();
}

std::string Report::text(const Tally& tally) const {
  std::string body;
  for (const MethodTally& method : tally.methods()) {
    const run::Rate rate = run::rate(method.all.wrong, method.all.given());
    body += fmt::format("<h1>{}</h1>\n<p>Wrong on {} of {}: {} ({} to {}, 95 % confidence). No answer on {}.</p>\n",
                        xml_text(method.method), method.all.wrong, run::counted(method.all.given(), "case"),
                        percent(rate.share), percent(rate.lower), percent(rate.upper), method.all.not_given);
    body += table("key", method.by_key) + table("family (file)", method.by_file);
    if (!method.by_tag.empty())
      body += "<details><summary>By tag</summary>\n" + table("tag", method.by_tag) + "</details>\n";
    const auto worst = worst_.find(method.method);
    if (worst == worst_.end()) continue;
    body +=
        fmt::format("<p>The worst {} cases follow, the furthest from the threshold first.</p>\n", worst->second.size());
    for (const Wrong& wrong : worst->second) {
      show::CaseView view = show::view_of(wrong.id, wrong.tags, wrong.shapes);
      view.verdicts.push_back({method.method, wrong.answer, {}, {}});
      body += show::section_of(view);
    }
  }
  if (body.empty()) body = "<p>No case has an expectation.</p>\n";
  return show::page_of("Report of touchstone judge", body);
}

}  // namespace touchstone::judge
