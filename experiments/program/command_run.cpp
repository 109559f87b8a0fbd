// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/command_run.h"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "experiments/program/input.h"
#include "experiments/program/words.h"

namespace touchstone::program {
namespace {

/// Returns the first Python interpreter that has the required packages.
std::optional<std::string> find_python() {
  for (const std::string python : {"/usr/bin/python3", "python3"})
    if (std::system((python + " -c 'import jinja2, matplotlib, numpy' 2>/dev/null").c_str()) == 0) return python;
  return std::nullopt;
}

}  // namespace

int draw_pictures(const std::string& name, const OutputFolder& folder) {
  folder.share();
  const std::string path = folder.path().string();
  const std::string script = shell_quoted(data("experiments/report/draw.py").string());
  const auto python = find_python();
  if (python && std::system(fmt::format("{} -B {} {} {}", *python, script, name, shell_quoted(path)).c_str()) == 0)
    return 0;
  fmt::print(stderr, "touchstone: {}; the data are in {}\n",
             python ? "the pictures could not be drawn" : "no pictures: no python3 with jinja2, matplotlib and numpy",
             path);
  return 1;
}

void declare_output(Command& command, FolderOptions& options, const std::string& about, bool has_pictures) {
  declare_folder(command, options.output, about);
  options.needs_folder = !options.output.empty();
  declare_force(command, options.force);
  if (has_pictures) declare_no_pictures(command, options.no_pictures);
  command.keep_call(options.call);
}

CommandRun::CommandRun(const FolderOptions& options) : options_(options) {
  if (options_.needs_folder || !options_.output.empty()) held_.emplace(options_.output, options_.force);
}

const std::atomic<bool>& CommandRun::stop() {
  if (!stop_signal_) stop_signal_.emplace();
  return stop_signal_->requested();
}

double CommandRun::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

ProgressLine CommandRun::progress(const std::string& what, std::uint64_t total) const {
  return ProgressLine(what, total, !options_.quiet);
}

void CommandRun::write_record(Run record) const {
  record.command = options_.call.line;
  record.seconds = seconds();
  write_run_record(folder(), record);
}

int CommandRun::draw(const std::string& script) const {
  return options_.no_pictures ? 0 : draw_pictures(script, *held_);
}

int CommandRun::finish(Run record, const std::string& text, const std::string& script) const {
  write_record(std::move(record));
  print_result(text, options_.quiet);
  return script.empty() ? 0 : draw(script);
}

int CommandRun::finish_unwritten() {
  fmt::print(stderr, "touchstone: interrupted; nothing is written\n");
  return kInterrupted;
}

}  // namespace touchstone::program
