// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/methods/engines/triangle_method.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "experiments/methods/triangulate.h"

namespace touchstone::methods {
namespace {

class Prepared : public PreparedMethod {
 public:
  Prepared(std::string_view stage, std::unique_ptr<TriangleSet> set) : stage_(stage), set_(std::move(set)) {}

  [[nodiscard]] PartialAnswer ask(const Ball& ball, QueryKind) const override {
    PartialAnswer answer;
    answer.contact = set_->contact(ball);
    answer.unsure = !answer.contact;
    answer.stage = stage_;
    return answer;
  }

  [[nodiscard]] std::optional<PartialAnswer> ask_moving(const Motion& motion) const override {
    if (!set_->sweeps()) return std::nullopt;
    const auto sweep = set_->sweep(motion);
    PartialAnswer answer;
    if (sweep) {
      answer.contact = sweep->touches;
      answer.time = sweep->time;
    }
    answer.unsure = !sweep;
    answer.stage = stage_;
    return answer;
  }

 private:
  std::string_view stage_;
  std::unique_ptr<TriangleSet> set_;
};

/// Tests each triangle separately.
class EachTriangle : public TriangleSet {
 public:
  EachTriangle(std::vector<Triangle> triangles, TriangleContact touches, TriangleSweep sweeps_one)
      : triangles_(std::move(triangles)), touches_(touches), sweep_(sweeps_one) {}

  [[nodiscard]] std::optional<bool> contact(const Ball& ball) const override {
    bool unsure = false;
    for (const Triangle& triangle : triangles_) {
      const auto touched = touches_(ball, triangle);
      if (touched == true) return true;
      if (!touched) unsure = true;
    }
    if (unsure) return std::nullopt;
    return false;
  }

  [[nodiscard]] bool sweeps() const override { return sweep_ != nullptr; }
  [[nodiscard]] std::optional<Sweep> sweep(const Motion& motion) const override {
    Sweep first{false, std::numeric_limits<double>::infinity()};
    bool unsure = false;
    for (const Triangle& triangle : triangles_) {
      const auto swept = sweep_(motion, triangle);
      if (!swept) {
        unsure = true;
      } else if (swept->touches) {
        if (!swept->time) return swept;
        first = {true, std::min(*first.time, *swept->time)};
      } else if (!swept->time) {
        first.time.reset();
      }
    }
    if (unsure && !first.touches) return std::nullopt;
    return first;
  }

 private:
  std::vector<Triangle> triangles_;
  TriangleContact touches_;
  TriangleSweep sweep_;
};

template <class Build>
class Engine : public Method {
 public:
  Engine(std::string_view name, std::string_view summary, Build build)
      : name_(name), summary_(summary), build_(std::move(build)) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string_view summary() const override { return summary_; }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<Prepared>(name_, build_(triangles_of(polygon)));
  }

 private:
  std::string_view name_, summary_;
  Build build_;
};

template <class Build>
std::unique_ptr<Method> engine(std::string_view name, std::string_view summary, Build build) {
  return std::make_unique<Engine<Build>>(name, summary, std::move(build));
}

}  // namespace

std::optional<Sweep> TriangleSet::sweep(const Motion&) const { return std::nullopt; }

std::unique_ptr<Method> triangle_method(std::string_view name, std::string_view summary, TriangleContact contact,
                                        TriangleSweep sweep) {
  return engine(name, summary, [contact, sweep](std::vector<Triangle> triangles) -> std::unique_ptr<TriangleSet> {
    return std::make_unique<EachTriangle>(std::move(triangles), contact, sweep);
  });
}

std::unique_ptr<Method> triangle_set_method(std::string_view name, std::string_view summary, BuildTriangleSet build) {
  return engine(name, summary, build);
}

}  // namespace touchstone::methods
