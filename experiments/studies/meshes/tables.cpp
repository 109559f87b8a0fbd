// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "experiments/cases/comparison.h"
#include "experiments/cases/key.h"
#include "experiments/cases/output_lines.h"
#include "experiments/cases/workloads/meshes.h"
#include "experiments/run/output.h"
#include "experiments/run/statistics/shares.h"
#include "experiments/run/table.h"
#include "experiments/studies/meshes/measure.h"
#include "geometry/io/detail/legible.h"
#include "robust/mesh/scene_faces.h"

namespace touchstone::meshes {
namespace {

/// A query of the study, and which methods fail which tests in it.
struct FailedQuery {
  std::set<std::size_t> methods;
  std::array<bool, kTests.size()> wrong{};
};

std::string case_line(const Settings& settings, const NamedMesh& mesh, std::uint64_t face, std::size_t ball,
                      const FailedQuery& failed) {
  const Polygon polygon = mesh::face_polygon(mesh.mesh, face);
  const exact::PreparedPolygon exact(polygon);
  const MeshBall drawn = draw_mesh_balls(polygon, exact, settings.seed, mesh.name, face).balls[ball];
  const auto whole = cases::PartialAnswer::of(exact::answer(drawn.ball, exact), "");
  std::vector<cases::Key> keys;
  for (std::size_t test = 0; test < kTests.size(); ++test)
    if (failed.wrong[test]) keys.push_back(cases::key_of(kTests[test]));
  std::vector<std::string> tags{std::string("near-") + std::string(to_string(drawn.place))};
  for (const std::size_t method : failed.methods)
    tags.push_back("fails-" + std::string(settings.methods[method]->name()));
  const std::string id =
      fmt::format("{}:{}:{}{:+}:seed-{}", mesh.name, face, to_string(drawn.place), drawn.steps, settings.seed);
  return cases::case_line(id, cases::Shapes{drawn.ball, polygon}, tags, cases::only(whole, keys));
}

struct MeshRow {
  std::string_view mesh;
  const MeshCounts* counts;
  std::string_view method;
  BallRegion place;
  Test test;
  const Failures* answers;
};

const run::Table<MeshRow>& meshes_table() {
  using run::path;
  static const run::Table<MeshRow> table(
      "meshes.csv", "a mesh, method, place and test",
      {{"mesh", "the mesh", &MeshRow::mesh},
       {"faces", "its faces", path(&MeshRow::counts, &MeshCounts::faces)},
       {"rejected", "faces that are not polygons", path(&MeshRow::counts, &MeshCounts::rejected)},
       {"method", "the method", &MeshRow::method},
       {"place", "what the balls are near", &MeshRow::place},
       {"test", "the decision that is compared", &MeshRow::test},
       {"trials", "answers", path(&MeshRow::answers, &Failures::trials)},
       {"wrong", "wrong answers", path(&MeshRow::answers, &Failures::wrong)},
       {"wrongly_in", "answers that wrongly say inside, or contact", path(&MeshRow::answers, &Failures::wrongly_in)},
       {"wrongly_out", "answers that wrongly say outside, or no contact",
        path(&MeshRow::answers, &Failures::wrongly_out)},
       {"boundary_missed", "answers that miss a boundary", path(&MeshRow::answers, &Failures::boundary_missed)}});
  return table;
}

struct RejectedRow {
  std::string_view mesh;
  const RejectedFace* face;
};

const run::Table<RejectedRow>& rejected_table() {
  static const run::Table<RejectedRow> table(
      "rejected.csv", "a face that is not a polygon",
      {{"mesh", "the mesh", &RejectedRow::mesh},
       {"face", "the number of the face in its file", run::path(&RejectedRow::face, &RejectedFace::face)},
       {"code", "the code of the rejection", [](const RejectedRow& row) { return row.face->rejection.code; }},
       {"message", "what is wrong", [](const RejectedRow& row) { return row.face->rejection.message; }}});
  return table;
}

constexpr std::size_t kWidth = 120;  // columns of the terminal

/// Three digits or so.
std::string percent(double share) { return statistics::percent_to_places(share, share < 0.09995 ? 2 : 1); }

std::string percent(const Failures& answers) { return answers.trials == 0 ? "-" : percent(answers.share()); }

MeshCounts sum_of(const Result& result) {
  MeshCounts sum;
  for (const MeshCounts& counts : result.meshes) run::add(sum, counts);
  return sum;
}

/// A limit of a share: small ones to two digits.
std::string limit(double share) {
  return share > 0 && share < 1e-4 ? fmt::format("{:.2g}", 100 * share) : percent(share);
}

std::string limits_of(std::uint64_t failures, std::uint64_t trials) {
  const auto limits = statistics::clopper_pearson(failures, trials);
  return fmt::format("{} - {}%", limit(limits.lower), limit(limits.upper));
}

/// Methods that stand side by side, each in a column as wide as its numbers; its name is broken at hyphens.
class Columns {
 public:
  static constexpr std::size_t kColumn = 7;

  Columns(const Settings& settings, std::vector<std::size_t> methods, std::size_t name_width)
      : settings_(settings), methods_(std::move(methods)), name_width_(name_width) {}

  [[nodiscard]] std::string head() const {
    std::vector<std::vector<std::string>> names;
    std::size_t lines = 1;
    for (const std::size_t method : methods_) {
      names.push_back(broken(settings_.methods[method]->name()));
      lines = std::max(lines, names.back().size());
    }
    std::string text;
    for (std::size_t line = 0; line < lines; ++line) {
      text += line + 1 < lines ? fmt::format("{:{}}", "", name_width_ + kFixed)
                               : row_head("mesh", "faces", "bad", "queries");
      for (const auto& name : names) {
        const std::size_t empty = lines - name.size();
        text += fmt::format("{:>{}}", line < empty ? "" : name[line - empty], kColumn);
      }
      text += "\n";
    }
    return text;
  }
  [[nodiscard]] std::string row(const std::string& name, const MeshCounts& counts) const {
    std::string text =
        row_head(name, std::to_string(counts.faces), std::to_string(counts.rejected), std::to_string(counts.queries));
    for (const std::size_t method : methods_)
      text += fmt::format("{:>{}}", percent(counts.methods[method].total(Test::Contact)), kColumn);
    return text + "\n";
  }
  /// The number that fits.
  static std::size_t most(std::size_t name_width) {
    const std::size_t used = name_width + kFixed;
    return used + kColumn > kWidth ? 1 : (kWidth - used) / kColumn;
  }

 private:
  static constexpr std::size_t kFixed = 6 + 5 + 8;

  [[nodiscard]] std::string row_head(const std::string& name, const std::string& faces, const std::string& bad,
                                     const std::string& queries) const {
    return fmt::format("{:<{}}{:>6}{:>5}{:>8}", name, name_width_, faces, bad, queries);
  }
  static std::vector<std::string> broken(std::string_view name) {
    std::vector<std::string> parts{""};
    for (const char c : name)
      if (c == '-')
        parts.emplace_back();
      else
        parts.back() += c;
    return parts;
  }

  const Settings& settings_;
  std::vector<std::size_t> methods_;
  std::size_t name_width_;
};

/// A row a mesh: wrong final answers of the methods that have any.
std::string by_mesh(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result) {
  const MeshCounts sum = sum_of(result);
  std::vector<std::size_t> shown;
  std::string never;
  for (std::size_t method = 0; method < settings.methods.size() && !meshes.empty(); ++method) {
    if (sum.methods[method].total(Test::Contact).wrong > 0)
      shown.push_back(method);
    else
      never.append(never.empty() ? "" : ", ").append(settings.methods[method]->name());
  }
  std::size_t name_width = 4;
  for (const NamedMesh& mesh : meshes) name_width = std::max(name_width, io::legible(mesh.name).size());

  std::string text = "Wrong final answers (contact or none), in % of the queries\n";
  if (!never.empty())
    text += fmt::format("Not one in {} queries (95 % limits: {} of the faces): {}\n", sum.queries,
                        limits_of(0, sum.faces - sum.rejected), never);
  const std::size_t most = Columns::most(name_width), blocks = (shown.size() + most - 1) / most;
  for (std::size_t block = 0; block == 0 || block < blocks; ++block) {
    const std::size_t first = blocks == 0 ? 0 : shown.size() * block / blocks;
    const std::size_t last = blocks == 0 ? 0 : shown.size() * (block + 1) / blocks;
    const Columns columns(settings, {shown.data() + first, shown.data() + last}, name_width);
    text += "\n" + columns.head();
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
      text += columns.row(io::legible(meshes[mesh].name), result.meshes[mesh]);
    if (!meshes.empty()) text += columns.row("all", sum);
  }
  return text;
}

/// Wrong answers and their percentage.
std::string cell(const Failures& answers) {
  return answers.trials == 0 ? "-" : fmt::format("{} {:>5}%", answers.wrong, percent(answers));
}

/// A row a method: every test, over all meshes.
std::string by_method(const Settings& settings, const Result& result) {
  const MeshCounts sum = sum_of(result);
  std::string text = fmt::format("\nWrong answers to each test, in {} queries\n\n", sum.queries);
  text += fmt::format("{:<16}", "method");
  for (const Test test : kTests) text += fmt::format("{:>15}", to_string(test));
  text += fmt::format("{:>9}{:>9}{:>24}\n", "missed", "false", "faces (95 % limits)");
  for (std::size_t method = 0; method < sum.methods.size(); ++method) {
    const MethodCounts& counts = sum.methods[method];
    text += fmt::format("{:<16}", settings.methods[method]->name());
    for (const Test test : kTests) text += fmt::format("{:>15}", cell(counts.total(test)));
    const Failures contact = counts.total(Test::Contact);
    text += fmt::format(
        "{:>9}{:>9}{:>24}\n", contact.wrongly_out, contact.wrongly_in,
        fmt::format("{} ({})", counts.faces_wrong, limits_of(counts.faces_wrong, sum.faces - sum.rejected)));
  }
  return text;
}

std::string left_out(const std::vector<NamedMesh>& meshes, const Result& result) {
  const MeshCounts sum = sum_of(result);
  std::string text;
  std::map<RejectionCode, std::vector<const RejectedFace*>> by_code;
  for (const RejectedFace& face : result.rejected) by_code[face.rejection.code].push_back(&face);
  text += fmt::format("\n{} of {} faces are bad: the contract rejects them, no method was asked{}\n", sum.rejected,
                      sum.faces, by_code.empty() ? "" : ":");
  for (const auto& [code, faces] : by_code)
    text += fmt::format("  {:<18} {:>6}  first {} face {}: {}\n", to_string(code), faces.size(),
                        io::legible(meshes[faces[0]->mesh].name), faces[0]->face, faces[0]->rejection.message);
  for (std::size_t place = 0; place < kPlaces.size(); ++place)
    if (sum.missing[place] > 0)
      text += fmt::format("{} faces have no ball near \"{}\": none drawn had it nearest\n", sum.missing[place],
                          to_string(kPlaces[place]));
  return text;
}

constexpr const char* kLegend = R"(
Queries: 20 a face. 5 near the face, 5 near an edge, 5 near a vertex: the radius is the double nearest to the exact
distance, moved by -2 to 2 doubles. 5 with an ample radius and the foot at an edge, the centre moved by -2 to 2 doubles.
plane: intersects or not (which side is not compared: the thesis's normal, from three vertices, may point either way).
foot: inside, boundary or outside; where the exact answer is boundary, a method without that word (thesis) is right
whether it says inside or outside. edges: the whole list. contact: the final answer; missed: a contact denied; false:
one reported wrongly. Touching is contact: the thesis, which says otherwise, is wrong there by definition.
faces: those with a wrong final answer, and the Clopper-Pearson limits of their share, as if drawn at random.
exact is the truth that all answers, its own included, are compared with. Percentages are those of the answers given:
interval may answer that it does not know.
)";

}  // namespace

void write_meshes(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                  const Result& result) {
  std::vector<MeshRow> rows;
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    const MeshCounts& counts = result.meshes[mesh];
    for (std::size_t method = 0; method < settings.methods.size(); ++method)
      for (std::size_t place = 0; place < kPlaces.size(); ++place)
        for (std::size_t test = 0; test < kTests.size(); ++test)
          rows.push_back({meshes[mesh].name, &counts, settings.methods[method]->name(), kPlaces[place], kTests[test],
                          &counts.methods[method].at[place][test]});
  }
  meshes_table().write(folder, rows);
}

void write_rejected(const std::filesystem::path& folder, const std::vector<NamedMesh>& meshes, const Result& result) {
  std::vector<RejectedRow> rows;
  for (const RejectedFace& face : result.rejected) rows.push_back({meshes[face.mesh].name, &face});
  rejected_table().write(folder, rows);
}

std::vector<run::TableDescription> tables() { return {meshes_table().description(), rejected_table().description()}; }

void write_failures(const std::filesystem::path& folder, const Settings& settings, const std::vector<NamedMesh>& meshes,
                    const Result& result) {
  std::map<std::tuple<std::size_t, std::uint64_t, std::size_t>, FailedQuery> queries;
  for (const Failure& failure : result.failures) {
    FailedQuery& query = queries[{failure.mesh, failure.face, failure.ball}];
    query.methods.insert(failure.method);
    for (std::size_t test = 0; test < kTests.size(); ++test) query.wrong[test] |= failure.wrong[test];
  }
  std::string text;
  for (const auto& [key, failed] : queries) {
    const auto& [mesh, face, ball] = key;
    text += case_line(settings, meshes[mesh], face, ball, failed);
  }
  run::write_file(folder / "failures.jsonl", text);
}

std::string table(const Settings& settings, const std::vector<NamedMesh>& meshes, const Result& result) {
  return by_mesh(settings, meshes, result) + by_method(settings, result) + left_out(meshes, result) + kLegend;
}

}  // namespace touchstone::meshes
