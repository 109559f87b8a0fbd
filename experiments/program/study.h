// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/program/command_run.h"
#include "experiments/program/state.h"
#include "experiments/program/sweep.h"

namespace touchstone::program {

/// The options of every study.
struct StudyOptions : FolderOptions {
  std::uint64_t samples = 1;
  std::uint64_t seed = 1;
  unsigned threads = all_threads();
  std::string part;
  bool has_pictures = true;  ///< whether the study draws pictures at all
};

/// The largest number of samples of a study: products with the numbers of families, placements and the like do not
/// overflow.
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 40;

/// Declares these options, after those of the study itself. `samples`: the name and the meaning of the number of
/// samples. Returns the option of that name.
Option declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about);
/// Declares those of a study of given items: of threads, the folder and parts.
void declare_parts(Command& command, StudyOptions& options);
/// Declares --part alone.
Option declare_part(Command& command, StudyOptions& options);
/// Declares --part of a command whose parts nothing merges.
Option declare_part(Command& command, std::string& part, const std::string& about);

/// Everything that results depend on: the values of options by their names (without dashes), and a version. The version
/// is raised when sample n of a seed changes, or when the form or the meaning of a sum changes.
struct ResultSettings {
  int version;
  std::vector<std::pair<std::string, std::string>> options;
  std::string part;  ///< of how many items
};

/// The sum of a part, in a file that says what it is of. A sum is written as an Archive; a function items_done(sum) in
/// its namespace returns how many items it covers.
class PartFile {
 public:
  PartFile(std::filesystem::path path, ResultSettings settings)
      : path_(std::move(path)), settings_(std::move(settings)) {}

  /// Throws std::runtime_error, which names the file, if it cannot be written.
  template <class Sum>
  void write(const Sum& sum) const {
    write_text(archived(sum));
  }

  /// Returns the sum. Throws std::runtime_error, which names the file, if there is none, if it was damaged or edited,
  /// does not cover this many items, or is of another version or of other settings: it names those that differ.
  template <class Sum>
  [[nodiscard]] Sum read(Sum sum, std::uint64_t items) const {
    const std::string text = read_text();
    try {
      restore(text, sum);
    } catch (const DamagedArchive& error) {
      refuse(std::string("is damaged: ") + error.what());
    }
    if (items_done(sum) != items) refuse("does not hold all items of its part");
    return sum;
  }

 private:
  void write_text(const std::string& sum) const;
  [[nodiscard]] std::string read_text() const;
  [[noreturn]] void refuse(const std::string& why) const;

  std::filesystem::path path_;
  ResultSettings settings_;
};

/// One run of a study: its phases and its end.
///
/// A run of a part runs its share of each phase that has a file of parts, and writes nothing but these files and
/// run.json. A run that merges parts takes the sum of the parts' instead of running such a phase. So only whole runs and
/// merging ones have something to write, and run other phases.
class StudyRun : public CommandRun {
 public:
  /// Locks the folder of the results. `study`: the name of the command. `version`: see ResultSettings. Throws as
  /// OutputFolder does.
  StudyRun(std::string study, int version, const StudyOptions& options);

  /// Returns whether this is the run of a part.
  [[nodiscard]] bool is_part() const { return part_.has_value(); }

  /// Runs a phase of `items` that may be divided into parts: run(control, sum) adds those of the part. Returns the sum.
  /// `what`: the items, for the line of progress; `file`: that of a part. Requires that sums may be added in any order
  /// (see `add`), or in that of parts. Throws as PartFile does.
  template <class Sum, class Run>
  Sum phase(const std::string& what, const std::string& file, std::uint64_t items, Sum zero, const Run& run) {
    if (!options_.call.parts.empty()) return sum_of_parts(file, items, zero);
    Sum sum = std::move(zero);
    ProgressLine line = progress(study_ + ": " + what, share().size(items));
    run(RunControl{stop(), [&line](std::uint64_t done) { line(done); }, share()}, sum);
    if (is_part() && !stopped()) PartFile(folder() / file, settings(*part_, items)).write(sum);
    return sum;
  }
  /// Runs another phase: run(control). Returns its result.
  template <class Run>
  auto phase(const std::string& what, std::uint64_t items, const Run& run) {
    ProgressLine line = progress(study_ + ": " + what, items);
    return run(RunControl{stop(), [&line](std::uint64_t done) { line(done); }});
  }

  /// Removes the files of an earlier run whose names begin so, because they would belong to other data.
  void remove_files(const std::vector<std::string>& beginnings) const;

  /// The end of a run.
  struct End {
    std::uint64_t done = 0, missing = 0;   ///< samples
    std::optional<std::uint64_t> items{};  ///< of the whole study, if --samples does not say how many
    std::string text{};                    ///< tables and sentences for standard output
    std::string also{};                    ///< what else an interrupted run covers, such as "3 of 5 passes"
    int status = 0;                        ///< the exit status of a complete run
    bool pictures = true;                  ///< whether a complete run has pictures
  };
  /// Writes run.json, prints the text, the time and the folder, or with --quiet nothing;
  /// reports an interruption and draws the pictures. Returns the exit status: that of the study or, if that is 0, that
  /// of draw_pictures.
  int finish(const End& end);

 private:
  [[nodiscard]] Part share() const { return part_.value_or(Part()); }
  [[nodiscard]] ResultSettings settings(const Part& part, std::uint64_t items) const;
  template <class Sum>
  Sum sum_of_parts(const std::string& file, std::uint64_t items, const Sum& zero) const {
    Sum sum = zero;
    for (std::uint64_t i = 0; i < options_.call.parts.size(); ++i) {
      const Part part{i + 1, options_.call.parts.size()};
      add(sum, PartFile(options_.call.parts[i] / file, settings(part, items)).read(zero, part.size(items)));
    }
    return sum;
  }

  std::string study_;
  int version_;
  const StudyOptions& options_;
  std::optional<Part> part_;
  // What options_.call.result_options() has returned: it is called once, because it may read files.
  mutable std::optional<std::vector<std::pair<std::string, std::string>>> result_options_;
};

/// Returns the function of a command that runs a study: run(StudyRun&, options) returns the exit status.
template <class Options, class Run>
std::function<int()> study_runner(const Command& command, int version, std::shared_ptr<Options> options, Run run) {
  return [study = command.name(), version, options = std::move(options), run = std::move(run)] {
    StudyRun study_run(study, version, *options);
    return run(study_run, *options);
  };
}

}  // namespace touchstone::program
