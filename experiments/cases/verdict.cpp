// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/verdict.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "experiments/workloads/ulp.h"

namespace touchstone::cases {
namespace {

Verdict number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value == 0 ? 0.0 : value;  // exact: drops the sign of zero
}

/// Returns whether numbers below this key denote their nearest doubles. Numbers below other keys are indices.
bool holds_doubles(std::string_view key) { return key == "point" || key == "distance" || key == "off_plane"; }

/// The same for every number within a value; keeps integers that are not doubles.
Verdict plain(const nlohmann::json& value, bool doubles) {
  if (value.is_number_float() || (doubles && value.is_number())) return number(value.get<double>());
  if (!value.is_structured()) return value;
  Verdict copy = value.is_array() ? Verdict::array() : Verdict::object();
  for (const auto& [key, member] : value.items()) {
    if (value.is_array())
      copy.push_back(plain(member, doubles));
    else
      copy[key] = plain(member, doubles);
  }
  return copy;
}

bool is_negative_integer(const nlohmann::json& value) {
  return value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() < 0;
}

/// The library treats a signed and an unsigned integer with the same bits as equal.
bool same_number(const nlohmann::json& a, const nlohmann::json& b, bool doubles) {
  if (doubles) return a.get<double>() == b.get<double>();
  return is_negative_integer(a) == is_negative_integer(b) && a == b;
}

bool same_value(const nlohmann::json& a, const nlohmann::json& b, bool doubles) {
  if (a.is_number() && b.is_number()) return same_number(a, b, doubles);
  const auto same_members = [doubles](const nlohmann::json& x, const nlohmann::json& y) {
    return same_value(x, y, doubles);
  };
  if (a.is_array() && b.is_array()) return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_members);
  if (!a.is_object() || !b.is_object()) return a == b;
  return a.size() == b.size() && std::all_of(a.items().begin(), a.items().end(), [&](const auto& member) {
           const auto found = b.find(member.key());
           return found != b.end() && same_value(member.value(), *found, doubles);
         });
}

constexpr std::array<std::string_view, 10> kAnswerKeys{"plane",   "plane_tangent", "foot",  "edges_hit", "relation",
                                                       "contact", "nearest",       "point", "distance",  "off_plane"};

Verdict point(const Eigen::Vector3d& p) { return {number(p.x()), number(p.y()), number(p.z())}; }

Verdict loop(const Polygon& polygon, std::size_t number) {
  Verdict points = Verdict::array();
  for (std::size_t i = polygon.loop_begin(number); i < polygon.loop_end(number); ++i)
    points.push_back(point(polygon.vertex(i)));
  return points;
}

Verdict feature(const Feature& nearest) {
  Verdict object = Verdict::object();
  object["kind"] = word(nearest.kind);
  if (nearest.kind != Feature::Kind::Face) object["index"] = nearest.index;
  return object;
}

template <class Json>
void write(std::string& line, const Json& value) {
  if (value.is_object()) {
    char separator = '{';
    for (const auto& [key, member] : value.items()) {
      line += separator;
      line += Verdict(key).dump() + ':';
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
    std::array<char, 32> digits;
    const double finite = value.template get<double>() + 0.0;  // -0 + 0 = 0
    const auto end = std::to_chars(digits.begin(), digits.end(), finite).ptr;
    line.append(digits.begin(), end);
  } else {
    line += value.dump();
  }
}

std::string text(const nlohmann::json& value) {
  std::string line;
  write(line, value);
  return line;
}

}  // namespace

bool is_answer_key(std::string_view key) {
  return std::find(kAnswerKeys.begin(), kAnswerKeys.end(), key) != kAnswerKeys.end();
}

Verdict object_of(const cases::PartialAnswer& answer) {
  Verdict verdict = Verdict::object();
  if (answer.plane) verdict["plane"] = word(*answer.plane);
  if (answer.plane_tangent) verdict["plane_tangent"] = *answer.plane_tangent;
  if (answer.foot) verdict["foot"] = word(*answer.foot);
  if (answer.edges_hit) verdict["edges_hit"] = *answer.edges_hit;
  if (answer.relation) verdict["relation"] = word(*answer.relation);
  if (answer.contact) verdict["contact"] = *answer.contact;
  if (answer.nearest) verdict["nearest"] = feature(*answer.nearest);
  if (answer.point) verdict["point"] = point(*answer.point);
  if (answer.distance) verdict["distance"] = number(*answer.distance);
  if (answer.off_plane) verdict["off_plane"] = number(*answer.off_plane);
  return verdict;
}

Verdict answer_in(const nlohmann::json& reply) {
  Verdict answer = Verdict::object();
  const auto copy = [&](std::string_view key) {
    if (const auto found = reply.find(key); found != reply.end())
      answer[std::string(key)] = plain(*found, holds_doubles(key));
  };
  for (const std::string_view key : kAnswerKeys) copy(key);
  copy("error");
  copy("message");
  return answer;
}

Verdict verdict_of(const std::string& id, std::string_view method, const cases::PartialAnswer& answer) {
  Verdict verdict = Verdict::object();
  verdict["id"] = id;
  verdict["method"] = method;
  verdict.update(object_of(answer));
  return verdict;
}

Verdict verdict_of(const std::optional<std::string>& id, std::string_view method, const Rejection& rejection) {
  Verdict verdict = Verdict::object();
  verdict["id"] = id ? Verdict(*id) : Verdict(nullptr);
  verdict["method"] = method;
  verdict["error"] = word(rejection.code);
  verdict["message"] = (id ? "case " + *id + ": " : "") + rejection.message;
  return verdict;
}

void explain(Verdict& verdict, const cases::PartialAnswer& answer, double radius) {
  if (!answer.stage.empty()) verdict["stage"] = answer.stage;
  if (answer.distance && !std::isnan(*answer.distance))
    verdict["margin"] = workloads::doubles_between(*answer.distance, radius);
  else
    verdict["margin"] = nullptr;
}

std::vector<std::string> differences(const nlohmann::json& expected, const Verdict& verdict) {
  std::vector<std::string> found;
  const nlohmann::json given = verdict;
  for (const auto& [key, value] : expected.items()) {
    const auto answered = given.find(key);
    if (key == "error" && value == nlohmann::json(true) && answered != given.end()) continue;
    if (answered == given.end())
      found.push_back(key + ": expected " + text(value) + ", not given");
    else if (!same_value(value, *answered, holds_doubles(key)))
      found.push_back(key + ": expected " + text(value) + ", found " + text(*answered));
  }
  return found;
}

Verdict case_of(const std::string& id, const Ball& ball, const Polygon& polygon, const std::vector<std::string>& tags,
                const Verdict& expected) {
  Verdict holes = Verdict::array();
  for (std::size_t number = 1; number < polygon.loop_count(); ++number) holes.push_back(loop(polygon, number));
  Verdict object = Verdict::object();
  object["id"] = id;
  object["ball"] = {{"center", point(ball.center)}, {"radius", number(ball.radius)}};
  object["polygon"] = {{"outer", loop(polygon, 0)}, {"holes", holes}};
  if (!expected.is_null()) object["expected"] = expected;
  object["tags"] = tags;
  return object;
}

std::string to_line(const Verdict& verdict) {
  std::string line;
  write(line, verdict);
  return line + '\n';
}

}  // namespace touchstone::cases
