// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "experiments/cases/method.h"
#include "experiments/methods/registry.h"

namespace touchstone::run_tests {

/// A method that asks another one, by default `exact`, and changes what it says: studies must find a planted error.
class PlantedMethod final : public cases::Method {
 public:
  using Change =
      std::function<cases::PartialAnswer(const cases::PreparedMethod& right, const Ball& ball, cases::QueryKind kind)>;
  using MovingChange = std::function<void(cases::PartialAnswer& answer, const Motion& motion)>;

  explicit PlantedMethod(Change change, std::string_view right = "exact")
      : right_(*methods::find_method(right)), change_(std::move(change)) {}
  /// Changes what is said of moving balls.
  explicit PlantedMethod(MovingChange change, std::string_view right = "exact")
      : right_(*methods::find_method(right)), moving_change_(std::move(change)) {}

  [[nodiscard]] std::string_view name() const override { return "planted"; }
  [[nodiscard]] std::string_view summary() const override { return ""; }
  [[nodiscard]] std::unique_ptr<cases::PreparedMethod> prepare(const Polygon& polygon) const override {
    return std::make_unique<Prepared>(*this, right_.prepare(polygon));
  }

 private:
  class Prepared final : public cases::PreparedMethod {
   public:
    Prepared(const PlantedMethod& method, std::unique_ptr<cases::PreparedMethod> right)
        : method_(method), right_(std::move(right)) {}
    [[nodiscard]] cases::PartialAnswer ask(const Ball& ball, cases::QueryKind kind) const override {
      return method_.change_ ? method_.change_(*right_, ball, kind) : right_->ask(ball, kind);
    }
    [[nodiscard]] std::optional<cases::PartialAnswer> ask_moving(const Motion& motion) const override {
      auto answer = right_->ask_moving(motion);
      if (answer && method_.moving_change_) method_.moving_change_(*answer, motion);
      return answer;
    }

   private:
    const PlantedMethod& method_;
    std::unique_ptr<cases::PreparedMethod> right_;
  };

  const cases::Method& right_;
  Change change_;
  MovingChange moving_change_;
};

}  // namespace touchstone::run_tests
