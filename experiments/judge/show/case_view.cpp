// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/case_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <numeric>
#include <set>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/program/printing.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::show {
namespace {

constexpr std::int64_t kLast = workloads::ordinal(std::numeric_limits<double>::max());
constexpr std::int64_t kNear = 20, kAround = 8;

/// Returns the offsets to show, where the answer first is yes at `change`.
std::vector<std::int64_t> offsets_to(std::optional<std::int64_t> change) {
  std::set<std::int64_t> offsets{0};
  if (!change || std::abs(*change) <= kNear) {
    const std::int64_t at = change.value_or(0);
    for (std::int64_t k = std::min<std::int64_t>(at, 0) - kAround; k <= std::max<std::int64_t>(at, 0) + kAround; ++k)
      offsets.insert(k);
  } else {
    const std::int64_t side = *change < 0 ? -1 : 1;
    for (std::int64_t k = 1; k <= std::abs(*change); k = k > kLast / 16 ? kLast : k * 16) offsets.insert(side * k);
    for (const std::int64_t k : {1, 16}) offsets.insert(-side * k);
    for (std::int64_t k = -2; k < 2; ++k) offsets.insert(*change + k);
  }
  return {offsets.begin(), offsets.end()};
}

}  // namespace

double Radii::radius(const cases::AnyShapes& shapes, std::size_t i) const {
  return workloads::move_radius_by_doubles(cases::ball_of(question_of(shapes)).radius, offsets[i]);
}

const Polygon& CaseView::polygon() const { return faces_of(shapes)[truth.face.value_or(0)]; }

Radii radii_around(const cases::AnyShapes& shapes) {
  const auto polygons = faces_of(shapes);
  const std::vector<exact::PreparedPolygon> faces(polygons.begin(), polygons.end());
  const cases::Question& question = question_of(shapes);
  const Ball& own_ball = cases::ball_of(question);
  const auto touches = [&](double radius) {
    return std::visit(
        [&](const auto& asked) {
          return std::ranges::any_of(faces, [&](const auto& face) { return exact::contact(asked, face); });
        },
        cases::with_radius(question, radius));
  };
  const std::int64_t own = workloads::ordinal(own_ball.radius);
  std::int64_t first = 0;  // kLast + 1: no radius has contact
  for (std::int64_t end = kLast + 1; first < end;) {
    const std::int64_t middle = std::midpoint(first, end);
    if (touches(workloads::from_ordinal(middle)))
      end = middle;
    else
      first = middle + 1;
  }
  Radii radii;
  std::optional<std::int64_t> change;
  if (first <= kLast) {
    if (first > 0) change = first - own;  // else even a point touches
    radii.margin = own - first;
    const Ball ball{own_ball.center, workloads::from_ordinal(first)};
    radii.exactly_touching =
        std::holds_alternative<Ball>(question) && std::ranges::all_of(faces, [&](const auto& face) {
          return exact::relation(ball, face) != Relation::Overlapping;
        });
  }
  for (const std::int64_t offset : offsets_to(change)) {
    if (own + offset < 0 || offset > kLast - own) continue;
    radii.offsets.push_back(offset);
    radii.contact.push_back(offset >= first - own);
  }
  radii.every_double =
      radii.offsets.back() - radii.offsets.front() + 1 == static_cast<std::int64_t>(radii.offsets.size());
  return radii;
}

CaseView view_of(const std::string& id, const std::vector<std::string>& tags, const cases::AnyShapes& shapes) {
  return {id, tags, shapes, exact_answer(shapes), radii_around(shapes), {}};
}

Verdict verdict_of(const CaseView& view, const cases::Method& method) {
  Verdict verdict{std::string(method.name()), {}, {}, {}};
  try {
    const auto prepared = cases::prepare(method, view.shapes);
    const cases::Question& question = question_of(view.shapes);
    const auto answer = prepared->answer(question);
    if (!answer) {
      verdict.fault = "cannot answer about moving balls";
      return verdict;
    }
    verdict.answer = cases::stated(*answer);
    for (std::size_t i = 0; i < view.radii.offsets.size(); ++i)
      verdict.contact.push_back(prepared->answer(cases::with_radius(question, view.radii.radius(view.shapes, i)))
                                    .value_or(cases::PartialAnswer{})
                                    .contact);
  } catch (const std::exception& error) {
    verdict.fault = error.what();
    verdict.contact.clear();
  }
  return verdict;
}

std::string margin_text(const CaseView& view) {
  const auto margin = view.radii.margin;
  if (!margin) return "No ball with this centre touches, whatever its radius.";
  if (workloads::move_radius_by_doubles(view.ball().radius, -*margin) == 0)
    return "Even a point there touches, so every ball does.";
  if (*margin == 0) return "The ball touches: its radius is the least double that does.";
  const auto count = static_cast<std::uint64_t>(std::abs(*margin));
  return fmt::format("The ball {}: its radius is {} {} the least one that does.",
                     *margin < 0 ? "does not touch" : "touches",
                     count > 1'000'000 ? "over a million doubles" : program::counted(count, "double"),
                     *margin < 0 ? "below" : "above");
}

}  // namespace touchstone::show
