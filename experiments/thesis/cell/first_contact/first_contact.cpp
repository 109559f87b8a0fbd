// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/first_contact.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc_pieces.h"
#include "experiments/thesis/cell/first_contact/chart.h"
#include "geometry/contact/answer.h"
#include "geometry/detail/floating_point_state.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/lifted_box.h"

namespace touchstone::kinematics {
namespace {

/// A polygon, lifted exactly onto its supporting plane: a vertex is vertices[i] times 2^unit / scale.
struct ExactFace {
  /// Requires a polygon that exact::validate accepts, and a unit that divides its coordinates.
  ExactFace(const Polygon& polygon, int unit);

  std::vector<IntegerVector> vertices;
  std::vector<std::size_t> next;  ///< edge i runs from vertex i to next[i]
  mpz_class scale;                ///< positive; 1 for polygons that are exactly planar
  IntegerVector normal;           ///< up to a positive factor
  std::size_t dropped_axis;
  double off_plane;  ///< in the unit of the polygon: the largest distance by which a vertex is lifted
};

/// The nearest double above.
double rounded_up(const mpq_class& value, int unit) {
  const double near = std::ldexp(value.get_d(), unit);  // value.get_d() rounds towards 0
  return value == 0 ? 0 : std::nextafter(std::nextafter(near, HUGE_VAL), HUGE_VAL);
}

ExactFace::ExactFace(const Polygon& polygon, int unit) : scale(1), normal{0, 0, 0}, dropped_axis(0), off_plane(0) {
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    vertices.push_back(in_units(polygon.vertex(i), unit));
    next.push_back(polygon.next(i));
  }
  const std::size_t outer = polygon.loop_end(0);
  IntegerVector sum{0, 0, 0};
  for (std::size_t i = 0; i < outer; ++i) {
    normal = normal + cross(vertices[i] - vertices[0], vertices[next[i]] - vertices[0]);
    sum = sum + vertices[i];
  }
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (mpz_cmpabs(normal[axis].get_mpz_t(), normal[dropped_axis].get_mpz_t()) > 0) dropped_axis = axis;

  // The heights over the supporting plane, through sum / outer, times outer and the normal's length.
  const mpz_class count(static_cast<unsigned long>(outer)), of_plane = dot(normal, sum);
  std::vector<mpz_class> heights;
  for (const IntegerVector& vertex : vertices) heights.push_back(mpz_class(count * dot(normal, vertex) - of_plane));
  if (std::ranges::all_of(heights, [](const mpz_class& height) { return height == 0; })) return;
  const bool negative = normal[dropped_axis] < 0;
  scale = abs(mpz_class(count * normal[dropped_axis]));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    off_plane = std::max(off_plane, rounded_up(mpq_class(abs(heights[i]), scale), unit));
    vertices[i] = scale * vertices[i];
    vertices[i][dropped_axis] += negative ? heights[i] : mpz_class(-heights[i]);
  }
}

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

/// A ball whose centre moves along an arc, and one face: computes exactly the roots at which the ball touches.
class ArcFace {
 public:
  ArcFace(const Arc& arc, double radius, const Polygon& polygon);

  struct Contact {
    Moment moment;
    Feature feature;
    bool grazing;
  };
  /// Returns the first contact after the start with a feature near the arc, on the whole turn of 360 degrees or at most
  /// up to `latest`, which only saves time.
  [[nodiscard]] std::optional<Contact> first(const ArcPieces& pieces, double latest);
  [[nodiscard]] const Charts& charts() const { return charts_; }

 private:
  struct Piece;

  [[nodiscard]] std::optional<Root> face_root(const Piece& piece) const;
  [[nodiscard]] std::optional<Root> edge_root(const Piece& piece, std::size_t edge) const;
  [[nodiscard]] std::optional<Root> vertex_root(const Piece& piece, std::size_t vertex) const;
  [[nodiscard]] bool foot_inside(const PolynomialVector& foot, const Polynomial& weight, Root& root) const;

  int unit_;
  ExactFace face_;
  Charts charts_;
  IntegerVector start_, center_, spoke_;  // of the arc, and start - center, in the units of the face
  mpz_class radius_;
  std::vector<Eigen::Vector3d> points_;  // the vertices before they are lifted
};

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

constexpr unsigned kBits = 64;  // of the parameter: about 1e-17 degrees

/// Returns whether the moment is after the given angle in degrees, as far as 200 bits can tell.
bool beyond(const Charts& charts, Moment& moment, double degrees) {
  moment.root.refine(200);
  return charts.degrees_exceed(moment.chart, moment.root.low(), degrees, 256);
}

/// The contact of one face after the start; nothing beyond the end of the move.
std::optional<FirstContact> contact_of(const Arc& arc, double radius, const Polygon& polygon, std::size_t face,
                                       const ArcPieces& pieces, double latest) {
  ArcFace problem(arc, radius, polygon);
  auto contact = problem.first(pieces, latest);
  if (!contact) return std::nullopt;
  const auto& [chart, root] = contact->moment;
  const Charts& charts = problem.charts();
  contact->moment.root.refine(kBits);
  const double low = charts.degrees(chart, root.low(), Charts::Towards::Low);
  const double high = charts.degrees(chart, root.high(), Charts::Towards::High);
  if (high > arc.degrees && beyond(charts, contact->moment, arc.degrees)) return std::nullopt;
  return FirstContact{low, high, contact->grazing ? FirstContact::Kind::Grazing : FirstContact::Kind::Transversal, face,
                      contact->feature};
}

}  // namespace

std::string_view to_string(FirstContact::Kind kind) {
  constexpr std::array<std::string_view, 3> words{"at-start", "transversal", "grazing"};
  return words[static_cast<std::size_t>(kind)];
}

std::optional<FirstContact> first_contact(const Arc& arc, double radius, const scene::Faces& faces) {
  require_valid(arc);
  const Ball start{arc.start, radius};
  if (const auto fault = find_fault(start)) throw Rejected(*fault);
  const FloatingPointState state;

  const ArcPieces pieces(arc, radius);
  struct Near {
    ArcPieces::Range range;
    std::size_t face;
  };
  std::vector<Near> near;
  const std::size_t triangles = faces.triangles.size();
  for (std::size_t i = 0; i < triangles; ++i)
    if (const auto range = pieces.near(box(faces.triangles[i]))) near.push_back({*range, i});
  for (std::size_t i = 0; i < faces.polygons.size(); ++i) {
    const Polygon& polygon = faces.polygons[i];
    const auto quick = scene::detail::quick_lifted_box(polygon);
    const auto range =
        pieces.near(quick ? *quick : scene::detail::lifted_box(polygon, filtered::PreparedPolygon(polygon)));
    if (range) near.push_back({*range, triangles + i});
  }
  const auto polygon_of = [&](std::size_t face) {
    if (face >= triangles) return faces.polygons[face - triangles];
    const Triangle& t = faces.triangles[face];
    return Polygon({t.a, t.b, t.c});
  };
  for (const Near& n : near) {
    if (n.range.begin > 0) continue;
    const Polygon polygon = polygon_of(n.face);
    const filtered::PreparedPolygon prepared(polygon);
    if (filtered::contact(start, prepared))
      return FirstContact{0, 0, FirstContact::Kind::AtStart, n.face, filtered::answer(start, prepared).nearest};
  }

  // Those that can be met early first, so that the others need not be looked at.
  std::ranges::stable_sort(near, {}, [](const Near& n) { return n.range.begin; });
  std::optional<FirstContact> first;
  for (const Near& n : near) {
    const double latest = first ? first->high : arc.degrees;
    if (n.range.begin > latest) break;
    const auto contact = contact_of(arc, radius, polygon_of(n.face), n.face, pieces, latest);
    if (!contact) continue;
    const bool apart = first && (contact->high < first->low || first->high < contact->low);
    if (!first || (apart ? contact->low < first->low : contact->face < first->face)) first = contact;
  }
  return first;
}

std::optional<SteppedContact> stepped_contact(const Arc& arc, double radius, double step, const scene::Faces& faces) {
  require_valid(arc);
  if (const auto fault = find_fault({arc.start, radius})) throw Rejected(*fault);
  if (!(step > 0 && std::isfinite(step)))
    throw std::invalid_argument(fmt::format("the step must be finite and positive, is {} degrees", step));
  scene::Scene scene;
  scene.add("faces", faces);
  for (std::uint64_t stop = 0; static_cast<double>(stop) * step <= arc.degrees; ++stop) {
    const double degrees = static_cast<double>(stop) * step;
    const auto touched = scene.touched({point_at(arc, degrees), radius});
    if (!touched.empty()) return SteppedContact{stop, degrees, touched.front().face};
  }
  return std::nullopt;
}

}  // namespace touchstone::kinematics
