// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/cases/method.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/simulation/process.h"

/// Layouts as cells, whose process is simulated by the thesis's rule: the sphere alone, from home by the storage to the
/// machine. With them `touchstone cell layout` computes the layouts that reproduce the captioned angles.
namespace touchstone::kinematics {

/// Simulates a layout in the Aristo's cell with the storage at a place; `drive` is that of cell::Rule. If the arm
/// cannot be simulated, the process has no moves and says why.
[[nodiscard]] cell::Process rehearse(const Layout& layout, const Station& storage,
                                     const cases::Method* drive = nullptr);
/// The same with the storage as in case 0 or 1.
[[nodiscard]] cell::Process rehearse_case(const Layout& layout, std::size_t number);

/// `base`, `shoulder` or `elbow`.
[[nodiscard]] std::string_view name_of(std::size_t joint);

/// Returns the moves of a case up to the machine, in order, by its captions.
[[nodiscard]] std::vector<std::pair<AristoJoint, int>> moves_of(const Captions& captions);
/// Returns how the captions of a case differ from a process up to the machine; empty if they agree to the degree.
[[nodiscard]] std::string difference(const cell::Process& process, const Captions& captions);

/// A home pose of the family and its layout.
struct Member {
  Linkage linkage;
  LinkAngles home;
  std::optional<Layout> layout;  ///< none if there is no solution
  std::string failure;           ///< why the captions are not reproduced; empty if they are
};

/// Solves the layout for a home pose, and runs both cases in it. Cost: about 20 ms.
[[nodiscard]] Member study_home(const Linkage& linkage, const LinkAngles& home);

/// The steps between home poses, in degrees: divisors of kHomeReach.
struct HomeSteps {
  int grid = 5, line = 1;
};

/// The leans and elevations of home poses go as far from 0, in degrees.
inline constexpr int kHomeReach = 60;

/// A value of a layout that is chosen freely.
struct Parameter {
  const char *name, *unit;
  std::function<std::vector<double*>(Layout&)> of;  ///< one place, or two that hold the same

  [[nodiscard]] double value(Layout layout) const { return *of(layout).front(); }
  [[nodiscard]] Layout moved(Layout layout, double by) const {
    for (double* each : of(layout)) *each += by;
    return layout;
  }
};
[[nodiscard]] const std::array<Parameter, 13>& parameters();

/// Returns by how much a value may be moved alone, up (direction 1) or down (-1), while `holds` is true: found by
/// doubling the change up to 128, then by bisection to `precision`. Requires a layout that holds.
[[nodiscard]] double furthest(const Layout& layout, const Parameter& parameter, double direction, double precision,
                              const std::function<bool(const Layout&)>& holds);

/// A chosen value, and the range in which it may vary alone while the captions of both cases are reproduced.
struct Choice {
  std::string name, unit;
  double value, lowest, highest;
};

struct LayoutStudy {
  std::vector<Member> grid;  ///< leans and elevations by HomeSteps::grid
  std::vector<Member>
      one_height;  ///< elevations by HomeSteps::line: those with one height of the storage in both cases
  Layout chosen;
  std::vector<cell::Process> cases;  ///< in the chosen layout
  std::vector<Choice> choices;       ///< of all parameters
};

/// Receives how much of `layout_work` is done.
using LayoutProgress = std::function<void(std::uint64_t done)>;
[[nodiscard]] std::uint64_t layout_work(HomeSteps steps);

/// Runs the study. Returns nothing if it was stopped. Cost: about 20 s, with steps of 30 and 15 degrees 1 s.
[[nodiscard]] std::optional<LayoutStudy> study_layout(HomeSteps steps, const std::atomic<bool>& stop,
                                                      const LayoutProgress& progress);

}  // namespace touchstone::kinematics
