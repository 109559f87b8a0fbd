// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/margin.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "geometry/io/detail/text_number.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::cases {
namespace {

double size(const AnyShapes& shapes) {
  const Question& question = question_of(shapes);
  double largest = std::max(ball_of(question).radius, ball_of(question).center.lpNorm<Eigen::Infinity>());
  if (const auto* motion = std::get_if<Motion>(&question))
    largest = std::max(largest, motion->to.lpNorm<Eigen::Infinity>());
  for (const Polygon& polygon : faces_of(shapes))
    for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
      largest = std::max(largest, polygon.vertex(i).lpNorm<Eigen::Infinity>());
  return largest;
}

PartialAnswer answer_with(const AnyShapes& shapes, double radius) { return exact_answer(with_radius(shapes, radius)); }

/// The supporting plane of a polygon, in rationals.
class SupportingPlane {
 public:
  explicit SupportingPlane(const Polygon& polygon) {
    const std::size_t vertices = polygon.loop_end(0);  // of the outer loop
    for (std::size_t i = 0; i < vertices; ++i) {
      const Vector p = exactly(polygon.vertex(i)), q = exactly(polygon.vertex(polygon.next(i)));
      for (std::size_t k = 0; k < 3; ++k) {
        normal_[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
        mean_[k] += p[k] / static_cast<unsigned long>(vertices);
      }
    }
    const auto below = [](const mpq_class& a, const mpq_class& b) { return abs(a) < abs(b); };
    axis_ = static_cast<std::size_t>(std::ranges::max_element(normal_, below) - normal_.begin());
  }

  /// Returns the foot of the perpendicular from a point, each coordinate truncated to a double.
  [[nodiscard]] Eigen::Vector3d foot(const Eigen::Vector3d& point) const {
    const mpq_class share = height(point) / dot(normal_, normal_);
    Vector foot = exactly(point);
    for (std::size_t k = 0; k < 3; ++k) foot[k] -= share * normal_[k];
    return {foot[0].get_d(), foot[1].get_d(), foot[2].get_d()};
  }
  /// Returns a vertex as it is lifted, truncated likewise.
  [[nodiscard]] Eigen::Vector3d lifted(Eigen::Vector3d vertex) const {
    const auto axis = static_cast<Eigen::Index>(axis_);
    vertex[axis] = mpq_class(vertex[axis] - height(vertex) / normal_[axis_]).get_d();
    return vertex;
  }

 private:
  using Vector = std::array<mpq_class, 3>;
  static Vector exactly(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
  static mpq_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// Times the length of the normal.
  [[nodiscard]] mpq_class height(const Eigen::Vector3d& point) const {
    Vector from = exactly(point);
    for (std::size_t k = 0; k < 3; ++k) from[k] -= mean_[k];
    return dot(normal_, from);
  }

  Vector normal_{0, 0, 0}, mean_{0, 0, 0};
  std::size_t axis_;  ///< the dropped one
};

bool has_text(const PartialAnswer& answer, const std::string& key, const std::string& text) {
  const StatedAnswer all = stated(answer);
  const auto found = all.texts.find(key);
  return found != all.texts.end() && found->second == text;
}

/// Returns a distance in doubles. Squares neither underflow nor overflow.
double distance_to_segment(const Eigen::Vector3d& point, const std::array<Eigen::Vector3d, 2>& ends) {
  const Eigen::Vector3d along = ends[1] - ends[0], from = point - ends[0];
  const double scale = std::max(along.lpNorm<Eigen::Infinity>(), from.lpNorm<Eigen::Infinity>());
  if (!(scale > 0) || !std::isfinite(scale)) return scale;
  const Eigen::Vector3d unit = along / scale, there = from / scale;
  const double squared = unit.squaredNorm();
  const double share = squared > 0 ? std::clamp(unit.dot(there) / squared, 0.0, 1.0) : 0;
  return scale * (there - share * unit).norm();
}

/// Returns whether the list is sorted, has all of `least`, and has nothing that is not in `most`.
bool is_sorted_between(const std::vector<std::size_t>& least, const std::vector<std::size_t>& list,
                       const std::vector<std::size_t>& most) {
  return std::ranges::is_sorted(list) && std::ranges::includes(most, list) && std::ranges::includes(list, least);
}

}  // namespace

double Margin::length(const AnyShapes& shapes) const { return of_size ? number * size(shapes) : number; }

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

AnswersWithin::AnswersWithin(AnyShapes shapes, double margin)
    : shapes_(std::move(shapes)),
      margin_(margin),
      size_(size(shapes_)),
      answers_{answer_with(shapes_, std::max(ball().radius - margin, 0.0)), exact_answer(shapes_),
               answer_with(shapes_, larger_radius())} {}

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
  if (!cases::has(answer.values, key)) return false;
  const auto* asked = std::get_if<MeshShapes>(&shapes_);
  if (asked == nullptr) return is_between(key, answer.values);
  if (const auto decided = is_between_of_mesh(key, answer.values)) return *decided;
  const bool names_one = answer.values.face && has_face(*answer.values.face);
  const std::optional<std::size_t> face = names_one ? answer.values.face : truth().face;
  if (!face) return false;
  AnswersWithin about_face(Shapes{asked->question, asked->mesh.faces()[*face]}, margin_);
  about_face.size_ = size_;
  return about_face.has(key, answer);
}

std::optional<bool> AnswersWithin::is_between_of_mesh(const Key& key, const PartialAnswer& found) const {
  const auto is = [&](auto member) { return key == key_of(member); };
  if (is(&PartialAnswer::face)) return has_face(*found.face);
  if (is(&PartialAnswer::touched)) return is_sorted_between(*smallest().touched, *found.touched, *largest().touched);
  if (is(&PartialAnswer::relation) || is(&PartialAnswer::first) || is(&PartialAnswer::time) ||
      is(&PartialAnswer::distance) || (is(&PartialAnswer::depth) && motion() == nullptr))
    return is_between(key, found);
  if (is(&PartialAnswer::contact)) return false;  // it is that of none of the radii
  return std::nullopt;
}

double AnswersWithin::larger_radius() const {
  return std::min(ball().radius + margin_, std::numeric_limits<double>::max());
}

bool AnswersWithin::has_face(std::size_t face) const {
  const auto& [question, mesh] = std::get<MeshShapes>(shapes_);
  if (face >= mesh.faces().size()) return false;
  const PartialAnswer about_face = answer_with(Shapes{question, mesh.faces()[face]}, larger_radius());
  if (motion() == nullptr) return *about_face.distance - *truth().distance <= margin_;
  return *about_face.contact && *about_face.time <= *smallest().time;
}

bool AnswersWithin::is_between(const Key& key, const PartialAnswer& found) const {
  const auto is = [&](auto member) { return key == key_of(member); };
  const auto is_near = [&](auto member) {
    const auto& exact = (truth().*member).has_value() ? truth().*member : largest().*member;
    return exact && std::abs(*(found.*member) - *exact) <= margin_;
  };
  if (is(&PartialAnswer::relation))
    return *smallest().relation <= *found.relation && *found.relation <= *largest().relation;
  if (is(&PartialAnswer::first)) return *largest().first <= *found.first && *found.first <= *smallest().first;
  if (is(&PartialAnswer::time)) return *largest().time <= *found.time && *found.time <= std::min(*smallest().time, 1.0);
  if (is(&PartialAnswer::momentary))
    return smallest().momentary != truth().momentary || truth().momentary != largest().momentary;
  if (is(&PartialAnswer::plane_tangent)) return smallest().plane != largest().plane;
  if (is(&PartialAnswer::edges_hit))
    return is_sorted_between(*smallest().edges_hit, *found.edges_hit, *largest().edges_hit);
  if (is(&PartialAnswer::distance)) return is_near(&PartialAnswer::distance);
  if (is(&PartialAnswer::depth)) return is_near(&PartialAnswer::depth);
  if (is(&PartialAnswer::off_plane)) return is_near(&PartialAnswer::off_plane);
  if (is(&PartialAnswer::point)) return has_point(*found.point);
  if (is(&PartialAnswer::contact_normal)) return has_normal(*found.contact_normal);
  if (is(&PartialAnswer::nearest)) return has_feature(*found.nearest);
  if (is(&PartialAnswer::foot)) return foot_is_near_boundary();
  return false;
}

bool AnswersWithin::reaches(const Motion& motion) const {
  return !find_fault(motion) && exact::contact(motion, polygon());
}

double AnswersWithin::distance() const {
  if (motion() == nullptr) return *truth().distance;
  return ball().radius - (*truth().contact ? *truth().depth : 0);
}

std::array<Eigen::Vector3d, 2> AnswersWithin::centers() const {
  const Eigen::Vector3d& first = ball().center;
  const Motion* motion = this->motion();
  if (motion == nullptr) return {first, first};
  const auto at = [&](double time) -> Eigen::Vector3d { return first + std::min(time, 1.0) * (motion->to - first); };
  return {at(*largest().time), at(*smallest().time)};
}

bool AnswersWithin::has_point(const Eigen::Vector3d& point) const {
  const bool touches = motion() == nullptr || *largest().contact;
  return touches && std::isfinite(distance()) && reaches(Motion({point, margin_}, point)) &&
         distance_to_segment(point, centers()) <= distance() + margin_;
}

bool AnswersWithin::has_normal(const Eigen::Vector3d& normal) const {
  const bool touches = motion() == nullptr || *largest().contact;
  if (!touches || !(std::abs(normal.norm() - 1) * size_ <= margin_)) return false;
  const auto [begin, end] = centers();
  const Eigen::Vector3d to_polygon = -distance() * normal;
  return reaches(Motion({begin + to_polygon, margin_}, end + to_polygon));
}

bool AnswersWithin::has_feature(const Feature& feature) const {
  const Eigen::Vector3d& center = ball().center;
  const double reach = *truth().distance + margin_;
  if (!std::isfinite(reach)) return false;
  const auto distance_to = [&](const Eigen::Vector3d& point) { return distance_to_segment(point, {center, center}); };
  const SupportingPlane plane(polygon());
  switch (feature.kind) {
    case Feature::Kind::Face: {
      const Eigen::Vector3d foot = plane.foot(center);
      return reaches(Motion({foot, margin_}, foot)) && distance_to(foot) <= reach;
    }
    case Feature::Kind::Edge:
      return std::ranges::binary_search(exact::edges_hit({center, reach}, polygon()), feature.index);
    case Feature::Kind::Vertex: break;
  }
  return feature.index < polygon().vertex_count() &&
         distance_to(plane.lifted(polygon().vertex(feature.index))) <= reach;
}

bool AnswersWithin::foot_is_near_boundary() const {
  const Eigen::Vector3d foot = SupportingPlane(polygon()).foot(ball().center);
  return foot.allFinite() && std::isfinite(margin_) && !exact::edges_hit({foot, margin_}, polygon()).empty();
}

}  // namespace touchstone::cases
