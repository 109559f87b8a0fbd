// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact/thesis.h"

#include "experiments/methods/add_methods.h"

namespace touchstone::methods {
namespace {

template <class Scalar>
class PreparedThesis final : public PreparedMethod {
 public:
  PreparedThesis(const Polygon& polygon, const thesis::Options& options, std::string_view stage)
      : polygon_(polygon, options), stage_(stage) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    const bool all = kind == QueryKind::Answer;
    PartialAnswer answer;
    if (all || kind == QueryKind::PlaneSide) answer.plane = thesis::plane_side(ball, polygon_);
    if (all || kind == QueryKind::Foot) answer.foot = thesis::foot(ball, polygon_);
    if (all || kind == QueryKind::EdgesHit) answer.edges_hit = thesis::edges_hit(ball, polygon_);
    if (all || kind == QueryKind::Contact || kind == QueryKind::Relation) {
      answer.contact = thesis::contact(ball, polygon_);
      // The method reports a collision or not; it does not distinguish touching from overlapping.
      if (kind != QueryKind::Contact) answer.relation = *answer.contact ? Relation::Overlapping : Relation::Separate;
    }
    answer.stage = stage_;
    return answer;
  }

 private:
  thesis::PreparedPolygon<Scalar> polygon_;
  std::string_view stage_;
};

template <class Scalar>
std::unique_ptr<Method> variant(const char* name, const thesis::Options& options, const char* summary) {
  return std::make_unique<Method>(name, summary, [options](const Polygon& polygon) {
    return std::make_unique<PreparedThesis<Scalar>>(polygon, options, sizeof(Scalar) == 4 ? "float" : "double");
  });
}

}  // namespace

void add_thesis(MethodList& list) {
  using namespace thesis;
  list.push_back(
      variant<double>("thesis", {}, "the thesis's own tests (2008) in doubles: angle sum >= 0.99 x 2 pi, strict"));
  list.push_back(variant<float>("thesis-float", {}, "thesis with 32-bit vectors, as in its source"));
  list.push_back(variant<double>("thesis-0.9999", {.match_factor = 0.9999}, "thesis with match factor 0.9999"));
  list.push_back(variant<double>("thesis-1", {.match_factor = 1}, "thesis with match factor 1"));
  list.push_back(variant<double>("thesis-signed", {.angles = Angles::Signed},
                                 "thesis with signed angles: right on non-convex outlines"));
  list.push_back(variant<double>("thesis-atan2", {.arc = Arc::Tangent}, "thesis with atan2 in place of acos"));
  list.push_back(variant<double>("thesis-newell", {.normal = Normal::Newell},
                                 "thesis with the Newell normal in place of the first three vertices"));
  list.push_back(
      variant<double>("thesis-closed", {.comparison = Comparison::Closed}, "thesis in which touching counts"));
}

}  // namespace touchstone::methods
