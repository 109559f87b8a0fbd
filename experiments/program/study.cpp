// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/study.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "experiments/program/json.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "geometry/io/detail/legible.h"

namespace touchstone::program {
namespace {

/// Returns the 64-bit hash FNV-1a of the text.
std::string hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace

void PartFile::write_text(const std::string& sum) const {
  nlohmann::ordered_json whole = {{"version", settings_.version}};
  for (const auto& [name, value] : settings_.options) whole[name] = value;
  whole["part"] = settings_.part;
  std::string text = nlohmann::json(sum).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  whole["hash"] = hash_of(text);
  std::string file = whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  file.pop_back();  // "}"
  write_file(path_, file + ",\"sum\":" + text + "}\n");
}

std::string PartFile::read_text() const {
  std::ifstream file(path_, std::ios::binary);
  if (!file)
    refuse(errno == ENOENT ? "is missing: its part has not ended, so run it again"
                           : "cannot be read: " + std::generic_category().message(errno));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    const auto whole = nlohmann::json::parse(text);
    if (whole.at("version") != settings_.version) refuse("is of another version of this program");
    std::string found, wanted;
    for (const auto& [name, value] : settings_.options) {
      const auto& held = whole.at(name).get_ref<const std::string&>();
      if (held == value) continue;
      const std::string option = std::isupper(static_cast<unsigned char>(name.front())) != 0 ? name : "--" + name;
      found += " " + option + " " + held;
      wanted += " " + option + " " + value;
    }
    if (const auto& part = whole.at("part").get_ref<const std::string&>(); part != settings_.part) {
      found += " --part " + part;
      wanted += " --part " + settings_.part;
    }
    if (!found.empty()) refuse("is of" + found + ", not of" + wanted);
    const auto& sum = whole.at("sum");
    if (whole.at("hash") != hash_of(sum.dump())) refuse("was changed since its run wrote it");
    return sum.get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    refuse("is not of a part of this program: " + json_fault(error, text));
  }
}

void PartFile::refuse(const std::string& why) const { throw std::runtime_error(path_.string() + ": " + why); }

Option declare_study(Command& command, StudyOptions& options, const std::string& samples, const std::string& about) {
  Option option = command.whole(samples, options.samples, about, 1, kMostSamples);
  declare_seed(command, options.seed).changes_results();
  declare_parts(command, options);
  return option;
}

void declare_parts(Command& command, StudyOptions& options) {
  declare_threads(command, options.threads);
  declare_output(command, options,
                 options.has_pictures ? "The folder for tables and pictures" : "The folder for tables",
                 options.has_pictures);
  declare_quiet(command, options.quiet);
  declare_part(command, options);
}

Option declare_part(Command& command, std::string& part, const std::string& about) {
  const auto fault = [](const std::string& text) {
    return Part::read(text) ? "" : fmt::format("\"{}\" is not I/N, 1 <= I <= N <= {}", io::legible(text), kMostParts);
  };
  return command.text("--part", part, about, fault).takes("I/N");
}

Option declare_part(Command& command, StudyOptions& options) {
  Option part = declare_part(command, options.part,
                             "Run only part I of N, for `touchstone merge`, which adds the parts up to the results of "
                             "one run");
  command.take_parts();
  command.keep_call(options.call);
  return part;
}

StudyRun::StudyRun(std::string study, int version, const StudyOptions& options)
    : CommandRun(options),
      study_(std::move(study)),
      version_(version),
      options_(options),
      part_(Part::read(options.part)) {
  (void)stop();
}

ResultSettings StudyRun::settings(const Part& part, std::uint64_t items) const {
  if (!result_options_) result_options_ = options_.call.result_options();
  return {version_, *result_options_, fmt::format("{} of {}", to_string(part), counted(items, "item"))};
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
  const std::uint64_t asked = share().size(end.items.value_or(options_.samples));
  std::string script;
  if (options_.has_pictures && end.pictures && !is_part() && !interrupted) script = study_;
  std::ranges::replace(script, '-', '_');
  const int drawn = CommandRun::finish(
      {.seed = options_.seed,
       .samples_asked = asked,
       .samples_done = end.done,
       .samples_missing = end.missing,
       .threads = options_.threads,
       .part = options_.part,
       .parts = std::max<std::uint64_t>(options_.call.parts.size(), 1),
       .interrupted = interrupted},
      interrupted && is_part()
          ? ""
          : fmt::format("{}{:.0f} s; results: {}\n", end.text, seconds(), io::all_legible(options_.output)),
      script);
  if (interrupted && is_part())
    fmt::print(stderr, "touchstone: interrupted: a part then keeps nothing; run it again\n");
  else if (interrupted)
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {}{}{}{}\n", io::all_legible(options_.output),
               end.done, counted(asked, end.items ? "item" : "sample"), end.also.empty() ? "" : " and ", end.also,
               options_.has_pictures ? "; no pictures" : "");
  if (end.status != 0) return end.status;
  return interrupted ? kInterrupted : drawn;
}

}  // namespace touchstone::program
