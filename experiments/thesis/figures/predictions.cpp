// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/predictions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/methods/registry.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;
using cell::Phase;

/// The place at an angle on the straight line, in angle and radius, through the places of both cases.
Station between(const Layout& layout, double angle) {
  Station station = layout.storage(0, angle);
  const double share = (kCases[0].storage_angle - angle) / (kCases[0].storage_angle - kCases[1].storage_angle);
  station.radius += share * (layout.storage_radius[1] - layout.storage_radius[0]);
  return station;
}

/// Where a joint, while the others are at these commands, brings the sphere to the material in storage, by trigonometry
/// in the plane of the arm. The base turns it against the near side, the shoulder lowers it onto that side's edge.
double derived_contact(const Layout& layout, const Station& storage, cell::Moved joint, SphereArm::Commands at) {
  const auto half_chord = [r = layout.sphere_radius](double away) { return std::sqrt(r * r - away * away); };
  if (joint == cell::kShoulder) at.shoulder = 0;
  const Reach reach = SphereArm(layout).reach(at);
  const double above = reach.up - storage.height - layout.side;  // the centre, above the upper face
  if (joint == cell::kBase)
    return storage.azimuth + workloads::arc_sine((half_chord(std::max(0.0, above)) - layout.gap) / reach.out);
  const double way = above - half_chord(layout.gap);
  return workloads::arc_cosine(workloads::cosine(layout.home.lean) - way / kUpperArm) - layout.home.lean;
}

Prediction predict_at(const Layout& layout, std::string_view line, double angle, const Station& storage, bool fitted) {
  const cell::Process process = rehearse(layout, storage, methods::find_method("thesis"));
  Prediction result{line, angle, storage.radius, fitted, process.failure, {}, {}, {}, {}, {}, {}, 0};
  if (process.cause) return result;
  result.found = implied(process);
  const double elbow = result.elbow_at_storage.emplace(process.turned(cell::kElbow, Phase::ToStorage));
  const double shoulder = result.shoulder_at_storage.emplace(process.turned(cell::kShoulder, Phase::ToStorage));
  for (const cell::Move& move : process.moves) {
    result.wrong_stops += move.wrong.has_value();
    if (move.until != cell::Until::Contact || move.phase != Phase::ToStorage) continue;
    result.contact_joint = name_of(move.joint);
    result.contact = process.turned(move.joint, Phase::ToStorage) - move.degrees + move.exact;
    result.derived = derived_contact(layout, storage, move.joint, {shoulder, elbow});
  }
  return result;
}

}  // namespace

Implied implied(double angle) { return {kStorageHome + angle, kMachineAzimuth - kStorageHome - angle, 35, 28}; }

Implied implied(const cell::Process& process) {
  return {process.turned(cell::kBase, Phase::ToStorage), process.turned(cell::kBase, Phase::ToMachine),
          process.net(cell::kElbow), process.net(cell::kShoulder)};
}

std::vector<Prediction> predict(const Layout& layout) {
  std::vector<Prediction> all;
  for (std::size_t i = 0; i < kCases.size(); ++i)
    for (int angle = -60; angle <= 60; ++angle)
      all.push_back(predict_at(layout, i == 0 ? "case 1" : "case 2", angle, layout.storage(i, angle),
                               angle == kCases[i].storage_angle));
  for (double angle = kCases[1].storage_angle + 1; angle < kCases[0].storage_angle; ++angle)
    all.push_back(predict_at(layout, "between", angle, between(layout, angle), false));
  return all;
}

Sensitivity sensitivity(const Layout& layout, const Parameter& parameter) {
  const auto changes = [](const Layout& moved) {
    for (const double angle : {0.0, -16.0}) {  // from the side, from above
      const cell::Process process = rehearse(moved, between(moved, angle));
      if (process.cause) return std::string("the process fails");
      std::vector<std::string_view> names;
      for (std::size_t i = 0; i < kImplied.size(); ++i)
        if (implied(process)[i] != implied(angle)[i]) names.push_back(kImplied[i]);
      if (!names.empty()) return fmt::format("{}", fmt::join(names, ", "));
    }
    return std::string();
  };
  constexpr double kPrecision = 0.01;
  Sensitivity result{parameter.name, parameter.unit, parameter.value(layout), {}, {}, "", ""};
  for (const double direction : {-1.0, 1.0}) {
    const double by =
        furthest(layout, parameter, direction, kPrecision, [&](const Layout& moved) { return changes(moved).empty(); });
    auto& beyond = direction < 0 ? result.below : result.above;
    beyond = changes(parameter.moved(layout, by + direction * kPrecision));
    if (!beyond.empty()) (direction < 0 ? result.lowest : result.highest) = result.value + by;
  }
  return result;
}

const program::Table<Prediction>& predictions_csv() {
  static const program::Table<Prediction> table = [] {
    std::vector<program::Column<Prediction>> columns{
        {"line", "at the radius of `case 1` or `case 2`, or `between` both", &Prediction::line},
        {"angle_deg", "of the storage", &Prediction::angle},
        {"radius_mm", "of the storage, from the robot's axis", &Prediction::radius, "{:.3f}"},
        {"basis", "`fitted`: the layout was solved for the captions of this place; else `predicted`",
         [](const Prediction& row) { return row.fitted ? "fitted" : "predicted"; }},
        {"elbow_at_storage_deg", "from home; not implied", &Prediction::elbow_at_storage},
        {"shoulder_at_storage_deg", "from home; not implied", &Prediction::shoulder_at_storage},
        {"contact_joint", "that moves until contact in the storage", &Prediction::contact_joint},
        {"contact_deg", "its certified first contact, from home", &Prediction::contact, "{:.9f}"},
        {"contact_derived_deg", "the same by trigonometry", &Prediction::derived, "{:.9f}"},
        {"wrong_stops", "stops of the thesis's method where the exact answer would not stop", &Prediction::wrong_stops},
        {"failure", "why the process ends early", &Prediction::failure}};
    for (std::size_t i = 0; i < kImplied.size(); ++i) {
      columns.emplace_back(fmt::format("{}_deg", kImplied[i]), "what the robot does", [i](const Prediction& row) {
        return row.found ? std::optional((*row.found)[i]) : std::nullopt;
      });
      columns.emplace_back(fmt::format("{}_implied_deg", kImplied[i]), "what the captions imply",
                           [i](const Prediction& row) { return implied(row.angle)[i]; });
    }
    return program::Table<Prediction>("predictions.csv", "a place of the storage", std::move(columns));
  }();
  return table;
}

const program::Table<Sensitivity>& sensitivity_csv() {
  static const program::Table<Sensitivity> table(
      "sensitivity.csv", "a chosen value of the layout, moved alone",
      {{"parameter", "the value", &Sensitivity::parameter},
       {"unit", "its unit", &Sensitivity::unit},
       {"value", "as chosen", &Sensitivity::value},
       {"lowest", "the least value with every implied angle, to 0.01; empty if none changes down to 128 less",
        &Sensitivity::lowest, "{:.2f}"},
       {"highest", "the greatest one, up to 128 more", &Sensitivity::highest, "{:.2f}"},
       {"below", "what changes below `lowest`", &Sensitivity::below},
       {"above", "what changes above `highest`", &Sensitivity::above}});
  return table;
}

}  // namespace touchstone::figures
