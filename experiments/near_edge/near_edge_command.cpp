// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "experiments/commands.h"
#include "experiments/near_edge/output.h"
#include "experiments/run/interrupt.h"
#include "experiments/run/pictures.h"
#include "experiments/run/progress_line.h"
#include "experiments/run/run_record.h"
#include "experiments/run/whole_number.h"
#include "experiments/run/write_file.h"

namespace touchstone::commands {
namespace {

using namespace near_edge;

struct Options {
  std::vector<std::string> methods{"fast", "fast-float", "thesis", "thesis-signed"};
  std::vector<std::string> families{"all"};
  std::uint64_t samples = 1000;  // about 60 s on two cores
  std::uint64_t seed = 1;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string output = "results/near-edge";
  bool no_pictures = false;
};

bool is_all(const std::vector<std::string>& names) { return names == std::vector<std::string>{"all"}; }

// Throws CLI::ValidationError, which names what is unknown.
workloads::Family find_family(const std::string& name) {
  std::string known;
  for (const auto family : workloads::all_families()) {
    if (word(family) == name) return family;
    known.append(known.empty() ? "" : ", ").append(word(family));
  }
  throw CLI::ValidationError("--families", "there is no family \"" + name + "\"; there are " + known + ", or all");
}

std::vector<workloads::Family> select_families(const std::vector<std::string>& names) {
  if (is_all(names)) return workloads::all_families();
  std::vector<workloads::Family> selected;
  for (const std::string& name : names) selected.push_back(find_family(name));
  return selected;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : ",").append(word);
  return text;
}

std::string command_line(const Options& options) {
  return fmt::format("touchstone near-edge --method {} --families {} --samples {} --seed {} --threads {} --output {}{}",
                     joined(options.methods), joined(options.families), options.samples, options.seed, options.threads,
                     run::shell_quoted(options.output), options.no_pictures ? " --no-pictures" : "");
}

/// Maps and pictures of an earlier run would belong to other tables.
void remove_old(const std::string& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("map-") || name.starts_with("maps.") || name.starts_with("rates-"))
      std::filesystem::remove(entry.path());
  }
}

int run(const Options& options) {
  const Settings settings{methods::find_methods(options.methods), select_families(options.families), options.samples,
                          options.seed, options.threads};
  run::make_folder(options.output);
  const run::Interrupt interrupt;
  const auto& stop = interrupt.requested();
  const auto begin = std::chrono::steady_clock::now();

  const Result result = [&] {
    run::ProgressLine line("near-edge: samples", settings.samples);
    return run_study(settings, stop, [&](std::uint64_t done) { line(done); });
  }();
  remove_old(options.output);
  write_rates(options.output, settings, result.counts);
  write_bands(options.output, settings, result.counts);
  {
    run::ProgressLine line("near-edge: maps", map_blocks());
    const auto maps =
        draw_maps(settings.methods, settings.seed, settings.threads, stop, [&](std::uint64_t done) { line(done); });
    write_maps(options.output, settings, maps);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run::write_run_record(options.output, {command_line(options), settings.seed, settings.samples, result.samples,
                                         result.missing, settings.threads, seconds});

  fmt::print("{}", table(settings, result.counts));
  fmt::print("\n{} samples of each family, placement and threshold, in {:.0f} s; {} of all were not found.\n",
             result.samples, seconds, result.missing);
  std::fflush(stdout);
  if (stop) {
    fmt::print(stderr, "touchstone: interrupted: {} covers {} of {} samples; no pictures\n", options.output,
               result.samples, settings.samples);
    constexpr int kInterrupted = 130;
    return kInterrupted;
  }
  if (!options.no_pictures) run::draw_pictures("near_edge.py", options.output);
  return 0;
}

}  // namespace

void add_near_edge(CLI::App& app, int& status) {
  auto* command =
      app.add_subcommand("near-edge", "Measure where methods fail near faces, edges and vertices, double by double");
  auto options = std::make_shared<Options>();
  command->add_option("--method", options->methods, "Method names, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--families", options->families, "Families of polygons, separated by commas, or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Samples of each family, placement and threshold")
      ->check(run::whole_number(1), "COUNT")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Any number; the same gives the same bytes")
      ->check(run::whole_number(0))
      ->capture_default_str();
  command->add_option("--threads", options->threads, "They do not change the results")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--output", options->output, "The folder for tables and pictures")->capture_default_str();
  command->add_flag("--no-pictures", options->no_pictures, "Write the tables only");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace touchstone::commands
