// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/own_functions.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"

namespace touchstone::methods {
namespace {

/// Names the stage that decided last.
class PreparedFiltered final : public PreparedMethod {
 public:
  explicit PreparedFiltered(const Polygon& polygon) : polygon_(polygon) {}

  PartialAnswer ask(const Ball& ball, QueryKind kind) const override {
    filtered::StageCounts counts;
    PartialAnswer answer = answer_of(ball, kind, polygon_, counts);
    answer.stage = to_string(counts.last());
    return answer;
  }

  std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    filtered::StageCounts counts;
    PartialAnswer answer = answer_of(motion, polygon_, counts);
    answer.stage = to_string(counts.last());
    return answer;
  }

 private:
  filtered::PreparedPolygon polygon_;
};

}  // namespace

void add_exact(MethodList& list) {
  list.push_back(own_method<exact::PreparedPolygon>(
      "exact", "exact", "the truth: CGAL exact arithmetic, correctly rounded point and distance", Method::Kind::Slow));
}

void add_filtered(MethodList& list) {
  list.push_back(std::make_unique<Method>(
      "filtered", "certified: the answers of exact, at the cost of fast except near the boundary",
      [](const Polygon& polygon) { return std::make_unique<PreparedFiltered>(polygon); }));
}

void add_fast(MethodList& list) {
  list.push_back(own_method<fast::PreparedPolygon<double>>("fast", "double",
                                                           "the three tests in plain doubles, carefully written"));
  list.push_back(
      own_method<fast::PreparedPolygon<float>>("fast-float", "float", "the code of fast over 32-bit floats"));
  list.push_back(own_method<fast::PreparedPolygon<long double>>("fast-long-double", "long double",
                                                                "the code of fast over long doubles"));
}

}  // namespace touchstone::methods
