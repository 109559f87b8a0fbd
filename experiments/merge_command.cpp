// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of studies and judgements, and the merge that adds them up.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "experiments/commands.h"
#include "experiments/program/command.h"
#include "experiments/program/study.h"
#include "experiments/program/sweep.h"
#include "experiments/program/words.h"

namespace touchstone::commands {
namespace {

namespace fs = std::filesystem;
using program::Command;

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw std::runtime_error(folder.string() + ": " + why);
}

/// A folder of a part, and how it was made.
struct MadePart {
  fs::path folder;
  program::Part part;
  std::string study;
  std::vector<std::string> arguments;  ///< without what is not of the study alone
};

/// Reads the record of a part. Throws std::runtime_error, which names the folder.
MadePart read_part(const fs::path& folder) {
  std::ifstream file(folder / "run.json", std::ios::binary);
  if (!file) refuse(folder, "has no run.json: its part has not ended, so run it again");
  const auto record = nlohmann::json::parse(file, nullptr, false);
  const auto text = [&](const char* key) {
    const auto found = record.is_object() ? record.find(key) : record.end();
    return found != record.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const auto part = program::Part::read(text("part"));
  const auto words = program::shell_words(text("command"));
  if (!part || words.size() < 2) refuse(folder, "is not of a part: its run.json names none");
  MadePart made{folder, *part, words[1], {}};
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--part" || words[i] == "--output" || words[i] == "--threads")
      ++i;
    else if (words[i] != "--quiet")
      made.arguments.push_back(words[i]);
  }
  return made;
}

/// Returns the parts in their order. Throws std::runtime_error unless they are all parts of one study, each once.
std::vector<MadePart> read_parts(const std::vector<std::string>& folders) {
  std::vector<MadePart> parts;
  for (const std::string& folder : folders) parts.push_back(read_part(folder));
  std::ranges::stable_sort(parts, {}, [](const MadePart& made) { return made.part.number; });
  const MadePart& first = parts.front();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [folder, part, study, arguments] = parts[i];
    if (study != first.study)
      refuse(folder, fmt::format("is of {}, unlike {}, which is of {}", study, first.folder.string(), first.study));
    if (part.of != first.part.of)
      refuse(folder, fmt::format("is part {}, unlike {}, which is part {}", to_string(part), first.folder.string(),
                                 to_string(first.part)));
    if (i > 0 && part.number == parts[i - 1].part.number)
      refuse(folder, fmt::format("is part {}, as {} is", to_string(part), parts[i - 1].folder.string()));
    if (part.number != i + 1) break;
  }
  for (std::size_t i = 0; i < first.part.of; ++i)
    if (i >= parts.size() || parts[i].part.number != i + 1)
      throw std::runtime_error(fmt::format("part {}/{} of {} is missing", i + 1, first.part.of, first.study));
  return parts;
}

bool takes(const Command& command, const std::string& option) {
  const auto options = command.description().options;
  return std::ranges::find(options, option, &program::OptionDescription::name) != options.end();
}

/// Returns the study of this name. Throws UsageError if there is no such study with parts.
const Command& find_study(const std::vector<Command>& commands, const std::string& name) {
  std::vector<std::string> known;
  for (const Command& command : commands) {
    if (!command.has_parts()) continue;
    if (command.name() == name) return command;
    known.push_back(command.name());
  }
  throw program::UsageError("STUDY", "\"" + name + "\" is not one of " + program::joined(known));
}

struct MergeOptions {
  bool json = false, quiet = false;
  std::vector<std::string> folders;
  std::string output;
  unsigned threads = program::all_threads();
  bool force = false, no_pictures = false;
};

int merge(const MergeOptions& options, const std::vector<Command>& commands) {
  std::vector<MadePart> parts = read_parts(options.folders);
  std::vector<fs::path> folders;
  for (const MadePart& made : parts) {
    std::error_code none;
    if (fs::equivalent(made.folder, options.output, none)) refuse(made.folder, "is a part, so it cannot be the output");
    folders.push_back(made.folder);
  }
  std::vector<std::string> arguments = std::move(parts.front().arguments);
  const auto add = [&](const std::string& flag, bool given) {
    if (given && std::ranges::find(arguments, flag) == arguments.end()) arguments.push_back(flag);
  };
  const Command& study = find_study(commands, parts.front().study);
  arguments.insert(arguments.end(), {"--output", options.output});
  if (takes(study, "--threads")) arguments.insert(arguments.end(), {"--threads", std::to_string(options.threads)});
  add("--force", options.force);
  add("--no-pictures", options.no_pictures);
  add("--quiet", options.quiet);
  add("--json", options.json);
  return study.merge(folders, arguments);
}

}  // namespace

Command merge_command(const std::vector<Command>& commands) {
  auto merged = std::make_shared<MergeOptions>();
  Command merging("merge", "Add the parts of a study or a judgement up to the results of one run");
  merging.texts("FOLDER", merged->folders, "The folders of all parts, in any order").required();
  program::declare_threads(merging, merged->threads);
  program::declare_folder(merging, merged->output, "The folder for tables and pictures").required();
  program::declare_force(merging, merged->force);
  program::declare_no_pictures(merging, merged->no_pictures);
  program::declare_quiet(merging, merged->quiet);
  program::declare_json(merging, merged->json, "Of parts of `judge`: print the summary as one JSON object")
      .excludes("--quiet");
  merging.help().footer =
      "A part is a run of a study with --part, such as `soak --part 1/2 --output one`. The data are the same bytes as "
      "those of one run, times aside. What is not a sum over samples, such as times and maps, is done here.\n"
      "Of parts of `judge`, it tells what one run tells, with the same exit status.";
  merging.help().examples.emplace_back("merge one two --output all");
  merging.runs([merged, commands] { return merge(*merged, commands); });
  return merging;
}

}  // namespace touchstone::commands
