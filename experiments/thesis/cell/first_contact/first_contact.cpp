// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/first_contact.h"

#include <algorithm>
#include <array>
#include <vector>

#include "experiments/thesis/cell/first_contact/arc_face.h"
#include "experiments/thesis/cell/first_contact/arc_pieces.h"
#include "geometry/detail/floating_point_state.h"
#include "geometry/shapes/ball.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/lifted_box.h"

namespace touchstone::kinematics {
namespace {

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

}  // namespace touchstone::kinematics
