// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/study.h"

#include <fmt/core.h>

#include <algorithm>

#include "experiments/run/pictures.h"
#include "experiments/run/run_record.h"

namespace touchstone::run {

void declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about) {
  command.whole(samples, options.samples, about, 1, kMostSamples);
  command.seed(options.seed).changes_results();
  command.threads(options.threads, "Threads of each process; they do not change the results");
  command.resume(options.resume);
  command.output(options.output, options.has_pictures ? "The folder for tables and pictures"
                                                      : "The folder for tables and the checkpoint");
  command.force(options.force);
  if (options.has_pictures) command.no_pictures(options.no_pictures);
  declare_printing(command, options);
  command.keep_line(options.line);
  command.keep_result_options(options.result_options);
}

StudyRun::StudyRun(std::string study, int version, const StudyOptions& options, const Processes& processes)
    : study_(std::move(study)), version_(version), options_(options), processes_(processes), folder_(options.output) {
  if (first()) held_.emplace(folder_, options.line, Existing{.force = options.force, .resume = options.resume});
}

double StudyRun::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void StudyRun::remove_files(const std::vector<std::string>& beginnings) const {
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::any_of(beginnings, [&](const std::string& start) { return name.starts_with(start); }))
      std::filesystem::remove(entry.path());
  }
}

int StudyRun::finish(const End& end) {
  if (!first()) return 0;
  const bool interrupted = stopped();
  write_run_record(folder_, {.command = options_.line,
                             .seed = options_.seed,
                             .samples_asked = options_.samples,
                             .samples_done = end.done,
                             .samples_missing = end.missing,
                             .threads = options_.threads,
                             .seconds = seconds(),
                             .processes = processes_.count(),
                             .interrupted = interrupted});
  options_.print(fmt::format("{}{:.0f} s; results: {}\n", end.text, seconds(), options_.output), folder_);
  if (interrupted) {
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {} samples; no pictures; --resume continues\n",
               options_.output, end.done, options_.samples);
    return end.status != 0 ? end.status : kInterrupted;
  }
  if (options_.has_pictures && end.pictures && !options_.no_pictures) {
    std::string script = study_;
    std::ranges::replace(script, '-', '_');
    const int drawn = draw_pictures(script, *held_);
    return end.status != 0 ? end.status : drawn;
  }
  return end.status;
}

}  // namespace touchstone::run
