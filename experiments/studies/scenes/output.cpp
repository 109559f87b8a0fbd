// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/scenes/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "experiments/cases/verdict.h"
#include "experiments/harness/table.h"
#include "experiments/statistics/percent.h"

namespace touchstone::scenes {
namespace {

using cases::Verdict;
using filtered::Stage;
using scene::CullOutcome;
using scene::FaceCounts;
using scene::FaceId;

struct Row {
  std::string what, explained;
  std::uint64_t count, of;
};

std::vector<Row> rows_of(const FaceCounts& counts) {
  const auto faces = [&](CullOutcome outcome, const char* explained) {
    return Row{std::string(to_string(outcome)), explained, counts.faces(outcome), counts.faces()};
  };
  std::vector<Row> rows{{"faces", "faces asked about", counts.faces(), counts.faces()},
                        faces(CullOutcome::Box, "rejected by a box of the hierarchy, never reached"),
                        faces(CullOutcome::Known, "skipped, the answer was known"),
                        faces(CullOutcome::Slab, "rejected by the slab: the plane is too far"),
                        faces(CullOutcome::Foot, "rejected by the foot, no edge tested"),
                        {"edges_missed", "rejected by the edges", counts.faces(CullOutcome::Edges), counts.faces()},
                        faces(CullOutcome::Touched, "touched"),
                        {"tested", "faces tested: slab, foot, edges or touched", counts.tested(), counts.faces()}};
  for (std::size_t i = 0; i < filtered::kStages; ++i) {
    const auto stage = static_cast<Stage>(i);
    rows.push_back({std::string(to_string(stage)),
                    fmt::format("settled by {}, later stages never entered", to_string(stage)), counts.tested(stage),
                    counts.tested()});
  }
  rows.push_back({"edges", "edges of the faces asked about", counts.edges(), counts.edges()});
  rows.push_back(
      {"edges_never_looked_at", "edges never tested", counts.edges() - counts.edges_looked_at(), counts.edges()});
  return rows;
}

const harness::Table<Row>& counts_table() {
  static const harness::Table<Row> table(
      "counts.csv", "what happened to the faces that the balls were asked about",
      {{"what", "what was counted", &Row::what}, {"count", "how often, for all balls", &Row::count}});
  return table;
}

Verdict face(FaceId id, const std::vector<Object>& objects) {
  const Object& object = objects[id.object];
  return {{"object", object.name}, {"face", object.numbers[id.face]}};
}

Verdict counts_of(const FaceCounts& counts) {
  Verdict object = Verdict::object();
  for (const Row& row : rows_of(counts)) object[row.what] = row.count;
  return object;
}

}  // namespace

std::string answer_line(const NamedBall& ball, const BallAnswer& answer, Question question,
                        const std::vector<Object>& objects, bool with_counts) {
  const auto point = [](const Eigen::Vector3d& p) { return Verdict{p.x(), p.y(), p.z()}; };
  Verdict line = Verdict::object();
  line["id"] = ball.id;
  line["ball"] = {{"center", point(ball.ball.center)}, {"radius", ball.ball.radius}};
  if (question == Question::Any) line["touches"] = !answer.touched.empty();
  if (question == Question::All) {
    line["touched"] = Verdict::array();
    // The scene numbers triangles first, the mesh does not.
    std::vector<FaceId> touched = answer.touched;
    std::ranges::sort(touched, {},
                      [&](FaceId id) { return std::pair(id.object, objects[id.object].numbers[id.face]); });
    for (const FaceId id : touched) line["touched"].push_back(face(id, objects));
  }
  if (question == Question::Nearest) {
    line["nearest"] = nullptr;
    if (answer.nearest) {
      cases::PartialAnswer keys;
      keys.nearest = answer.nearest->feature;
      keys.point = answer.nearest->point;
      keys.distance = answer.nearest->distance;
      const Verdict found = cases::object_of(keys);
      Verdict nearest = face(answer.nearest->face, objects);
      nearest["feature"] = found["nearest"];
      nearest["point"] = found["point"];
      nearest["distance"] = found["distance"];
      line["nearest"] = nearest;
    }
  }
  if (with_counts) line["counts"] = counts_of(answer.counts);
  return cases::to_line(line);
}

void Differences::add(const BallAnswer& given, const BallAnswer& truth, Question question) {
  ++balls;
  unsure += given.unsure > 0 ? 1 : 0;
  bool differs = false;
  switch (question) {
    case Question::Any: differs = given.touched.empty() != truth.touched.empty(); break;
    case Question::All: differs = given.touched != truth.touched; break;
    case Question::Nearest: {
      const bool both = given.nearest && truth.nearest;
      const bool other = !both || given.nearest->distance != truth.nearest->distance;  // compared as rounded
      differs = both ? other && given.nearest->face != truth.nearest->face : given.nearest || truth.nearest;
      distances += both && other ? 1 : 0;
      break;
    }
  }
  answers += differs ? 1 : 0;
}

std::string table(const FaceCounts& counts, std::uint64_t balls) {
  std::string text = fmt::format("{:<54}{:>16}{:>9}{:>14}\n", "", "in sum", "share", "a ball");
  for (const Row& row : rows_of(counts)) {
    const double each = balls == 0 ? 0 : static_cast<double>(row.count) / static_cast<double>(balls);
    text += fmt::format("{:<54}{:>16}{:>7} %{:>14.2f}\n", row.explained, row.count,
                        statistics::percent_to_places(statistics::share_of(row.count, row.of), 2), each);
  }
  return text;
}

void write_counts(const std::filesystem::path& folder, const FaceCounts& counts, std::uint64_t balls) {
  std::vector<Row> rows = rows_of(counts);
  rows.insert(rows.begin(), {"balls", "balls", balls, balls});
  counts_table().write(folder, rows);
}

std::vector<harness::TableDescription> tables() { return {counts_table().description()}; }

}  // namespace touchstone::scenes
