// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "experiments/program/command_run.h"
#include "experiments/program/output.h"
#include "experiments/program/printing.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench/families.h"

namespace touchstone::bench {

const std::vector<Family>& all_families() {
  static const std::vector<Family> families = [] {
    std::vector<Family> list = triangle_families();
    for (Family& family : polygon_families()) list.push_back(std::move(family));
    list.push_back(batch_family());
    list.push_back(motion_family());
    list.push_back(nearness_family());
    return list;
  }();
  return families;
}

}  // namespace touchstone::bench

namespace touchstone::commands {
namespace {

using namespace bench;
using namespace timing;

struct Options : program::FolderOptions {
  std::vector<std::string> families{"all"};
  Settings settings;
  unsigned repetitions = 11;
  std::string count;
};

// Throws program::UsageError, which names what is unknown.
const Family& find_family(const std::string& name) {
  std::string known;
  for (const Family& family : all_families()) {
    if (family.name == name) return family;
    known.append(known.empty() ? "" : ", ").append(family.name);
  }
  throw program::UsageError("--family", "there is no family \"" + name + "\"; there are " + known + ", or all");
}

std::vector<const Family*> select_families(const std::vector<std::string>& names) {
  std::vector<const Family*> selected;
  if (names == std::vector<std::string>{"all"})
    for (const Family& family : all_families()) selected.push_back(&family);
  else
    for (const std::string& name : names) selected.push_back(&find_family(name));
  return selected;
}

/// Draws, measures and prints one benchmark after the other.
class Runner {
 public:
  Runner(program::CommandRun& run, const Options& options) : run_(run), options_(options) {}

  void measure_family(const Family& family) {
    std::vector<Result> results;
    if (!options_.quiet) fmt::print("\n== {}: {}\n", family.name, family.summary);
    for (const auto& draw : family.benchmarks) {
      if (run_.stop()) return;
      const Benchmark benchmark = draw(options_.settings);
      program::ProgressLine line = run_.progress("bench: " + family.name + " " + benchmark.name, options_.repetitions);
      results.push_back(
          measure(family.name, benchmark, options_.repetitions, run_.stop(), [&](std::uint64_t n) { line(n); }));
      keep(results.back());
    }
    if (!results.empty() && !results.front().pool.empty())
      if (const auto together = pooled(results, results.front().pool)) keep(*together);
  }
  [[nodiscard]] const std::vector<Result>& results() const { return results_; }

 private:
  void keep(const Result& result) {
    if (!options_.quiet) fmt::print("{}", table(result));
    program::flush_standard_output();
    results_.push_back(result);
  }

  program::CommandRun& run_;
  const Options& options_;
  std::vector<Result> results_;
};

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  return nlohmann::ordered_json::parse(file);
}

/// Writes the results, and the record of the run, which also stands beside.
void write(const program::CommandRun& run, const Options& options, const std::vector<Result>& results) {
  run.write_record({.seed = options.settings.seed,
                    .samples_asked = options.settings.samples,
                    .samples_done = run.stopped() ? 0 : options.settings.samples});
  const nlohmann::ordered_json all = {{"run", read_json(run.folder() / "run.json")},
                                      {"processor_features", processor_features()},
                                      {"samples", options.settings.samples},
                                      {"repetitions", options.repetitions},
                                      {"contests", json(results)}};
  program::write_file(run.folder() / "bench.json",
                      all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

int measure_all(const Options& options) {
  const auto families = select_families(options.families);
  program::CommandRun run(options);
  Runner runner(run, options);
  for (const Family* family : families)
    if (!run.stop()) runner.measure_family(*family);
  write(run, options, runner.results());

  if (!options.quiet) {
    fmt::print("{}\n{}", legend(), goals(runner.results()));
    constexpr std::uint64_t kEnough = 100'000;
    if (options.settings.samples < kEnough)
      fmt::print("Fewer than {} samples: branch predictors may have learnt them; do not quote these times.\n", kEnough);
    fmt::print("{} samples, {} repetitions, seed {}, in {:.0f} s. Results: {}\n", options.settings.samples,
               options.repetitions, options.settings.seed, run.seconds(), options.output);
  }
  program::flush_standard_output();
  if (!run.stopped()) return 0;
  fmt::print(stderr, "touchstone: interrupted: {} holds what was measured until then\n", options.output);
  return program::kInterrupted;
}

/// Asks one candidate every query of the benchmarks that share the first one's pool, `repetitions` times, and does
/// nothing else that depends on that number. Benchmarks outside the pool time something else, such
/// as preparing for each query.
int count(const Options& options) {
  const auto families = select_families(options.families);
  if (families.size() != 1) throw program::UsageError("--count", "needs one --family");
  Settings settings = options.settings;
  settings.checks = false;
  std::uint64_t asked = 0, sum = 0;
  std::vector<std::string> known;
  std::optional<std::string> pool;
  for (const auto& draw : families[0]->benchmarks) {
    const Benchmark benchmark = draw(settings);
    if (!pool) pool = benchmark.pool;
    if (benchmark.pool != pool) continue;
    for (const Candidate& candidate : benchmark.candidates) {
      if (std::ranges::find(known, candidate.name) == known.end()) known.push_back(candidate.name);
      if (candidate.name != options.count || !candidate.count_wrong) continue;
      asked += candidate.queries;
      if (candidate.before) candidate.before(candidate.queries);
      for (unsigned i = 0; i < options.repetitions; ++i) sum += candidate.ask(candidate.queries);
    }
  }
  if (asked == 0) {
    std::string names;
    for (const std::string& name : known) names.append(names.empty() ? "" : ", ").append(name);
    throw program::UsageError(
        "--count", "\"" + options.count + "\" is not a candidate of " + families[0]->name + "; there are " + names);
  }
  fmt::print("{}, {}: {} queries, {} times; sum of the answers {}\n", families[0]->name, options.count, asked,
             options.repetitions, sum);
  return 0;
}

constexpr const char* kFooter =
    "Times depend on what the compiler may use. A second build shows what this machine could do, its run record the "
    "flags:\n"
    "  cmake --preset release -B build/native -DCMAKE_CXX_FLAGS=-march=native\n"
    "A missed goal does not change the exit status. For instructions per query: "
    "experiments/studies/bench/instructions.py.";

}  // namespace

program::Command bench_command() {
  constexpr std::uint64_t kMostSamples = 10'000'000;  // all are held, at 100 bytes each and more
  program::Command command("bench", "Compare the times of filtered, fast and other methods on the same queries");
  command.help().footer = kFooter;
  auto options = std::make_shared<Options>();
  options->output = "results/bench";
  command.names("--family", options->families, "Families of queries, separated by commas, or all");
  command.whole("--samples", options->settings.samples,
                "Distinct queries, up to 10000000; branch predictors may learn fewer than 100000", 1, kMostSamples);
  command.whole("--repetitions", options->repetitions, "The number of turns of each candidate", 1, 100'000);
  program::declare_seed(command, options->settings.seed, "Any number; the same seed gives the same queries");
  command.text("--count", options->count,
               "Do not time: run this candidate of one family on all queries, for a profiler");
  program::declare_output(command, *options, "The folder for bench.json, which has all numbers, and run.json");
  program::declare_quiet(command, options->quiet);
  command.help().examples.emplace_back("bench --family near --samples 100");
  command.runs([options] { return options->count.empty() ? measure_all(*options) : count(*options); });
  return command;
}

}  // namespace touchstone::commands
