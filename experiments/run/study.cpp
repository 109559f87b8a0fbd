// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/study.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "experiments/run/counted.h"
#include "experiments/run/pictures.h"
#include "experiments/run/run_record.h"
#include "experiments/run/whole_number.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::run {

std::optional<Part> Part::read(const std::string& text) {
  const auto slash = std::min(text.find('/'), text.size());
  const auto number = read_whole_number(text.substr(0, slash));
  const auto of = read_whole_number(slash < text.size() ? text.substr(slash + 1) : "");
  if (!number || !of || *number < 1 || *number > *of || *of > kMostParts) return std::nullopt;
  return Part{*number, *of};
}

std::string to_string(const Part& part) { return fmt::format("{}/{}", part.number, part.of); }

void declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about) {
  command.whole(samples, options.samples, about, 1, kMostSamples);
  command.seed(options.seed).changes_results();
  command.threads(options.threads);
  command.resume(options.resume);
  command.output(options.output, options.has_pictures ? "The folder for tables and pictures"
                                                      : "The folder for tables and the checkpoint");
  command.force(options.force);
  if (options.has_pictures) command.no_pictures(options.no_pictures);
  declare_printing(command, options);
  const auto fault = [](const std::string& text) {
    return Part::read(text) ? "" : fmt::format("\"{}\" is not I/N, 1 <= I <= N <= {}", io::legible(text), kMostParts);
  };
  command
      .text("--part", options.part,
            "Run only part I of N, for `touchstone merge`, which adds the parts up to the results of one run", fault)
      .takes("I/N")
      .excludes("--json");
  command.merges(options.merged);
  command.keep_line(options.line);
  command.keep_result_options(options.result_options);
}

StudyRun::StudyRun(std::string study, int version, const StudyOptions& options)
    : study_(std::move(study)),
      version_(version),
      options_(options),
      part_(Part::read(options.part)),
      held_(options.output, options.line, {.force = options.force, .resume = options.resume}) {}

ResultSettings StudyRun::settings(const std::optional<Part>& part, std::uint64_t items) const {
  return {version_, options_.result_options(),
          part ? fmt::format("{} of {}", to_string(*part), counted(items, "item")) : ""};
}

double StudyRun::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
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
  const std::uint64_t asked = share().size(options_.samples);
  write_run_record(folder(), {.command = options_.line,
                              .seed = options_.seed,
                              .samples_asked = asked,
                              .samples_done = end.done,
                              .samples_missing = end.missing,
                              .threads = options_.threads,
                              .seconds = seconds(),
                              .part = options_.part,
                              .parts = std::max<std::uint64_t>(options_.merged.size(), 1),
                              .interrupted = interrupted});
  options_.print(fmt::format("{}{:.0f} s; results: {}\n", end.text, seconds(), options_.output), folder());
  if (interrupted) {
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {} samples; no pictures; --resume continues\n",
               options_.output, end.done, asked);
    return end.status != 0 ? end.status : kInterrupted;
  }
  if (options_.has_pictures && end.pictures && !is_part() && !options_.no_pictures) {
    std::string script = study_;
    std::ranges::replace(script, '-', '_');
    const int drawn = draw_pictures(script, held_);
    return end.status != 0 ? end.status : drawn;
  }
  return end.status;
}

}  // namespace touchstone::run
