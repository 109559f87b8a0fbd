// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/show/case_view.h"

#include <fmt/core.h>

#include <exception>

#include "experiments/cases/workloads/ulp.h"
#include "experiments/run/numbers.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"

namespace touchstone::show {
namespace {

std::string doubles(std::int64_t count) {
  if (count > 1'000'000) return "over a million doubles";
  return run::counted(static_cast<std::uint64_t>(count), "double");
}

}  // namespace

CaseView view_of(const std::string& id, const std::vector<std::string>& tags, const cases::Shapes& shapes) {
  const exact::PreparedPolygon polygon(shapes.polygon);
  const Answer answer = exact::answer(shapes.ball, polygon);
  const auto motion = shapes.motion();
  auto truth = motion ? cases::PartialAnswer::of(exact::first_contact(*motion, polygon), answer.off_plane, "")
                      : cases::PartialAnswer::of(answer, "");
  return {id, tags, shapes, std::move(truth), radii_around(shapes), {}};
}

Verdict verdict_of(const CaseView& view, const cases::Method& method) {
  Verdict verdict{std::string(method.name()), {}, {}, {}};
  const auto ask = [&](const cases::PreparedMethod& prepared, const Ball& ball) {
    return view.shapes.to ? prepared.ask_moving(Motion{ball, *view.shapes.to})
                          : std::optional(prepared.ask(ball, cases::QueryKind::Answer));
  };
  try {
    const auto prepared = method.prepare(view.shapes.polygon);
    const auto answer = ask(*prepared, view.shapes.ball);
    if (!answer) {
      verdict.fault = "cannot answer about moving balls";
      return verdict;
    }
    verdict.answer = cases::stated(*answer);
    for (std::size_t i = 0; i < view.radii.offsets.size(); ++i)
      verdict.contact.push_back(ask(*prepared, {view.shapes.ball.center, view.radii.radius(view.shapes, i)})
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
  if (workloads::move_radius_by_doubles(view.shapes.ball.radius, -*margin) == 0)
    return "Even a point there touches, so every ball does.";
  if (*margin < 0)
    return fmt::format("The ball does not touch: its radius is {} below the least one that does.", doubles(-*margin));
  if (*margin == 0) return "The ball touches: its radius is the least double that does.";
  return fmt::format("The ball touches: its radius is {} above the least one that does.", doubles(*margin));
}

}  // namespace touchstone::show
