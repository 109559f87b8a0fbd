// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/run/command.h"
#include "experiments/run/output_folder.h"
#include "experiments/run/printing.h"
#include "experiments/run/processes.h"
#include "experiments/run/run_control.h"
#include "experiments/run/stop_signal.h"

namespace touchstone::run {

/// The options of every study that draws samples.
struct StudyOptions : Printing {
  std::uint64_t samples = 1;
  std::uint64_t seed = 1;
  unsigned threads = all_threads();  ///< of each process
  std::string output;
  bool force = false, resume = false, no_pictures = false;
  bool has_pictures = true;  ///< whether the study draws pictures at all

  // Set by the command before it runs.
  std::string line;  ///< repeats the run
  std::function<std::vector<std::pair<std::string, std::string>>()> result_options;
};

/// The largest number of samples of a study: products with the numbers of families, placements and the like do not
/// overflow.
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 40;

/// Declares these options, after those of the study itself. `samples`: the name and the meaning of the number of
/// samples.
void declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about);

/// One run of a study by all processes: its folder, its phases and its end. Only the first process writes and prints.
class StudyRun {
 public:
  /// Locks the folder of the results at the first process. `study`: the name of the command. `version`: see
  /// ResultSettings. Throws as OutputFolder does.
  StudyRun(std::string study, int version, const StudyOptions& options, const Processes& processes);

  [[nodiscard]] const Processes& processes() const { return processes_; }
  [[nodiscard]] bool first() const { return processes_.first(); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Returns whether any process was stopped, as far as phases have told, or this one was.
  [[nodiscard]] bool stopped() const { return stopped_ || stop_signal_.requested(); }
  /// Returns the seconds since this run began.
  [[nodiscard]] double seconds() const;

  /// Runs a phase that a checkpoint continues. All processes must call each phase, in the same order: run(control,
  /// state) processes the items from items_done(state) on, of `items`. Returns the state at the end. `what`: the items,
  /// for the line of progress. Throws as Checkpoint does.
  template <class State, class Run>
  State phase(const std::string& what, const std::string& checkpoint, std::uint64_t items, State zero, const Run& run) {
    const Checkpoint file(folder_ / checkpoint, {version_, options_.result_options()});
    State state = begin(file, processes_, options_.resume, items, std::move(zero));
    ProgressLine line(study_ + ": " + what, items, items_done(state), !options_.quiet);
    run(run_control<State>(processes_, stop_signal_.requested(), line, file), state);
    share_stop();
    return state;
  }
  /// Throws as that phase would when it begins, if it cannot continue its checkpoint. For phases that come late.
  template <class State>
  void require_resumable(const std::string& checkpoint, std::uint64_t items, State zero) const {
    if (!first() || !options_.resume) return;
    const Checkpoint file(folder_ / checkpoint, {version_, options_.result_options()});
    if (const auto held = file.read(std::move(zero))) file.refuse_more(items_done(*held), items);
  }
  /// Runs a short phase without a checkpoint: run(control). Returns its result.
  template <class State, class Run>
  auto phase(const std::string& what, std::uint64_t items, const Run& run) {
    ProgressLine line(study_ + ": " + what, items, 0, !options_.quiet);
    const auto result =
        run(RunControl<State>{processes_, stop_signal_.requested(), [&line](std::uint64_t done) { line(done); }});
    share_stop();
    return result;
  }

  /// Removes the files of an earlier run whose names begin so, because they would belong to other data.
  void remove_files(const std::vector<std::string>& beginnings) const;

  /// The end of a run.
  struct End {
    std::uint64_t done = 0, missing = 0;  ///< samples
    std::string text;                     ///< tables and sentences for standard output
    int status = 0;                       ///< the exit status of a complete run
    bool pictures = true;                 ///< whether a complete run has pictures
  };
  /// Writes run.json, prints the text, the time and the folder, or with --json the tables, or with --quiet nothing;
  /// reports an interruption and draws the pictures. Returns the exit status: that of the study or, if that is 0, that
  /// of draw_pictures.
  int finish(const End& end);

 private:
  /// Tells all processes whether one of them was stopped.
  void share_stop() { stopped_ = processes_.largest(stopped() ? 1 : 0) > 0; }

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::string study_;
  int version_;
  const StudyOptions& options_;
  const Processes& processes_;
  std::filesystem::path folder_;
  std::optional<OutputFolder> held_;  ///< by the first process
  StopSignal stop_signal_;
  bool stopped_ = false;
};

/// Returns the function of a command that runs a study in all processes; run(StudyRun&) returns the exit status.
template <class Run>
std::function<int()> study_runner(std::string study, int version, const StudyOptions& options, Run run) {
  return [study = std::move(study), version, &options, run = std::move(run)] {
    return run_together([&](const Processes& processes) {
      StudyRun study_run(study, version, options, processes);
      return run(study_run);
    });
  };
}

}  // namespace touchstone::run
