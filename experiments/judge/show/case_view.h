// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/cases/method.h"

namespace touchstone::show {

/// Contact at radii around that of a case, double by double where the answer changes.
struct Radii {
  /// The number of doubles by which the radius exceeds the least one with contact: 0 or more if the ball touches,
  /// negative if it does not; nothing if no radius has contact.
  std::optional<std::int64_t> margin;
  /// Whether the ball of the least radius with contact exactly touches, and does not overlap.
  bool exactly_touching = false;
  std::vector<std::int64_t> offsets;  ///< in doubles from the radius of the case, ascending, with 0
  std::vector<bool> contact;          ///< the exact answer at each
  bool every_double = false;          ///< whether the offsets leave none out

  [[nodiscard]] double radius(const cases::AnyShapes& shapes, std::size_t i) const;
};

/// Finds them by `exact`, for a ball at a place or a moving one. If the answer changes within 20 doubles of the radius,
/// every double around is taken; else powers of two up to there, and the two doubles between which it changes. Contact
/// grows with the radius, so 64 questions find the least one.
[[nodiscard]] Radii radii_around(const cases::AnyShapes& shapes);

/// The verdict of one method on a case.
struct Verdict {
  std::string method;
  cases::StatedAnswer answer;
  std::string fault;                         ///< why there is no answer; else empty
  std::vector<std::optional<bool>> contact;  ///< at each radius of the view; empty if it was asked about the case alone
};

/// A case with everything that its picture and its table show.
struct CaseView {
  std::string id;
  std::vector<std::string> tags;
  cases::AnyShapes shapes;
  cases::PartialAnswer truth;  ///< by `exact`
  Radii radii;
  std::vector<Verdict> verdicts;

  [[nodiscard]] const Ball& ball() const { return cases::ball_of(question_of(shapes)); }
  /// Returns nothing for a ball at a place.
  [[nodiscard]] const Motion* motion() const { return std::get_if<Motion>(&question_of(shapes)); }
  /// Returns the polygon, or the nearest or first face of a mesh; its face 0 if a moving ball touches none.
  [[nodiscard]] const Polygon& polygon() const;
};

/// Asks `exact`.
[[nodiscard]] CaseView view_of(const std::string& id, const std::vector<std::string>& tags,
                               const cases::AnyShapes& shapes);

/// Asks the method about the case, and about contact at each radius of the view. An exception of the method becomes its
/// fault.
[[nodiscard]] Verdict verdict_of(const CaseView& view, const cases::Method& method);

/// Returns the margin as a sentence: `The ball touches: its radius is 3 doubles above the least one that does.`
/// Margins of more than a million doubles are not counted.
[[nodiscard]] std::string margin_text(const CaseView& view);

/// The shapes of a case in coordinates for pictures: two in the plane of the view's polygon and the height above it, in
/// doubles, scaled by a power of two. For drawing only.
struct FlatCase {
  using Loop = std::vector<Eigen::Vector3d>;

  std::vector<Loop> loops;            ///< of the polygon, at height 0
  std::vector<Loop> other_faces;      ///< of a mesh
  Eigen::Vector3d from, to;           ///< the centre, and the end of its way (else the same)
  std::optional<Eigen::Vector3d> at;  ///< the centre at a place, or when contact begins
  double radius = 0;
  std::optional<Eigen::Vector3d> touched;  ///< the nearest point, or the first touched one, at height 0
  Eigen::Vector3d along;                   ///< the direction of the section: a unit vector in the plane

  /// Returns the foot of the centre.
  [[nodiscard]] Eigen::Vector3d foot() const { return {from.x(), from.y(), 0}; }
  /// Returns the ends of the parts of the section, a plane through the centre, that lie inside these loops of a face.
  [[nodiscard]] std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> section(std::span<const Loop> face) const;
};

/// Returns nothing if the numbers of the case differ too much for a picture.
[[nodiscard]] std::optional<FlatCase> flat_case(const CaseView& view);

/// Draws a case (SVG, in the style of a page): the polygon from above with the ball, the foot of its centre and the
/// nearest point; a section through them; and the radii around that of the ball, double by double, with what `exact`
/// and each method say of contact. Of a moving ball: its way, and the ball at its first contact.
[[nodiscard]] std::string picture_of(const CaseView& view);

/// Returns a case as a section of a page: its margin, its picture, and a table of what `exact` and the verdicts say,
/// key by key, with what differs marked.
[[nodiscard]] std::string section_of(const CaseView& view);

/// Returns a text as the content of an element or attribute of XML or HTML: `&`, `<`, `>` and quotation marks become
/// entities, and what is not legible is escaped as io::legible does. Line ends stay.
[[nodiscard]] std::string xml_text(std::string_view text);

/// Returns a page of HTML that loads nothing: the title, then the body.
[[nodiscard]] std::string page_of(const std::string& title, const std::string& body);

}  // namespace touchstone::show
