// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "experiments/judge/show/case_view.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::show {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPanel = 400, kGap = 20, kTitle = 46, kWidth = 2 * kPanel + 3 * kGap;
constexpr double kRow = 22, kNames = 170, kTop = kTitle + kPanel + 40, kRowsTop = kTop + 126;

/// The elements of a drawing in SVG, each of a class of the page's style.
struct Svg {
  std::string body{};

  /// A coordinate; what lies far beyond any panel is moved nearer, because viewers compute in floats.
  static std::string number(double value) { return fmt::format("{:.2f}", std::clamp(value, -1e6, 1e6)); }
  static std::string pair(const Vector2d& point, const char* x, const char* y) {
    return fmt::format(" {}=\"{}\" {}=\"{}\"", x, number(point.x()), y, number(point.y()));
  }
  void add(const char* element, std::string_view kind, const std::string& attributes) {
    body += fmt::format("<{} class=\"{}\"{}/>\n", element, kind, attributes);
  }
  void line(std::string_view kind, const Vector2d& from, const Vector2d& to) {
    add("line", kind, pair(from, "x1", "y1") + pair(to, "x2", "y2"));
  }
  void circle(std::string_view kind, const Vector2d& centre, double radius = 4) {
    add("circle", kind, pair(centre, "cx", "cy") + fmt::format(" r=\"{}\"", number(radius)));
  }
  void rectangle(std::string_view kind, const Vector2d& corner, const Vector2d& size) {
    add("rect", kind, pair(corner, "x", "y") + pair(size, "width", "height"));
  }
  void text(std::string_view kind, const Vector2d& at, std::string_view text) {
    body += fmt::format("<text class=\"{}\"{}>{}</text>\n", kind, pair(at, "x", "y"), xml_text(text));
  }
};

/// A panel of a drawing: the shapes of a case as a projection shows them, with y upwards.
class Panel {
 public:
  using Project = std::function<Vector2d(const Vector3d&)>;

  /// Shows the square around these points and the ball with this radius, and cuts off what is drawn beyond.
  Panel(Svg& svg, double x, const char* title, const FlatCase& flat, Project project,
        const std::vector<Vector3d>& points, double radius)
      : svg_(svg), flat_(flat), project_(std::move(project)) {
    Vector2d low = project_(flat.from), high = low;
    const auto include = [&](const Vector2d& point, double around) {
      low = low.cwiseMin(Vector2d(point.array() - around));
      high = high.cwiseMax(Vector2d(point.array() + around));
    };
    for (const Vector3d& point : points) include(project_(point), 0);
    for (const Vector3d& centre : {flat.from, flat.to}) include(project_(centre), radius);
    middle_ = (low + high) / 2;
    scale_ = 0.86 * kPanel / std::max((high - low).maxCoeff(), 1e-300);
    svg.text("", {x, kTitle - 8}, title);
    svg.body += "<svg" + Svg::pair({x, kTitle}, "x", "y") + Svg::pair({kPanel, kPanel}, "width", "height") + ">\n";
    svg.rectangle("panel", {0.5, 0.5}, {kPanel - 1, kPanel - 1});
  }
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
  ~Panel() { svg_.body += "</svg>\n"; }

  void line(std::string_view kind, const Vector3d& from, const Vector3d& to) const {
    svg_.line(kind, at(from), at(to));
  }
  /// Draws loops, filled by the rule of even and odd.
  void outline(std::string_view kind, std::span<const FlatCase::Loop> loops) const {
    std::string path;
    for (const FlatCase::Loop& loop : loops) {
      for (const Vector3d& point : loop)
        path += fmt::format("{}{} {}", &point == loop.data() ? 'M' : 'L', Svg::number(at(point).x()),
                            Svg::number(at(point).y()));
      path += "Z";
    }
    svg_.add("path", kind, fmt::format(" d=\"{}\" fill-rule=\"evenodd\"", path));
  }
  /// Draws the ball where it rests or first touches, the way of one that moves, and the point that it is nearest to.
  void ball(bool moves) const {
    const double radius = scale_ * flat_.radius;
    const Vector3d place = flat_.at.value_or(flat_.from);
    if (moves) way(at(flat_.from), at(flat_.to), radius);
    if (flat_.at) svg_.circle("ball", at(place), radius);
    if (flat_.touched) line("point", place, *flat_.touched);
    svg_.circle("centre", at(place));
    svg_.circle("foot", at(flat_.foot()));
    if (flat_.touched) svg_.circle("point", at(*flat_.touched));
  }

 private:
  [[nodiscard]] Vector2d at(const Vector3d& point) const {
    const Vector2d from_middle = project_(point) - middle_;
    return Vector2d(kPanel / 2, kPanel / 2) + scale_ * Vector2d(from_middle.x(), -from_middle.y());
  }
  void way(const Vector2d& from, const Vector2d& to, double radius) const {
    for (const Vector2d& end : {from, to}) svg_.circle("swept", end, radius);
    if ((to - from).norm() < 1e-9) return;
    const Vector2d along = (to - from).normalized(), across(-along.y(), along.x());
    svg_.line("way", from, to);
    for (const double side : {1.0, -1.0}) {
      svg_.line("swept", from + side * radius * across, to + side * radius * across);
      svg_.line("way", to, to - 9 * along + side * 4.5 * across);
    }
  }

  Svg& svg_;
  const FlatCase& flat_;
  Project project_;
  Vector2d middle_;
  double scale_ = 1;
};

void draw_plan(Svg& svg, const FlatCase& flat, bool moves) {
  std::vector<Vector3d> points;
  for (const FlatCase::Loop& loop : flat.loops) points.insert(points.end(), loop.begin(), loop.end());
  double size = 0;
  for (const Vector3d& point : points) size = std::max(size, (point - points[0]).norm());
  const auto from_above = [](const Vector3d& point) -> Vector2d { return point.head<2>(); };
  const Panel panel(svg, kGap, "from above: the polygon's plane", flat, from_above, points,
                    flat.radius < 3 * size ? flat.radius : 0);
  for (const FlatCase::Loop& face : flat.other_faces) panel.outline("face", {&face, 1});
  panel.outline("polygon", flat.loops);
  panel.line("section", flat.foot() - 100 * flat.along, flat.foot() + 100 * flat.along);
  panel.ball(moves);
}

void draw_section(Svg& svg, const FlatCase& flat, bool moves) {
  const auto from_side = [&](const Vector3d& point) {
    return Vector2d((point - flat.from).dot(flat.along), point.z());
  };
  const Panel panel(svg, 2 * kGap + kPanel, "section along the dashed line, from the side", flat, from_side,
                    {flat.foot(), flat.touched.value_or(flat.foot())}, flat.radius);
  panel.line("panel", flat.foot() - 1e3 * flat.along, flat.foot() + 1e3 * flat.along);
  for (const FlatCase::Loop& face : flat.other_faces)
    for (const auto& [begin, end] : flat.section({&face, 1})) panel.line("face", begin, end);
  for (const auto& [begin, end] : flat.section(flat.loops)) panel.line("cut", begin, end);
  panel.ball(moves);
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

/// Returns the label of a column, which differs from those beside it: an offset, or, near a least radius with contact
/// that is far from the ball's, what is added to that one: such offsets differ in their last digits alone.
std::string column_text(std::int64_t offset, bool is_far, std::int64_t least) {
  constexpr std::int64_t kNearChange = 1000;
  if (!is_far || std::abs(offset - least) > kNearChange) return offset_text(offset);
  return offset == least ? "c" : fmt::format("c{:+}", offset - least);
}

/// Draws the columns of the radii: the surfaces of balls of these radii and the point of the polygon that they reach or
/// do not reach; their offsets; and a row of contact for `exact` and each method.
void draw_radii(Svg& svg, const CaseView& view) {
  const Radii& radii = view.radii;
  const std::size_t count = radii.offsets.size();
  const std::int64_t least = -radii.margin.value_or(0);
  const bool is_far = std::abs(least) >= 1'000'000;
  const auto x = [&](double column) {
    return kNames + kGap + (kWidth - kNames - 2 * kGap) / static_cast<double>(count) * (column + 0.5);
  };
  svg.text("", {kGap, kTop - 10},
           radii.every_double
               ? "zoom: one column is one double of the radius; 0 is the ball's"
               : "zoom: the radius in doubles from the ball's, 0; every double where the answer changes" +
                     (is_far ? "; c, at " + offset_text(least) + ", touches first" : ""));
  svg.text("", {kGap, kTop + 20}, "surface of each ball");
  svg.text("", {kGap, kTop + 46}, "point of the polygon");
  for (std::size_t i = 0; i < count; ++i) {
    const double at = x(static_cast<double>(i));
    const bool lower = !radii.every_double && i % 2 == 1;  // long labels beside each other do not overlap
    svg.line(radii.offsets[i] == 0 ? "own" : "surface", {at, kTop}, {at, kTop + 84});
    svg.text("middle", {at, kTop + (lower ? 116 : 102)}, column_text(radii.offsets[i], is_far, least));
  }
  double y = kRowsTop + kRow / 2;
  const auto row = [&](const std::string& name, const auto& contact_at) {
    svg.text("", {kGap, y + 4}, io::legible(name, 24));
    for (std::size_t i = 0; i < count; ++i) {
      const Vector2d cell(x(static_cast<double>(i)), y);
      if (const std::optional<bool> contact = contact_at(i))
        svg.circle(fmt::format("{}{}", *contact ? "yes" : "no", *contact == radii.contact[i] ? "" : " wrong"), cell, 6);
      else
        svg.text("middle", cell + Vector2d(0, 4), "-");
    }
    y += kRow;
  };
  row("contact by exact", [&](std::size_t i) { return radii.contact[i]; });
  for (const Verdict& verdict : view.verdicts)
    row(verdict.method, [&](std::size_t i) {
      if (!verdict.contact.empty()) return verdict.contact[i];
      return radii.offsets[i] == 0 ? verdict.answer.values.contact : std::nullopt;
    });
  // The exact answer changes before the first column with contact.
  const auto first = static_cast<double>(std::ranges::find(radii.contact, true) - radii.contact.begin());
  if (first == 0 || first == static_cast<double>(count)) return;
  svg.circle("point", {x(radii.exactly_touching ? first : first - 0.5), kTop + 42}, 6);
  svg.line("change", {x(first - 0.5), kRowsTop}, {x(first - 0.5), y - kRow / 2});
}

}  // namespace

std::vector<std::pair<Vector3d, Vector3d>> FlatCase::section(std::span<const Loop> face) const {
  const Vector3d across(-along.y(), along.x(), 0);
  std::vector<Vector3d> crossings;
  for (const Loop& loop : face)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double begin = (a - from).dot(across), end = (b - from).dot(across);
      if ((begin > 0) != (end > 0)) crossings.push_back(a + begin / (begin - end) * (b - a));
    }
  std::ranges::sort(crossings, {}, [&](const Vector3d& point) { return std::pair(point.dot(along), point.z()); });
  std::vector<std::pair<Vector3d, Vector3d>> parts;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) parts.emplace_back(crossings[i], crossings[i + 1]);
  return parts;
}

std::optional<FlatCase> flat_case(const CaseView& view) {
  const Polygon& polygon = view.polygon();
  const Vector3d origin = polygon.vertex(0);
  double largest = 0;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    largest = std::max(largest, (polygon.vertex(i) / 4 - origin / 4).cwiseAbs().maxCoeff());
  const int exponent = largest > 0 ? std::ilogb(largest) + 2 : 0;  // brings the largest coordinate near 1
  const auto scaled = [&](const Vector3d& point) -> Vector3d {
    return (point - origin).unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
  };
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i)
    normal += scaled(polygon.vertex(i)).cross(scaled(polygon.vertex(polygon.next(i))));
  const Vector3d edge = scaled(polygon.vertex(1));
  Vector3d right = edge - normal.normalized() * edge.dot(normal.normalized());
  if (!(normal.norm() > 0) || !(right.norm() > 0)) return std::nullopt;
  normal.normalize();
  right.normalize();
  const Vector3d up = normal.cross(right);
  const auto flat = [&](const Vector3d& point) -> Vector3d {
    const Vector3d place = scaled(point);
    return {place.dot(right), place.dot(up), place.dot(normal)};
  };
  const auto project = [](const Vector3d& point) { return Vector3d(point.x(), point.y(), 0); };

  FlatCase result;
  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop) {
    FlatCase::Loop& points = result.loops.emplace_back();
    for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
      points.push_back(project(flat(polygon.vertex(i))));
  }
  for (const Polygon& face : faces_of(view.shapes)) {
    if (&face == &polygon) continue;
    FlatCase::Loop& points = result.other_faces.emplace_back();
    for (std::size_t i = 0; i < face.vertex_count(); ++i) points.push_back(flat(face.vertex(i)));
  }
  const Motion* motion = view.motion();
  result.from = flat(view.ball().center);
  result.to = motion != nullptr ? flat(motion->to) : result.from;
  if (const double time = motion != nullptr ? view.truth.time.value_or(HUGE_VAL) : 0; std::isfinite(time))
    result.at = result.from + time * (result.to - result.from);
  result.radius = std::ldexp(view.ball().radius, -exponent);
  if (view.truth.point) result.touched = project(flat(*view.truth.point));

  const Vector3d way = project(result.to - result.from);
  const Vector3d to_point = project(result.touched.value_or(result.from) - result.at.value_or(result.from));
  result.along = Vector3d::UnitX();
  if (way.norm() > 1e-9)
    result.along = way.normalized();
  else if (to_point.norm() > 1e-9 * result.radius)
    result.along = to_point.normalized();
  const bool finite =
      result.from.allFinite() && result.to.allFinite() && std::isfinite(result.radius) && result.along.allFinite();
  return finite ? std::optional(result) : std::nullopt;
}

std::string picture_of(const CaseView& view) {
  const bool moves = view.motion() != nullptr;
  const double end = kRowsTop + kRow * static_cast<double>(view.verdicts.size() + 1), height = end + 44;
  Svg svg;
  svg.rectangle("paper", {0, 0}, {kWidth, height});
  svg.text("", {kGap, 18}, io::legible(view.id, 90));
  if (const auto flat = flat_case(view)) {
    draw_plan(svg, *flat, moves);
    draw_section(svg, *flat, moves);
  } else {
    svg.text("", {kGap, kTitle + 20}, "The numbers of this case differ too much for a picture of its shapes.");
  }
  draw_radii(svg, view);
  double x = kGap + 4;
  for (const auto& [kind, meaning] : {std::pair("point", moves ? "first touched point" : "nearest point"),
                                      {"foot", "foot of the centre"},
                                      {"centre", "centre"},
                                      {"yes", "contact (hollow: none)"},
                                      {"yes wrong", "wrong"}}) {
    svg.circle(kind, {x, end + 26});
    svg.text("", {x + 9, end + 30}, meaning);
    x += 160;
  }
  return fmt::format(
      "<svg width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" role=\"img\">\n<title>{2}</title>\n{3}</svg>\n",
      kWidth, height, xml_text("Case " + view.id + ": " + margin_text(view)), svg.body);
}

}  // namespace touchstone::show
