// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/missed_study.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/program/printing.h"
#include "experiments/program/statistics/shares.h"
#include "experiments/program/study.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/first_contact/first_contact.h"
#include "experiments/thesis/cell/kinematics/layout.h"

namespace touchstone::kinematics {
namespace {

constexpr std::uint64_t kBlock = 16;

const Layout& layout() {
  static const Layout layout = chosen_layout();
  return layout;
}

void add(Missed& sum, const Missed& part) {
  sum.contacts += part.contacts, sum.missed += part.missed, sum.early += part.early;
}

void ask(const ThroughSheet& sample, std::size_t radius, MissedStudy& study) {
  const scene::Faces faces{{}, {sample.sheet}};
  const auto contact = first_contact(sample.arc, kRadii[radius], faces);
  if (contact && contact->kind == FirstContact::Kind::AtStart) return;
  if (contact) study.widest = std::max(study.widest, contact->high - contact->low);
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const auto stop = stepped_contact(sample.arc, kRadii[radius], kSteps[i], faces);
    Missed& counts = study.counts[radius][i];
    if (stop && (!contact || stop->degrees < contact->low)) ++counts.early;
    if (!contact) continue;
    const double next = std::ceil(contact->high / kSteps[i]) * kSteps[i];
    if (next > sample.arc.degrees) continue;
    ++counts.contacts;
    if (!stop || stop->degrees > next) ++counts.missed;
  }
}

struct MissedRow {
  double radius, step;
  Missed counts;
  program::Rate missed;
};

const program::Table<MissedRow>& missed_csv() {
  using program::path;
  constexpr const char* kFormat = "{:.6g}";
  static const program::Table<MissedRow> table(
      "missed.csv", "a radius of the sphere and a step of the joint",
      {{"radius_mm", "of the sphere", &MissedRow::radius},
       {"step_deg", "of the joint", &MissedRow::step},
       {"contacts", "certified contacts, not at the start", path(&MissedRow::counts, &Missed::contacts)},
       {"missed", "contacts that stepping misses", path(&MissedRow::counts, &Missed::missed)},
       {"early", "stops that touch before the certified contact: 0", path(&MissedRow::counts, &Missed::early)},
       {"share", "the share of contacts that stepping misses", path(&MissedRow::missed, &program::Rate::share),
        kFormat},
       {"lower", "its lower limit", path(&MissedRow::missed, &program::Rate::lower), kFormat},
       {"upper", "its upper limit", path(&MissedRow::missed, &program::Rate::upper), kFormat}});
  return table;
}

}  // namespace

ThroughSheet draw_through_sheet(std::uint64_t seed, std::uint64_t n) {
  workloads::Random random(seed, n, 96);
  const auto between = [&random](double low, double high) { return low + (high - low) * random.unit(); };
  const Chain chain = aristo(layout().coupling, layout().hand);
  Angles angles = home_pose(layout());
  angles[kBase] += between(-90, 0);
  angles[kShoulder] += between(-20, 20);
  angles[kElbow] += between(-20, 20);
  const auto joint = static_cast<std::size_t>(random.integer(kBase, kElbow));
  const double size = between(30, 45);
  const bool up = random.coin();
  // The other way, where the joint's limits leave no room for this one.
  const double move = (chain.room(angles, joint, up) >= size) == up ? size : -size;
  const Arc arc = chain.arc(angles, joint, move, sphere_center(layout()));

  const double at = between(2, arc.degrees - 2);
  const Eigen::Vector3d center = point_at(arc, at);
  const Eigen::Vector3d way = arc.axis.cross(center - arc.point).normalized();
  const Eigen::Vector3d across = arc.axis.normalized(), out = way.cross(across);
  const double tilt = between(0, 60), turn = between(0, 360);
  const Eigen::Vector3d aside = workloads::cosine(turn) * across + workloads::sine(turn) * out;
  const Eigen::Vector3d u = workloads::cosine(tilt) * aside + workloads::sine(tilt) * way, v = way.cross(aside);
  const double half_u = between(30, 80), half_v = between(30, 80);
  const double off_v = between(-half_v, half_v), off_u = between(-half_u, half_u);
  const Eigen::Vector3d middle = center + off_u * u + off_v * v;
  return {arc, Polygon({middle - half_u * u - half_v * v, middle + half_u * u - half_v * v,
                        middle + half_u * u + half_v * v, middle - half_u * u + half_v * v})};
}

std::uint64_t blocks_of(std::uint64_t samples) { return (samples + kBlock - 1) / kBlock; }

MissedStudy study_missed(std::uint64_t seed, std::uint64_t samples, unsigned threads, const std::atomic<bool>& stop,
                         const program::Progress& progress) {
  std::vector<MissedStudy> parts(threads);
  const std::uint64_t done =
      program::run_blocks(blocks_of(samples), threads, stop, progress, [&](unsigned thread, std::uint64_t block) {
        for (std::uint64_t n = block * kBlock; n < std::min(samples, (block + 1) * kBlock); ++n) {
          const ThroughSheet sample = draw_through_sheet(seed, n);
          for (std::size_t radius = 0; radius < kRadii.size(); ++radius) ask(sample, radius, parts[thread]);
        }
      });
  MissedStudy sum;
  sum.samples = std::min(samples, done * kBlock);
  for (const MissedStudy& part : parts) {
    sum.widest = std::max(sum.widest, part.widest);
    for (std::size_t r = 0; r < kRadii.size(); ++r)
      for (std::size_t s = 0; s < kSteps.size(); ++s) add(sum.counts[r][s], part.counts[r][s]);
  }
  return sum;
}

void write_missed(const std::filesystem::path& folder, const MissedStudy& study) {
  std::vector<MissedRow> rows;
  for (std::size_t r = 0; r < kRadii.size(); ++r)
    for (std::size_t s = 0; s < kSteps.size(); ++s) {
      const Missed& counts = study.counts[r][s];
      rows.push_back({kRadii[r], kSteps[s], counts, program::rate(counts.missed, counts.contacts)});
    }
  missed_csv().write(folder, rows);
}

std::vector<program::TableDescription> missed_tables() { return {missed_csv().description()}; }

std::string missed_table(const MissedStudy& study) {
  std::string text =
      "certified contacts with a thin sheet that stepping misses, % (in brackets: 95 % upper limit)\nradius";
  for (const double step : kSteps) text += fmt::format("{:>17}", fmt::format("every {}°", step));
  text += '\n';
  std::uint64_t early = 0;
  for (std::size_t r = 0; r < kRadii.size(); ++r) {
    text += fmt::format("{:>3} mm", kRadii[r]);
    for (const Missed& m : study.counts[r]) {
      early += m.early;
      const double upper = statistics::clopper_pearson(m.missed, m.contacts).upper;
      text += fmt::format("{:>8} ({:>6})", statistics::percent_to_places(statistics::share_of(m.missed, m.contacts), 2),
                          statistics::percent_to_places(upper, 2));
    }
    text += '\n';
  }
  text += fmt::format(
      "{} of one joint; certified first contacts are enclosed to {:.2g} degrees; stops that touch before them: "
      "{}\n",
      program::counted(study.samples, "move"), study.widest, early);
  return text;
}

}  // namespace touchstone::kinematics

namespace touchstone::cell {
namespace {

struct MissedOptions : program::FolderOptions {
  std::uint64_t samples = 2000, seed = 1;
  unsigned threads = program::all_threads();
};

int run_missed(const MissedOptions& options) {
  program::CommandRun run(options);
  const auto study = [&] {
    program::ProgressLine line = run.progress("moves", kinematics::blocks_of(options.samples));
    return kinematics::study_missed(options.seed, options.samples, options.threads, run.stop(), std::ref(line));
  }();
  kinematics::write_missed(run.folder(), study);
  const int drawn = run.finish({.seed = options.seed,
                                .samples_asked = options.samples,
                                .samples_done = study.samples,
                                .threads = options.threads},
                               kinematics::missed_table(study), "cell_missed");
  if (study.samples < options.samples) {
    fmt::print(stderr, "touchstone: interrupted: {} covers the first {} of {} moves\n", options.output, study.samples,
               options.samples);
    return program::kInterrupted;
  }
  return drawn;
}

}  // namespace

program::Command missed_command() {
  auto options = std::make_shared<MissedOptions>();
  options->output = "results/cell-missed";
  program::Command command("missed", "Contacts that stepping misses and the certified search finds");
  command.help().footer =
      "Moves one joint of the arm through thin sheets at random. Counts how often stepping, which tests for contact "
      "only after each step, misses the first contact, for spheres and steps of several sizes.";
  command.whole("--samples", options->samples, "Moves", 1, program::kMostSamples);
  program::declare_seed(command, options->seed);
  program::declare_threads(command, options->threads);
  program::declare_output(command, *options, "Folder for missed.csv, run.json and the picture", true);
  program::declare_quiet(command, options->quiet);
  command.writes(kinematics::missed_tables());
  command.help().examples.emplace_back("cell missed --samples 100");
  command.runs([options] { return run_missed(*options); });
  return command;
}

}  // namespace touchstone::cell
