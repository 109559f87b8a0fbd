// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/verdict.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/cases/workloads/ulp.h"

namespace touchstone::cases {
std::optional<std::size_t> index_in(const nlohmann::json& value) {
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  if (!value.is_number_float()) return std::nullopt;
  const auto number = value.get<double>();
  if (!(number >= 0 && number < 0x1p64 && number == std::floor(number))) return std::nullopt;
  return static_cast<std::size_t>(number);
}

namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value == 0 ? 0.0 : value;  // exact: drops the sign of zero
}

Json value_of(PlaneSide value) { return to_string(value); }
Json value_of(PointLocation value) { return to_string(value); }
Json value_of(Relation value) { return to_string(value); }
Json value_of(FirstContactKind value) { return to_string(value); }
Json value_of(bool value) { return value; }
Json value_of(std::size_t value) { return value; }
Json value_of(const std::vector<std::size_t>& value) { return value; }
Json value_of(double value) { return number(value); }
Json value_of(const Eigen::Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }
Json value_of(const Feature& nearest) {
  Json object = Json::object();
  object["kind"] = to_string(nearest.kind);
  if (nearest.kind != Feature::Kind::Face) object["index"] = nearest.index;
  return object;
}

// Each reads a value of the contract's form.

template <class Enumerator>
void read_word(const json& value, std::initializer_list<Enumerator> all, std::optional<Enumerator>& read) {
  if (!value.is_string()) return;
  for (const Enumerator one : all)
    if (to_string(one) == value.get_ref<const std::string&>()) read = one;
}

void read(const json& value, std::optional<PlaneSide>& side) {
  read_word(value, {PlaneSide::InFront, PlaneSide::Behind, PlaneSide::Intersects}, side);
}

void read(const json& value, std::optional<PointLocation>& location) {
  read_word(value, {PointLocation::Inside, PointLocation::Boundary, PointLocation::Outside}, location);
}

void read(const json& value, std::optional<Relation>& relation) {
  read_word(value, {Relation::Separate, Relation::Touching, Relation::Overlapping}, relation);
}

void read(const json& value, std::optional<FirstContactKind>& kind) {
  read_word(value, {FirstContactKind::Start, FirstContactKind::Way, FirstContactKind::None}, kind);
}

void read(const json& value, std::optional<bool>& yes) {
  if (value.is_boolean()) yes = value.get<bool>();
}

void read(const json& value, std::optional<std::size_t>& index) { index = index_in(value); }

void read(const json& value, std::optional<std::vector<std::size_t>>& indices) {
  if (!value.is_array()) return;
  std::vector<std::size_t> found;
  for (const json& member : value) {
    const auto index = index_in(member);
    if (!index) return;
    found.push_back(*index);
  }
  indices = std::move(found);
}

void read(const json& value, std::optional<Feature>& nearest) {
  using Kind = Feature::Kind;
  if (!value.is_object() || !value.contains("kind")) return;
  std::optional<Kind> kind;
  read_word(value["kind"], {Kind::Face, Kind::Edge, Kind::Vertex}, kind);
  const bool has_index = value.contains("index");
  if (!kind || has_index != (*kind != Kind::Face) || value.size() != (has_index ? 2U : 1U)) return;
  const auto index = has_index ? index_in(value["index"]) : 0;
  if (index) nearest = {*kind, *index};
}

void read(const json& value, std::optional<double>& length) {
  if (value.is_number()) length = value.get<double>();
  if (value.is_null()) length = kInfinity;
}

void read(const json& value, std::optional<Eigen::Vector3d>& point) {
  if (!value.is_array() || value.size() != 3) return;
  Eigen::Vector3d found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::optional<double> coordinate;
    read(value[axis], coordinate);
    if (!coordinate) return;
    found[static_cast<Eigen::Index>(axis)] = *coordinate;
  }
  point = found;
}

Json loop(const Polygon& polygon, std::size_t number) {
  Json points = Json::array();
  for (std::size_t i = polygon.loop_begin(number); i < polygon.loop_end(number); ++i)
    points.push_back(value_of(polygon.vertex(i)));
  return points;
}

template <class Value>
void write(std::string& line, const Value& value) {
  if (value.is_object()) {
    char separator = '{';
    for (const auto& [key, member] : value.items()) {
      line += separator;
      line += Json(key).dump() + ':';
      write(line, member);
      separator = ',';
    }
    line += value.empty() ? "{}" : "}";
  } else if (value.is_array()) {
    line += '[';
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (i > 0) line += ',';
      write(line, value[i]);
    }
    line += ']';
  } else if (value.is_number_float()) {
    const double number = value.template get<double>() + 0.0;  // -0 + 0 = 0
    if (!std::isfinite(number)) {
      line += "null";
      return;
    }
    std::array<char, 32> digits;
    line.append(digits.begin(), std::to_chars(digits.begin(), digits.end(), number).ptr);
  } else {
    line += value.dump();
  }
}

template <class Value>
std::string text(const Value& value) {
  std::string line;
  write(line, value);
  return line;
}

}  // namespace

Json object_of(const PartialAnswer& answer) {
  Json object = Json::object();
  for (const Key& key : kKeys) {
    key.visit([&](auto member) {
      if (answer.*member) object[std::string(key.name)] = value_of(*(answer.*member));
    });
    if (is_null(answer, key)) object[std::string(key.name)] = nullptr;
  }
  return object;
}

StatedAnswer stated(const PartialAnswer& answer) {
  StatedAnswer result{.values = answer, .texts = {}};
  const Json object = object_of(answer);
  for (const auto& [key, value] : object.items()) result.texts[key] = text(value);
  return result;
}

StatedAnswer stated(const Rejection& rejection) {
  return {.values = {},
          .texts = {{"error", text(Json(to_string(rejection.code)))}, {"message", text(Json(rejection.message))}}};
}

StatedAnswer stated_in(const json& object) {
  StatedAnswer result;
  for (const auto& [name, value] : object.items()) {
    const auto key = find_key(name);
    if (!key && name != "error" && name != "message") continue;
    result.texts[name] = text(value);
    if (!key) continue;
    key->visit([&, &name = name, &value = value](auto member) {
      read(value, result.values.*member);
      if (result.values.*member) result.texts[name] = text(value_of(*(result.values.*member)));
    });
  }
  if (result.values.first == FirstContactKind::None)
    result.values.depth.reset();  // null without a contact, not infinite
  return result;
}

Json object_of(const Ball& ball) { return {{"center", value_of(ball.center)}, {"radius", number(ball.radius)}}; }

Json object_of(const Motion& motion) { return {{"to", value_of(motion.to)}}; }

Json object_of(const Polygon& polygon) {
  Json holes = Json::array();
  for (std::size_t number = 1; number < polygon.loop_count(); ++number) holes.push_back(loop(polygon, number));
  return {{"outer", loop(polygon, 0)}, {"holes", std::move(holes)}};
}

Json object_of(const Mesh& mesh) {
  Json vertices = Json::array();
  for (const Eigen::Vector3d& vertex : mesh.vertices) vertices.push_back(value_of(vertex));
  return {{"vertices", std::move(vertices)}, {"faces", mesh.faces}};
}

Json object_of(const Pose& pose) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < 3; ++i) rows.push_back(value_of(Eigen::Vector3d(pose.rotation.row(i))));
  return {{"rotation", std::move(rows)}, {"translation", value_of(pose.translation)}};
}

Json case_of(const std::string& id, const AnyShapes& shapes, const std::vector<std::string>& tags,
             const Json& expected) {
  Json object = Json::object();
  object["id"] = id;
  const Question& question = question_of(shapes);
  object["ball"] = object_of(ball_of(question));
  if (const Motion* motion = std::get_if<Motion>(&question)) object["motion"] = object_of(*motion);
  if (const auto* one = std::get_if<Shapes>(&shapes)) {
    object["polygon"] = object_of(one->polygon);
  } else {
    const PosedMesh& mesh = std::get<MeshShapes>(shapes).mesh;
    object["mesh"] = object_of(mesh.mesh());
    if (!(mesh.pose() == Pose())) object["pose"] = object_of(mesh.pose());
  }
  if (!expected.is_null()) object["expected"] = expected;
  object["tags"] = tags;
  return object;
}

std::string to_line(const Json& verdict) {
  std::string line;
  write(line, verdict);
  return line + '\n';
}

namespace {

Json begin(const Json& id, std::string_view method) {
  Json verdict = Json::object();
  verdict["id"] = id;
  verdict["method"] = method;
  return verdict;
}

}  // namespace

std::string unanswered_line(const std::string& id, std::string_view method) {
  Json verdict = begin(id, method);
  verdict["unanswered"] = "motion";
  return to_line(verdict);
}

std::string verdict_line(const std::string& id, std::string_view method, const StatedAnswer& answer,
                         std::optional<double> explained_radius) {
  std::string line = to_line(begin(id, method));
  line.resize(line.size() - 2);  // the end of the object and of the line
  const auto add = [&](std::string_view name, const std::string& text) {
    line.append(",\"").append(name).append("\":").append(text);
  };
  const auto add_stated = [&](std::string_view name) {
    if (const auto found = answer.texts.find(std::string(name)); found != answer.texts.end()) add(name, found->second);
  };
  for (const Key& key : kKeys) add_stated(key.name);
  add_stated("error");
  add_stated("message");
  const PartialAnswer& values = answer.values;
  if (explained_radius && !values.stage.empty()) add("stage", Json(values.stage).dump());
  if (explained_radius && !values.first)
    add("margin", values.distance && !std::isnan(*values.distance)
                      ? std::to_string(workloads::doubles_between(*values.distance, *explained_radius))
                      : "null");
  return line + "}\n";
}

std::string verdict_line(const std::optional<std::string>& id, std::string_view method, const Rejection& rejection) {
  Json verdict = begin(id ? Json(*id) : Json(nullptr), method);
  verdict["error"] = to_string(rejection.code);
  verdict["message"] = (id ? "case " + *id + ": " : "") + rejection.message;
  return to_line(verdict);
}

std::string case_line(const std::string& id, const AnyShapes& shapes, const std::vector<std::string>& tags,
                      const std::optional<PartialAnswer>& expected) {
  return to_line(case_of(id, shapes, tags, expected ? object_of(*expected) : Json(nullptr)));
}

}  // namespace touchstone::cases
