// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace touchstone::cell {
namespace {

constexpr std::array kRises{0.0, 1.0 / 8, 1.0 / 4, 3.0 / 8, -1.0 / 8};  // of the arm's reach, above the higher end
constexpr std::array kSharesOfReach{0.45, 0.6, 0.3, 0.75, 0.9};         // of that reach, from the base's axis

class Search {
 public:
  Search(const Workcell& workcell, const kinematics::Angles& from, const StretchTest& test)
      : arm_(workcell.arm()), plane_(workcell.plane()), from_(from), test_(test) {}

  /// True if these ends, one after the other, make a way, which `best` then is.
  bool take(std::vector<kinematics::Angles> ends) {
    if (!std::ranges::all_of(ends, [&](const kinematics::Angles& end) { return is_reachable(end); })) return false;
    kinematics::Angles at = from_;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool free = test_(at, ends[i]);
      at = ends[i];
      if (free) continue;
      if (i + 1 > best.ends.size()) best = {{ends.begin(), ends.begin() + static_cast<long>(i) + 1}};
      return false;
    }
    best = {std::move(ends), true};
    return true;
  }

  bool lift_turn_lower(const kinematics::Angles& to) {
    const double reach = plane_.furthest();
    const double high = std::max(arm_.sphere_at(from_).center.z(), arm_.sphere_at(to).center.z());
    for (const double rise : kRises)
      for (const double share : kSharesOfReach) {
        const auto commands = plane_.inverse({share * reach, high + rise * reach});
        if (!commands) continue;
        kinematics::Angles lifted = from_, turned = to;
        lifted[kShoulder] = turned[kShoulder] = commands->shoulder;
        lifted[kElbow] = turned[kElbow] = commands->elbow;
        if (take({lifted, turned, to})) return true;
      }
    return false;
  }

  Way best;

 private:
  [[nodiscard]] bool is_reachable(const kinematics::Angles& angles) const {
    try {
      arm_.chain.require_reachable(angles);
      return true;
    } catch (const std::out_of_range&) {
      return false;
    }
  }

  const Arm& arm_;
  const PlanarArm& plane_;
  const kinematics::Angles& from_;
  const StretchTest& test_;
};

}  // namespace

Way find_way(const Workcell& workcell, const kinematics::Angles& from, const kinematics::Angles& to,
             const StretchTest& test) {
  Search search(workcell, from, test);
  for (const double whole : {0.0, 360.0, -360.0}) {
    kinematics::Angles end = to, turned = from, stretched = to;
    end[kBase] = turned[kBase] = to[kBase] + whole;
    stretched[kBase] = from[kBase];
    if (search.take({end}) || search.take({turned, end}) || search.take({stretched, end})) break;
  }
  if (search.best.found) return search.best;
  for (const double whole : {0.0, 360.0, -360.0}) {
    kinematics::Angles end = to;
    end[kBase] += whole;
    if (search.lift_turn_lower(end)) break;
  }
  return search.best;
}

}  // namespace touchstone::cell
