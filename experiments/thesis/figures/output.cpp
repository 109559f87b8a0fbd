// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "experiments/program/output.h"
#include "experiments/program/table.h"
#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/cell/model/solid.h"
#include "experiments/thesis/figures/drawn_cell.h"
#include "experiments/thesis/figures/picture_tables.h"
#include "experiments/thesis/figures/predictions.h"

namespace touchstone::figures {
namespace {

using namespace kinematics;
using nlohmann::ordered_json;
using program::path;

const program::Table<Entry>& entries_csv() {
  static const program::Table<Entry> table(
      "entries.csv", "a figure or table",
      {{"id", "its number", &Entry::id},
       {"caption", "its caption", &Entry::caption},
       {"page", "of the thesis",
        [](const Entry& entry) { return entry.page == 0 ? std::nullopt : std::optional(entry.page); }},
       {"status", "whether it was reproduced, or what its numbers are compared with", &Entry::status_words},
       {"text", "what was done, or why nothing can be done", &Entry::text},
       {"picture", "the file of our picture",
        [](const Entry& entry) { return entry.shows.empty() ? std::string() : entry.file_stem(); }},
       {"shows", "what our picture shows", &Entry::shows}});
  return table;
}

struct NumberRow {
  std::string_view id;
  const Number* number;
};

const program::Table<NumberRow>& numbers_csv() {
  const auto limit = [](double statistics::Limits::*side) {
    return [side](const NumberRow& row) {
      return row.number->ours.limits ? std::optional((*row.number->ours.limits).*side) : std::nullopt;
    };
  };
  static const program::Table<NumberRow> table(
      "numbers.csv", "a number of a figure or table",
      {{"id", "the figure or table", &NumberRow::id},
       {"what", "the number", path(&NumberRow::number, &Number::what)},
       {"unit", "its unit", path(&NumberRow::number, &Number::unit)},
       {"ours", "our value", [](const NumberRow& row) { return row.number->ours.value; }},
       {"lower", "the lower limit of a share", limit(&statistics::Limits::lower)},
       {"upper", "the upper limit of a share", limit(&statistics::Limits::upper)},
       {"samples", "the samples of a share",
        [](const NumberRow& row) {
          return row.number->ours.limits ? std::optional(row.number->ours.samples) : std::nullopt;
        }},
       {"stated", "the stated value", path(&NumberRow::number, &Number::stated)},
       {"tolerance", "the largest difference that counts as agreement",
        [](const NumberRow& row) { return row.number->stated ? std::optional(row.number->tolerance) : std::nullopt; }},
       {"basis", "why they agree: `fitted`, `input`, `predicted`, `own check` or `other source`",
        [](const NumberRow& row) { return row.number->basis ? to_string(*row.number->basis) : std::string_view(); }},
       {"label", "the source of the stated value",
        [](const NumberRow& row) {
          return row.number->basis ? std::string(1, static_cast<char>(label_of(*row.number->basis))) : std::string();
        }},
       {"agrees", "whether the two agree",
        [](const NumberRow& row) { return row.number->stated ? program::yes_or_no(*row.number->agrees()) : ""; }},
       {"rests_on", "C if our value depends on chosen values",
        [](const NumberRow& row) { return row.number->chosen ? "C" : ""; }}});
  return table;
}

ordered_json box(const Eigen::AlignedBox2d& b) {
  return {{"from", {b.min().x(), b.min().y()}}, {"to", {b.max().x(), b.max().y()}}};
}

ordered_json drawing(const Study& study) {
  const cell::Cell& cell = study.cell;
  ordered_json moments = ordered_json::object(), outlines = ordered_json::object();
  for (const CaseStudy& its : study.cases) moments.update(drawn_moments(its));
  for (const Outline& outline : study.outlines) outlines[std::string(outline.name)] = outline.corners;
  ordered_json joints = ordered_json::array(), links = ordered_json::array();
  for (const cell::Joint& joint : study.cell.robot.joints)
    joints.push_back({{"name", joint.name}, {"lower", joint.lower}, {"upper", joint.upper}, {"home", joint.home}});
  for (const cell::Link& link : study.cell.robot.links) links.push_back(link.name);
  const auto& [first, second] = study.cases;
  // The height of a station is that of the material in its slot.
  const auto station = [](const cell::Station& s, std::size_t slot) {
    return ordered_json{{"azimuth", s.azimuth()},
                        {"radius", s.radius},
                        {"height", s.height + s.slots[slot].place.z()},
                        {"deck", s.height}};
  };
  const Eigen::AlignedBox3d material = cell::bounds_of(cell.material.solid);
  const double side = material.sizes().x();
  return {
      {"parts", drawn_parts(study.parts)},
      {"primitives",
       {{"Base", drawn_primitives(study.cell.robot.links[0].parts)},
        {"Axis1", drawn_primitives(study.cell.robot.links[1].parts)}}},
      {"links", links},
      {"joints", joints},
      {"moments", moments},
      {"outlines", outlines},
      {"plan", {{"body", study.plan.body}, {"storage", box(study.plan.storage)}, {"machine", box(study.plan.machine)}}},
      {"stations",
       {{"storage 1", station(first.cell.storage, cell.material.slot)},
        {"storage 2", station(second.cell.storage, cell.material.slot)},
        {"machine", station(cell.machine, cell.material.machine_slot)}}},
      {"material",
       {{"side", side},
        {"gap", -cell.storage.slots[cell.material.slot].place.y() - side / 2},
        {"drop", cell.material.drop}}},
      {"sphere_radius", cell.gripper.sphere.radius},
      {"reach",
       {{"first", kUpperArm},
        {"second", kForearm},
        {"down", kHand - cell.gripper.sphere.center.z()},
        {"shoulder", kShoulderHeight}}}};
}

}  // namespace

void write_entries(const std::filesystem::path& folder, const std::vector<Entry>& entries) {
  entries_csv().write(folder, entries);
  std::vector<NumberRow> numbers;
  for (const Entry& entry : entries)
    for (const Number& number : entry.numbers) numbers.push_back({entry.id, &number});
  numbers_csv().write(folder, numbers);
}

void write_data(const std::filesystem::path& folder, const Study& study) {
  write_picture_tables(folder, study);
  predictions_csv().write(folder, study.predictions);
  sensitivity_csv().write(folder, study.sensitivities);
  program::write_file(folder / "drawing.json", drawing(study).dump() + "\n");
  program::make_folder(folder / "models");
  for (const LinkFile& file : study.link_files)
    if (file.model.name == "Axis1" || file.model.name == "Gripper1" || file.model.name == "machine-bottom")
      program::write_file(folder / "models" / (file.model.name + ".txt"), file.text);
}

std::vector<program::TableDescription> tables() {
  std::vector<program::TableDescription> all{entries_csv().description(), numbers_csv().description(),
                                             predictions_csv().description(), sensitivity_csv().description()};
  for (auto& table : picture_tables()) all.push_back(std::move(table));
  return all;
}

std::string table(const std::vector<Entry>& entries) {
  std::vector<std::pair<std::string_view, std::size_t>> statuses;
  struct Counts {
    std::size_t stated = 0, agreeing = 0;
  };
  std::map<Basis, Counts> counts;
  Counts of_errors;
  std::set<std::pair<std::string, double>> captions;
  std::string differing;
  for (const Entry& entry : entries) {
    const auto same =
        std::ranges::find(statuses, entry.status_words(), &std::pair<std::string_view, std::size_t>::first);
    if (same == statuses.end())
      statuses.emplace_back(entry.status_words(), 1);
    else
      ++same->second;
    for (const Number& n : entry.numbers) {
      if (!n.stated) continue;
      Counts& its = entry.page == 0 ? of_errors : counts[*n.basis];
      ++its.stated;
      its.agreeing += *n.agrees();
      if (n.basis == Basis::Fitted) captions.insert({n.what.substr(0, n.what.find(' ')), *n.stated});
      if (!*n.agrees())
        differing += fmt::format("  {}: {}: {:.6g} {}, stated {:g} [{}]\n", entry.id, n.what, n.ours.value, n.unit,
                                 *n.stated, static_cast<char>(label_of(*n.basis)));
    }
  }
  std::ranges::sort(statuses, std::greater<>{}, &std::pair<std::string_view, std::size_t>::second);
  std::string text = fmt::format("{} figures and tables\n", entries.size());
  for (const auto& [words, count] : statuses) text += fmt::format("{:>5}  {}\n", count, words);
  const auto line = [&](const Counts& its, const std::string& what) {
    text += fmt::format("{} of {} agree: {}\n", its.agreeing, its.stated, what);
  };
  line(counts[Basis::Fitted],
       fmt::format("angles of captions, {} different ones, for which the layout was solved", captions.size()));
  line(counts[Basis::Input], "numbers of captions that the cell was built with");
  line(counts[Basis::Predicted], "counts of places that were not fitted, at which what the captions imply is found");
  line(counts[Basis::OtherSource], "numbers of other sources");
  line(counts[Basis::OwnCheck], "tests of this project: arithmetic, and the exact answer");
  line(of_errors, "known errors of the thesis's method, derived here");
  if (!differing.empty()) text += "otherwise:\n" + differing;
  return text;
}

}  // namespace touchstone::figures
