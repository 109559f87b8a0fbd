// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/svg.h"

#include <fmt/core.h>

#include <algorithm>

#include "experiments/run/quoting.h"

namespace touchstone::show {
namespace {

using Eigen::Vector2d;

std::string attributes(const Style& style) {
  std::string text = fmt::format(R"( fill="{}" stroke="{}")", style.fill, style.stroke);
  if (style.stroke != "none") text += fmt::format(R"( stroke-width="{:g}")", style.width);
  if (style.dashed) text += R"( stroke-dasharray="4 3")";
  if (style.opacity != 1) text += fmt::format(R"( fill-opacity="{:g}")", style.opacity);
  return text;
}

/// A coordinate of a file; what lies far beyond any panel is moved nearer, because viewers compute in floats.
std::string number(double value) { return fmt::format("{:.2f}", std::clamp(value, -1e6, 1e6)); }

}  // namespace

void Svg::line(const Vector2d& from, const Vector2d& to, const Style& style) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", number(from.x()), number(from.y()),
                       number(to.x()), number(to.y()), attributes(style));
}

void Svg::circle(const Vector2d& centre, double radius, const Style& style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(centre.x()), number(centre.y()),
                       number(radius), attributes(style));
}

void Svg::rectangle(const Vector2d& corner, const Vector2d& size, const Style& style) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", number(corner.x()),
                       number(corner.y()), number(size.x()), number(size.y()), attributes(style));
}

void Svg::loops(const std::vector<std::vector<Vector2d>>& loops, const Style& style) {
  std::string path;
  for (const auto& loop : loops) {
    char command = 'M';
    for (const Vector2d& point : loop) {
      path += fmt::format("{}{} {}", command, number(point.x()), number(point.y()));
      command = 'L';
    }
    path += "Z";
  }
  body_ += fmt::format("<path d=\"{}\" fill-rule=\"evenodd\"{}/>\n", path, attributes(style));
}

void Svg::text(const Vector2d& at, std::string_view text, double size, std::string_view anchor, std::string_view fill) {
  body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                       number(at.x()), number(at.y()), size, anchor, fill, run::xml_text(text));
}

void Svg::begin_panel(const Vector2d& corner, const Vector2d& size) {
  body_ += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", number(corner.x()), number(corner.y()),
                       number(size.x()), number(size.y()));
}

void Svg::end_panel() { body_ += "</svg>\n"; }

void Svg::append(const Svg& other) {
  body_ += fmt::format("<svg x=\"0\" y=\"{}\" width=\"{}\" height=\"{}\">\n{}</svg>\n", number(height_),
                       number(other.width_), number(other.height_), other.body_);
  width_ = std::max(width_, other.width_);
  height_ += other.height_;
}

std::string Svg::text_of_file(std::string_view title) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
      "font-family=\"sans-serif\" role=\"img\">\n<title>{2}</title>\n{3}</svg>\n",
      width_, height_, run::xml_text(title), body_);
}

}  // namespace touchstone::show
