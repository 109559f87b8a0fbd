// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <map>
#include <system_error>

#include "experiments/cases/verdict.h"
#include "experiments/harness/options.h"
#include "experiments/harness/whole_number.h"
#include "experiments/methods/registry.h"
#include "experiments/workloads/workload.h"

namespace touchstone::commands {
namespace {

using cases::Question;
using cases::Verdict;

// A method that never fails must not make the search for failures run for ever.
constexpr std::uint64_t kMostSamplesPerCase = 10'000;

struct CasesOptions {
  workloads::Workload workload;
  std::uint64_t seed = 1, first = 0, count = 10;
  bool expected = false;
  std::vector<std::string> failing;
};

/// An option that takes the word of one of `all`.
template <class Enumerator>
void add_word(CLI::App& command, const std::string& name, Enumerator& target, const std::vector<Enumerator>& all,
              const std::string& description) {
  std::map<std::string, Enumerator> by_word;
  std::vector<std::string> words;
  for (const Enumerator value : all) {
    by_word.emplace(workloads::word(value), value);
    words.emplace_back(workloads::word(value));
  }
  command
      .add_option_function<std::string>(
          name, [&target, by_word](const std::string& word) { target = by_word.at(word); }, description)
      ->check(CLI::IsMember(words))
      ->default_str(std::string(workloads::word(target)));
}

Verdict ask(const cases::Method& method, const workloads::Sample& sample) {
  return cases::object_of(method.prepare(sample.polygon)->ask(sample.ball, Question::Answer));
}

/// Does one of the methods give a key whose value is not that of the truth, the roundings of point and distance aside?
bool fails(const std::vector<const cases::Method*>& methods, const workloads::Sample& sample, const Verdict& truth) {
  for (const auto* method : methods) {
    const Verdict given = ask(*method, sample);
    for (const char* key : {"foot", "edges_hit", "relation", "contact", "nearest"})
      if (given.contains(key) && given[key] != truth[key]) return true;
  }
  return false;
}

[[noreturn]] void cannot_write() {
  throw std::system_error(errno, std::generic_category(), "the cases cannot be written");
}

void print(const CasesOptions& options) {
  const auto failing = methods::find_methods(options.failing);
  const cases::Method& exact = *methods::find_method("exact");
  std::uint64_t printed = 0;
  for (std::uint64_t index = options.first; printed < options.count; ++index) {
    const workloads::Sample sample = workloads::sample(options.workload, options.seed, index);
    Verdict expected = nullptr;
    if (options.expected || !failing.empty()) expected = ask(exact, sample);
    if (!failing.empty() && !fails(failing, sample, expected)) {
      if (index - options.first >= kMostSamplesPerCase * options.count) break;
      continue;
    }
    ++printed;
    const std::string line = cases::to_line(cases::case_of(sample.id, sample.ball, sample.polygon, sample.tags,
                                                           options.expected ? expected : Verdict(nullptr)));
    if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size()) cannot_write();
  }
  if (std::fflush(stdout) != 0) cannot_write();
  if (printed < options.count)
    fmt::print(stderr, "touchstone: only {} of {} cases found in {} samples\n", printed, options.count,
               kMostSamplesPerCase * options.count);
}

}  // namespace

void add_cases(CLI::App& app) {
  auto* command =
      app.add_subcommand("cases", "Print random cases (JSON Lines); case i depends on the settings, seed and i alone");
  auto options = std::make_shared<CasesOptions>();
  auto& workload = options->workload;
  add_word(*command, "--family", workload.family, workloads::all_families(), "Outline");
  add_word(*command, "--placement", workload.placement,
           {workloads::Placement::LatticeFrame, workloads::Placement::Rotated}, "How the outline comes into space");
  add_word(*command, "--ball", workload.ball, workloads::all_ball_places(), "Where the ball is");
  command->add_option("--vertices", workload.vertices, "Vertices of the outer loop")
      ->check(harness::whole_number(3, 1U << 17))
      ->capture_default_str();
  command->add_option("--holes", workload.holes, "Holes")->check(harness::whole_number(0))->capture_default_str();
  command->add_option("--doubles", workload.doubles, "Move the radius by so many doubles from the threshold");
  command->add_option("--koch-dimension", workload.koch_dimension, "Dimension of Koch outlines")->capture_default_str();
  command->add_option("--origin-distance", workload.origin_distance, "Distance from the origin, in sizes");
  harness::add_seed(*command, options->seed);
  command->add_option("--first", options->first, "Number of the first sample")->check(harness::whole_number(0));
  command->add_option("--count", options->count, "Cases to print")
      ->check(harness::whole_number(0))
      ->capture_default_str();
  command->add_flag("--expected", options->expected, "Add the exact answer");
  harness::add_names(*command, "--failing", options->failing, "Only cases on which one of these methods errs");
  command->callback([options] { print(*options); });
}

}  // namespace touchstone::commands
