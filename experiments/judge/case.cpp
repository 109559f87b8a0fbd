// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/case.h"

#include <algorithm>
#include <array>
#include <limits>

#include "experiments/judge/strict_json.h"
#include "experiments/judge/verdict.h"
#include "robust/exact/validate.h"

namespace touchstone::judge {
namespace {

using nlohmann::json;

/// Reads the parts of a case; what is wrong in form ends it with `malformed-case`.
class Reader {
 public:
  explicit Reader(const StrictJson& text) : text_(text) {}

  void check_form() const {
    if (!text_.value.is_object()) malformed("the case is not an object");
    if (text_.duplicate_key) malformed("key \"" + *text_.duplicate_key + "\" stands twice in one object");
    if (const json& id = member(text_.value, "id", "the case"); !id.is_string() || is_number(id))
      malformed("id is not a string");
    check_expected();
    check_tags();
  }

  [[nodiscard]] Ball ball() const {
    const json& ball = member(text_.value, "ball", "the case");
    if (!ball.is_object()) malformed("ball is not an object");
    const json& radius = member(ball, "radius", "ball");
    if (!is_number(radius)) malformed("ball.radius is not a number");
    return {point(member(ball, "center", "ball"), "ball.center"), number(radius)};
  }

  [[nodiscard]] std::vector<Loop> loops() const {
    const json& polygon = member(text_.value, "polygon", "the case");
    if (!polygon.is_object()) malformed("polygon is not an object");
    std::vector<Loop> loops{loop(member(polygon, "outer", "polygon"), "polygon.outer")};
    if (const auto holes = polygon.find("holes"); holes != polygon.end()) {
      if (!holes->is_array()) malformed("polygon.holes is not an array");
      for (const json& hole : *holes)
        loops.push_back(loop(hole, "polygon.holes[" + std::to_string(loops.size() - 1) + "]"));
    }
    return loops;
  }

 private:
  [[noreturn]] static void malformed(const std::string& message) {
    throw Rejected({RejectionCode::MalformedCase, message});
  }

  static const json& member(const json& object, const char* key, const char* owner) {
    const auto found = object.find(key);
    if (found == object.end()) malformed(std::string(owner) + " has no key \"" + key + "\"");
    return *found;
  }

  [[nodiscard]] bool is_number(const json& value) const {
    return value.is_number() || (text_.has_overflow && is_overflow(value));
  }

  /// The nearest double; infinite where that is beyond the finite ones.
  [[nodiscard]] static double number(const json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] Eigen::Vector3d point(const json& value, const std::string& where) const {
    if (!value.is_array() || value.size() != 3 ||
        !std::all_of(value.begin(), value.end(), [this](const json& v) { return is_number(v); }))
      malformed(where + " is not a point of three numbers");
    return {number(value[0]), number(value[1]), number(value[2])};
  }

  [[nodiscard]] Loop loop(const json& value, const std::string& where) const {
    if (!value.is_array()) malformed(where + " is not an array of points");
    Loop points;
    points.reserve(value.size());
    for (const json& p : value) points.push_back(point(p, where + "[" + std::to_string(points.size()) + "]"));
    return points;
  }

  void check_expected() const {
    const auto expected = text_.value.find("expected");
    if (expected == text_.value.end()) return;
    if (!expected->is_object()) malformed("expected is not an object");
    if (const auto error = expected->find("error"); error != expected->end()) {
      if (expected->size() != 1) malformed("expected has other keys beside \"error\"");
      if (!error->is_string() && *error != json(true)) malformed("expected.error is neither a code nor true");
      return;
    }
    for (const auto& [key, value] : expected->items())
      if (!is_answer_key(key)) malformed("expected has the unknown key \"" + key + "\"");
  }

  void check_tags() const {
    const auto tags = text_.value.find("tags");
    if (tags == text_.value.end()) return;
    if (!tags->is_array() || !std::all_of(tags->begin(), tags->end(), [this](const json& tag) {
          return tag.is_string() && !is_number(tag);
        }))
      malformed("tags is not an array of strings");
  }

  const StrictJson& text_;
};

Shapes read_shapes(const StrictJson& text) {
  const Reader reader(text);
  reader.check_form();
  const Ball ball = reader.ball();
  const std::vector<Loop> loops = reader.loops();

  const auto fault = find_fault(ball);
  if (fault && fault->code == RejectionCode::NotFinite) throw Rejected(*fault);
  try {
    Polygon polygon(loops.front(), {loops.begin() + 1, loops.end()});
    if (fault) throw Rejected(*fault);
    if (const auto rejection = exact::validate(polygon)) throw Rejected(*rejection);
    return {ball, std::move(polygon)};
  } catch (const Rejected& rejected) {
    // A negative radius comes before all that is wrong with the loops but numbers that are not finite.
    if (fault && rejected.rejection().code != RejectionCode::NotFinite) throw Rejected(*fault);
    throw;
  }
}

}  // namespace

Case read_case(std::string_view line) {
  StrictJson text;
  try {
    text = read_strict_json(line);
  } catch (const json::exception& error) {
    throw NotJson(error.what());
  }

  Case result{.id = {}, .expected = {}, .content = Rejection{}};
  if (text.value.is_object()) {
    if (const auto id = text.value.find("id"); id != text.value.end() && id->is_string() && !is_overflow(*id))
      result.id = id->get<std::string>();
    if (const auto expected = text.value.find("expected"); expected != text.value.end() && expected->is_object())
      result.expected = *expected;
  }
  try {
    result.content = read_shapes(text);
  } catch (const Rejected& rejected) {
    result.content = rejected.rejection();
  }
  return result;
}

}  // namespace touchstone::judge
