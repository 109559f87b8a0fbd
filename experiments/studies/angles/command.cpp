// SPDX-License-Identifier: GPL-3.0-or-later
// A study in one file: are methods wrong more often from some directions? The ball's centre goes around an edge of a
// random polygon, from beside it over it to above the face, at the same distance; the radius is the double nearest to
// that distance, and one double less and more.
#include <fmt/core.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "experiments/cases/failures.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/methods/selection.h"
#include "experiments/run/study.h"

namespace touchstone::angles {
namespace {

using cases::Failures;
using cases::SampledFailures;

struct Options : run::StudyOptions {
  methods::Selection methods{{"fast", "fast-float", "thesis", "thesis-signed", "filtered"}};
  std::vector<std::string> families{"all"};
  std::size_t vertices = 24;
};

constexpr int kDegrees = 10;  // between neighbouring directions
constexpr std::size_t kAngles = 180 / kDegrees + 1;
constexpr std::array<std::int64_t, 3> kOffsets{-1, 0, 1};  // of the radius, in doubles

struct Sum {
  std::uint64_t samples = 0;
  std::uint64_t missing = 0;                                ///< directions from which another feature is nearer
  std::vector<std::array<SampledFailures, kAngles>> count;  ///< by method

  auto members() { return std::tie(samples, missing, count); }
};

std::uint64_t items_done(const Sum& sum) { return sum.samples; }

struct Row {
  std::size_t angle;
  std::string_view method;
  SampledFailures count;
  run::Rate rate;
};

const run::Table<Row>& table() {
  using run::path;
  static const run::Table<Row> table(
      "angles.csv", "a direction and a method",
      run::all_columns<Row>(
          {{{"angle_deg", "of the centre about the edge: 0 beside it in the plane, 90 above it, 180 over the face",
             [](const Row& row) { return row.angle * kDegrees; }},
            {"method", "the method", &Row::method},
            {"failed_samples", "polygons with a wrong answer; undecided answers are not wrong",
             path(&Row::count, path(&SampledFailures::samples, &Failures::wrong))},
            {"samples", "polygons", path(&Row::count, path(&SampledFailures::samples, &Failures::trials))}},
           run::rate_columns<Row>("failed samples", &Row::rate),
           {{"wrong_answers", "wrong answers, of three for each polygon",
             path(&Row::count, path(&SampledFailures::answers, &Failures::wrong))}}}));
  return table;
}

/// Sample n of each family: one edge of one polygon, and balls around it.
class Study {
 public:
  explicit Study(const Options& options)
      : options_(options), methods_(options.methods.methods()), families_(workloads::find_families(options.families)) {
    workloads::require_vertices(families_, options.vertices);
  }

  [[nodiscard]] Sum zero() const {
    return {.count = std::vector<std::array<SampledFailures, kAngles>>(methods_.size())};
  }

  void ask(std::uint64_t n, Sum& sum) const {
    for (const workloads::Family family : families_) ask(family, n, sum);
    ++sum.samples;
  }

  [[nodiscard]] std::vector<Row> rows(const Sum& sum) const {
    std::vector<Row> rows;
    for (std::size_t angle = 0; angle < kAngles; ++angle)
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        const SampledFailures& count = sum.count[m][angle];
        rows.push_back({angle, methods_[m]->name(), count, count.samples.rate()});
      }
    return rows;
  }

 private:
  void ask(workloads::Family family, std::uint64_t n, Sum& sum) const {
    const workloads::Workload workload{
        .family = family, .placement = workloads::Placement::Rotated, .vertices = options_.vertices};
    const Polygon polygon = workloads::sample(workload, options_.seed, n).polygon;
    const auto exact = methods::find_method("exact")->prepare(polygon);
    std::vector<std::unique_ptr<cases::PreparedMethod>> prepared;
    for (const auto* method : methods_) prepared.push_back(method->prepare(polygon));

    workloads::Random random(options_.seed, n, kStream);
    const auto last = static_cast<std::int64_t>(polygon.loop_end(0)) - 1;
    const auto edge = static_cast<std::size_t>(random.integer(0, last));
    const Eigen::Vector3d a = polygon.vertex(edge), b = polygon.vertex(polygon.next(edge));
    const Eigen::Vector3d point = a + (0.25 + random.unit() / 2) * (b - a);
    const Eigen::Vector3d normal = workloads::normal_of(polygon, 0).normalized();
    // A loop goes counterclockwise about its own Newell normal, so this direction leads out of the polygon.
    const Eigen::Vector3d outward = (b - a).cross(normal).normalized();
    const double distance = (b - a).norm() * std::exp2(-1 - 8 * random.unit());
    for (std::size_t angle = 0; angle < kAngles; ++angle) {
      const double radians = static_cast<double>(angle * kDegrees) * std::numbers::pi / 180;
      const Eigen::Vector3d center = point + distance * (std::cos(radians) * outward + std::sin(radians) * normal);
      ask(edge, center, angle, *exact, prepared, sum);
    }
  }

  void ask(std::size_t edge, const Eigen::Vector3d& center, std::size_t angle, const cases::PreparedMethod& exact,
           const std::vector<std::unique_ptr<cases::PreparedMethod>>& prepared, Sum& sum) const {
    const auto nearest = exact.ask({center, 1}, cases::QueryKind::Answer);
    const bool is_near =
        nearest.nearest == Feature{Feature::Kind::Face} || nearest.nearest == Feature{Feature::Kind::Edge, edge};
    if (!is_near) {
      ++sum.missing;
      return;
    }
    std::array<cases::PartialAnswer, kOffsets.size()> truths;
    std::array<Ball, kOffsets.size()> balls;
    for (std::size_t i = 0; i < kOffsets.size(); ++i) {
      balls[i] = {center, workloads::move_radius_by_doubles(*nearest.distance, kOffsets[i])};
      truths[i] = exact.ask(balls[i], cases::QueryKind::Contact);
    }
    for (std::size_t m = 0; m < prepared.size(); ++m) {
      Failures answers;
      for (std::size_t i = 0; i < kOffsets.size(); ++i)
        answers.add(
            compare(cases::Test::Contact, prepared[m]->ask(balls[i], cases::QueryKind::Contact), truths[i], true));
      sum.count[m][angle].samples.add_sample(answers.wrong > 0);
      run::add(sum.count[m][angle].answers, answers);
    }
  }

  static constexpr std::uint64_t kStream = 0x616e676c65;
  const Options& options_;
  std::vector<const cases::Method*> methods_;
  std::vector<workloads::Family> families_;
};

int run_angles(run::StudyRun& run, const Options& options) {
  const Study study(options);
  const Sum sum =
      run.phase("samples", "checkpoint.json", options.samples, study.zero(), [&](const auto& control, Sum& so_far) {
        run::run_sweep(options.samples, options.threads, control, study.zero(), so_far,
                       [&](std::uint64_t n, Sum& part) { study.ask(n, part); });
      });
  if (run.is_part()) return run.finish({.done = sum.samples});
  const auto rows = study.rows(sum);
  table().write(run.folder(), rows);
  return run.finish({.done = sum.samples,
                     .text = table().aligned(rows) +
                             fmt::format("{} directions of {} samples were left out: another feature is nearer.\n",
                                         sum.missing, sum.samples)});
}

}  // namespace
}  // namespace touchstone::angles

namespace touchstone::commands {

run::Command angles_command() {
  using angles::Options;
  constexpr int kVersion = 2;  // raised when sample n of a seed changes
  run::Command command("angles", "Measure how often methods are wrong around an edge, direction by direction");
  auto options = std::make_shared<Options>();
  options->samples = 100;
  options->output = "results/angles";
  options->has_pictures = false;
  methods::declare_compared_methods(command, options->methods);
  command.families(options->families).changes_results([options] {
    return workloads::selected_names(options->families);
  });
  command
      .whole("--vertices", options->vertices, "Vertices of the polygons, approximate; families round it", 3,
             workloads::kMostVertices)
      .changes_results();
  run::declare_study(command, *options, "--samples", "Polygons of each family");
  command.writes({angles::table().description()});
  command.example("angles --samples 10");
  command.runs(run::study_runner(command, kVersion, options, angles::run_angles));
  return command;
}

}  // namespace touchstone::commands
