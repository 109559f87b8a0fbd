// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/arc_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::kinematics {
namespace {

constexpr double kSlack = 1e-6;  // degrees, for ranges that only save time

int unit_of(const Arc& arc, double radius, const Polygon& polygon) {
  constexpr int none = std::numeric_limits<int>::max();
  int unit = lowest_bit({radius, 0, 0}, lowest_bit(arc.start, lowest_bit(arc.point, none)));
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) unit = lowest_bit(polygon.vertex(i), unit);
  return unit;
}

/// About the normal of points, of a length that does not matter.
Eigen::Vector3d rough_normal(const ExactFace& face) {
  Eigen::Vector3d normal;
  mp_bitcnt_t bits = 0;
  for (const mpz_class& n : face.normal) bits = std::max<mp_bitcnt_t>(bits, mpz_sizeinbase(n.get_mpz_t(), 2));
  for (int axis = 0; axis < 3; ++axis) {
    long exponent = 0;
    const double digits = mpz_get_d_2exp(&exponent, face.normal[static_cast<std::size_t>(axis)].get_mpz_t());
    normal[axis] = std::ldexp(digits, static_cast<int>(exponent - static_cast<long>(bits)));
  }
  return normal;
}

}  // namespace

/// The centre in one chart is center / weight; `weight` is positive.
struct ArcFace::Piece {
  Dyadic end;
  Polynomial weight;
  PolynomialVector center;
};

ArcFace::ArcFace(const Arc& arc, double radius, const Polygon& polygon)
    : unit_(unit_of(arc, radius, polygon)), face_(polygon, unit_), charts_(arc.axis) {
  start_ = face_.scale * in_units(arc.start, unit_);
  center_ = face_.scale * in_units(arc.point, unit_);
  spoke_ = start_ - center_;
  radius_ = face_.scale * in_units({radius, 0, 0}, unit_)[0];
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) points_.push_back(polygon.vertex(i));
}

// With v the spoke and n the axis, the quaternion (x, y n) turns v to
// ((x^2 - y^2 n.n) v + 2 x y n x v + 2 y^2 (n.v) n) / (x^2 + y^2 n.n).
std::optional<ArcFace::Contact> ArcFace::first(const ArcPieces& pieces, double latest) {
  const IntegerVector& axis = charts_.axis();
  const mpz_class squared_length = dot(axis, axis);
  const IntegerVector mixed = mpz_class(2) * cross(axis, spoke_);
  const IntegerVector behind = squared_length * (center_ - spoke_) + mpz_class(2 * dot(axis, spoke_)) * axis;

  struct Candidate {
    Feature feature;
    ArcPieces::Range range;
  };
  std::vector<Candidate> candidates;
  const auto consider = [&](Feature feature, const std::optional<ArcPieces::Range>& range) {
    if (range) candidates.push_back({feature, *range});
  };
  const double lift = face_.off_plane;
  consider({Feature::Kind::Face, 0}, pieces.near(points_, rough_normal(face_), lift));
  if (candidates.empty()) return std::nullopt;
  for (std::size_t i = 0; i < points_.size(); ++i)
    consider({Feature::Kind::Edge, i}, pieces.near(points_[i], points_[face_.next[i]], lift));
  for (std::size_t i = 0; i < points_.size(); ++i)
    consider({Feature::Kind::Vertex, i}, pieces.near(points_[i], points_[i], lift));

  std::optional<Contact> first;
  for (int chart = 0; chart < Charts::kCount && !first; ++chart) {
    const double begin = charts_.begin(chart) - kSlack, end = charts_.begin(chart + 1) + kSlack;
    if (begin > latest) break;
    std::optional<Piece> piece;
    for (const Candidate& candidate : candidates) {
      if (candidate.range.end + kSlack < begin || candidate.range.begin - kSlack > std::min(end, latest)) continue;
      if (!piece) {
        const auto [x, y, last] = charts_.chart(chart);
        piece = {last, x * x + squared_length * (y * y), (x * x) * start_ + (x * y) * mixed + (y * y) * behind};
      }
      const auto [kind, index] = candidate.feature;
      std::optional<Root> root = kind == Feature::Kind::Face   ? face_root(*piece)
                                 : kind == Feature::Kind::Edge ? edge_root(*piece, index)
                                                               : vertex_root(*piece, index);
      if (!root) continue;
      Contact contact{{chart, std::move(*root)}, candidate.feature, false};
      contact.grazing = contact.moment.root.multiple();
      if (!first || compare(contact.moment, first->moment) < 0) first = std::move(contact);
    }
  }
  return first;
}

/// The centre at distance r from the supporting plane, its foot in the relative interior of the polygon.
std::optional<Root> ArcFace::face_root(const Piece& piece) const {
  const IntegerVector& normal = face_.normal;
  const mpz_class squared_normal = dot(normal, normal);
  const Polynomial height = dot(normal, piece.center) - dot(normal, face_.vertices[0]) * piece.weight;
  const Polynomial reach = mpz_class(radius_ * radius_ * squared_normal) * (piece.weight * piece.weight);
  const PolynomialVector below = height * normal;
  const PolynomialVector foot{squared_normal * piece.center[0] - below[0], squared_normal * piece.center[1] - below[1],
                              squared_normal * piece.center[2] - below[2]};
  const Polynomial weight = squared_normal * piece.weight;
  // A point that passes through the plane is not a tangency.
  for (Root& root : real_roots(radius_ == 0 ? height : height * height - reach, piece.end))
    if (foot_inside(foot, weight, root)) return root;
  return std::nullopt;
}

/// Even-odd, in the plane of the other two axes. The foot is foot / weight.
bool ArcFace::foot_inside(const PolynomialVector& foot, const Polynomial& weight, Root& root) const {
  const std::size_t i = (face_.dropped_axis + 1) % 3, j = (face_.dropped_axis + 2) % 3;
  const auto side = [&](const IntegerVector& vertex, std::size_t axis) {
    return root.sign_of(vertex[axis] * weight - foot[axis]);
  };
  std::vector<int> above;
  for (const IntegerVector& vertex : face_.vertices) above.push_back(side(vertex, j));
  bool inside = false;
  for (std::size_t edge = 0; edge < face_.vertices.size(); ++edge) {
    const IntegerVector &a = face_.vertices[edge], &b = face_.vertices[face_.next[edge]];
    const int at_a = above[edge], at_b = above[face_.next[edge]];
    if (at_a * at_b > 0) continue;
    const int turn = root.sign_of(mpz_class(b[i] - a[i]) * (foot[j] - a[j] * weight) -
                                  mpz_class(b[j] - a[j]) * (foot[i] - a[i] * weight));
    if (turn == 0 && side(a, i) * side(b, i) <= 0) return false;  // on the boundary
    // Crosses the half line to the right: from not above to above with the foot on the left, or the other way.
    if ((at_a > 0) != (at_b > 0) && turn != 0 && (at_b > 0) == (turn > 0)) inside = !inside;
  }
  return inside;
}

/// The centre at distance r from the edge's line, its foot strictly between the ends.
std::optional<Root> ArcFace::edge_root(const Piece& piece, std::size_t edge) const {
  const IntegerVector &a = face_.vertices[edge], &b = face_.vertices[face_.next[edge]];
  const IntegerVector along = b - a;
  const mpz_class squared_length = dot(along, along);
  const PolynomialVector from_a = piece.center - piece.weight * a;
  const Polynomial reach = mpz_class(radius_ * radius_ * squared_length) * (piece.weight * piece.weight);
  const Polynomial foot = dot(along, from_a), beyond = foot - squared_length * piece.weight;
  for (Root& root : real_roots(squared(cross(from_a, along)) - reach, piece.end))
    if (root.sign_of(foot) > 0 && root.sign_of(beyond) < 0) return root;
  return std::nullopt;
}

/// The centre at distance r from a vertex: |c - o|^2 = v.v, so |c - a|^2 = v.v + |a - o|^2 - 2 (c - o).(a - o).
std::optional<Root> ArcFace::vertex_root(const Piece& piece, std::size_t vertex) const {
  const IntegerVector to_vertex = face_.vertices[vertex] - center_;
  const PolynomialVector spoke = piece.center - piece.weight * center_;
  const mpz_class constant = dot(spoke_, spoke_) + dot(to_vertex, to_vertex) - radius_ * radius_;
  auto roots = real_roots(constant * piece.weight - mpz_class(2) * dot(to_vertex, spoke), piece.end);
  if (roots.empty()) return std::nullopt;
  return std::move(roots.front());
}

}  // namespace touchstone::kinematics
