// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "experiments/commands.h"
#include "experiments/run/help.h"
#include "experiments/run/numbers.h"
#include "experiments/run/output.h"
#include "experiments/run/run_record.h"

namespace touchstone::commands {

using run::Command;

std::vector<Command> help_commands(const std::string& about, const std::string& heading,
                                   std::vector<Command> commands) {
  Command completion("completion", "Print a script that completes commands and options in a shell");
  auto shell = std::make_shared<std::string>("bash");
  completion.choice("SHELL", *shell, {"bash", "zsh"}, "The shell");
  completion.footer(
      "The installed program has both scripts. Otherwise: bash reads the script by `. FILE`; zsh finds it as the file "
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

  completion.heading(heading);
  manual.heading(heading);
  commands.push_back(completion);
  commands.push_back(manual);
  const run::CommandDescription program = run::description_of(about, commands);
  completion.runs([shell, program] {
    fmt::print("{}", *shell == "bash" ? run::bash_completion(program) : run::zsh_completion(program));
    return 0;
  });
  manual.runs([options, program] {
    const run::OutputFolder folder(options->folder, options->line, {.force = options->force});
    const std::string version = run::version_text().substr(0, run::version_text().find('\n'));
    const auto pages = run::manual_pages(program, version);
    for (const auto& [name, text] : pages) run::write_file(folder.path() / name, text);
    fmt::print("{} in {}\n", run::counted(pages.size(), "page"), options->folder);
    return 0;
  });
  return {completion, manual};
}

}  // namespace touchstone::commands
