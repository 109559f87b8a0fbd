// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact/fast.h"

#include "experiments/methods/all.h"

namespace touchstone::methods {
namespace {

template <class Scalar>
class PreparedFast final : public PreparedMethod {
 public:
  PreparedFast(const Polygon& polygon, std::string_view stage) : polygon_(polygon), stage_(stage) {}

  PartialAnswer ask(const Ball& ball, Question question) const override {
    PartialAnswer answer;
    switch (question) {
      case Question::Contact: answer.contact = fast::contact(ball, polygon_); break;
      case Question::Relation: answer.relation = fast::relation(ball, polygon_); break;
      case Question::PlaneSide: answer.plane = fast::plane_side(ball, polygon_); break;
      case Question::Foot: answer.foot = fast::foot(ball, polygon_); break;
      case Question::EdgesHit: answer.edges_hit = fast::edges_hit(ball, polygon_); break;
      case Question::Answer: answer = PartialAnswer::of(fast::answer(ball, polygon_), ""); break;
    }
    answer.stage = stage_;
    return answer;
  }

 private:
  fast::PreparedPolygon<Scalar> polygon_;
  std::string_view stage_;
};

template <class Scalar>
class Fast final : public Method {
 public:
  Fast(std::string_view name, std::string_view stage, std::string_view summary)
      : name_(name), stage_(stage), summary_(summary) {}
  std::string_view name() const override { return name_; }
  std::string_view summary() const override { return summary_; }
  std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<PreparedFast<Scalar>>(polygon, stage_);
  }

 private:
  std::string_view name_, stage_, summary_;
};

}  // namespace

void add_fast(std::vector<std::unique_ptr<Method>>& list) {
  list.push_back(std::make_unique<Fast<double>>("fast", "double", "the three tests in plain doubles, carefully written"));
  list.push_back(std::make_unique<Fast<float>>("fast-float", "float", "the code of fast over 32-bit floats"));
  list.push_back(
      std::make_unique<Fast<long double>>("fast-long-double", "long double", "the code of fast over long doubles"));
}

}  // namespace touchstone::methods
