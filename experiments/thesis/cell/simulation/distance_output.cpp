// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/distance_output.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/timing.h"

namespace touchstone::cell {
namespace {

struct LeastRow {
  const LeastDistance* least;
  std::optional<double> seconds;
};

program::Table<LeastRow> separation_csv() {
  using program::path;
  return {"separation.csv",
          "a thing that moves, and one that stands",
          {{"mover", "arm, held material or sphere", path(&LeastRow::least, &LeastDistance::mover)},
           {"element", "the part that stands, or material that lies there",
            path(&LeastRow::least, &LeastDistance::element)},
           {"least_low", "their least distance on the run: a proved lower bound",
            [](const LeastRow& row) { return row.least->bounds.lower; }, "{:.6f}"},
           {"least_high", "the distance that is attained", [](const LeastRow& row) { return row.least->bounds.upper; },
            "{:.6f}"},
           {"part", "the part of the mover that attains it", path(&LeastRow::least, &LeastDistance::part)},
           {"stop", "it is attained after this stop,", path(&LeastRow::least, &LeastDistance::stop)},
           {"degrees", "the degrees from there on the way to the next one",
            path(&LeastRow::least, &LeastDistance::degrees), "{:.6f}"},
           {"seconds", "when that is, each move as fast as its joints allow", &LeastRow::seconds, "{:.4f}"}}};
}

std::vector<LeastRow> least_rows(const Workcell& workcell, const Process& process, const Separation& separation) {
  const Timing timing(workcell, process);
  std::vector<LeastRow> rows;
  for (const LeastDistance& least : separation.least) rows.push_back({&least, timing.after(least.stop, least.degrees)});
  return rows;
}

struct TriggerRow {
  const Trigger* trigger;
  const Zone* zone;
  std::optional<double> seconds;
};

program::Table<TriggerRow> triggers_csv() {
  using program::path;
  const auto place = [](int i) { return [i](const TriggerRow& row) { return row.trigger->at[i]; }; };
  return {
      "triggers.csv",
      "something that comes into a virtual object",
      {{"zone", "the virtual object", path(&TriggerRow::zone, &Zone::name)},
       {"mover", "arm, held material or sphere", path(&TriggerRow::trigger, &Trigger::mover)},
       {"part", "the part of the mover that comes in first", path(&TriggerRow::trigger, &Trigger::part)},
       {"after_stop", "it comes in after this stop,", path(&TriggerRow::trigger, &Trigger::after)},
       {"degrees", "the degrees from there on the way to the next one", path(&TriggerRow::trigger, &Trigger::degrees),
        "{:.6f}"},
       {"until_stop", "from this stop on it is outside, or the run ends", path(&TriggerRow::trigger, &Trigger::until)},
       {"seconds", "when it comes in, each move as fast as its joints allow", &TriggerRow::seconds, "{:.4f}"},
       {"x", "the first coordinate of the sphere's centre then", place(0), "{:.6f}"},
       {"y", "the second one", place(1), "{:.6f}"},
       {"z", "the third one", place(2), "{:.6f}"},
       {"stops", "1 if the robot stops there", [](const TriggerRow& row) { return row.zone->stops ? 1 : 0; }}}};
}

std::vector<TriggerRow> trigger_rows(const Workcell& workcell, const Process& process) {
  const Timing timing(workcell, process);
  std::vector<TriggerRow> rows;
  for (const Trigger& trigger : process.triggers)
    rows.push_back({&trigger, &workcell.cell().zones[trigger.zone], timing.after(trigger.after, trigger.degrees)});
  return rows;
}

}  // namespace

std::string separation_text(const Workcell& workcell, const Process& process, const Separation& separation) {
  if (process.stops.empty()) return "";
  double gap = 0;
  for (const LeastDistance& least : separation.least) gap = std::max(gap, least.bounds.upper - least.bounds.lower);
  std::string text = separation_csv().aligned(least_rows(workcell, process, separation));
  text += fmt::format(
      "Least distances in {}: at least least_low on the whole run, between the stops, too; least_high is attained. "
      "They differ by at most {:.2g}.\n",
      workcell.cell().unit.name, gap);
  return text + Timing(workcell, process).text() + "\n";
}

void write_separation(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
                      const Separation& separation) {
  separation_csv().write(folder, least_rows(workcell, process, separation));
}

program::TableDescription separation_table() { return separation_csv().description(); }

std::string triggers_text(const Workcell& workcell, const Process& process) {
  if (workcell.cell().zones.empty()) return "";
  if (process.triggers.empty()) return "nothing comes into a virtual object\n";
  return triggers_csv().aligned(trigger_rows(workcell, process)) +
         "Virtual objects, and what comes into them; what is not listed is certainly outside, between the stops, "
         "too.\n";
}

void write_triggers(const std::filesystem::path& folder, const Workcell& workcell, const Process& process) {
  triggers_csv().write(folder, trigger_rows(workcell, process));
}

program::TableDescription triggers_table() { return triggers_csv().description(); }

}  // namespace touchstone::cell
