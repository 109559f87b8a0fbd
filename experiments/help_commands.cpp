// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/help_commands.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "experiments/harness/completion.h"
#include "experiments/harness/manual.h"
#include "experiments/harness/output_folder.h"
#include "experiments/harness/processes.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/write_file.h"

namespace touchstone::commands {
namespace {

using harness::Command;
using harness::CommandDescription;

CommandDescription program_of(const std::string& about, const std::vector<Command>& commands) {
  CommandDescription program{.name = {},
                             .about = about,
                             .footer =
                                 "Cases, cells and scripts lie in share/touchstone beside the program's folder, or\n"
                                 "where the variable TOUCHSTONE_DATA says.",
                             .options = {{.name = "--version",
                                          .value = {},
                                          .about = "Print the version, the commit and the engines",
                                          .fallback = {},
                                          .words = {}}},
                             .examples = {"help near-edge"},
                             .subcommands = {}};
  for (const Command& command : commands) program.subcommands.push_back(command.description());
  return program;
}

}  // namespace

std::vector<Command> help_commands(const std::string& about, std::vector<Command> commands) {
  Command completion("completion", "Print a script that completes commands and options in a shell");
  auto shell = std::make_shared<std::string>("bash");
  completion.choice("SHELL", *shell, {"bash", "zsh"}, "The shell");
  completion.footer(
      "The installed program has both scripts. Otherwise: bash reads the script by `. FILE`; zsh finds it as the file\n"
      "_touchstone in a folder of $fpath.");
  completion.example("completion bash");

  struct Options {
    std::string folder = "results/manual", line;
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  Command manual("manual", "Write the manual pages of all commands, for man(1)");
  manual.output(options->folder, "The folder for the pages");
  manual.force(options->force);
  manual.keep_line(options->line);
  manual.example("manual && man ./results/manual/touchstone-near-edge.1");

  commands.push_back(completion);
  commands.push_back(manual);
  const CommandDescription program = program_of(about, commands);
  completion.runs([shell, program] {
    return harness::run_alone([&] {
      fmt::print("{}", *shell == "bash" ? harness::bash_completion(program) : harness::zsh_completion(program));
      return 0;
    });
  });
  manual.runs([options, program] {
    return harness::run_alone([&] {
      const harness::OutputFolder folder(options->folder, options->line, {.force = options->force});
      const std::string version = harness::version_text().substr(0, harness::version_text().find('\n'));
      const auto pages = harness::manual_pages(program, version);
      for (const auto& [name, text] : pages) harness::write_file(folder.path() / name, text);
      fmt::print("{} pages in {}\n", pages.size(), options->folder);
      return 0;
    });
  });
  return {completion, manual};
}

}  // namespace touchstone::commands
