// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/thesis/cell/browser/aristo.h"

#include "experiments/methods/registry.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/experiments/support/cells.h"

namespace touchstone::cell::browser {

const cell::Cell& aristo() {
  static const cell::Cell cell = cell::read_cell(run_tests::kAristo);
  return cell;
}

const Simulator& simulator() {
  static const Simulator simulator(aristo(), {.methods = methods::find_methods({"filtered", "thesis"}), .rule = {}});
  return simulator;
}

const Recording& recording() {
  static const Recording recording = simulator().run(setting_of(aristo()));
  return recording;
}

}  // namespace touchstone::cell::browser
