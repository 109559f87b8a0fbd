// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "experiments/cases/case.h"
#include "experiments/judge/show/case_view.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

struct ShowOptions {
  std::vector<std::string> files, ids;
  methods::Selection methods{{"filtered", "fast", "fast-float", "thesis"}};
  std::string html;
  std::uint64_t most = 20;
  bool force = false;
};

/// Draws the selected cases; complains about lines that are not cases. Returns the exit status.
int show_cases(const ShowOptions& options) {
  if (!options.html.empty()) program::refuse_overwrite(options.html, options.force);
  const auto methods = options.methods.methods();
  const auto files = options.files == std::vector<std::string>{"-"} ? std::vector<std::string>() : options.files;
  int status = 0;
  std::uint64_t shown = 0, left_out = 0;
  std::string title, body;
  for (cases::LineReader reader(files); const auto line = reader.next_case();) {
    const auto complain = [&](const std::string& why) {
      fmt::print(stderr, "touchstone: {}\n", io::all_legible(why));
      status = 2;
    };
    const auto is_selected = [&](const std::optional<std::string>& id) {
      return options.ids.empty() || (id && std::ranges::find(options.ids, *id) != options.ids.end());
    };
    if (!line->read) {
      complain(line->complaint);
    } else if (const cases::Case& read = *line->read; !is_selected(read.id)) {
      continue;
    } else if (const auto* rejection = std::get_if<Rejection>(&read.content)) {
      complain(fmt::format("{}: rejected: {}: {}", line->place, to_string(rejection->code), rejection->message));
    } else if (shown == options.most) {
      ++left_out;
    } else {
      show::CaseView view = show::view_of(*read.id, read.tags, read.shapes());
      for (const auto* method : methods) view.verdicts.push_back(show::verdict_of(view, *method));
      body += show::section_of(view);
      title = ++shown == 1 ? "Case " + *read.id : fmt::format("{} cases", shown);
    }
  }
  if (left_out > 0)
    fmt::print(stderr, "touchstone: not shown: {}; --samples and --id select others\n",
               program::counted(left_out, "more case"));
  if (shown == 0 && status == 0) throw std::runtime_error("there is no case to show");
  if (shown == 0) return status;
  const std::string page = show::page_of(title, body);
  if (options.html.empty())
    fmt::print("{}", page);
  else
    program::write_file(options.html, page, options.force);
  return status;
}

}  // namespace

program::Command show_command() {
  program::Command command("show",
                           "Draw cases: polygon, ball, nearest point, and a zoom onto the contact, double by double");
  auto options = std::make_shared<ShowOptions>();
  command
      .texts("CASE", options->files,
             "Files of cases, as `cases`, `soak --print`, `corpus shrink` and studies write them; "
             "- is standard input")
      .required();
  command.texts("--id", options->ids, "Only the case of this id; may be repeated").takes("ID");
  methods::declare_methods(command, options->methods);
  command.whole("--samples", options->most, "Draw at most this number of cases", 1, 1000);
  command.text("--html", options->html, "Write the page to this file instead of standard output").takes("FILE");
  program::declare_force(command, options->force);
  command.help().footer =
      "From above: the polygon, the ball, the foot of its centre and the nearest point (of a moving ball: its way, "
      "and the first touched point). From the side: a section. Below: the radii next to the ball's, in doubles, and "
      "what exact and each method say of contact with each. Exit status: 2 for wrong input, else 0.";
  command.help().examples.emplace_back("show tests/corpus/edge.jsonl --samples 3 --html edge.html");
  command.runs([options] {
    const methods::KillEngineOnSignal kill_engine_on_signal;
    return show_cases(*options);
  });
  return command;
}

}  // namespace touchstone::commands
