// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <malloc.h>

#include <filesystem>

#include "experiments/program/command_run.h"
#include "experiments/program/printing.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench_scenes/measure.h"

namespace touchstone::commands {
namespace {

using namespace bench_scenes;

struct SceneOptions : program::FolderOptions {
  SceneSettings settings;
  std::size_t most_triangles = 1'000'000;
  std::string meshes;  ///< a folder; empty: no real meshes
};

/// The scenes, from the smallest of a kind to the largest; made one after the other, since they are large.
std::vector<std::function<NamedScene()>> all_scenes(const SceneOptions& options) {
  constexpr std::size_t kSmallest = 1000;
  std::vector<std::function<NamedScene()>> scenes;
  for (std::size_t size = kSmallest; size <= options.most_triangles; size *= 10)
    scenes.push_back([size] { return NamedScene{"torus", torus(size)}; });
  if (options.meshes.empty()) return scenes;
  const auto machine = std::make_shared<const Machine>(options.meshes);
  const std::size_t once = machine->triangle_count();
  if (once <= options.most_triangles)
    scenes.push_back([machine, once] { return NamedScene{"machine", machine->replicated(once)}; });
  for (std::size_t size = kSmallest; size <= options.most_triangles; size *= 10)
    if (size > once) scenes.push_back([machine, size] { return NamedScene{"machine", machine->replicated(size)}; });
  return scenes;
}

void write(const program::CommandRun& run, const SceneOptions& options, const std::vector<SceneResult>& results) {
  write_scene_tables(run.folder(), results);
  const std::uint64_t samples = options.settings.samples;
  run.write_record({.seed = options.settings.seed,
                    .samples_asked = samples,
                    .samples_done = run.stopped() ? 0 : samples,
                    .interrupted = run.stopped()});
}

int exit_status(const SceneOptions& options, const std::vector<SceneResult>& results, bool stopped) {
  bool disputed = false;
  for (const SceneResult& result : results)
    for (const std::string& dispute : result.disputes) {
      fmt::print(stderr, "touchstone: the exact scene and brute force differ: {}\n", dispute);
      disputed = true;
    }
  if (disputed) return 1;
  if (!stopped) return 0;
  fmt::print(stderr, "touchstone: interrupted: {} holds what was measured until then\n", options.output);
  return program::kInterrupted;
}

int measure_scenes(const SceneOptions& options) {
  program::CommandRun run(options);
  const auto scenes = all_scenes(options);
  const auto& stop = run.stop();
  const std::vector<Library> libraries = all_libraries();
  const auto print = [&](const std::string& text) { program::print_result(text, options.quiet); };

  std::vector<SceneResult> results;
  for (const auto& make : scenes) {
    if (stop) break;
    results.push_back(measure_scene(
        make(), libraries, options.settings, stop, [&](const SceneResult& result) { print(builds_table(result)); },
        [&](const SceneBenchmark& benchmark) { print(table(benchmark.result)); }));
    for (const MotionBenchmark& benchmark : results.back().motions) print(table(benchmark.result));
    for (const PointBenchmark& benchmark : results.back().points) print(table(benchmark.result));
    print(poses_table(results.back()));
    ::malloc_trim(0);  // the next, larger scene needs it
  }
  write(run, options, results);

  const std::string exact = libraries.front().name;
  std::string text = scene_legend() + "\n" + scene_goals(results, exact);
  for (const std::string& absent : absent_libraries())
    text += fmt::format("Built without {}: it does not take part.\n", absent);
  text +=
      fmt::format("{}, {}, seed {}, in {:.0f} s. Everything: {}\n", program::counted(options.settings.samples, "ball"),
                  program::counted(options.settings.repetitions, "repetition"), options.settings.seed, run.seconds(),
                  options.output);
  program::print_result(text, options.quiet);
  const int drawn = stop ? 0 : run.draw("bench_scenes");
  const int status = exit_status(options, results, stop);
  return status != 0 ? status : drawn;
}

}  // namespace

program::Command bench_scenes_command() {
  constexpr std::size_t kFewest = 1000, kMost = 10'000'000;
  constexpr std::uint64_t kMostSamples = 10'000'000;
  program::Command command("bench-scenes",
                           "Compare the times of scenes of 1000 and more triangles with other libraries");
  auto options = std::make_shared<SceneOptions>();
  options->output = "results/bench-scenes";
  command.whole("--samples", options->settings.samples, "Distinct balls, up to 10000000", 1, kMostSamples);
  command.whole("--repetitions", options->settings.repetitions, "The number of turns of each library", 1, 100'000);
  program::declare_seed(command, options->settings.seed, "Any number; the same seed gives the same balls");
  command.whole("--max-faces", options->most_triangles,
                "Triangles of the largest scene, up to 10000000 (which takes 12 GiB)", kFewest, kMost);
  command.text("--meshes", options->meshes, "A folder of meshes, also measured, once and replicated").takes("FOLDER");
  program::declare_output(command, *options, "The folder for tables and pictures", true);
  program::declare_quiet(command, options->quiet);
  command.writes(tables());
  command.help().examples.emplace_back("bench-scenes --max-faces 10000");
  command.runs([options] { return measure_scenes(*options); });
  return command;
}

}  // namespace touchstone::commands
