// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/triggers_output.h"

#include <fmt/core.h>

#include <optional>
#include <vector>

#include "experiments/thesis/cell/simulation/cycle_time.h"

namespace touchstone::cell {
namespace {

struct Row {
  const Trigger* trigger;
  const Zone* zone;
  std::optional<double> seconds;
};

run::Table<Row> triggers_csv() {
  using run::path;
  const auto place = [](int i) { return [i](const Row& row) { return row.trigger->at[i]; }; };
  return {"triggers.csv",
          "something that comes into a virtual object",
          {{"zone", "the virtual object", path(&Row::zone, &Zone::name)},
           {"mover", "arm, held material or sphere", path(&Row::trigger, &Trigger::mover)},
           {"part", "the part of the mover that comes in first", path(&Row::trigger, &Trigger::part)},
           {"after_stop", "it comes in after this stop,", path(&Row::trigger, &Trigger::after)},
           {"degrees", "the degrees from there on the way to the next one", path(&Row::trigger, &Trigger::degrees),
            "{:.6f}"},
           {"until_stop", "from this stop on it is outside, or the run ends", path(&Row::trigger, &Trigger::until)},
           {"seconds", "when it comes in, with every joint at its greatest speed", &Row::seconds, "{:.4f}"},
           {"x", "the first coordinate of the sphere's centre then", place(0), "{:.6f}"},
           {"y", "the second one", place(1), "{:.6f}"},
           {"z", "the third one", place(2), "{:.6f}"},
           {"stops", "1 if the robot stops there", [](const Row& row) { return row.zone->stops ? 1 : 0; }}}};
}

std::vector<Row> rows_of(const Workcell& workcell, const Process& process) {
  const std::vector<double> times = times_of(workcell.arm(), process);
  std::vector<Row> rows;
  for (const Trigger& trigger : process.triggers) {
    Row row{&trigger, &workcell.cell().zones[trigger.zone], {}};
    if (!times.empty()) {
      row.seconds = times[trigger.after];
      if (trigger.after + 1 < process.stops.size()) {
        const Moved joint = step_between(process.stops[trigger.after], process.stops[trigger.after + 1]).joint;
        *row.seconds += seconds(workcell.arm(), joint, trigger.degrees).value();
      }
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string triggers_text(const Workcell& workcell, const Process& process) {
  if (workcell.cell().zones.empty()) return "";
  if (process.triggers.empty()) return "nothing comes into a virtual object\n";
  return triggers_csv().aligned(rows_of(workcell, process)) +
         "Virtual objects, and what comes into them; what is not listed is certainly outside, between the stops, "
         "too.\n";
}

void write_triggers(const std::filesystem::path& folder, const Workcell& workcell, const Process& process) {
  triggers_csv().write(folder, rows_of(workcell, process));
}

run::TableDescription triggers_table() { return triggers_csv().description(); }

}  // namespace touchstone::cell
