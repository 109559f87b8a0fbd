// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/program.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>

#include "experiments/program/command.h"
#include "experiments/program/command_parts.h"
#include "experiments/program/json.h"
#include "experiments/program/printing.h"
#include "experiments/program/words.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {
namespace {

std::atomic<bool> requested_once = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set within a signal handler");

extern "C" void request(int) {
  requested_once = true;
  handle_end_signals(SIG_DFL);
}

}  // namespace

void handle_end_signals(void (*handler)(int)) {
  for (const int signal : kEndSignals) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) std::signal(signal, handler);
  }
}

StopSignal::StopSignal() {
  requested_once = false;
  handle_end_signals(request);
}

StopSignal::~StopSignal() { handle_end_signals(SIG_DFL); }

const std::atomic<bool>& StopSignal::requested() const { return requested_once; }

CommandDescription description_of(const std::string& about, const std::vector<Command>& commands) {
  CommandDescription program{
      .name = {},
      .heading = {},
      .about = about,
      .footer =
          "Cases and the other data lie in share/touchstone beside the program's folder, or where "
          "the variable TOUCHSTONE_DATA says.",
      .options = {},
      .examples = {"help judge"},
      .subcommands = {}};
  program.options.push_back({.name = "--version",
                             .value = {},
                             .about = "Print the version, the commit and the engines",
                             .fallback = {},
                             .words = {},
                             .limits = {}});
  for (const Command& command : commands) program.subcommands.push_back(command.description());
  return program;
}

namespace {

/// Refuses the first word that should name a command and does not. Without such a word, prints the help of the group.
void check_names(const CommandDescription& group, const std::vector<std::string>& arguments) {
  if (group.subcommands.empty()) return;
  if (arguments.empty()) {
    fmt::print(stderr, "{}\n", help_text(group, help_width()));
    throw UsageError("name one of these commands, such as `" + call_of(group.subcommands.front().name) + "`");
  }
  if (arguments.front().starts_with("-")) return;
  const auto named = std::ranges::find(group.subcommands, arguments.front(), &CommandDescription::word);
  if (named != group.subcommands.end()) return check_names(*named, {arguments.begin() + 1, arguments.end()});
  std::vector<std::string> known;
  for (const CommandDescription& command : group.subcommands) known.push_back(command.word());
  const std::string meant = suggestion(arguments.front(), known);
  throw UsageError((group.name.empty() ? "there is" : group.name + " has") + " no command \"" +
                   io::legible(arguments.front()) + "\"" +
                   (meant.empty() ? "; see `" + call_of(group.name) + " --help`" : meant));
}

/// Returns the words after the name of the program; `help COMMAND` is `COMMAND --help`, and --exec the name that
/// --engine had in 0.1.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  for (std::string& word : words)
    if (word == "--exec" || word.starts_with("--exec=")) word.replace(2, 4, "engine");
  if (words.empty() || words.front() != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

}  // namespace

int run_program(const ProgramText& text, const std::vector<Command>& commands, int argc, char** argv) {
  const Command program(kProgram, text.about, commands);
  CLI::App& app = *program.parts().app;
  app.set_version_flag("--version", text.version);
  app.formatter_fn([&](const CLI::App*, const std::string&, CLI::AppFormatMode) {
    return help_text(description_of(text.about, commands), help_width());
  });
  std::vector<std::string> words = words_of(argc, argv);
  check_names(description_of(text.about, commands), words);
  std::ranges::reverse(words);
  try {
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success)) throw fault_of(&app, error);
    return app.exit(error);
  }
  for (const Command& command : commands) {
    if (!command.parts().app->parsed()) continue;
    for (const Command& sub : command.parts().subcommands)
      if (sub.parts().app->parsed()) return sub.parts().status;
    return command.parts().status;
  }
  return 0;
}

namespace {

/// Opens the standard streams that are closed, lest a file or socket take their place: for the wrong direction, so that
/// reading and writing them stay errors. False if that cannot be done.
bool occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(stream, F_GETFD) >= 0;
    if (!is_open && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return false;
  }
  return true;
}

constexpr std::string_view kOutOfMemory = "touchstone: out of memory\n";
const std::terminate_handler usual_end = std::get_terminate();

/// Where memory ends within a destructor or a thread, so that main does not learn of it. (Destructors of the JSON
/// library allocate.)
[[noreturn]] void end_out_of_memory() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kOutOfMemory.data(), kOutOfMemory.size());
    _exit(2);
  } catch (...) {
    usual_end();
  }
  usual_end();
  std::abort();
}

/// What an exception that ended a command says, legible and without a library's tags.
std::string complaint(const std::exception& error) {
  if (const auto* json = dynamic_cast<const nlohmann::json::exception*>(&error)) return json_fault(*json);
  return io::all_legible(message_of(error));
}

}  // namespace

int main_of(const std::string& about, const std::function<std::vector<Command>()>& commands, int argc, char** argv) {
  if (!occupy_standard_streams()) return 2;
  std::set_terminate(end_out_of_memory);
  try {
    const int status = run_program({about, version_text()}, commands(), argc, argv);
    flush_standard_output();
    return status;
  } catch (const std::bad_alloc&) {
    std::fputs(kOutOfMemory.data(), stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s %s\n", coloured("touchstone:", Colour::Red, stderr).c_str(), complaint(error).c_str());
  }
  return 2;
}

}  // namespace touchstone::program
