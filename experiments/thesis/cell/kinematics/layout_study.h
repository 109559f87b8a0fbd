// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/simulation/process.h"

/// Layouts as cells, whose process is simulated by the thesis's rule: the sphere alone, from home by the storage to the
/// machine.
namespace touchstone::kinematics {

/// Returns the cell with the joints' couplings and home, the sphere, the material, its slots and the places of the
/// stations as in a layout. Requires a cell of the Aristo's joints. Bodies of gripper and stations stay as they are.
[[nodiscard]] cell::Cell laid_out(cell::Cell cell, const Layout& layout, const Station& storage);

/// Simulates a layout in the Aristo's cell with the storage at a place. If the arm cannot be simulated, the process has
/// no moves and says why.
[[nodiscard]] cell::Process rehearse(const Layout& layout, const Station& storage);
/// The same with the storage as in case 0 or 1.
[[nodiscard]] cell::Process rehearse_case(const Layout& layout, std::size_t number);

/// `base`, `shoulder` or `elbow`.
[[nodiscard]] std::string_view name_of(std::size_t joint);

/// Returns the moves of a case up to the machine, in order, by its captions.
[[nodiscard]] std::vector<std::pair<AristoJoint, int>> moves_of(const Captions& captions);
/// Returns how the captions of a case differ from a process up to the machine; empty if they agree to the degree.
[[nodiscard]] std::string difference(const cell::Process& process, const Captions& captions);

}  // namespace touchstone::kinematics

/// The computations of `touchstone cell layout`: the layouts that reproduce the captioned angles, the chosen layout,
/// and its predictions.
namespace touchstone::kinematics {

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
/// Returns how many values of a layout are chosen freely: those that LayoutStudy::choices lists.
[[nodiscard]] std::size_t free_parameters();

/// A chosen value, and the range in which it may vary alone while the captions of both cases are reproduced.
struct Choice {
  std::string name, unit;
  double value, lowest, highest;
};

/// Counts of processes up to the machine, by the sphere alone, that keep what the captions imply for every angle of the
/// storage.
struct Predictions {
  std::uint64_t places = 0;
  std::uint64_t to_storage = 0;  ///< the base turned by 150 degrees less the storage's angle, clockwise
  std::uint64_t to_machine = 0;  ///< and then by 67 less the angle, counter-clockwise
  std::uint64_t net = 0;         ///< elbow and shoulder were at +35 and +28 at the machine
  std::uint64_t all = 0;         ///< all three

  /// Takes the process of a storage at an angle.
  void take(double angle, const cell::Process& path);
};

struct LayoutStudy {
  std::vector<Member> grid;  ///< leans and elevations by HomeSteps::grid
  std::vector<Member>
      one_height;  ///< elevations by HomeSteps::line: those with one height of the storage in both cases
  Layout chosen;
  std::vector<cell::Process> cases;  ///< in the chosen layout
  std::vector<Choice> choices;
  Predictions predictions;  ///< for every whole angle from -60 to 60, in both cases' places
};

/// Receives how much of `layout_work` is done.
using LayoutProgress = std::function<void(std::uint64_t done)>;
[[nodiscard]] std::uint64_t layout_work(HomeSteps steps);

/// Runs the study. Returns nothing if it was stopped. Cost: about 20 s, with steps of 30 and 15 degrees 1 s.
[[nodiscard]] std::optional<LayoutStudy> study_layout(HomeSteps steps, const std::atomic<bool>& stop,
                                                      const LayoutProgress& progress);

}  // namespace touchstone::kinematics
