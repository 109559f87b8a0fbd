// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/first_contact.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
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
#include "robust/exact/detail/lifted.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/lifted_box.h"

namespace touchstone::kinematics {
namespace {

constexpr double kSlack = 1e-6;  // degrees, for ranges that only save time

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

  exact::PreparedPolygon polygon_;
  const exact::detail::Lifted& face_;
  Charts charts_;
  // Integers, by one power of two, and lengths also by that of the face: its lifted vertices, its normal, start and
  // centre of the arc, start - center.
  std::vector<IntegerVector> vertices_;
  IntegerVector normal_, start_, center_, spoke_;
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
    : polygon_(polygon), face_(exact::lifted(polygon_)), charts_(arc.axis) {
  std::vector<Vector<mpq_class>> all;
  const auto add = [&](const exact::detail::Vector& v) {
    all.push_back({rational(v.x()), rational(v.y()), rational(v.z())});
  };
  for (const auto& vertex : face_.vertices) add(vertex);
  add(face_.normal);
  for (const Eigen::Vector3d& v : {Eigen::Vector3d(radius, 0, 0), arc.point, arc.start})
    add(face_.scale * exact::detail::vector(v));
  vertices_ = whole(all);
  const auto take = [&] {
    IntegerVector last = std::move(vertices_.back());
    vertices_.pop_back();
    return last;
  };
  start_ = take(), center_ = take(), radius_ = take()[0], normal_ = take();
  spoke_ = start_ - center_;
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
  const Eigen::Vector3d normal(CGAL::to_double(face_.normal.x()), CGAL::to_double(face_.normal.y()),
                               CGAL::to_double(face_.normal.z()));
  consider({Feature::Kind::Face, 0}, pieces.near(points_, normal, lift));
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
  const mpz_class squared_normal = dot(normal_, normal_);
  const Polynomial height = dot(normal_, piece.center) - dot(normal_, vertices_[0]) * piece.weight;
  const Polynomial reach = mpz_class(radius_ * radius_ * squared_normal) * (piece.weight * piece.weight);
  const PolynomialVector below = height * normal_;
  const PolynomialVector foot{squared_normal * piece.center[0] - below[0], squared_normal * piece.center[1] - below[1],
                              squared_normal * piece.center[2] - below[2]};
  const Polynomial weight = squared_normal * piece.weight;
  // A point that passes through the plane is not a tangency.
  for (Root& root : real_roots(radius_ == 0 ? height : height * height - reach, piece.end))
    if (foot_inside(foot, weight, root)) return root;
  return std::nullopt;
}

/// In the plane of the other two axes. The foot is foot / weight.
bool ArcFace::foot_inside(const PolynomialVector& foot, const Polynomial& weight, Root& root) const {
  const std::size_t dropped = static_cast<std::size_t>(face_.dropped_axis), u = (dropped + 1) % 3,
                    v = (dropped + 2) % 3;
  const auto sign = [&](const Polynomial& polynomial) { return static_cast<kernel::Sign>(root.sign_of(polynomial)); };
  const auto beside = [&](std::size_t i, std::size_t axis) { return sign(vertices_[i][axis] * weight - foot[axis]); };
  struct Signs {
    std::function<kernel::Sign(std::size_t)> above, side;
    std::function<bool(std::size_t)> covers;
  };
  const Signs signs{[&](std::size_t i) { return beside(i, v); },
                    [&](std::size_t i) {
                      const IntegerVector &a = vertices_[i], &b = vertices_[face_.next[i]];
                      return sign(mpz_class(b[u] - a[u]) * (foot[v] - a[v] * weight) -
                                  mpz_class(b[v] - a[v]) * (foot[u] - a[u] * weight));
                    },
                    [&](std::size_t i) { return beside(i, u) * beside(face_.next[i], u) != kernel::POSITIVE; }};
  return exact::detail::locate(face_, signs) == PointLocation::Inside;
}

/// The centre at distance r from the edge's line, its foot strictly between the ends.
std::optional<Root> ArcFace::edge_root(const Piece& piece, std::size_t edge) const {
  const IntegerVector &a = vertices_[edge], &b = vertices_[face_.next[edge]];
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
  const IntegerVector to_vertex = vertices_[vertex] - center_;
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
