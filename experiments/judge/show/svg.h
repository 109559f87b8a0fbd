// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::show {

/// How a shape is drawn; colours as in SVG, `none` for nothing.
struct Style {
  std::string fill = "none", stroke = "none";
  double width = 1;
  bool dashed = false;
  double opacity = 1;  ///< of the fill
};

/// A drawing in SVG: lines, circles, paths, rectangles and texts, with attributes of their own, in groups that are
/// moved and cut off.
class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Style& style);
  void circle(const Eigen::Vector2d& centre, double radius, const Style& style);
  void rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size, const Style& style);
  /// Closed loops, filled by the rule of even and odd.
  void loops(const std::vector<std::vector<Eigen::Vector2d>>& loops, const Style& style);
  /// `anchor`: start, middle or end.
  void text(const Eigen::Vector2d& at, std::string_view text, double size = 12, std::string_view anchor = "start",
            std::string_view fill = "#222");
  /// Begins a group at a place, which is cut off beyond the size.
  void begin_panel(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);
  void end_panel();
  /// Adds another drawing below, and makes this one as much higher.
  void append(const Svg& other);

  [[nodiscard]] double height() const { return height_; }

  /// Returns the file. `title` is read to those who do not see it.
  [[nodiscard]] std::string text_of_file(std::string_view title) const;

 private:
  double width_, height_;
  std::string body_;
};

}  // namespace touchstone::show
