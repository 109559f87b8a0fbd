// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <limits>
#include <memory>
#include <utility>

#include "experiments/cases/workloads/meshes.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/numbers.h"
#include "experiments/run/output.h"
#include "experiments/run/study.h"
#include "experiments/studies/meshes/measure.h"

namespace touchstone::commands {
namespace {

using namespace meshes;

struct Options : run::StudyOptions {
  std::vector<std::string> files;
  methods::Selection methods{{"all"}};
  bool skip_bad = false;
};

// Raised when the balls of a face change, or the form of what is kept.
constexpr int kVersion = 1;

// More than --faces takes, so that help has no default.
constexpr std::uint64_t kAllFaces = std::numeric_limits<std::uint64_t>::max();

/// Reports faces that are not polygons, unless they may be skipped. Returns the exit status.
int tell_rejected(const Options& options, const Result& result) {
  if (result.rejected.empty() || options.skip_bad) return 0;
  fmt::print(stderr, "touchstone: {}; with --skip-bad this is not an error\n",
             run::counted(result.rejected.size(), "rejected face"));
  return 2;
}

int run_meshes(run::StudyRun& run, const Options& options) {
  constexpr int kBadInput = 2;
  const Settings settings{options.methods.methods(), options.seed, options.samples, options.threads};
  workloads::NamedFiles files =
      workloads::read_named_files(options.files, options.skip_bad ? OnFault::Skip : OnFault::Refuse);
  std::vector<NamedMesh> meshes;
  for (auto& file : files.read) meshes.push_back({file.name, std::move(file.content.mesh)});
  if (meshes.empty()) return kBadInput;

  const std::uint64_t faces = face_count(settings, meshes);
  const Result result = run.phase("faces", "part.json", faces, no_result(settings, meshes),
                                  [&](const auto& control, Result& sum) { measure(settings, meshes, control, sum); });
  run::StudyRun::End end{.done = items_done(result), .missing = result.rejected.size(), .items = faces};
  if (!files.all_read && !run.stopped()) end.status = kBadInput;
  if (run.is_part()) return run.finish(end);
  write_meshes(run.folder(), settings, meshes, result);
  write_rejected(run.folder(), meshes, result);
  write_failures(run.folder(), settings, meshes, result);
  run::write_file(run.folder() / "left-out.txt", workloads::left_out_text(files));
  end.text = fmt::format("{}\n{} of {} faces in {} of {} meshes, {} of files left out; seed {}.\n",
                         table(settings, meshes, result), end.done, faces, meshes.size(), options.files.size(),
                         run::counted(files.parts_left_out, "part"), settings.seed);
  const int status = run.finish(end);
  return status == 0 ? tell_rejected(options, result) : status;
}

}  // namespace

run::Command meshes_command() {
  run::Command command("meshes", "Count wrong answers near every face of meshes (OBJ, OFF, STL, PLY)");
  auto options = std::make_shared<Options>();
  options->samples = kAllFaces;
  options->output = "results/meshes";
  options->has_pictures = false;
  run::declare_meshes(command, options->files, "Mesh files").changes_results([options] {
    return workloads::with_hashes(options->files);
  });
  methods::declare_compared_methods(command, options->methods);
  command
      .flag("--skip-bad", options->skip_bad,
            "Leave out faulty parts of a file, and report them; rejected faces are then not an error")
      .changes_results([options] { return std::string(run::yes_or_no(options->skip_bad)); });
  run::declare_study(command, *options, "--faces",
                     "The number of faces of each mesh to test, from the first on (default: all)")
      .changes_results(
          [options] { return options->samples == kAllFaces ? std::string("all") : std::to_string(options->samples); });
  command.writes(tables());
  command.help().examples.emplace_back("meshes part.obj --methods fast,filtered");
  command.runs(run::study_runner(command, kVersion, options, run_meshes));
  return command;
}

}  // namespace touchstone::commands
