// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/study.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "experiments/cell/kinematics/solve_layout.h"
#include "experiments/cell/model/convert.h"
#include "experiments/cell/model/read_cell.h"
#include "experiments/harness/run_record.h"
#include "experiments/harness/write_file.h"
#include "experiments/thesis/drawn_cell.h"

namespace touchstone::thesis_figures {
namespace {

using namespace kinematics;

using Task = std::function<void()>;

constexpr int kLargestAngle = 60;
constexpr int kLowestRadius = 150, kHighestRadius = 720;  // of the area of configuration
constexpr int kHighestHeight = 900;
constexpr int kFurthestOffset = 15;  // a power of ten, mm
constexpr std::size_t kMapPoints = 180;
constexpr std::uint64_t kFlowcharts = 128;  // the first of their streams of random numbers
constexpr double kFlowchartRadius = kRadii[2];

/// The links' model files, written and read again; and that of the machine's bottom part.
std::vector<LinkFile> link_files(const std::vector<cell::ModelPart>& parts) {
  std::vector<LinkFile> files;
  const auto add = [&](const std::string& name, const cell::ModelPart& part) {
    if (files.empty() || files.back().model.name != name) files.push_back({{name, {}}, "", false});
    const std::size_t slash = part.name.find('/');
    files.back().model.parts.push_back(cell::link_part(part.name.substr(slash + 1), part.faces));
  };
  for (const cell::ModelPart& part : parts) {
    const std::string own = part.name.substr(part.name.find('/') + 1);
    if (part.carrier == cell::Carrier::Link) add(part.name.substr(0, part.name.find('/')), part);
    if (part.carrier == cell::Carrier::Gripper) add(own, part);
    if (part.name == "machine/bottom") add("machine-bottom", part);
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("touchstone-thesis-" + std::to_string(::getpid()));
  harness::make_folder(folder);
  for (LinkFile& file : files) {
    file.text = cell::link_model_text(file.model);
    harness::write_file(folder / "model.txt", file.text);
    file.same = cell::read_link_model(folder / "model.txt") == file.model;
    for (const char* mesh : {"mesh.obj", "mesh.off", "mesh.stl", "mesh.ply"}) {
      const cell::LinkModel written = cell::prepared(file.model, cell::Preparation::None, folder / mesh);
      harness::write_file(folder / mesh, cell::model_text(written, folder / mesh));
      ++file.converted;
      file.converted_same += cell::differences(written, cell::read_model(folder / mesh)).empty();
    }
  }
  std::filesystem::remove_all(folder);
  return files;
}

Predictions predict(const Layout& layout) {
  Predictions predictions;
  for (std::size_t place = 0; place < kCases.size(); ++place)
    for (int angle = -kLargestAngle; angle <= kLargestAngle; ++angle) {
      const SimulatedPath r = simulate(layout, layout.storage(place, angle));
      ++predictions.places;
      if (!r.complete()) continue;
      predictions.to_storage += -r.to_storage(kBase) == 150 - angle;
      predictions.to_machine += r.net(kBase) - r.to_storage(kBase) == 67 - angle;
      predictions.net += r.net(kElbow) == 35 && r.net(kShoulder) == 28;
    }
  return predictions;
}

/// The work that is shared out among threads: each task has a place of its own to write to.
std::vector<Task> tasks_of(Study& study) {
  const Settings& settings = study.settings;
  const std::uint64_t samples = settings.samples, seed = settings.seed;
  const stability::Outline& gripper = study.gripper();
  std::vector<Task> tasks;

  study.flowcharts.resize(study.outlines.size() * kRadii.size(), {nullptr, 0});
  study.areas.resize(study.outlines.size(), {nullptr});
  for (std::size_t i = 0; i < study.outlines.size(); ++i) {
    for (std::size_t k = 0; k < kRadii.size(); ++k)
      tasks.emplace_back([&study, samples, seed, i, k] {
        const std::size_t number = i * kRadii.size() + k;
        study.flowcharts[number] = measure_flowchart(study.outlines[i], kRadii[k], samples, seed, kFlowcharts + number);
      });
    tasks.emplace_back([&study, samples, seed, i] {
      study.areas[i] = stability::measure_false_area(study.outlines[i], 10 * samples, seed);
    });
  }

  const Layout& layout = study.layout;
  const double height = layout.storage_height[0], first_angle = kCases[0].storage_angle;
  const auto scan = [&](std::vector<StoragePosition>& places, std::size_t count, const auto& place_of) {
    places.resize(count);
    constexpr std::size_t kBlock = 50;
    for (std::size_t begin = 0; begin < count; begin += kBlock)
      tasks.emplace_back([&study, &places, begin, end = std::min(count, begin + kBlock), place_of] {
        for (std::size_t i = begin; i < end; ++i) {
          const auto [angle, radius, its_height] = place_of(i);
          places[i] = try_position(study.layout, study.plan, angle, radius, its_height);
        }
      });
  };
  struct Where {
    double angle, radius, height;
  };
  const auto count = [](int range, int step) { return static_cast<std::size_t>(range / step) + 1; };
  const std::size_t radii = count(kHighestRadius - kLowestRadius, settings.radius_step);
  const auto angles = static_cast<std::size_t>(360 / settings.angle_step);
  scan(study.area, angles * radii, [=](std::size_t i) {
    return Where{-180.0 + settings.angle_step * static_cast<int>(i / radii),
                 kLowestRadius + static_cast<double>(settings.radius_step) * static_cast<double>(i % radii), height};
  });
  scan(study.radii, count(kHighestRadius - kLowestRadius, settings.radius_scan), [=](std::size_t i) {
    return Where{first_angle, kLowestRadius + static_cast<double>(settings.radius_scan) * static_cast<double>(i),
                 height};
  });
  for (std::size_t place = 0; place < kCases.size(); ++place)
    scan(study.heights[place], count(kHighestHeight, settings.height_scan),
         [=, angle = kCases[place].storage_angle, radius = layout.storage_radius[place]](std::size_t i) {
           return Where{angle, radius, static_cast<double>(settings.height_scan) * static_cast<double>(i) + 1};
         });
  tasks.emplace_back([&study] { study.predictions = predict(study.layout); });

  tasks.emplace_back([&study, &gripper, samples, seed] {
    const auto& moments = study.cases[0].moments;
    const Angles& commanded = moments[std::min<std::size_t>(2, moments.size() - 1)].commanded;
    study.feet = measure_foot_errors(gripper_face(study.cell, study.parts, commanded), study.layout.sphere_radius,
                                     samples, seed);
    study.edges = measure_edge_places(gripper, kFlowchartRadius, samples, seed);
  });
  tasks.emplace_back([&study, &gripper] { study.map = stability::map_angle_sums(gripper, kMapPoints); });
  tasks.emplace_back([&study, &gripper, samples, seed] {
    study.square_reach = measure_factor_reach(stability::find_outline("square"));
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

Study begin_study(const Settings& settings, const Layout& layout) {
  Study study{};
  study.settings = settings;
  study.layout = layout;
  study.cell = cell::read_cell(harness::source_folder() / "experiments/cell/cells/aristo.json");
  study.parts = cell::build_model(study.cell);
  study.link_files = link_files(study.parts);
  study.outlines.push_back(gripper_outline(study.parts));
  for (const stability::Outline& outline : stability::outlines()) study.outlines.push_back(outline);
  study.plan = floor_plan(study.parts);
  for (std::size_t i = 0; i < kCases.size(); ++i) study.cases[i] = study_case(layout, i);
  return study;
}

std::optional<Study> run_study(const Settings& settings, unsigned threads, const std::atomic<bool>& stop,
                               const StudyProgress& progress) {
  Study study = begin_study(settings, chosen_layout());
  const std::vector<Task> tasks = tasks_of(study);
  const std::uint64_t moves = missed_moves(settings), total = tasks.size() + blocks_of(moves);
  const std::uint64_t done = harness::run_blocks(
      tasks.size(), threads, stop, [&](std::uint64_t so_far) { progress(so_far, total); },
      [&](unsigned, std::uint64_t task) { tasks[task](); });
  if (done < tasks.size()) return std::nullopt;
  study.missed =
      study_missed(settings.seed, moves, threads, stop, [&](std::uint64_t blocks) { progress(done + blocks, total); });
  if (study.missed.samples < moves) return std::nullopt;
  return study;
}

}  // namespace touchstone::thesis_figures
