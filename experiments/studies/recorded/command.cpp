// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of a simulation that was written by others: Bullet steps balls that pile up on uneven ground; every
// question of ball and triangle that its narrow phase asks is asked again, of exact arithmetic and of other methods.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>

#include "experiments/cases/failures.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/methods/registry.h"
#include "experiments/program/study.h"
#include "experiments/studies/recorded/measure.h"

namespace touchstone::recorded {
namespace {

struct Options : program::StudyOptions {
  methods::Selection methods{
      {"fast", "fast-float", "thesis", "cgal-double-distance", "cgal-epick-distance", "filtered"}};
  std::size_t balls = 24, steps = 180;
};

/// The radii that are asked about: the ball's, and that with Bullet's threshold.
enum class Radius { Own, WithThreshold };
constexpr std::array kRadii{Radius::Own, Radius::WithThreshold};
std::string_view to_string(Radius radius) { return radius == Radius::Own ? "own" : "with threshold"; }

/// The answers of one method about piles, which are the samples.
struct MethodFailures : cases::SampledFailures {
  program::Maximum<double> furthest;  ///< wrong answer from contact, as a share of the triangle's size

  auto members() { return std::tuple_cat(SampledFailures::members(), std::tie(furthest)); }
};

constexpr std::size_t kMostExponent = 60;

/// The questions of one simulation at one radius.
struct Part {
  std::uint64_t questions = 0, touching = 0;
  std::array<std::uint64_t, kMostExponent + 1> near{};  ///< [k]: at most 2^-k of the triangle's size from contact
  std::vector<MethodFailures> methods;                  ///< the simulation's own answers, then by method

  auto members() { return std::tie(questions, touching, near, methods); }
};

struct Sum {
  std::uint64_t samples = 0;
  std::vector<std::array<Part, kRadii.size()>> parts;  ///< by simulation

  auto members() { return std::tie(samples, parts); }
};

std::uint64_t items_done(const Sum& sum) { return sum.samples; }

struct Row {
  std::string_view simulation;
  Radius radius;
  std::string_view method;
  const Part* part;
  const MethodFailures* failures;
  program::Rate rate, pile_rate;
};

const program::Table<Row>& table() {
  using cases::Failures;
  using program::path;
  static const program::Table<Row> table(
      "recorded.csv", "a simulation, a radius and a method",
      program::all_columns<Row>(
          {{{"simulation", "the engine that stepped the piles: Bullet's build in doubles or in floats",
             &Row::simulation},
            {"radius", "`own`: the ball's; `with threshold`: with the contact breaking threshold that Bullet adds",
             &Row::radius},
            {"method", "the method; that of the simulation's name stands for the answers that the simulation got",
             &Row::method},
            {"questions", "questions of ball and triangle", path(&Row::part, &Part::questions)},
            {"touching", "of these, contacts", path(&Row::part, &Part::touching)},
            {"wrong", "answers that differ from those of `exact`",
             path(&Row::failures, path(&MethodFailures::answers, &Failures::wrong))}},
           program::rate_columns<Row>(
               "wrong answers, as if questions were independent, which those of one pile are not", &Row::rate),
           {{"failed_piles", "piles with a wrong answer",
             path(&Row::failures, path(&MethodFailures::samples, &Failures::wrong))},
            {"piles", "piles, which are independent",
             path(&Row::failures, path(&MethodFailures::samples, &Failures::trials))}},
           program::rate_columns<Row>("failed piles", &Row::pile_rate, "piles_"),
           {{"furthest",
             "of the wrong answers, the largest difference of distance and radius, as a share of the triangle's "
             "largest coordinate difference",
             path(&Row::failures, path(&MethodFailures::furthest, &program::Maximum<double>::value))}}}));
  return table;
}

struct NearRow {
  std::string_view simulation;
  Radius radius;
  std::size_t exponent;
  std::uint64_t questions, of;
};

const program::Table<NearRow>& near_table() {
  static const program::Table<NearRow> table(
      "near.csv", "a simulation, a radius and an exponent",
      {{"simulation", "the engine that stepped the piles", &NearRow::simulation},
       {"radius", "as in recorded.csv", &NearRow::radius},
       {"exponent", "k", &NearRow::exponent},
       {"near", "questions whose radius differs from the distance by at most 2^-k of the triangle's size",
        &NearRow::questions},
       {"questions", "all questions", &NearRow::of}});
  return table;
}

class Study {
 public:
  explicit Study(const Options& options)
      : options_(options), methods_(options.methods.methods()), exact_(*methods::find_method("exact")) {}

  [[nodiscard]] Sum zero() const {
    Part part;
    part.methods.resize(1 + methods_.size());
    Sum sum;
    sum.parts.resize(simulations().size(), {part, part});
    return sum;
  }

  void ask(std::uint64_t n, Sum& sum) const {
    const Pile pile = draw_pile(options_.seed, n, options_.balls);
    for (std::size_t s = 0; s < simulations().size(); ++s) ask(pile, simulations()[s], sum.parts[s]);
    ++sum.samples;
  }

  [[nodiscard]] std::vector<Row> rows(const Sum& sum) const {
    std::vector<Row> rows;
    for (std::size_t s = 0; s < sum.parts.size(); ++s)
      for (const Radius radius : kRadii) {
        const Part& part = sum.parts[s][static_cast<std::size_t>(radius)];
        for (std::size_t m = 0; m < part.methods.size(); ++m) {
          const MethodFailures& failures = part.methods[m];
          rows.push_back({simulations()[s].name, radius, m == 0 ? simulations()[s].name : methods_[m - 1]->name(),
                          &part, &failures, failures.answers.rate(), failures.samples.rate()});
        }
      }
    return rows;
  }

  [[nodiscard]] static std::vector<NearRow> near_rows(const Sum& sum) {
    std::vector<NearRow> rows;
    for (std::size_t s = 0; s < sum.parts.size(); ++s)
      for (const Radius radius : kRadii) {
        const Part& part = sum.parts[s][static_cast<std::size_t>(radius)];
        for (std::size_t k = 0; k <= kMostExponent; ++k)
          rows.push_back({simulations()[s].name, radius, k, part.near[k], part.questions});
      }
    return rows;
  }

 private:
  using Parts = std::array<Part, kRadii.size()>;

  void ask(const Pile& pile, const Simulation& simulation, Parts& parts) const {
    std::map<std::size_t, std::vector<Question>> of_triangle;
    for (Question& question : record(simulation, pile, options_.steps))
      of_triangle[question.triangle].push_back(question);
    std::array<std::vector<bool>, kRadii.size()> failed;
    for (auto& list : failed) list.resize(1 + methods_.size());
    for (const auto& [triangle, questions] : of_triangle) ask(pile.triangle(triangle), questions, parts, failed);
    for (std::size_t r = 0; r < kRadii.size(); ++r)
      for (std::size_t m = 0; m < failed[r].size(); ++m) parts[r].methods[m].samples.add_sample(failed[r][m]);
  }

  void ask(const Triangle& triangle, const std::vector<Question>& questions, Parts& parts,
           std::array<std::vector<bool>, kRadii.size()>& failed) const {
    const Polygon polygon({triangle.a, triangle.b, triangle.c});
    const double size = workloads::extent_of(polygon);
    const auto truth = exact_.prepare(polygon);
    std::vector<std::unique_ptr<cases::PreparedMethod>> prepared;
    for (const auto* method : methods_) prepared.push_back(method->prepare(polygon));
    for (const Question& question : questions) {
      const double distance = *truth->ask(question.ball, cases::QueryKind::Answer).distance;
      for (std::size_t r = 0; r < kRadii.size(); ++r) {
        const bool own = kRadii[r] == Radius::Own;
        const Ball ball{question.ball.center, own ? question.ball.radius : question.within_radius};
        const auto right = truth->ask(ball, cases::QueryKind::Contact);
        const double share = std::abs(distance - ball.radius) / size;
        Part& part = parts[r];
        ++part.questions;
        part.touching += *right.contact ? 1 : 0;
        for (std::size_t k = 0; k <= kMostExponent && share <= std::ldexp(1, -static_cast<int>(k)); ++k) ++part.near[k];
        const auto count = [&](std::size_t m, const cases::PartialAnswer& answer) {
          const auto outcome = compare(cases::Test::Contact, answer, right, true);
          part.methods[m].answers.add(outcome);
          if (!outcome || *outcome == cases::Outcome::Right) return;
          part.methods[m].furthest += share;
          failed[r][m] = true;
        };
        cases::PartialAnswer simulated;
        simulated.contact = own ? question.contact : question.within;
        count(0, simulated);
        for (std::size_t m = 0; m < prepared.size(); ++m)
          count(1 + m, prepared[m]->ask(ball, cases::QueryKind::Contact));
      }
    }
  }

  const Options& options_;
  std::vector<const cases::Method*> methods_;
  const cases::Method& exact_;
};

int run_recorded(program::StudyRun& run, const Options& options) {
  if (simulations().empty())
    throw std::runtime_error("this program was built without Bullet (libbullet-dev), which steps the piles");
  const Study study(options);
  const Sum sum = run.phase("piles", "part.json", options.samples, study.zero(), [&](const auto& control, Sum& so_far) {
    program::run_sweep(options.samples, options.threads, control, study.zero(), so_far,
                       [&](std::uint64_t n, Sum& part) { study.ask(n, part); });
  });
  if (run.is_part()) return run.finish({.done = sum.samples});
  const auto rows = study.rows(sum);
  table().write(run.folder(), rows);
  near_table().write(run.folder(), Study::near_rows(sum));
  return run.finish({.done = sum.samples, .text = table().aligned(rows)});
}

}  // namespace
}  // namespace touchstone::recorded

namespace touchstone::commands {

program::Command recorded_command() {
  using recorded::Options;
  constexpr int kVersion = 2;  // raised when pile n of a seed changes
  program::Command command("recorded", "Replay every ball-triangle query of a Bullet simulation of piled balls");
  auto options = std::make_shared<Options>();
  options->samples = 100;
  options->output = "results/recorded";
  options->has_pictures = false;
  methods::declare_compared_methods(command, options->methods);
  command.whole("--balls", options->balls, "Balls of a pile", 1, 1000).changes_results();
  command.whole("--steps", options->steps, "Steps of 1/60 s", 1, 100'000).changes_results();
  program::declare_study(command, *options, "--samples", "Piles");
  command.writes({recorded::table().description(), recorded::near_table().description()});
  command.help().examples.emplace_back("recorded --samples 2");
  command.runs(program::study_runner(command, kVersion, options, recorded::run_recorded));
  return command;
}

}  // namespace touchstone::commands
