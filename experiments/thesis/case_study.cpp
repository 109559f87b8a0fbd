// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/case_study.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"
#include "geometry/contact/thesis.h"
#include "robust/filtered/filtered.h"

namespace touchstone::thesis_figures {
namespace {

using namespace kinematics;

/// A face with every method's view of it.
struct AskedFace {
  explicit AskedFace(const Polygon& polygon) : truth(polygon) {
    for (const std::string_view name : kMethods) prepared.push_back(methods::find_method(name)->prepare(polygon));
  }

  [[nodiscard]] bool contact(std::size_t method, const Ball& ball) const {
    return prepared[method]->ask(ball, cases::QueryKind::Contact).contact.value();
  }

  filtered::PreparedPolygon truth;
  std::vector<std::unique_ptr<cases::PreparedMethod>> prepared;
};

std::vector<AskedFace> asked(const std::vector<Polygon>& faces) {
  std::vector<AskedFace> all;
  for (const Polygon& face : faces) all.emplace_back(face);
  return all;
}

/// The face of `faces` that the ball is deepest in, as the exact answer has it.
std::size_t deepest(const std::vector<AskedFace>& faces, const Ball& ball) {
  std::size_t deepest = 0;
  const auto distance = [&](std::size_t i) { return filtered::answer(ball, faces[i].truth).distance; };
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (distance(i) < distance(deepest)) deepest = i;
  return deepest;
}

}  // namespace

std::string face_words(std::size_t face) {
  constexpr std::array<const char*, 6> words{"underside",
                                             "upper face",
                                             "side towards the base",
                                             "side away from the base",
                                             "clockwise side",
                                             "counter-clockwise side"};
  return words.at(face);
}

CaseStudy study_case(const Layout& layout, std::size_t number) {
  CaseStudy study{layout.storage(number, kCases.at(number).storage_angle), {}, {}, {}};
  study.path = simulate(layout, study.storage);
  const Chain chain = aristo(layout.coupling);
  Angles angles = home_pose(layout);
  bool gripped = false;
  const auto remember = [&](const std::string& name) {
    study.moments.push_back(
        {fmt::format("case {}, {}", number + 1, name), angles, gripped, chain.place(angles, sphere_center(layout))});
  };
  remember("home");
  const auto in_storage = asked(material_in_storage(layout, study.storage));
  const auto at_machine = asked(material_at_machine(layout));

  for (std::size_t i = 0; i < study.path.moves.size(); ++i) {
    const Move& move = study.path.moves[i];
    const int sign = move.degrees < 0 ? -1 : 1;
    const auto ball_at = [&](double degrees) {
      Angles there = angles;
      there[move.joint] += sign * degrees;
      return Ball{chain.place(there, sphere_center(layout)), layout.sphere_radius};
    };
    const int length = std::abs(move.degrees);
    for (int degrees = 1; degrees <= length; ++degrees) {
      const Ball ball = ball_at(degrees);
      for (const auto* faces : {&in_storage, &at_machine}) {
        if (gripped && faces == &in_storage) continue;
        for (const AskedFace& face : *faces) {
          const bool touches = filtered::contact(ball, face.truth);
          ++study.asked;
          for (std::size_t m = 0; m < kMethods.size(); ++m) study.wrong[m] += face.contact(m, ball) != touches;
        }
      }
    }
    if (move.until == Until::Contact) {
      const auto& faces = gripped ? at_machine : in_storage;
      const Ball at = ball_at(length), before = ball_at(length - 1);
      const std::size_t face = deepest(faces, at);
      const auto by_thesis = [&](const Ball& ball) {
        return std::ranges::any_of(faces, [&](const AskedFace& asked) { return asked.contact(0, ball); });
      };
      study.stops.push_back({i, face, filtered::answer(at, faces[face].truth),
                             filtered::answer(before, faces[face].truth), at.center,
                             ball_at(std::abs(move.exact)).center, before.center, by_thesis(at), by_thesis(before)});
      gripped = true;
    }
    angles[move.joint] += move.degrees;
    remember(fmt::format("move {}", i + 1));
  }
  return study;
}

}  // namespace touchstone::thesis_figures
