// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/margin.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "geometry/io/detail/text_number.h"
#include "robust/exact/exact.h"

namespace touchstone::cases {
namespace {

double size(const Shapes& shapes) {
  double largest = std::max(shapes.ball().radius, shapes.ball().center.lpNorm<Eigen::Infinity>());
  if (const Motion* motion = shapes.motion()) largest = std::max(largest, motion->to.lpNorm<Eigen::Infinity>());
  for (std::size_t i = 0; i < shapes.polygon.vertex_count(); ++i)
    largest = std::max(largest, shapes.polygon.vertex(i).lpNorm<Eigen::Infinity>());
  return largest;
}

PartialAnswer answer_with(const Shapes& shapes, double radius) {
  return exact_answer({with_radius(shapes.question, radius), shapes.polygon});
}

/// Returns the foot of the perpendicular from a point to the supporting plane, each coordinate truncated to a double.
Eigen::Vector3d foot_of(const Eigen::Vector3d& center, const Polygon& polygon) {
  using Vector = std::array<mpq_class, 3>;
  const auto exactly = [](const Eigen::Vector3d& v) { return Vector{v.x(), v.y(), v.z()}; };
  const auto dot = [](const Vector& a, const Vector& b) -> mpq_class {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const std::size_t vertices = polygon.loop_end(0);  // of the outer loop
  Vector normal{0, 0, 0}, sum{0, 0, 0};
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vector p = exactly(polygon.vertex(i)), q = exactly(polygon.vertex(polygon.next(i)));
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
      sum[k] += p[k];
    }
  }
  Vector foot = exactly(center), from = foot;
  for (std::size_t k = 0; k < 3; ++k) from[k] -= sum[k] / static_cast<unsigned long>(vertices);
  const mpq_class share = dot(normal, from) / dot(normal, normal);
  for (std::size_t k = 0; k < 3; ++k) foot[k] -= share * normal[k];
  return {foot[0].get_d(), foot[1].get_d(), foot[2].get_d()};
}

bool has_text(const PartialAnswer& answer, const std::string& key, const std::string& text) {
  const StatedAnswer all = stated(answer);
  const auto found = all.texts.find(key);
  return found != all.texts.end() && found->second == text;
}

double distance_to_segment(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 2>& ends) {
  const Eigen::Vector3d along = ends[1] - ends[0];
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp(along.dot(point - ends[0]) / squared, 0.0, 1.0) : 0;
  return (point - ends[0] - share * along).norm();
}

}  // namespace

double Margin::length(const Shapes& shapes) const { return of_size ? number * size(shapes) : number; }

Margin margin_of(const std::string& text) {
  Margin margin;
  std::string number = text;
  if (number.ends_with('m')) margin.of_size = false, number.pop_back();
  const auto fail = [&](const char* why) { throw std::invalid_argument("\"" + text + "\" " + why); };
  const bool is_power = number.starts_with("2^");
  const auto read = io::nearest_double(is_power ? number.substr(2) : number);
  if (!read || (is_power && *read != std::round(*read)))
    fail("is not a margin: write 2^-20 or 1e-6, with m for a length");
  margin.number = is_power ? std::exp2(*read) : *read;
  if (!(margin.number > 0) || !std::isfinite(margin.number)) fail("is not above 0 and finite");
  return margin;
}

AnswersWithin::AnswersWithin(const Shapes& shapes, double margin)
    : shapes_(shapes),
      margin_(margin),
      answers_{answer_with(shapes, std::max(shapes.ball().radius - margin, 0.0)), exact_answer(shapes),
               answer_with(shapes, shapes.ball().radius + margin)} {}

bool AnswersWithin::is_exact(const Key& key, const StatedAnswer& expected) const {
  const std::string name(key.name);
  const auto text = expected.texts.find(name);
  return text != expected.texts.end() && has_text(truth(), name, text->second);
}

bool AnswersWithin::has(const Key& key, const StatedAnswer& answer) const {
  const std::string name(key.name);
  const auto text = answer.texts.find(name);
  if (text == answer.texts.end()) return false;
  const auto has_it = [&](const PartialAnswer& one) { return has_text(one, name, text->second); };
  if (std::ranges::any_of(answers_, has_it)) return true;
  return cases::has(answer.values, key) && is_between(key, answer.values);
}

bool AnswersWithin::is_between(const Key& key, const PartialAnswer& found) const {
  const auto near = [&](const std::optional<double>& number, const std::optional<double>& exact) {
    return exact && std::abs(*number - *exact) <= margin_;
  };
  const auto is = [&](auto member) { return key == key_of(member); };
  if (is(&PartialAnswer::relation))
    return *smallest().relation <= *found.relation && *found.relation <= *largest().relation;
  if (is(&PartialAnswer::first)) return *largest().first <= *found.first && *found.first <= *smallest().first;
  if (is(&PartialAnswer::time)) return *largest().time <= *found.time && *found.time <= *smallest().time;
  if (is(&PartialAnswer::plane_tangent)) return smallest().plane != largest().plane;
  if (is(&PartialAnswer::edges_hit)) {
    const auto includes = [](const auto& all, const auto& some) { return std::ranges::includes(*all, *some); };
    return std::ranges::is_sorted(*found.edges_hit) && includes(largest().edges_hit, found.edges_hit) &&
           includes(found.edges_hit, smallest().edges_hit);
  }
  if (is(&PartialAnswer::distance)) return near(found.distance, truth().distance);
  if (is(&PartialAnswer::depth)) return near(found.depth, truth().depth);
  if (is(&PartialAnswer::off_plane)) return near(found.off_plane, truth().off_plane);
  if (is(&PartialAnswer::point)) return has_point(*found.point);
  if (is(&PartialAnswer::contact_normal)) return has_normal(*found.contact_normal);
  if (is(&PartialAnswer::nearest)) return has_feature(*found.nearest);
  if (is(&PartialAnswer::foot)) return foot_is_near_boundary();
  return false;
}

bool AnswersWithin::reaches(const Eigen::Vector3d& point, double distance) const {
  return point.allFinite() && std::isfinite(distance) && exact::contact({point, distance}, shapes_.polygon);
}

std::array<Eigen::Vector3d, 2> AnswersWithin::uncertain_way() const {
  const Motion& motion = *shapes_.motion();
  const auto at = [&](double time) -> Eigen::Vector3d {
    return motion.ball.center + std::min(time, 1.0) * (motion.to - motion.ball.center);
  };
  return {at(*largest().time), at(*smallest().time)};
}

bool AnswersWithin::has_point(const Eigen::Vector3d& point) const {
  if (!reaches(point, margin_)) return false;
  if (shapes_.motion() == nullptr) return (point - shapes_.ball().center).norm() <= *truth().distance + margin_;
  const double reach = std::max(shapes_.ball().radius, *truth().contact ? shapes_.ball().radius - *truth().depth : 0);
  return distance_to_segment(point, uncertain_way()) <= reach + margin_;
}

bool AnswersWithin::has_normal(const Eigen::Vector3d& normal) const {
  if (!(std::abs(normal.norm() - 1) * size(shapes_) <= margin_)) return false;
  if (shapes_.motion() == nullptr) return reaches(shapes_.ball().center - *truth().distance * normal, margin_);
  if (!*truth().contact) return false;
  const auto way = uncertain_way();
  const double distance = shapes_.ball().radius - *truth().depth;
  return reaches(way[0] - distance * normal, margin_ + (way[1] - way[0]).norm());
}

bool AnswersWithin::has_feature(const Feature& feature) const {
  const Eigen::Vector3d& center = shapes_.ball().center;
  const double reach = *truth().distance + margin_;
  switch (feature.kind) {
    case Feature::Kind::Face: {
      const Eigen::Vector3d foot = foot_of(center, shapes_.polygon);
      return reaches(foot, margin_) && (foot - center).norm() <= reach;
    }
    case Feature::Kind::Edge:
      return std::isfinite(reach) &&
             std::ranges::binary_search(exact::edges_hit({center, reach}, shapes_.polygon), feature.index);
    case Feature::Kind::Vertex: break;
  }
  return feature.index < shapes_.polygon.vertex_count() &&
         (shapes_.polygon.vertex(feature.index) - center).norm() <= reach + *truth().off_plane;
}

bool AnswersWithin::foot_is_near_boundary() const {
  const Eigen::Vector3d foot = foot_of(shapes_.ball().center, shapes_.polygon);
  return foot.allFinite() && !exact::edges_hit({foot, margin_}, shapes_.polygon).empty();
}

}  // namespace touchstone::cases
