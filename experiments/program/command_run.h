// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/program/command.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/program.h"

namespace touchstone::program {

/// The options of every command that writes a folder.
struct FolderOptions {
  std::string output;
  bool force = false, no_pictures = false, quiet = false;
  bool needs_folder = false;  ///< whether there is no run without a folder; set by declare_output
  Call call;                  ///< set by the command before it runs
};

/// Declares --output and --force, and --no-pictures if the command draws any. `about`: the meaning of the folder. A
/// command whose folder has a default does not run without one.
void declare_output(Command& command, FolderOptions& options, const std::string& about, bool has_pictures = false);

/// Draws the data of a folder by experiments/report/studies/<name>.py, with the first Python interpreter that has the
/// required packages: that of Debian, else the one on the path. Returns the exit status of a study: 0, or 1 if not all
/// pictures could be drawn; standard error then says why. Throws as data() does.
[[nodiscard]] int draw_pictures(const std::string& name, const OutputFolder& folder);

/// The facts that run.json records about a run besides the compiler, the flags, the commit, the machine and the date.
struct Run {
  std::string command{};
  std::uint64_t seed = 0;
  std::uint64_t samples_asked = 0, samples_done = 0, samples_missing = 0;
  unsigned threads = 1;
  double seconds = 0;                 ///< of a merge, its own
  std::string part{};                 ///< I/N, if the run was a part of a study
  std::uint64_t parts = 1;            ///< that were merged; 1: none
  std::optional<bool> interrupted{};  ///< only for studies that report it
};

/// Writes run.json. Throws std::runtime_error if it cannot be written.
void write_run_record(const std::filesystem::path& folder, const Run& run);

/// One run of a command that writes a folder: its lock, its time, the request to stop, and its end.
class CommandRun {
 public:
  /// Locks the folder, if one is named or needed. Throws as OutputFolder does.
  explicit CommandRun(const FolderOptions& options);

  [[nodiscard]] bool has_folder() const { return held_.has_value(); }
  /// Requires has_folder().
  [[nodiscard]] const std::filesystem::path& folder() const { return held_->path(); }
  /// Becomes true when the run is asked to stop. From the first call on, the run stops itself: see StopSignal.
  [[nodiscard]] const std::atomic<bool>& stop();
  [[nodiscard]] bool stopped() const { return stop_signal_ && stop_signal_->requested(); }
  /// Returns the seconds since this run began.
  [[nodiscard]] double seconds() const;
  /// Returns a line of progress, unless the run is quiet.
  [[nodiscard]] ProgressLine progress(const std::string& what, std::uint64_t total) const;

  /// Writes run.json with the command line and the seconds. Requires has_folder(). Throws as write_run_record does.
  void write_record(Run record) const;
  /// Draws the pictures of the folder, unless the command line forbids that. Returns the exit status, as draw_pictures
  /// does. Requires has_folder().
  [[nodiscard]] int draw(const std::string& script) const;
  /// Writes run.json, prints the text and draws the pictures, if a script is named.
  /// Returns the exit status of `draw`.
  int finish(Run record, const std::string& text, const std::string& script = "") const;
  /// Reports an interrupted run that writes nothing. Returns its exit status.
  [[nodiscard]] static int finish_unwritten();

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const FolderOptions& options_;
  std::optional<OutputFolder> held_;
  std::optional<StopSignal> stop_signal_;
};

}  // namespace touchstone::program
