// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/study.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "experiments/program/input.h"
#include "experiments/program/output.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "experiments/thesis/figures/drawn_cell.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;

using Task = std::function<void()>;

constexpr int kLowestRadius = 150, kHighestRadius = 720;  // of the area of configuration
constexpr int kHighestHeight = 700;
constexpr int kFurthestOffset = 15;  // a power of ten, mm
constexpr std::size_t kMapPoints = 180;
constexpr std::uint64_t kFlowcharts = 128;  // the first of their streams of random numbers
constexpr double kFlowchartRadius = kRadii[2];

/// The links' model files, written and read again; and that of the machine's bottom part.
std::vector<LinkFile> link_files(const std::vector<cell::ModelPart>& parts) {
  std::vector<cell::ModelPart> shown;
  std::ranges::copy_if(parts, std::back_inserter(shown), [](const cell::ModelPart& part) {
    return part.carrier == cell::Carrier::Link || part.carrier == cell::Carrier::Gripper ||
           part.name == "machine/bottom";
  });
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("touchstone-thesis-" + std::to_string(::getpid()));
  program::make_folder(folder);
  std::vector<LinkFile> files;
  for (const auto& [name, model] : cell::link_models(shown)) {
    files.push_back({model, cell::link_model_text(model)});
    program::write_file(folder / "model.txt", files.back().text);
    files.back().same = cell::read_link_model(folder / "model.txt") == model;
  }
  std::filesystem::remove_all(folder);
  return files;
}

/// The work that is shared out among threads: each task has a place of its own to write to.
std::vector<Task> tasks_of(Study& study) {
  const Settings& settings = study.settings;
  const std::uint64_t samples = settings.samples, seed = settings.seed;
  const Outline& gripper = study.gripper();
  std::vector<Task> tasks;

  study.flowcharts.resize(study.outlines.size() * kRadii.size(), {nullptr, 0});
  study.areas.resize(study.outlines.size(), {nullptr});
  for (std::size_t i = 0; i < study.outlines.size(); ++i) {
    for (std::size_t k = 0; k < kRadii.size(); ++k)
      tasks.emplace_back([&study, samples, seed, i, k] {
        const std::size_t number = i * kRadii.size() + k;
        study.flowcharts[number] = measure_flowchart(study.outlines[i], kRadii[k], samples, seed, kFlowcharts + number);
      });
    tasks.emplace_back(
        [&study, samples, seed, i] { study.areas[i] = measure_false_area(study.outlines[i], 10 * samples, seed); });
  }

  const auto along = static_cast<std::size_t>(2 * kinematics::kHomeReach / settings.home_step) + 1;
  study.homes.resize(along * along);
  for (std::size_t row = 0; row < along; ++row)
    tasks.emplace_back([&study, along, row, step = static_cast<double>(settings.home_step)] {
      const auto angle = [&](std::size_t i) { return step * static_cast<double>(i) - kinematics::kHomeReach; };
      for (std::size_t i = 0; i < along; ++i)
        study.homes[row * along + i] = kinematics::study_home(
            {kinematics::Coupling::KeepsElevation, kinematics::Hand::Level}, {angle(i), angle(row)});
    });

  const double height = study.cell.storage.height;
  const auto scan = [&](std::vector<cell::Tried>& places, std::size_t count, bool sphere_alone, const auto& place_of) {
    places.resize(count);
    constexpr std::size_t kBlock = 20;
    for (std::size_t begin = 0; begin < count; begin += kBlock)
      tasks.emplace_back([&study, &places, sphere_alone, begin, end = std::min(count, begin + kBlock), place_of] {
        for (std::size_t i = begin; i < end; ++i) {
          const auto [angle, radius, its_height] = place_of(i);
          places[i] = cell::try_place(study.cell, study.parts, study.covered, {.sphere_alone = sphere_alone}, angle,
                                      radius, its_height);
        }
      });
  };
  struct Where {
    double angle, radius, height;
  };
  const auto count = [](int range, int step) { return static_cast<std::size_t>(range / step) + 1; };
  const std::size_t radii = count(kHighestRadius - kLowestRadius, settings.radius_step);
  const auto angles = static_cast<std::size_t>(360 / settings.angle_step);
  for (const bool sphere_alone : {false, true})
    scan(sphere_alone ? study.area_of_sphere : study.area, angles * radii, sphere_alone, [=](std::size_t i) {
      return Where{-180.0 + settings.angle_step * static_cast<int>(i / radii),
                   kLowestRadius + static_cast<double>(settings.radius_step) * static_cast<double>(i % radii), height};
    });
  // Along a line, and the case study's own place among them.
  const auto line = [](int lowest, int highest, int step, double own) {
    std::vector<double> values{own};
    for (int value = lowest; value <= highest; value += step)
      if (value != own) values.push_back(value);
    std::ranges::sort(values);
    return values;
  };
  const auto tried_radii = line(kLowestRadius, kHighestRadius, settings.radius_scan, study.cell.storage.radius);
  scan(study.radii, tried_radii.size(), false, [=, first_angle = study.cell.storage.angle](std::size_t i) {
    return Where{first_angle, tried_radii[i], height};
  });
  // The stand must reach above the floor.
  const int lowest = study.cell.storage.stand ? static_cast<int>(-study.cell.storage.stand->top) + 5 : 5;
  for (std::size_t place = 0; place < study.cases.size(); ++place) {
    const cell::Station& storage = study.cases[place].cell.storage;
    const auto tried_heights = line(lowest, kHighestHeight, settings.height_scan, storage.height);
    for (const bool sphere_alone : {false, true})
      scan(sphere_alone ? study.heights_of_sphere[place] : study.heights[place], tried_heights.size(), sphere_alone,
           [=, angle = storage.angle, radius = storage.radius](std::size_t i) {
             return Where{angle, radius, tried_heights[i]};
           });
  }
  tasks.emplace_back([&study] { study.predictions = predict(chosen_layout()); });
  study.sensitivities.resize(parameters().size());
  for (std::size_t i = 0; i < parameters().size(); ++i)
    tasks.emplace_back([&study, i] { study.sensitivities[i] = sensitivity(chosen_layout(), parameters()[i]); });

  tasks.emplace_back([&study, &gripper, samples, seed] {
    const CaseStudy& first = study.cases[0];
    const std::size_t stop = first.moments.at(std::min<std::size_t>(2, first.moments.size() - 1)).stop;
    study.feet = measure_foot_errors(gripper_face(study.parts, first.snapshots[stop].links.back()),
                                     study.cell.gripper.sphere.radius, samples, seed);
    study.edges = measure_edge_places(gripper, kFlowchartRadius, samples, seed);
  });
  tasks.emplace_back([&study, &gripper] { study.map = map_angle_sums(gripper, kMapPoints); });
  tasks.emplace_back([&study, &gripper, samples, seed] {
    study.square_reach = measure_factor_reach(find_outline("square"));
    study.gripper_reach = measure_factor_reach(gripper);
    study.not_numbers = measure_not_numbers(gripper, samples, seed);
    for (std::size_t what = 0; what < study.touching.size(); ++what)
      study.touching[what] = measure_touching(gripper, static_cast<Touched>(what), samples, seed);
    study.collinear = measure_collinear(gripper, samples, seed);
  });
  study.far_away.resize(kFurthestOffset + 1, {0});
  for (int power = 0; power <= kFurthestOffset; ++power)
    tasks.emplace_back([&study, &gripper, samples, seed, power] {
      double offset = 1;
      for (int i = 0; i < power; ++i) offset *= 10;
      study.far_away[static_cast<std::size_t>(power)] = measure_far_away(gripper, offset, samples, seed);
    });
  return tasks;
}

std::uint64_t missed_moves(const Settings& settings) { return std::max<std::uint64_t>(16, settings.samples / 100); }

}  // namespace

Study begin_study(const Settings& settings, const std::vector<std::string>& changes) {
  Study study{};
  study.settings = settings;
  const auto file = program::data("experiments/thesis/cell/cells/aristo.json");
  const auto cell_of = [&](const char* name) {
    std::vector<std::string> all = cell::preset(file, name);
    all.insert(all.end(), changes.begin(), changes.end());
    return cell::read_cell(file, {}, all);
  };
  const std::array<cell::Cell, 2> cells{cell_of("case 1"), cell_of("case 2")};
  study.cell = cells[0];
  study.parts = cell::build_model(study.cell);
  study.covered = std::make_shared<const std::vector<cell::Covered>>(cell::cover_arm(study.parts));
  study.link_files = link_files(study.parts);
  study.outlines.push_back(gripper_outline(study.parts));
  for (const Outline& outline : outlines()) study.outlines.push_back(outline);
  study.plan = floor_plan(study.parts);
  for (std::size_t i = 0; i < cells.size(); ++i) study.cases[i] = study_case(cells[i], study.parts, study.covered, i);
  return study;
}

std::optional<Study> run_study(const Settings& settings, unsigned threads, const std::atomic<bool>& stop,
                               const StudyProgress& progress) {
  Study study = begin_study(settings);
  const std::vector<Task> tasks = tasks_of(study);
  const std::uint64_t moves = missed_moves(settings), total = tasks.size() + blocks_of(moves);
  const std::uint64_t done = program::run_blocks(
      tasks.size(), threads, stop, [&](std::uint64_t so_far) { progress(so_far, total); },
      [&](unsigned, std::uint64_t task) { tasks[task](); });
  if (done < tasks.size()) return std::nullopt;
  study.missed =
      study_missed(settings.seed, moves, threads, stop, [&](std::uint64_t blocks) { progress(done + blocks, total); });
  if (study.missed.samples < moves) return std::nullopt;
  return study;
}

}  // namespace touchstone::figures
