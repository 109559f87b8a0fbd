// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "experiments/cases/case.h"
#include "experiments/cases/key.h"
#include "experiments/cases/margin.h"
#include "experiments/cases/workloads/meshes.h"
#include "experiments/judge/judge.h"
#include "experiments/judge/known_failures.h"
#include "experiments/judge/report.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/study.h"
#include "experiments/program/words.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

constexpr int kVersion = 3;  // raised whenever the form or the meaning of an entry changes

struct JudgeOptions : program::StudyOptions {
  methods::Selection methods{{}};
  std::vector<std::string> files, keys;
  std::string junit, report, beyond, known;
  double time_limit = std::chrono::duration<double>(methods::kTimeLimit).count();
  bool json = false, explain = false, at_rest = false, triangles = false, summary = false, update = false;
  cases::LineCount counted;  ///< of the files, if the run is kept in a folder

  [[nodiscard]] bool reads_standard_input() const { return files.empty() || files == std::vector<std::string>{"-"}; }
};

std::vector<cases::Key> find_keys(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const cases::Key& key : cases::kKeys) known.emplace_back(key.name);
  std::vector<cases::Key> keys;
  for (const std::string& name : names) {
    const auto key = cases::find_key(name);
    if (!key)
      throw program::UsageError("--keys", "no answer has a key \"" + name + "\"" + program::suggestion(name, known));
    keys.push_back(*key);
  }
  return keys;
}

judge::Question question_of(const JudgeOptions& options) {
  judge::Question question{.keys = find_keys(options.keys),
                           .explain = options.explain,
                           .at_rest = options.at_rest,
                           .triangles = options.triangles,
                           .keeps_wrong = !options.report.empty()};
  if (!options.reads_standard_input()) question.files = options.files;
  question.methods = methods::find_methods(options.methods.names);
  for (const std::string& text : options.methods.engines) {
    methods::Engine engine = methods::engine_of(text);
    const auto& engines = question.engines;
    const bool is_taken = methods::find_method(engine.name) != nullptr ||
                          std::ranges::find(engines, engine.name, &methods::Engine::name) != engines.end();
    if (is_taken)
      throw program::UsageError("--engine", io::legible(engine.name) + " is the name of a method or engine");
    question.engines.push_back(std::move(engine));
  }
  if (options.methods.empty()) question.methods = methods::find_methods({"exact"});
  question.time_limit = std::chrono::milliseconds(std::lround(1000 * options.time_limit));
  if (!options.beyond.empty()) question.beyond = cases::margin_of(options.beyond);
  return question;
}

/// Tells which known failures are mended and how many are new; with `update`, writes those that there are now.
void tell_of_known(const judge::KnownFailures& known, const std::string& file, bool update) {
  const auto mended = known.mended();
  for (const judge::Failure& failure : mended)
    fmt::print(stderr, "{}: mended: case {}: method {}: {}{}\n", file, io::legible(failure.id),
               io::legible(failure.method), failure.key, failure.omits ? ", which it did not give" : "");
  if (update) {
    program::write_file(file, known.text(), true);
    fmt::print(stderr, "{}: {} added, {} removed\n", file, known.new_ones(), mended.size());
  }
}

/// Returns the number of bytes of all files, or nothing if one of them has no size, like a pipe.
std::optional<std::uint64_t> size_of(const std::vector<std::string>& files) {
  std::uint64_t sum = 0;
  for (const std::string& file : files) {
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(file, error);
    if (error) return std::nullopt;
    sum += size;
  }
  return files.empty() ? std::nullopt : std::optional(sum);
}

/// Judges a part, or tells what the merged parts found. Returns the exit status.
int judge_parts(judge::Question question, const judge::Output& output, JudgeOptions& options) {
  if (options.part.empty() && options.call.parts.empty())
    throw program::UsageError("--output", "only a part has a folder: see --part");
  if (options.reads_standard_input())
    throw program::UsageError("--part", "cases on standard input cannot be counted; name their files");
  for (const std::string& file : options.files)
    if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
      throw program::UsageError("--part", io::legible(file) + " is not a file that can be read again");
  program::StudyRun study("judge", kVersion, options);
  options.counted = cases::count_lines(question.files);
  const std::uint64_t lines = options.counted.lines;
  judge::Judgement judgement =
      study.phase("cases", "part.json", lines, judge::Judgement(),
                  [&](const program::RunControl& control, judge::Judgement& found) {
                    question.first_line = control.part.first(lines);
                    question.lines = control.part.size(lines);
                    found.lines = judge::ask(
                        question, [&](judge::Entry&& entry) { found.entries.push_back(std::move(entry)); },
                        [&](std::uint64_t judged, std::uint64_t) {
                          control.progress(judged);
                          return !control.stop;
                        });
                  });
  if (study.is_part()) return study.finish({.done = judgement.lines, .items = lines});
  judge::Teller teller(output);
  for (judge::Entry& entry : judgement.entries) teller.tell(std::move(entry));
  study.write_record({.samples_asked = lines, .samples_done = lines, .parts = options.call.parts.size()});
  return teller.finish();
}

/// Judges and tells each case at once. Returns the exit status.
int judge_at_once(const judge::Question& question, judge::Output output, bool quiet) {
  const methods::KillEngineOnSignal kill_engine_on_signal;
  const bool fills_terminal = output.prints_verdicts && isatty(STDOUT_FILENO) == 1;
  const auto size = size_of(question.files);
  program::ProgressLine progress("judge", size.value_or(0), size && !quiet && !fills_terminal);
  output.before_complaint = [&] { progress.erase(); };
  return judge::judge(question, output, std::ref(progress));
}

int run_judge(JudgeOptions& options) {
  const judge::Question question = question_of(options);
  for (const std::string& file : {options.junit, options.report})
    if (!file.empty() && options.part.empty()) program::refuse_overwrite(file, options.force);

  std::optional<judge::KnownFailures> known;
  if (!options.known.empty()) {
    const bool begins = options.update && !std::filesystem::exists(options.known);
    known = begins ? judge::KnownFailures() : judge::KnownFailures(options.known);
  }
  judge::Tally tally;
  judge::JunitReport junit;
  judge::Report report;
  const bool prints_verdicts = !options.summary && !options.json;
  const judge::Output output{.prints_verdicts = prints_verdicts,
                             // A summary does not name the new ones among many failures that are known.
                             .prints_differences = !options.quiet && (prints_verdicts || (known && !options.update)),
                             .judged =
                                 [&](const judge::Judged& judged) {
                                   tally.add(judged);
                                   if (!options.junit.empty()) junit.add(judged);
                                   if (!options.report.empty()) report.add(judged);
                                 },
                             .known = known ? &*known : nullptr,
                             .new_ones_pass = options.update};
  const int status =
      options.output.empty() ? judge_at_once(question, output, options.quiet) : judge_parts(question, output, options);
  if (!options.part.empty() || status == program::kInterrupted) return status;
  if (options.json)
    fmt::print("{}", judge::summary_json(tally));
  else if (options.summary)
    fmt::print("{}", judge::summary_text(tally, program::takes_colours(stdout)));
  if (!options.junit.empty()) program::write_file(options.junit, junit.text(), options.force);
  if (!options.report.empty()) program::write_file(options.report, report.text(tally), options.force);
  if (known) tell_of_known(*known, options.known, options.update);
  return status;
}

/// Declares who is asked, and about which cases.
void declare_question(program::Command& command, const std::shared_ptr<JudgeOptions>& options) {
  methods::declare_methods(command, options->methods,
                           "Methods, separated by commas: names, or all (default: exact, or none with --engine)")
      .changes_results([options] {
        std::vector<std::string> all = options->methods.names;
        all.insert(all.end(), options->methods.engines.begin(), options->methods.engines.end());
        return program::joined(all);
      });
  command
      .real("--time-limit", options->time_limit,
            "Seconds for each verdict of an engine, from 0.001 to 86400; it gets one case after the other, and is "
            "restarted if it ends, is late or prints anything but its verdict",
            1e-3, 86'400)
      .needs("--engine")
      .changes_results();
  command.names("--keys", options->keys, "Compare only these keys of answers, separated by commas, such as contact")
      .changes_results();
  command
      .flag("--at-rest", options->at_rest,
            "Leave out the cases of moving balls, for an engine that knows only balls at rest")
      .changes_results();
  command
      .flag("--triangles", options->triangles,
            "Leave out the cases of other polygons than triangles, and of meshes with such faces")
      .changes_results();
  command
      .text("--beyond", options->beyond,
            "Count an answer as wrong only if it is still wrong when the radius is changed by this much: 2^-20 or 1e-6 "
            "of the case's largest coordinate, or a length such as 1e-6m",
            program::readable_by(cases::margin_of))
      .takes("MARGIN")
      .changes_results();
}

/// Declares what is told, and where.
void declare_telling(program::Command& command, const std::shared_ptr<JudgeOptions>& options) {
  command
      .text(
          "--known", options->known,
          "Failures that this file names are counted, but not told, and do not change the exit status; those that are "
          "mended are told",
          program::not_empty)
      .takes("FILE");
  command
      .flag("--update", options->update,
            "Write the failures that there are now to the file of --known; new ones do not change the exit status")
      .needs("--known");
  command.flag("--explain", options->explain, "Add the deciding stage and the margin in doubles").changes_results();
  command
      .flag("--summary", options->summary,
            "Instead of verdicts and differences, print how many cases were wrong, by key, family and tag, with limits")
      .changes_results();
  program::declare_json(command, options->json,
                        "Instead of verdicts and differences, print the summary as one JSON object");
  program::declare_quiet(command, options->quiet, "Print verdicts only; report mismatches by exit status");
  command.text("--junit", options->junit, "Also write the outcome of every case to this file, in the XML of JUnit")
      .takes("FILE");
  command
      .text("--report", options->report,
            "Also write a page to this file: the summary, and the worst cases as pictures (HTML, self-contained)")
      .takes("FILE")
      .changes_results([options] { return options->report.empty() ? "no" : "yes"; });
  program::declare_force(command, options->force);
}

/// Declares the files of cases, and that parts are of the same ones.
void declare_parts(program::Command& command, const std::shared_ptr<JudgeOptions>& options) {
  program::declare_folder(command, options->output, "The folder of the part; `touchstone merge` tells the judgement");
  command.texts("FILE", options->files, "Files of cases; none, or -: standard input").changes_results([options] {
    const cases::LineCount& counted = options->counted;
    const std::string meshes = counted.meshes.empty() ? "" : ", meshes " + workloads::with_hashes(counted.meshes);
    return fmt::format("{} ({}, hash {:016x}{})", program::joined(options->files),
                       program::counted(counted.lines, "line"), counted.hash, meshes);
  });
  program::declare_part(command, *options).needs("--output");
  command.keep_call(options->call);
}

}  // namespace

program::Command judge_command() {
  program::Command command("judge", "Answer cases (JSON Lines) by methods or engines; compare with `expected`");
  auto options = std::make_shared<JudgeOptions>();
  declare_question(command, options);
  declare_telling(command, options);
  declare_parts(command, options);
  command.help().footer =
      "Exit status: 0 if all expectations are met, 1 if one is not or an engine failed somewhere, 2 for wrong input "
      "or an engine that cannot be started, 130 if interrupted.";
  command.help().examples.emplace_back("judge --part 1/2 --output one --methods fast tests/corpus/edge.jsonl");
  command.help().examples.emplace_back(
      "judge --engine './engine --flags =mine' --keys contact --at-rest --summary tests/corpus/*.jsonl");
  command.runs([options] { return run_judge(*options); });
  return command;
}

program::Command methods_command() {
  program::Command command("methods", "List the methods, one per line");
  auto json = std::make_shared<bool>(false);
  program::declare_json(command, *json, "Print them as a JSON array");
  command.help().examples.emplace_back("methods --json");
  command.runs([json] {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& method : methods::all_methods()) {
      if (*json)
        list.push_back({{"method", method->name()}, {"summary", method->summary()}});
      else
        fmt::print("{:<24}{}\n", method->name(), method->summary());
    }
    if (*json) fmt::print("{}\n", list.dump());
    return 0;
  });
  return command;
}

}  // namespace touchstone::commands
