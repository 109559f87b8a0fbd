// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/case.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "experiments/cases/verdict.h"
#include "experiments/program/input.h"
#include "experiments/program/json.h"
#include "geometry/io/detail/legible.h"
#include "geometry/io/read_mesh.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/exact/validate.h"

namespace touchstone::cases {
namespace {

using nlohmann::json;

bool is_code(const json& value) {
  using enum RejectionCode;
  constexpr std::array kCodes{MalformedCase, NotFinite,       NegativeRadius, TooFewVertices, RepeatedVertex,
                              ZeroNormal,    LoopMeetsItself, LoopsMeet,      HoleOutside};
  return std::ranges::any_of(kCodes, [&](RejectionCode code) { return value == json(to_string(code)); });
}

bool is_finite(const json& value) {
  if (value.is_structured()) return std::all_of(value.begin(), value.end(), is_finite);
  return !value.is_number_float() || std::isfinite(value.get<double>());
}

/// What a case expects, and its faults, which Reader reports in their turn.
struct Expected {
  std::optional<StatedAnswer> answer{};  ///< nothing if the key is missing or its value is malformed
  std::string malformed{};               ///< what is wrong in form; else empty
  std::string infinite{};                ///< a key with a number beyond the finite doubles; else empty
};

Expected read_expected(const program::StrictJson& text) {
  if (!text.value.is_object() || !text.value.contains("expected")) return {};
  const json& expected = text.value["expected"];
  if (!expected.is_object()) return {.malformed = "expected is not an object"};
  if (text.ambiguous.contains("expected")) return {.malformed = "expected is, or contains, a duplicate key"};
  const auto error = expected.find("error");
  if (error != expected.end() && expected.size() != 1) return {.malformed = "expected has other keys beside \"error\""};
  if (error != expected.end() && *error != json(true) && !is_code(*error))
    return {.malformed = "expected.error is neither a code nor true, but " + io::legible(error->dump())};
  Expected read;
  for (const auto& [key, value] : expected.items()) {
    if (key != "error" && !find_key(key)) return {.malformed = "expected has the unknown key \"" + key + "\""};
    if (read.infinite.empty() && !is_finite(value)) read.infinite = "expected." + key;
  }
  read.answer = stated_in(expected);
  return read;
}

/// Reads the parts of a case; what is wrong in form ends it with `malformed-case`.
class Reader {
 public:
  Reader(const program::StrictJson& text, const Expected& expected) : text_(text), expected_(expected) {}

  void check_form() const {
    if (!text_.value.is_object()) malformed("the case is not an object");
    if (text_.too_deep) malformed("nested deeper than " + std::to_string(program::kMostLevels) + " levels");
    if (text_.duplicate_key) malformed("duplicate key \"" + *text_.duplicate_key + "\" in one object");
    if (const json& id = member(text_.value, "id", "the case"); !id.is_string()) malformed("id is not a string");
    if (!expected_.malformed.empty()) malformed(expected_.malformed);
    check_tags();
  }

  void check_expected_is_finite() const {
    if (!expected_.infinite.empty())
      throw Rejected({RejectionCode::NotFinite, expected_.infinite + " has a number beyond the finite doubles"});
  }

  [[nodiscard]] Question question() const {
    const Ball ball = this->ball();
    const auto motion = text_.value.find("motion");
    if (motion == text_.value.end()) return ball;
    if (!motion->is_object()) malformed("motion is not an object");
    return Motion{ball, point(member(*motion, "to", "motion"), "motion.to")};
  }

  [[nodiscard]] std::vector<Loop> loops() const {
    const json& polygon = member(text_.value, "polygon", "the case");
    if (!polygon.is_object()) malformed("polygon is not an object");
    const auto closed = polygon.find("closed");
    if (closed != polygon.end() && !closed->is_boolean()) malformed("polygon.closed is neither true nor false");
    const bool opens = closed != polygon.end() && closed->get<bool>();
    const auto loop = [&](const json& value, const std::string& where) {
      return opens ? opened(points_of(value, where), where) : points_of(value, where);
    };
    std::vector<Loop> loops{loop(member(polygon, "outer", "polygon"), "polygon.outer")};
    if (const auto holes = polygon.find("holes"); holes != polygon.end()) {
      if (!holes->is_array()) malformed("polygon.holes is not an array");
      for (const json& hole : *holes)
        loops.push_back(loop(hole, "polygon.holes[" + std::to_string(loops.size() - 1) + "]"));
    }
    return loops;
  }

  /// Returns whether the case asks about a mesh.
  [[nodiscard]] bool has_mesh() const {
    const bool has_mesh = text_.value.contains("mesh");
    if (has_mesh && text_.value.contains("polygon")) malformed("the case has both a polygon and a mesh");
    if (!has_mesh && text_.value.contains("pose")) malformed("the case has a pose, but no mesh");
    return has_mesh;
  }

  [[nodiscard]] Mesh mesh(const std::filesystem::path& folder) const {
    const json& mesh = text_.value["mesh"];
    if (!mesh.is_object()) malformed("mesh is not an object");
    if (const auto file = mesh.find("file"); file != mesh.end()) {
      if (!file->is_string()) malformed("mesh.file is not a string");
      if (mesh.contains("vertices") || mesh.contains("faces")) malformed("mesh has a file, and vertices or faces");
      if (file->get_ref<const std::string&>().find('\0') != std::string::npos)
        malformed("mesh.file has a NUL character");
      try {
        return read_mesh(folder / file->get<std::string>()).mesh;
      } catch (const BrokenMesh& error) {
        malformed(std::string("mesh.file: ") + error.what());
      }
    }
    Mesh read;
    read.vertices = points_of(member(mesh, "vertices", "mesh"), "mesh.vertices");
    const json& faces = member(mesh, "faces", "mesh");
    if (!faces.is_array() || faces.empty()) malformed("mesh.faces is not an array of faces");
    for (const json& face : faces) {
      const std::string where = "mesh.faces[" + std::to_string(read.faces.size()) + "]";
      if (!face.is_array()) malformed(where + " is not an array of vertex numbers");
      auto& corners = read.faces.emplace_back();
      for (const json& corner : face) {
        const auto number = index_in(corner);
        if (!number) malformed(where + " is not an array of vertex numbers");
        if (*number >= read.vertices.size())
          malformed(fmt::format("{}: vertex {} is out of range: there are {}", where, *number, read.vertices.size()));
        corners.push_back(static_cast<std::uint32_t>(*number));
      }
    }
    return read;
  }

  [[nodiscard]] Pose pose() const {
    Pose pose;
    const auto given = text_.value.find("pose");
    if (given == text_.value.end()) return pose;
    if (!given->is_object()) malformed("pose is not an object");
    if (const auto rows = given->find("rotation"); rows != given->end()) {
      if (!rows->is_array() || rows->size() != 3) malformed("pose.rotation is not an array of three rows");
      for (std::size_t i = 0; i < 3; ++i)
        pose.rotation.row(static_cast<Eigen::Index>(i)) = point((*rows)[i], fmt::format("pose.rotation[{}]", i));
    }
    if (const auto moved = given->find("translation"); moved != given->end())
      pose.translation = point(*moved, "pose.translation");
    return pose;
  }

 private:
  [[noreturn]] static void malformed(const std::string& message) {
    throw Rejected({RejectionCode::MalformedCase, message});
  }

  [[nodiscard]] Ball ball() const {
    const json& ball = member(text_.value, "ball", "the case");
    if (!ball.is_object()) malformed("ball is not an object");
    const json& radius = member(ball, "radius", "ball");
    if (!radius.is_number()) malformed("ball.radius is not a number");
    return {point(member(ball, "center", "ball"), "ball.center"), radius.get<double>()};
  }

  static const json& member(const json& object, const char* key, const char* owner) {
    const auto found = object.find(key);
    if (found == object.end()) malformed(std::string(owner) + " has no key \"" + key + "\"");
    return *found;
  }

  static Eigen::Vector3d point(const json& value, const std::string& where) {
    if (!value.is_array() || value.size() != 3 ||
        !std::all_of(value.begin(), value.end(), [](const json& v) { return v.is_number(); }))
      malformed(where + " is not a point of three numbers");
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }

  /// Returns the loop without its last point, which repeats the first.
  static Loop opened(Loop loop, const std::string& where) {
    if (loop.size() < 2) malformed(where + " is not closed: it has " + (loop.empty() ? "no" : "only one") + " point");
    if (loop.front() != loop.back()) malformed(where + " is not closed: its last point is not its first");
    loop.pop_back();
    return loop;
  }

  static Loop points_of(const json& value, const std::string& where) {
    if (!value.is_array()) malformed(where + " is not an array of points");
    Loop points;
    points.reserve(value.size());
    for (const json& p : value) points.push_back(point(p, where + "[" + std::to_string(points.size()) + "]"));
    return points;
  }

  void check_tags() const {
    const auto tags = text_.value.find("tags");
    if (tags == text_.value.end()) return;
    if (!tags->is_array() || !std::all_of(tags->begin(), tags->end(), [](const json& tag) { return tag.is_string(); }))
      malformed("tags is not an array of strings");
  }

  const program::StrictJson& text_;
  const Expected& expected_;
};

/// Calls `build`, which throws the rejection of the polygon or the mesh, after the rejections of `question` that
/// precede it.
template <class Build>
auto built_after(const Question& question, const Build& build) {
  const auto fault = std::visit([](const auto& asked) { return find_fault(asked); }, question);
  if (fault && fault->code == RejectionCode::NotFinite) throw Rejected(*fault);
  try {
    auto built = build();
    if (fault) throw Rejected(*fault);
    return built;
  } catch (const Rejected& rejected) {
    // In the order of rejections, a negative radius precedes every fault of the loops except numbers that are not
    // finite.
    if (fault && rejected.rejection().code != RejectionCode::NotFinite) throw Rejected(*fault);
    throw;
  }
}

Shapes read_shapes(const Reader& reader) {
  Question question = reader.question();
  const std::vector<Loop> loops = reader.loops();
  reader.check_expected_is_finite();
  Polygon polygon = built_after(question, [&] {
    Polygon built(loops.front(), {loops.begin() + 1, loops.end()});
    if (const auto rejection = exact::validate(built)) throw Rejected(*rejection);
    return built;
  });
  return {std::move(question), std::move(polygon)};
}

MeshShapes read_mesh_shapes(const Reader& reader, const std::filesystem::path& folder) {
  Question question = reader.question();
  Mesh mesh = reader.mesh(folder);
  const Pose pose = reader.pose();
  reader.check_expected_is_finite();
  PosedMesh posed = built_after(question, [&] { return PosedMesh(std::move(mesh), pose); });
  return {std::move(question), std::move(posed)};
}

std::filesystem::path folder_of(const Line& line) { return std::filesystem::path(line.file).parent_path(); }

void read_case_of(Line& line) {
  try {
    line.read = read_case(line.text, folder_of(line));
  } catch (const program::NotJson& error) {
    line.complaint = fmt::format("{}: not JSON: {}", line.place, error.what());
  } catch (const std::bad_alloc&) {
    line.complaint = fmt::format("{}: there is not enough memory to read the case", line.place);
  }
}

/// Returns the path of the mesh file that a line names; nothing if it names none.
std::optional<std::string> mesh_file_of(const Line& line) {
  if (line.text.find('\\') == std::string::npos && line.text.find("\"file\"") == std::string::npos)
    return std::nullopt;  // most lines, which need not be parsed
  try {
    const json value = program::read_strict_json(line.text).value;
    return (folder_of(line) / value.at("mesh").at("file").get_ref<const std::string&>()).string();
  } catch (const program::NotJson&) {
    return std::nullopt;
  } catch (const json::exception&) {  // it has no such key
    return std::nullopt;
  }
}

}  // namespace

PartialAnswer exact_answer(const Shapes& shapes) {
  const exact::PreparedPolygon polygon(shapes.polygon);
  const Answer answer = exact::answer(shapes.ball(), polygon);
  if (const Motion* motion = shapes.motion())
    return PartialAnswer::of(exact::first_contact(*motion, polygon), answer.off_plane, "");
  return PartialAnswer::of(answer, "");
}

PartialAnswer exact_answer(const MeshShapes& shapes) {
  std::vector<exact::PreparedPolygon> faces;
  for (const Polygon& face : shapes.mesh.faces()) faces.emplace_back(face);
  const auto precedes = [&](const exact::PreparedPolygon& a, const exact::PreparedPolygon& b) {
    const auto* motion = std::get_if<Motion>(&shapes.question);
    return (motion ? exact::compare_times(*motion, a, b) : exact::compare_distances(ball_of(shapes.question), a, b)) <
           0;
  };
  const std::size_t first = *std::ranges::min_element(
      shapes.mesh.order(), [&](std::size_t a, std::size_t b) { return precedes(faces[a], faces[b]); });
  std::vector<std::size_t> touched;
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (std::visit([&](const auto& asked) { return exact::contact(asked, faces[face]); }, shapes.question))
      touched.push_back(face);
  return PartialAnswer::of_mesh(exact_answer(Shapes{shapes.question, shapes.mesh.faces()[first]}), first,
                                std::move(touched));
}

PartialAnswer exact_answer(const AnyShapes& shapes) {
  return std::visit([](const auto& one) { return exact_answer(one); }, shapes);
}

const Question& question_of(const AnyShapes& shapes) {
  return std::visit([](const auto& one) -> const Question& { return one.question; }, shapes);
}

std::span<const Polygon> faces_of(const AnyShapes& shapes) {
  if (const auto* one = std::get_if<Shapes>(&shapes)) return {&one->polygon, 1};
  return std::get<MeshShapes>(shapes).mesh.faces();
}

AnyShapes with_radius(AnyShapes shapes, double radius) {
  std::visit([&](auto& one) { one.question = with_radius(one.question, radius); }, shapes);
  return shapes;
}

std::unique_ptr<PreparedMethod> prepare(const Method& method, const AnyShapes& shapes) {
  if (const auto* one = std::get_if<Shapes>(&shapes)) return method.prepare(one->polygon);
  return method.prepare(std::get<MeshShapes>(shapes).mesh);
}

AnyShapes Case::shapes() const {
  if (const auto* one = std::get_if<Shapes>(&content)) return *one;
  return std::get<MeshShapes>(content);
}

Case read_case(std::string_view line, const std::filesystem::path& folder) {
  const program::StrictJson text = program::read_strict_json(line);
  Case result{.id = {}, .expected = {}, .content = Rejection{}};
  if (text.value.is_object()) {
    if (const auto id = text.value.find("id"); id != text.value.end() && id->is_string())
      result.id = id->get<std::string>();
  }
  Expected expected = read_expected(text);
  try {
    const Reader reader(text, expected);
    reader.check_form();
    if (reader.has_mesh()) {
      result.content = read_mesh_shapes(reader, folder);
      result.rewritten = text.value["mesh"].contains("file");
    } else {
      result.content = read_shapes(reader);
      result.rewritten = text.value["polygon"].value("closed", false);
    }
    if (text.value.contains("tags")) result.tags = text.value["tags"].get<std::vector<std::string>>();
  } catch (const Rejected& rejected) {
    result.content = rejected.rejection();
  }
  result.expected = std::move(expected.answer);
  return result;
}

LineReader::LineReader(std::vector<std::string> files) : files_(std::move(files)) {
  if (!files_.empty()) return;
  program::announce_standard_input("cases");
  stream_ = &std::cin;
  name_ = "standard input";
}

std::optional<Line> LineReader::next() {
  for (; stream_ != nullptr || opened_ < files_.size(); stream_ = nullptr) {
    if (stream_ == nullptr) {
      name_ = files_[opened_++];
      number_ = 0;
      try {
        file_ = program::open_file(name_);
      } catch (const std::runtime_error& error) {
        return Line{.text = {}, .place = {}, .read = {}, .complaint = error.what(), .file = name_};
      }
      stream_ = &file_;
    }
    for (std::string text; std::getline(*stream_, text);) {
      ++number_;
      bytes_ += text.size() + 1;
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      return Line{std::move(text), fmt::format("{}: line {}", name_, number_), {}, {}, name_, bytes_};
    }
    // Only the C stream records errors of standard input.
    if (stream_ == &std::cin ? std::ferror(stdin) == 0 : !stream_->bad()) continue;
    stream_ = nullptr;
    return Line{.text = {}, .place = {}, .read = {}, .complaint = name_ + ": cannot be read to its end"};
  }
  return std::nullopt;
}

std::optional<Line> LineReader::next_case() {
  std::optional<Line> line = next();
  if (line && line->complaint.empty()) read_case_of(*line);
  return line;
}

LineCount count_lines(const std::vector<std::string>& files) {
  LineCount count;
  std::set<std::string> meshes;
  for (LineReader reader(files); const auto line = reader.next(); ++count.lines) {
    boost::hash_combine(count.hash, std::hash<std::string>()(line->text));
    if (auto mesh = mesh_file_of(*line)) meshes.insert(*std::move(mesh));
  }
  count.meshes.assign(meshes.begin(), meshes.end());
  return count;
}

}  // namespace touchstone::cases
