// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/timing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::cell {

std::optional<Pace> pace_of(const Arm& arm, const Step& step) {
  const kinematics::Angles before = arm.chain.turns(arm.home),
                           after = arm.chain.turns(step.after(arm.home, std::abs(step.degrees)));
  Pace pace{0, 0};
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (after[i] == before[i]) continue;
    if (!(arm.speeds[i] > 0)) return std::nullopt;
    pace.seconds = std::max(pace.seconds, std::abs(after[i] - before[i]) / arm.speeds[i]);
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    if (after[i] != before[i] && arm.accelerations[i] > 0)
      pace.ramp = std::max(pace.ramp, std::abs(after[i] - before[i]) / pace.seconds / arm.accelerations[i]);
  return pace;
}

/// Without braking.
double SpeedProfile::speeding(double part) const {
  return part < ramp / 2 ? std::sqrt(2 * ramp * part) : part + ramp / 2;
}

double SpeedProfile::seconds(double part) const {
  const double braking = std::min(way, ramp) / 2;
  return part <= way - braking ? speeding(part) : seconds() - speeding(way - part);
}

Timing::Timing(const Workcell& workcell, const Process& process) {
  const auto accelerates = [](double acceleration) { return acceleration > 0; };
  accelerates_ = std::ranges::any_of(workcell.arm().accelerations, accelerates);
  all_do_ = std::ranges::all_of(workcell.arm().accelerations, accelerates);
  take_paces(workcell.arm(), process);
  take_waits(workcell.cell(), process);
  if (!std::ranges::all_of(moves_, &MoveTime::known)) return;
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    MoveTime& move = moves_[stops_[i].move];
    if (i > 0 && (i == 1 || stops_[i].move != stops_[i - 1].move)) move.begins = arrivals_.back() + waits_[i - 1];
    arrivals_.push_back(move.begins + move.profile.seconds(stops_[i].way));
  }
}

void Timing::take_paces(const Arm& arm, const Process& process) {
  moves_.resize(process.moves.size());
  for (std::size_t i = 0; i < process.stops.size(); ++i) {
    stops_.push_back({process.stops[i].move});
    if (stops_[i].move >= moves_.size()) moves_.resize(stops_[i].move + 1);
    if (i == 0) continue;
    const Step step = step_between(process.stops[i - 1], process.stops[i]);
    MoveTime& move = moves_[stops_[i].move];
    const auto pace = pace_of(arm, step);
    move.known = move.known && pace;
    if (!pace) continue;
    move.profile.way += pace->seconds;
    move.profile.ramp = std::max(move.profile.ramp, pace->ramp);
    stops_[i].way = move.profile.way;
    stops_[i].degrees = std::abs(step.degrees);
  }
}

void Timing::take_waits(const Cell& cell, const Process& process) {
  waits_.resize(process.stops.size());
  const auto wait = [&](std::size_t stop, double seconds, double& sum) { waits_[stop] += seconds, sum += seconds; };
  for (std::size_t i = 1; i < process.transfers.size(); ++i)
    if (const MaterialTransfer& transfer = process.transfers[i]; transfer.slot)
      wait(transfer.stop, cell.gripper.release_seconds, releasing_);
    else
      wait(transfer.stop, cell.gripper.grip_seconds, gripping_);
  const auto to_piece = std::ranges::find(process.moves, Phase::ToPiece, &Move::phase);
  const auto number = static_cast<std::size_t>(to_piece - process.moves.begin());
  const auto first = std::ranges::find(process.stops, number, &Stop::move);
  if (to_piece != process.moves.end() && first != process.stops.begin())
    wait(static_cast<std::size_t>(first - process.stops.begin()) - 1, cell.material.milling_seconds, milling_);
}

std::optional<double> Timing::move(std::size_t number) const {
  if (!moves_[number].known) return std::nullopt;
  return moves_[number].profile.seconds();
}

std::optional<double> Timing::after(std::size_t stop, double degrees) const {
  if (arrivals_.empty()) return std::nullopt;
  if (degrees == 0 || stop + 1 == stops_.size()) return arrivals_[stop];
  const Arrival &from = stops_[stop], &to = stops_[stop + 1];
  const double begun = from.move == to.move ? from.way : 0;
  const double part = begun + (to.way - begun) * std::abs(degrees / to.degrees);
  return moves_[to.move].begins + moves_[to.move].profile.seconds(part);
}

std::optional<double> Timing::cycle() const {
  if (arrivals_.empty()) return std::nullopt;
  return arrivals_.back() + waits_.back();
}

std::string Timing::text() const {
  const auto whole = cycle();
  if (!whole)
    return stops_.empty() ? "no cycle time: no stops" : "no cycle time: the greatest speed of a joint is unknown";
  std::string text = fmt::format("cycle time {:.2f} s: ", *whole), without;
  text += !accelerates_ ? "every turn as fast as its joints allow"
                        : "every move from rest to rest as fast as the speeds and accelerations of its joints allow";
  if (accelerates_ && !all_do_) text += "; a joint without a stated acceleration has its speed at once";
  for (const auto& [what, seconds] :
       {std::pair("gripping", gripping_), std::pair("releasing", releasing_), std::pair("milling", milling_)})
    if (seconds > 0)
      text += fmt::format("; {} {:g} s", what, seconds);
    else
      without += fmt::format("{}{}", without.empty() ? "; without " : ", ", what);
  return text + without;
}

}  // namespace touchstone::cell
