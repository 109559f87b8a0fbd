// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "experiments/cases/comparison.h"
#include "experiments/judge/show/case_view.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::show {
namespace {

void append_as_xml(std::string& text, std::string_view line) {
  for (const char c : io::all_legible(line)) switch (c) {
      case '&': text += "&amp;"; break;
      case '<': text += "&lt;"; break;
      case '>': text += "&gt;"; break;
      case '"': text += "&quot;"; break;
      case '\'': text += "&#39;"; break;
      default: text += c;
    }
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string escaped;
  for (;;) {
    const std::size_t end = text.find('\n');
    append_as_xml(escaped, text.substr(0, end));
    if (end == std::string_view::npos) return escaped;
    escaped += '\n';
    text.remove_prefix(end + 1);
  }
}

namespace {

constexpr const char* kStyle =
    R"(body { font: 15px/1.45 sans-serif; color: #222; max-width: 900px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin-top: 2.2em; word-break: break-all; }
table { border-collapse: collapse; font-size: 13px; margin: .6em 0; }
td, th { border: 1px solid #ddd; padding: 3px 8px; text-align: left; vertical-align: top; }
td.number { text-align: right; } td.key { font-family: monospace; }
td.wrong { background: #fbe3e4; color: #a01b1b; } td.missing { color: #888; }
.scroll { overflow-x: auto; } .scroll > svg { border: 1px solid #eee; }
p.tags { color: #666; font-size: 13px; }
svg text { font-size: 12px; fill: #222; } svg text.middle { text-anchor: middle; fill: #555; }
.paper, .no { fill: #fff; } .panel { fill: #fff; stroke: #ccc; } .section { stroke: #999; stroke-dasharray: 4 3; }
.polygon { fill: #c9b458; fill-opacity: .5; stroke: #7a6a1c; } .cut { stroke: #c9b458; stroke-width: 5; }
.face { fill: none; stroke: #a59a63; stroke-width: 1.5; } .foot { fill: #444; }
.ball { fill: #2a6f97; fill-opacity: .12; stroke: #2a6f97; } .centre, .way { fill: #2a6f97; stroke: #2a6f97; }
.swept { fill: none; stroke: #2a6f97; stroke-dasharray: 4 3; } .surface { stroke: #9bbdd1; }
.own { stroke: #2a6f97; stroke-width: 3; } .point, .change { fill: #b3261e; stroke: #b3261e; }
.change { stroke-dasharray: 4 3; } .yes { fill: #333; } .yes, .no { stroke: #333; stroke-width: 1.5; }
.yes.wrong { fill: #d62828; } .yes.wrong, .no.wrong { stroke: #d62828; }
@media (prefers-color-scheme: dark) {
  body { background: #181a1b; color: #ddd; } td, th { border-color: #444; } p.tags { color: #aaa; }
  td.wrong { background: #4a1f22; color: #ffb3b0; } td.missing { color: #999; }
  .scroll > svg { filter: invert(0.9) hue-rotate(180deg); }
})";

/// Returns a value of JSON, shortened for a table.
std::string cell_text(const std::string& value) { return xml_text(io::legible(value, 90)); }

std::string table_of(const CaseView& view) {
  const cases::StatedAnswer truth = cases::stated(view.truth);
  std::string text = "<div class=\"scroll\"><table><tr><th></th><th>exact</th>";
  for (const Verdict& verdict : view.verdicts) text += "<th>" + xml_text(verdict.method) + "</th>";
  text += "</tr>\n";
  for (const auto& [key, value] : truth.texts) {
    text += fmt::format("<tr><td class=\"key\">{}</td><td>{}</td>", xml_text(key), cell_text(value));
    for (const Verdict& verdict : view.verdicts) {
      const auto given = verdict.answer.texts.find(key);
      if (given == verdict.answer.texts.end()) {
        text += "<td class=\"missing\">-</td>";
        continue;
      }
      const cases::StatedAnswer expected{.values = view.truth, .texts = {{key, value}}};
      const bool right = cases::differences(expected, verdict.answer).empty();
      text += fmt::format("<td{}>{}</td>", right ? "" : " class=\"wrong\"", cell_text(given->second));
    }
    text += "</tr>\n";
  }
  text += "</table></div>\n";
  for (const Verdict& verdict : view.verdicts)
    if (!verdict.fault.empty())
      text += fmt::format("<p>{} gave no answer: {}</p>\n", xml_text(verdict.method), cell_text(verdict.fault));
  return text;
}

}  // namespace

std::string section_of(const CaseView& view) {
  const std::string tags = fmt::format("{}", fmt::join(view.tags, ", "));
  const Ball& ball = view.ball();
  std::string about = fmt::format("{} Centre ({}, {}, {}), radius {}", margin_text(view), ball.center.x(),
                                  ball.center.y(), ball.center.z(), ball.radius);
  if (const Motion* motion = view.motion())
    about += fmt::format(", moving to ({}, {}, {})", motion->to.x(), motion->to.y(), motion->to.z());
  if (const auto* mesh = std::get_if<cases::MeshShapes>(&view.shapes)) {
    about += fmt::format("; a mesh of {} faces, of which the picture shows the plane of face {}",
                         mesh->mesh.faces().size(), view.truth.face.value_or(0));
  } else {
    const Polygon& polygon = view.polygon();
    about += fmt::format("; a polygon of {} vertices", polygon.vertex_count());
    if (polygon.loop_count() > 1) about += fmt::format(" with {} holes", polygon.loop_count() - 1);
  }
  return fmt::format("<section>\n<h2>{}</h2>\n<p>{}.</p>\n{}<div class=\"scroll\">{}</div>\n{}</section>\n",
                     xml_text(view.id), xml_text(about),
                     tags.empty() ? "" : "<p class=\"tags\">" + xml_text(tags) + "</p>\n", picture_of(view),
                     table_of(view));
}

std::string page_of(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{0}</title>\n<style>\n{1}\n</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
      "</body>\n</html>\n",
      xml_text(title), kStyle, body);
}

}  // namespace touchstone::show
