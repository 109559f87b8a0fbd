// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/program/printing.h"

namespace touchstone::commands {
namespace {

using cases::key_of;
using cases::PartialAnswer;

// Bounds the search for failures of a method that never fails.
constexpr std::uint64_t kMostSamplesPerCase = 10'000;

constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 40;  // the search then counts without overflow

struct CasesOptions {
  workloads::Workload workload;
  std::uint64_t seed = 1, first = 0, count = 10;
  bool expected = false;
  methods::Selection failing;
};

/// Returns whether one of the methods gives a wrong value for a key, apart from rounding errors of lengths and times.
bool fails(const std::vector<const cases::Method*>& methods, const cases::Shapes& shapes,
           const cases::PartialAnswer& truth) {
  const cases::PartialAnswer looked_at =
      only(truth, {key_of(&PartialAnswer::foot), key_of(&PartialAnswer::edges_hit), key_of(&PartialAnswer::relation),
                   key_of(&PartialAnswer::contact), key_of(&PartialAnswer::nearest), key_of(&PartialAnswer::first),
                   key_of(&PartialAnswer::momentary), key_of(&PartialAnswer::feature)});
  return std::ranges::any_of(methods, [&](const cases::Method* method) {
    const auto answer = method->prepare(shapes.polygon)->answer(shapes.question);
    return answer && !cases::differing_keys(looked_at, *answer).empty();
  });
}

void print(const CasesOptions& options) {
  const auto failing = options.failing.methods();
  std::uint64_t printed = 0;
  for (std::uint64_t index = options.first; printed < options.count; ++index) {
    const workloads::Sample sample = workloads::sample(options.workload, options.seed, index);
    const cases::Shapes shapes{sample.question(), sample.polygon};
    std::optional<cases::PartialAnswer> truth;
    if (options.expected || !failing.empty()) truth = exact_answer(shapes);
    if (!failing.empty() && !fails(failing, shapes, *truth)) {
      if (index - options.first >= kMostSamplesPerCase * options.count) break;
      continue;
    }
    ++printed;
    fmt::print("{}", cases::case_line(sample.id, shapes, sample.tags, options.expected ? truth : std::nullopt));
  }
  program::flush_standard_output();
  if (printed < options.count)
    fmt::print(stderr, "touchstone: only {} of {} cases found in {} samples\n", printed, options.count,
               kMostSamplesPerCase * options.count);
}

}  // namespace

program::Command cases_command() {
  program::Command command("cases",
                           "Print random cases (JSON Lines); case i depends on the settings, seed and i alone");
  auto options = std::make_shared<CasesOptions>();
  auto& workload = options->workload;
  command.choice("--family", workload.family, workloads::all_families(), "Outline");
  command.choice("--placement", workload.placement, workloads::all_placements(), "Placement of the outline in space");
  command.choice("--ball", workload.ball, workloads::all_ball_places(), "Where the ball is");
  command.choice("--way", workload.way, workloads::all_ways(), "How the ball moves");
  command.whole("--vertices", workload.vertices, "Vertices of the outer loop", 3, workloads::kMostVertices);
  command.whole("--holes", workload.holes, "Holes", 0, workloads::kMostHoles);
  command.integer("--ulps", workload.doubles, "Number of doubles by which the radius is moved from the threshold");
  command.real("--koch-dimension", workload.koch_dimension, "Dimension of Koch outlines");
  command.real("--origin-distance", workload.origin_distance, "Distance from the origin, in sizes");
  program::declare_seed(command, options->seed);
  command.whole("--first", options->first, "Number of the first sample", 0);
  command.whole("--samples", options->count, "Cases to print", 0, kMostSamples);
  command.flag("--expected", options->expected, "Add the exact answer");
  command.names("--failing", options->failing.names, "Only cases on which one of these methods errs");
  methods::declare_engines(
      command, options->failing.engines,
      "Only cases on which this engine of yours errs (COMMAND or COMMAND=NAME), or one of --failing; "
      "may be repeated");
  command.help().examples.emplace_back("cases --family u --ball near-edge --failing fast --expected --samples 3");
  command.runs([options] {
    print(*options);
    return 0;
  });
  return command;
}

}  // namespace touchstone::commands
