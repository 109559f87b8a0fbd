// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <stdexcept>

#include "experiments/cases/case.h"
#include "experiments/cases/verdict.h"
#include "experiments/judge/show/page.h"
#include "experiments/methods/process/engine_process.h"
#include "experiments/methods/selection.h"
#include "experiments/run/command.h"
#include "experiments/run/input.h"
#include "experiments/run/json.h"
#include "experiments/run/numbers.h"
#include "experiments/run/output.h"
#include "experiments/run/pictures.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::commands {
namespace {

struct ShowOptions {
  std::vector<std::string> files, ids;
  methods::Selection methods{{"filtered", "fast", "fast-float", "thesis"}};
  std::string verdicts, html, svg, png;
  std::uint64_t most = 20;
  bool force = false;
};

/// Verdicts that the judge has printed, by the id of the case.
using Printed = std::multimap<std::string, show::Verdict>;

Printed read_verdicts(const std::string& file) {
  std::ifstream stream = run::open_file(file);
  Printed printed;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const auto bad = [&](const std::string& why) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", file, number, why));
    };
    try {
      const nlohmann::json verdict = run::read_strict_json(line).value;
      if (!verdict.is_object() || !verdict.contains("id") || !verdict.contains("method"))
        bad("is not a verdict of the judge");
      if (!verdict["id"].is_string() || !verdict["method"].is_string()) continue;  // a case without an id
      show::Verdict one{verdict["method"].get<std::string>(), cases::stated_in(verdict), {}, {}};
      if (verdict.contains("unanswered")) one.fault = "cannot answer about moving balls";
      printed.emplace(verdict["id"].get<std::string>(), std::move(one));
    } catch (const run::NotJson& error) {
      bad(std::string("not JSON: ") + error.what());
    }
  }
  return printed;
}

/// Returns the selected cases; complains about lines that are not cases, and sets the status.
std::vector<show::CaseView> views_of(const ShowOptions& options, int& status) {
  const auto methods = options.verdicts.empty() ? options.methods.methods() : std::vector<const cases::Method*>();
  const Printed printed = options.verdicts.empty() ? Printed() : read_verdicts(options.verdicts);
  std::vector<show::CaseView> views;
  std::uint64_t left_out = 0;
  const auto files = options.files == std::vector<std::string>{"-"} ? std::vector<std::string>() : options.files;
  const auto complain = [&](const std::string& why) {
    fmt::print(stderr, "touchstone: {}\n", io::all_legible(why));
    status = 2;
  };
  for (cases::LineReader reader(files); const auto line = reader.next_case();) {
    if (!line->read) {
      complain(line->complaint);
      continue;
    }
    const cases::Case& read = *line->read;
    if (!options.ids.empty() && (!read.id || std::ranges::find(options.ids, *read.id) == options.ids.end())) continue;
    if (const auto* rejection = std::get_if<Rejection>(&read.content)) {
      complain(fmt::format("{}: rejected: {}: {}", line->place, to_string(rejection->code), rejection->message));
    } else if (views.size() == options.most) {
      ++left_out;
    } else {
      views.push_back(show::view_of(*read.id, read.tags, read.shapes()));
      for (const auto* method : methods) views.back().verdicts.push_back(show::verdict_of(views.back(), *method));
      const auto [begin, end] = printed.equal_range(*read.id);
      for (auto verdict = begin; verdict != end; ++verdict) views.back().verdicts.push_back(verdict->second);
    }
  }
  if (left_out > 0)
    fmt::print(stderr, "touchstone: not shown: {}; --samples and --id select others\n",
               run::counted(left_out, "more case"));
  if (views.empty() && status == 0) throw std::runtime_error("there is no case to show");
  return views;
}

int show_cases(const ShowOptions& options) {
  for (const std::string& file : {options.html, options.svg, options.png})
    if (!file.empty()) run::refuse_overwrite(file, options.force);
  int status = 0;
  const std::vector<show::CaseView> views = views_of(options, status);
  if (views.empty()) return status;
  const std::string title = views.size() == 1 ? "Case " + views.front().id : fmt::format("{} cases", views.size());
  if (!options.html.empty() || (options.svg.empty() && options.png.empty())) {
    std::string body;
    for (const show::CaseView& view : views) body += show::section_of(view);
    const std::string page = show::page_of(title, body);
    if (options.html.empty())
      fmt::print("{}", page);
    else
      run::write_file(options.html, page, options.force);
  }
  if (options.svg.empty() && options.png.empty()) return status;
  show::Svg all = show::picture(views.front());
  for (std::size_t i = 1; i < views.size(); ++i) all.append(show::picture(views[i]));
  const std::string drawing = all.text_of_file(title);
  if (!options.svg.empty()) run::write_file(options.svg, drawing, options.force);
  if (!options.png.empty()) run::write_file(options.png, run::png_of(drawing, all.height()), options.force);
  return status;
}

}  // namespace

run::Command show_command() {
  run::Command command("show",
                       "Draw cases: polygon, ball, nearest point, and a zoom onto the contact, double by double");
  auto options = std::make_shared<ShowOptions>();
  command
      .texts("CASE", options->files,
             "Files of cases, as `cases`, `soak --print`, `corpus shrink` and studies write them; "
             "- is standard input")
      .required();
  command.texts("--id", options->ids, "Only the case of this id; may be repeated").takes("ID");
  methods::declare_methods(command, options->methods);
  command
      .text("--verdicts", options->verdicts,
            "Show the verdicts of this file, which `judge` has printed, instead of asking methods")
      .takes("FILE")
      .excludes("--methods")
      .excludes("--engine");
  command.whole("--samples", options->most, "Draw at most this number of cases", 1, 1000);
  command
      .text("--html", options->html,
            "Write the page to this file; without any of the three, it goes to standard output")
      .takes("FILE");
  command.text("--svg", options->svg, "Write the pictures to this file (SVG)").takes("FILE");
  command.text("--png", options->png, "Write the pictures to this file (PNG); needs rsvg-convert").takes("FILE");
  command.force(options->force);
  command.footer(
      "From above: the polygon, the ball, the foot of its centre and the nearest point (of a moving ball: its way, "
      "and the first touched point). From the side: a section. Below: the radii next to the ball's, in doubles, and "
      "what exact and each method say of contact with each. Exit status: 2 for wrong input or if no PNG could be "
      "drawn, else 0.");
  command.example("show tests/corpus/edge.jsonl --samples 3 --html edge.html");
  command.runs([options] {
    const methods::KillEngineOnSignal kill_engine_on_signal;
    return show_cases(*options);
  });
  return command;
}

}  // namespace touchstone::commands
