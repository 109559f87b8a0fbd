// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/page.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "experiments/cases/comparison.h"
#include "experiments/judge/show/flat_case.h"
#include "experiments/run/quoting.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::show {
namespace {

using Eigen::Vector2d;

constexpr double kPanel = 400, kGap = 20, kTitle = 46, kWidth = 2 * kPanel + 3 * kGap;
constexpr double kRow = 22, kNames = 170, kAboveRows = 126;
const std::string kPolygon = "#c9b458", kBall = "#2a6f97", kPoint = "#b3261e", kFoot = "#444", kGrid = "#ccc",
                  kWrong = "#d62828", kOtherFace = "#a59a63";

/// A frame of coordinates that is mapped to a panel, with y upwards.
class Frame {
 public:
  /// The square around these points.
  explicit Frame(const std::vector<Vector2d>& points) {
    Vector2d low = points.front(), high = points.front();
    for (const Vector2d& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    middle_ = (low + high) / 2;
    const double size = std::max((high - low).maxCoeff(), 1e-300);
    scale_ = 0.86 * kPanel / size;
  }
  [[nodiscard]] Vector2d at(const Vector2d& point) const {
    return {kPanel / 2 + scale_ * (point.x() - middle_.x()), kPanel / 2 - scale_ * (point.y() - middle_.y())};
  }
  [[nodiscard]] double length(double length) const { return scale_ * length; }

 private:
  Vector2d middle_;
  double scale_ = 1;
};

void begin(Svg& svg, double x, const char* title) {
  svg.text({x, kTitle - 8}, title, 13);
  svg.begin_panel({x, kTitle}, {kPanel, kPanel});
  svg.rectangle({0.5, 0.5}, {kPanel - 1, kPanel - 1}, {.fill = "#fff", .stroke = kGrid});
}

void dot(Svg& svg, const Vector2d& at, const std::string& colour) { svg.circle(at, 4, {.fill = colour}); }

/// The two tangents of two discs of one radius.
void tangents(Svg& svg, const Vector2d& from, const Vector2d& to, double radius) {
  if ((to - from).norm() < 1e-9) return;
  const Vector2d along = (to - from).normalized(), across = radius * Vector2d(-along.y(), along.x());
  for (const double side : {1.0, -1.0})
    svg.line(from + side * across, to + side * across, {.stroke = kBall, .width = 1, .dashed = true});
}

/// Draws the ball as discs about its places, of a moving one with its way.
void ball(Svg& svg, const Frame& frame, const std::vector<Vector2d>& places, double radius, bool moves,
          const std::optional<Vector2d>& at_contact) {
  const double r = frame.length(radius);
  const Style outline{.fill = kBall, .stroke = kBall, .width = 1.5, .dashed = false, .opacity = 0.12};
  const Style faint{.fill = "none", .stroke = kBall, .width = 1, .dashed = true};
  const Vector2d from = frame.at(places.front()), to = frame.at(places.back());
  svg.circle(from, r, moves ? faint : outline);
  if (!moves) return;
  svg.circle(to, r, faint);
  tangents(svg, from, to, r);
  svg.line(from, to, {.stroke = kBall, .width = 1.5});
  const Vector2d way = to - from;
  if (way.norm() > 12) {
    const Vector2d along = way.normalized() * 9, across(-along.y() / 2, along.x() / 2);
    svg.loops({{to, to - along + across, to - along - across}}, {.fill = kBall});
  }
  if (at_contact) svg.circle(frame.at(*at_contact), r, outline);
}

void draw_plan(Svg& svg, const FlatCase& flat, bool moves) {
  begin(svg, kGap, "from above: the polygon's plane");
  std::vector<Vector2d> points{flat.foot, flat.foot_at_end};
  double size = 0;
  for (const auto& loop : flat.loops)
    for (const Vector2d& point : loop) {
      points.push_back(point);
      size = std::max(size, (point - flat.loops[0][0]).norm());
    }
  if (flat.radius < 3 * size)
    for (const Vector2d& centre : {flat.foot, flat.foot_at_end}) {
      points.emplace_back(centre.array() - flat.radius);
      points.emplace_back(centre.array() + flat.radius);
    }
  const Frame frame(points);
  for (const auto& face : flat.other_faces) {
    std::vector<Vector2d> outline;
    for (const Eigen::Vector3d& corner : face) outline.push_back(frame.at(corner.head<2>()));
    svg.loops({outline}, {.fill = "none", .stroke = kOtherFace});
  }
  auto loops = flat.loops;
  for (auto& loop : loops)
    for (Vector2d& point : loop) point = frame.at(point);
  svg.loops(loops, {.fill = kPolygon, .stroke = "#7a6a1c", .width = 1.5, .dashed = false, .opacity = 0.5});
  const auto at_contact = flat.time ? std::optional(flat.foot_at(*flat.time)) : std::nullopt;
  ball(svg, frame, {flat.foot, flat.foot_at_end}, flat.radius, moves, at_contact);
  svg.line(frame.at(flat.foot) - 1000 * Vector2d(flat.along.x(), -flat.along.y()),
           frame.at(flat.foot) + 1000 * Vector2d(flat.along.x(), -flat.along.y()),
           {.stroke = "#999", .width = 1, .dashed = true});
  dot(svg, frame.at(flat.foot), kFoot);
  if (flat.touched) dot(svg, frame.at(*flat.touched), kPoint);
  svg.end_panel();
}

void draw_section(Svg& svg, const FlatCase& flat, bool moves) {
  begin(svg, 2 * kGap + kPanel, "section along the dashed line, from the side");
  const auto side = [&](const Vector2d& foot, double height) {
    return Vector2d((foot - flat.foot).dot(flat.along), height);
  };
  const Vector2d from = side(flat.foot, flat.height), to = side(flat.foot_at_end, flat.height_at_end);
  std::vector<Vector2d> points{{0, 0}};
  for (const Vector2d& centre : {from, to}) {
    points.emplace_back(centre.array() - flat.radius);
    points.emplace_back(centre.array() + flat.radius);
  }
  if (flat.touched) points.push_back(side(*flat.touched, 0));
  const Frame frame(points);
  svg.line(frame.at({-1e3, 0}), frame.at({1e3, 0}), {.stroke = kGrid, .width = 1});
  for (const auto& [begin, end] : flat.other_sections())
    svg.line(frame.at(begin), frame.at(end), {.stroke = kOtherFace, .width = 2});
  for (const auto& [begin, end] : flat.section())
    svg.line(frame.at({begin, 0}), frame.at({end, 0}), {.stroke = kPolygon, .width = 5});
  const auto at_contact =
      flat.time ? std::optional(side(flat.foot_at(*flat.time), flat.height_at(*flat.time))) : std::nullopt;
  ball(svg, frame, {from, to}, flat.radius, moves, at_contact);
  const Vector2d centre = at_contact.value_or(from);
  if (flat.touched) svg.line(frame.at(centre), frame.at(side(*flat.touched, 0)), {.stroke = kPoint, .width = 1});
  dot(svg, frame.at(centre), kBall);
  dot(svg, frame.at({0, 0}), kFoot);
  if (flat.touched) dot(svg, frame.at(side(*flat.touched, 0)), kPoint);
  svg.end_panel();
}

/// An offset as people read it: whole up to a million, and powers of two.
std::string offset_text(std::int64_t offset) {
  const auto size = static_cast<std::uint64_t>(std::abs(offset));
  const std::string sign = offset < 0 ? "-" : offset > 0 ? "+" : "";
  const bool is_power = std::has_single_bit(size);
  if (size < 1000 || (size < 1'000'000 && !is_power)) return sign + std::to_string(size);
  if (is_power) return fmt::format("{}2^{}", sign, std::countr_zero(size));
  return fmt::format("{}2^{:.1f}", sign, std::log2(static_cast<double>(size)));
}

/// The offsets of radii next to the least one with contact, c, differ in their last digits alone.
constexpr std::int64_t kFarFromBall = 1'000'000, kNearChange = 1000;

/// Returns the label of a column, which differs from those beside it: an offset, or, far from the ball's radius and
/// near the least one with contact, what is added to that one.
std::string column_text(std::int64_t offset, const std::optional<std::int64_t>& least) {
  if (!least || std::abs(*least) < kFarFromBall || std::abs(offset - *least) > kNearChange) return offset_text(offset);
  return offset == *least ? "c" : fmt::format("c{:+}", offset - *least);
}

/// The columns of the radii.
class Columns {
 public:
  Columns(const Radii& radii, double top) : radii_(radii), top_(top) {}

  [[nodiscard]] double x(std::size_t i) const {
    const double step = (kWidth - kNames - 2 * kGap) / static_cast<double>(radii_.offsets.size());
    return kNames + kGap + step * (static_cast<double>(i) + 0.5);
  }
  [[nodiscard]] Vector2d cell(std::size_t i, std::size_t row) const {
    return {x(i), top_ + kRow * (static_cast<double>(row) + 0.5)};
  }
  /// Between which columns the exact answer changes: the first with contact.
  [[nodiscard]] std::optional<std::size_t> change() const {
    const auto first = std::ranges::find(radii_.contact, true) - radii_.contact.begin();
    return first == 0 || first == std::ssize(radii_.contact) ? std::nullopt
                                                             : std::optional(static_cast<std::size_t>(first));
  }

 private:
  const Radii& radii_;
  double top_;
};

/// The surfaces of balls of neighbouring radii, and the point of the polygon that they reach or do not reach.
void draw_surfaces(Svg& svg, const CaseView& view, const Columns& columns, double top) {
  constexpr double kHeight = 84;
  svg.text({kGap, top + 20}, "surface of the ball", 12, "start", kBall);
  svg.text({kGap, top + 38}, "with each radius", 12, "start", kBall);
  svg.text({kGap, top + 60}, "point of the polygon", 12, "start", kPoint);
  for (std::size_t i = 0; i < view.radii.offsets.size(); ++i) {
    const bool own = view.radii.offsets[i] == 0;
    svg.line({columns.x(i), top}, {columns.x(i), top + kHeight},
             {.stroke = own ? kBall : "#9bbdd1", .width = own ? 3.0 : 1.0});
  }
  if (const auto change = columns.change()) {
    const double there =
        view.radii.exactly_touching ? columns.x(*change) : (columns.x(*change - 1) + columns.x(*change)) / 2;
    svg.circle({there, top + kHeight / 2}, 6, {.fill = kPoint});
  }
}

void draw_row(Svg& svg, const CaseView& view, const Columns& columns, std::size_t row, const std::string& name,
              const std::vector<std::optional<bool>>& contact) {
  svg.text({kGap, columns.cell(0, row).y() + 4}, io::legible(name, 24));
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (!contact[i]) {
      svg.text(columns.cell(i, row) + Vector2d(0, 4), "-", 12, "middle", "#888");
      continue;
    }
    const std::string colour = *contact[i] == view.radii.contact[i] ? "#333" : kWrong;
    svg.circle(columns.cell(i, row), 6, {.fill = *contact[i] ? colour : "#fff", .stroke = colour, .width = 1.5});
  }
}

/// What a method said of the case alone, as a row.
std::vector<std::optional<bool>> contact_of(const CaseView& view, const Verdict& verdict) {
  if (!verdict.contact.empty()) return verdict.contact;
  std::vector<std::optional<bool>> contact(view.radii.offsets.size());
  const auto own = std::ranges::find(view.radii.offsets, 0) - view.radii.offsets.begin();
  contact[static_cast<std::size_t>(own)] = verdict.answer.values.contact;
  return contact;
}

/// Returns the offset of the least radius with contact, in doubles from the ball's.
std::optional<std::int64_t> least_of(const CaseView& view) {
  return view.radii.margin ? std::optional(-*view.radii.margin) : std::nullopt;
}

std::string about_least(const CaseView& view) {
  const auto least = least_of(view);
  return least && std::abs(*least) >= kFarFromBall ? "; c, at " + offset_text(*least) + ", touches first" : "";
}

void draw_radii(Svg& svg, const CaseView& view, double top) {
  svg.text(
      {kGap, top - 10},
      view.radii.every_double
          ? "zoom: one column is one double of the radius; 0 is the ball's"
          : "zoom: the radius in doubles from the ball's, 0; every double where the answer changes" + about_least(view),
      13);
  const double rows_top = top + kAboveRows;
  const Columns columns(view.radii, rows_top);
  draw_surfaces(svg, view, columns, top);
  for (std::size_t i = 0; i < view.radii.offsets.size(); ++i) {
    const bool lower = !view.radii.every_double && i % 2 == 1;  // long labels beside each other do not overlap
    svg.text({columns.x(i), top + (lower ? 116 : 102)}, column_text(view.radii.offsets[i], least_of(view)), 12,
             "middle", "#555");
  }
  std::vector<std::optional<bool>> exact(view.radii.contact.begin(), view.radii.contact.end());
  draw_row(svg, view, columns, 0, "contact by exact", exact);
  for (std::size_t v = 0; v < view.verdicts.size(); ++v)
    draw_row(svg, view, columns, v + 1, view.verdicts[v].method, contact_of(view, view.verdicts[v]));
  if (const auto change = columns.change()) {
    const double between = (columns.x(*change - 1) + columns.x(*change)) / 2;
    svg.line({between, rows_top}, {between, rows_top + kRow * static_cast<double>(view.verdicts.size() + 1)},
             {.stroke = kPoint, .width = 1, .dashed = true});
  }
}

using run::xml_text;

constexpr const char* kStyle =
    R"(body { font: 15px/1.45 sans-serif; color: #222; max-width: 900px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.1em; margin-top: 2.2em; word-break: break-all; }
table { border-collapse: collapse; font-size: 13px; margin: .6em 0; }
td, th { border: 1px solid #ddd; padding: 3px 8px; text-align: left; vertical-align: top; }
td.number { text-align: right; } td.key { font-family: monospace; }
td.wrong { background: #fbe3e4; color: #a01b1b; } td.missing { color: #888; }
.scroll { overflow-x: auto; } .scroll > svg { border: 1px solid #eee; }
p.tags { color: #666; font-size: 13px; }
@media (prefers-color-scheme: dark) {
  body { background: #181a1b; color: #ddd; } td, th { border-color: #444; } p.tags { color: #aaa; }
  td.wrong { background: #4a1f22; color: #ffb3b0; } td.missing { color: #999; }
  .scroll > svg { filter: invert(0.9) hue-rotate(180deg); }
})";

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

Svg picture(const CaseView& view) {
  const double rows = static_cast<double>(view.verdicts.size() + 1), top = kTitle + kPanel + 40, legend = 44;
  const double height = top + kAboveRows + kRow * rows + legend;
  Svg svg(kWidth, height);
  svg.rectangle({0, 0}, {kWidth, height}, {.fill = "#fff"});
  svg.text({kGap, 18}, io::legible(view.id, 90), 14);
  const bool moves = view.motion() != nullptr;
  if (const auto flat = flat_case(view)) {
    draw_plan(svg, *flat, moves);
    draw_section(svg, *flat, moves);
  } else {
    svg.text({kGap, kTitle + 20}, "The numbers of this case differ too much for a picture of its shapes.");
  }
  draw_radii(svg, view, top);
  const double y = height - 14;
  const auto key = [&](double x, const std::string& colour, const char* meaning) {
    svg.circle({x, y - 4}, 4, {.fill = colour});
    svg.text({x + 9, y}, meaning, 12, "start", "#555");
  };
  key(kGap + 4, kPoint, moves ? "first touched point" : "nearest point");
  key(kGap + 154, kFoot, "foot of the centre");
  key(kGap + 304, kBall, "centre");
  key(kGap + 384, "#333", "contact (hollow: none)");
  key(kGap + 554, kWrong, "wrong");
  return svg;
}

std::string section_of(const CaseView& view) {
  std::string tags;
  for (const std::string& tag : view.tags) tags.append(tags.empty() ? "" : ", ").append(tag);
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
