// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/judge/corpus/corpus.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/program.h"
#include "experiments/program/study.h"
#include "experiments/program/sweep.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

struct MakeOptions {
  std::string folder;
  unsigned threads = program::all_threads();
  bool force = false;
};

int make(const MakeOptions& options) {
  const program::OutputFolder held(options.folder, options.force);
  const auto files = corpus::make_corpus(options.threads);
  for (const auto& [name, text] : files) {
    const std::filesystem::path file = std::filesystem::path(options.folder) / name;
    std::filesystem::create_directories(file.parent_path());
    program::write_file(file, text);
  }
  fmt::print("{} in {}\n", program::counted(files.size(), "file"), io::all_legible(options.folder));
  return 0;
}

std::vector<std::string> corpus_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(program::data("tests/corpus")))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

struct CheckOptions {
  std::vector<std::string> files;
  std::string part;
};

/// Returns the size of the regular ones of these files, in bytes.
std::uint64_t size_of(const std::vector<std::string>& files) {
  std::uint64_t sum = 0;
  for (const std::string& file : files)
    if (std::error_code none; std::filesystem::is_regular_file(file, none)) sum += std::filesystem::file_size(file);
  return sum;
}

int check(const CheckOptions& options) {
  const auto files = options.files.empty() ? corpus_files() : options.files;
  const program::Part part = program::Part::read(options.part).value_or(program::Part{});
  const program::StopSignal stop_signal;
  program::ProgressLine line("corpus check", size_of(files));
  const auto findings = corpus::check_files(files, part, stop_signal.requested(), std::ref(line));
  line.erase();
  for (const std::string& fault : findings.faults) fmt::print(stderr, "{}\n", io::all_legible(fault));
  if (stop_signal.requested()) fmt::print("interrupted: these are the findings of the first cases\n");
  fmt::print("{} in {}, checked twice: {}\n", program::counted(findings.cases, "case"),
             program::counted(files.size(), "file"), program::counted(findings.faults.size(), "fault"));
  if (stop_signal.requested()) return program::kInterrupted;
  return findings.faults.empty() ? 0 : 1;
}

struct ShrinkOptions {
  std::string file, method;
  std::vector<std::string> engines;
  std::string key;  ///< empty: all wrong keys
};

/// Returns one case, or nothing after a complaint about it.
std::optional<std::string> shrunk_line(const cases::Line& line, const cases::Method& method,
                                       const std::optional<std::string>& key, const std::atomic<bool>& stop) {
  if (!line.read) {
    fmt::print(stderr, "touchstone: {}\n", io::all_legible(line.complaint));
    return std::nullopt;
  }
  if (const auto* rejection = std::get_if<Rejection>(&line.read->content)) {
    fmt::print(stderr, "touchstone: {}{}: rejected: {}: {}\n", io::all_legible(line.place),
               line.read->id ? ": case " + io::legible(*line.read->id) : "", to_string(rejection->code),
               io::all_legible(rejection->message));
    return std::nullopt;
  }
  const std::string& id = *line.read->id;
  const cases::AnyShapes shapes = line.read->shapes();
  try {
    const corpus::SameFailure failure(method, shapes, key);
    const cases::AnyShapes small = corpus::shrink(failure, shapes, stop);
    auto labels = corpus::labels_of(line.text);
    if (std::ranges::find(labels.tags, "shrunk") == labels.tags.end()) {
      labels.tags.emplace_back("shrunk");
      std::string from = labels.origin.empty() ? id : labels.origin;
      std::vector<std::string> keys;
      for (const cases::Key& wrong : failure.keys()) keys.emplace_back(wrong.name);
      labels.origin =
          fmt::format("touchstone corpus shrink --{} {}{}: {}; from: {}", method.through_pipe() ? "engine" : "method",
                      method.name(), key ? " --key " + *key : "", program::joined(keys), from);
    }
    return corpus::line_of({id, small, labels.tags, labels.origin}, exact_answer(small));
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "touchstone: case {}: {}\n", io::legible(id), error.what());
    return std::nullopt;
  }
}

int shrink(const ShrinkOptions& options) {
  methods::Selection selection{{}, options.engines};
  if (!options.method.empty()) selection.names = {options.method};
  const auto methods = selection.methods();
  if (methods.size() != 1)
    throw program::UsageError(options.method.empty() ? "--engine" : "--method " + options.method,
                              "a case is shrunk for one method or engine");
  const cases::Method& method = *methods.front();
  const std::optional<std::string> key = options.key.empty() ? std::nullopt : std::optional(options.key);
  const program::StopSignal stop_signal;
  int status = 0;
  std::size_t lines = 0;
  const auto files = options.file == "-" ? std::vector<std::string>{} : std::vector{options.file};
  for (cases::LineReader reader(files); const auto line = reader.next_case();) {
    ++lines;
    if (const auto shrunk = shrunk_line(*line, method, key, stop_signal.requested())) {
      program::print_result(*shrunk, false);
    } else {
      status = 2;
    }
    if (stop_signal.requested()) break;
  }
  if (lines == 0) {
    fmt::print(stderr, "touchstone: {}: there is no case in it\n", io::all_legible(options.file));
    return 2;
  }
  return stop_signal.requested() ? program::kInterrupted : status;
}

program::Command make_command() {
  program::Command command("make", "Write every file of the corpus, with its page");
  auto options = std::make_shared<MakeOptions>();
  command.text("FOLDER", options->folder, "Destination; the corpus is tests/corpus").required();
  program::declare_threads(command, options->threads, "Number of threads; does not affect the files");
  program::declare_force(command, options->force);
  command.help().examples.emplace_back("corpus make new-corpus");
  command.runs([options] { return make(*options); });
  return command;
}

program::Command check_command() {
  program::Command command("check", "Derive every answer again, with two exact number types");
  auto options = std::make_shared<CheckOptions>();
  command.texts("FILES", options->files, "Files of cases with whole answers (default: the corpus)");
  program::declare_part(command, options->part,
                        "Check only part I of N of the cases; the parts' faults are those of one run");
  command.help().examples.emplace_back("corpus check");
  command.runs([options] { return check(*options); });
  return command;
}

program::Command shrink_command() {
  program::Command command("shrink", "Reduce failing cases to small ones that still fail");
  auto options = std::make_shared<ShrinkOptions>();
  command.text("CASE", options->file, "A file of cases (JSON Lines); - is standard input").required();
  command.text("--method", options->method, "The method that fails").takes("METHOD");
  methods::declare_engines(command, options->engines,
                           "Instead: an engine of yours that fails, COMMAND or COMMAND=NAME");
  program::require_one_of(command, {"--method", "--engine"});
  command.text("--key", options->key, "The key of the answer that must stay wrong; default: all wrong decisive keys")
      .takes("KEY");
  command.help().examples.emplace_back("corpus shrink failing.jsonl --method fast");
  command.runs([options] { return shrink(*options); });
  return command;
}

}  // namespace

program::Command corpus_command() {
  return {"corpus",
          "The certified cases of tests/corpus: make, check, and shrink new ones",
          {make_command(), check_command(), shrink_command()}};
}

}  // namespace touchstone::commands
