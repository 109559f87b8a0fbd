// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/page.h"

#include <fmt/core.h>

#include "experiments/cases/comparison.h"
#include "experiments/judge/show/picture.h"
#include "experiments/run/quoting.h"

namespace touchstone::show {
namespace {

using run::xml_text;

constexpr const char* kStyle =
    R"(body { font: 15px/1.45 sans-serif; color: #222; max-width: 900px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin-top: 2.2em; word-break: break-all; }
table { border-collapse: collapse; font-size: 13px; margin: .6em 0; }
td, th { border: 1px solid #ddd; padding: 3px 8px; text-align: left; vertical-align: top; }
td.number { text-align: right; } td.key { font-family: monospace; }
td.wrong { background: #fbe3e4; color: #a01b1b; } td.missing { color: #888; }
.scroll { overflow-x: auto; } svg { max-width: 100%; height: auto; border: 1px solid #eee; }
p.tags { color: #666; font-size: 13px; })";

/// Returns a value of JSON, shortened for a table.
std::string cell_text(const std::string& value) {
  constexpr std::size_t kMost = 90;
  return value.size() <= kMost ? value : value.substr(0, kMost) + "...";
}

std::string table_of(const CaseView& view) {
  const cases::StatedAnswer truth = cases::stated(view.truth);
  std::string text = "<div class=\"scroll\"><table><tr><th></th><th>exact</th>";
  for (const Verdict& verdict : view.verdicts) text += "<th>" + xml_text(verdict.method) + "</th>";
  text += "</tr>\n";
  for (const auto& [key, value] : truth.texts) {
    text += fmt::format("<tr><td class=\"key\">{}</td><td>{}</td>", xml_text(key), xml_text(cell_text(value)));
    for (const Verdict& verdict : view.verdicts) {
      const auto given = verdict.answer.texts.find(key);
      if (given == verdict.answer.texts.end()) {
        text += "<td class=\"missing\">-</td>";
        continue;
      }
      const cases::StatedAnswer expected{.values = view.truth, .texts = {{key, value}}};
      const bool right = cases::differences(expected, verdict.answer).empty();
      text += fmt::format("<td{}>{}</td>", right ? "" : " class=\"wrong\"", xml_text(cell_text(given->second)));
    }
    text += "</tr>\n";
  }
  text += "</table></div>\n";
  for (const Verdict& verdict : view.verdicts)
    if (!verdict.fault.empty())
      text +=
          fmt::format("<p>{} gave no answer: {}</p>\n", xml_text(verdict.method), xml_text(cell_text(verdict.fault)));
  return text;
}

}  // namespace

std::string section_of(const CaseView& view) {
  std::string tags;
  for (const std::string& tag : view.tags) tags.append(tags.empty() ? "" : ", ").append(tag);
  const Ball& ball = view.shapes.ball;
  std::string about = fmt::format("{} Centre ({}, {}, {}), radius {}", margin_text(view), ball.center.x(),
                                  ball.center.y(), ball.center.z(), ball.radius);
  if (const auto& to = view.shapes.to) about += fmt::format(", moving to ({}, {}, {})", to->x(), to->y(), to->z());
  const Polygon& polygon = view.shapes.polygon;
  about += fmt::format("; a polygon of {} vertices", polygon.vertex_count());
  if (polygon.loop_count() > 1) about += fmt::format(" with {} holes", polygon.loop_count() - 1);
  return fmt::format("<section>\n<h2>{}</h2>\n<p>{}.</p>\n{}{}\n{}</section>\n", xml_text(view.id), xml_text(about),
                     tags.empty() ? "" : "<p class=\"tags\">" + xml_text(tags) + "</p>\n",
                     picture(view).text_of_file("Case " + view.id + ": " + margin_text(view)), table_of(view));
}

std::string page_of(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>\n{1}\n</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
      "</body>\n</html>\n",
      xml_text(title), kStyle, body);
}

}  // namespace touchstone::show
