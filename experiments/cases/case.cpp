// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/case.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/key.h"
#include "experiments/cases/verdict.h"
#include "experiments/run/json/strict_json.h"
#include "geometry/io/detail/legible.h"
#include "robust/exact/validate.h"

namespace touchstone::cases {
namespace {

using nlohmann::json;

/// Reads the parts of a case; what is wrong in form ends it with `malformed-case`.
class Reader {
 public:
  explicit Reader(const run::StrictJson& text) : text_(text) {}

  void check_form() const {
    if (!text_.value.is_object()) malformed("the case is not an object");
    if (text_.too_deep) malformed("nested deeper than " + std::to_string(run::kMostLevels) + " levels");
    if (text_.duplicate_key) malformed("duplicate key \"" + *text_.duplicate_key + "\" in one object");
    if (const json& id = member(text_.value, "id", "the case"); !id.is_string()) malformed("id is not a string");
    (void)expected();
    check_tags();
  }

  /// Returns what the case expects; null if the key is missing.
  [[nodiscard]] const json* expected() const {
    const auto expected = text_.value.find("expected");
    if (expected == text_.value.end()) return nullptr;
    if (!expected->is_object()) malformed("expected is not an object");
    if (text_.ambiguous.contains("expected")) malformed("expected is, or contains, a duplicate key");
    if (const auto error = expected->find("error"); error != expected->end()) {
      if (expected->size() != 1) malformed("expected has other keys beside \"error\"");
      if (*error != json(true) && !is_code(*error))
        malformed("expected.error is neither a code nor true, but " + io::legible(error->dump()));
    } else {
      for (const auto& [key, value] : expected->items())
        if (!find_key(key)) malformed("expected has the unknown key \"" + key + "\"");
    }
    return &*expected;
  }

  void check_expected_is_finite() const {
    const json* expected = this->expected();
    if (expected == nullptr) return;
    for (const auto& [key, value] : expected->items())
      if (!is_finite(value))
        throw Rejected({RejectionCode::NotFinite, "expected." + key + " has a number beyond the finite doubles"});
  }

  [[nodiscard]] Ball ball() const {
    const json& ball = member(text_.value, "ball", "the case");
    if (!ball.is_object()) malformed("ball is not an object");
    const json& radius = member(ball, "radius", "ball");
    if (!radius.is_number()) malformed("ball.radius is not a number");
    return {point(member(ball, "center", "ball"), "ball.center"), radius.get<double>()};
  }

  /// Returns the end of the centre's way; nothing if the ball does not move.
  [[nodiscard]] std::optional<Eigen::Vector3d> to() const {
    const auto motion = text_.value.find("motion");
    if (motion == text_.value.end()) return std::nullopt;
    if (!motion->is_object()) malformed("motion is not an object");
    return point(member(*motion, "to", "motion"), "motion.to");
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

  static bool is_code(const json& value) {
    if (!value.is_string()) return false;
    for (int code = 0; !to_string(RejectionCode(code)).empty(); ++code)
      if (to_string(RejectionCode(code)) == value.get_ref<const std::string&>()) return true;
    return false;
  }

  static bool is_finite(const json& value) {
    if (value.is_structured()) return std::all_of(value.begin(), value.end(), is_finite);
    return !value.is_number_float() || std::isfinite(value.get<double>());
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

  static Loop loop(const json& value, const std::string& where) {
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

  const run::StrictJson& text_;
};

Shapes read_shapes(const run::StrictJson& text) {
  const Reader reader(text);
  reader.check_form();
  const Ball ball = reader.ball();
  const auto to = reader.to();
  const std::vector<Loop> loops = reader.loops();
  reader.check_expected_is_finite();

  const auto fault = find_fault(Motion{ball, to.value_or(ball.center)});
  if (fault && fault->code == RejectionCode::NotFinite) throw Rejected(*fault);
  try {
    Polygon polygon(loops.front(), {loops.begin() + 1, loops.end()});
    if (fault) throw Rejected(*fault);
    if (const auto rejection = exact::validate(polygon)) throw Rejected(*rejection);
    return {ball, std::move(polygon), to};
  } catch (const Rejected& rejected) {
    // In the order of rejections, a negative radius precedes every fault of the loops except numbers that are not
    // finite.
    if (fault && rejected.rejection().code != RejectionCode::NotFinite) throw Rejected(*fault);
    throw;
  }
}

}  // namespace

Case read_case(std::string_view line) {
  const run::StrictJson text = run::read_strict_json(line);
  Case result{.id = {}, .expected = {}, .content = Rejection{}};
  if (text.value.is_object()) {
    if (const auto id = text.value.find("id"); id != text.value.end() && id->is_string())
      result.id = id->get<std::string>();
    try {
      if (const json* expected = Reader(text).expected()) result.expected = expectation_in(*expected);
    } catch (const Rejected&) {
      // A malformed `expected` expects nothing. read_shapes reports this rejection in its turn.
    }
  }
  try {
    result.content = read_shapes(text);
    if (text.value.contains("tags")) result.tags = text.value["tags"].get<std::vector<std::string>>();
  } catch (const Rejected& rejected) {
    result.content = rejected.rejection();
  }
  return result;
}

}  // namespace touchstone::cases
