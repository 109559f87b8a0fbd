// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/study.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "experiments/program/numbers.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {

Option declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about) {
  Option option = command.whole(samples, options.samples, about, 1, kMostSamples);
  declare_seed(command, options.seed).changes_results();
  declare_parts(command, options);
  return option;
}

void declare_parts(Command& command, StudyOptions& options) {
  declare_threads(command, options.threads);
  declare_output(command, options,
                 options.has_pictures ? "The folder for tables and pictures" : "The folder for tables",
                 options.has_pictures);
  declare_quiet(command, options.quiet);
  declare_part(command, options);
}

Option declare_part(Command& command, std::string& part, const std::string& about) {
  const auto fault = [](const std::string& text) {
    return Part::read(text) ? "" : fmt::format("\"{}\" is not I/N, 1 <= I <= N <= {}", io::legible(text), kMostParts);
  };
  return command.text("--part", part, about, fault).takes("I/N");
}

Option declare_part(Command& command, StudyOptions& options) {
  Option part = declare_part(command, options.part,
                             "Run only part I of N, for `touchstone merge`, which adds the parts up to the results of "
                             "one run");
  command.take_parts();
  command.keep_call(options.call);
  return part;
}

StudyRun::StudyRun(std::string study, int version, const StudyOptions& options)
    : CommandRun(options),
      study_(std::move(study)),
      version_(version),
      options_(options),
      part_(Part::read(options.part)) {
  (void)stop();
}

ResultSettings StudyRun::settings(const Part& part, std::uint64_t items) const {
  if (!result_options_) result_options_ = options_.call.result_options();
  return {version_, *result_options_, fmt::format("{} of {}", to_string(part), counted(items, "item"))};
}

void StudyRun::remove_files(const std::vector<std::string>& beginnings) const {
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::any_of(beginnings, [&](const std::string& start) { return name.starts_with(start); }))
      std::filesystem::remove(entry.path());
  }
}

int StudyRun::finish(const End& end) {
  const bool interrupted = stopped();
  const std::uint64_t asked = share().size(end.items.value_or(options_.samples));
  std::string script;
  if (options_.has_pictures && end.pictures && !is_part() && !interrupted) script = study_;
  std::ranges::replace(script, '-', '_');
  const int drawn = CommandRun::finish(
      {.seed = options_.seed,
       .samples_asked = asked,
       .samples_done = end.done,
       .samples_missing = end.missing,
       .threads = options_.threads,
       .part = options_.part,
       .parts = std::max<std::uint64_t>(options_.call.parts.size(), 1),
       .interrupted = interrupted},
      interrupted && is_part()
          ? ""
          : fmt::format("{}{:.0f} s; results: {}\n", end.text, seconds(), io::all_legible(options_.output)),
      script);
  if (interrupted && is_part())
    fmt::print(stderr, "touchstone: interrupted: a part then keeps nothing; run it again\n");
  else if (interrupted)
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {}{}{}{}\n", io::all_legible(options_.output),
               end.done, counted(asked, end.items ? "item" : "sample"), end.also.empty() ? "" : " and ", end.also,
               options_.has_pictures ? "; no pictures" : "");
  if (end.status != 0) return end.status;
  return interrupted ? kInterrupted : drawn;
}

}  // namespace touchstone::program
