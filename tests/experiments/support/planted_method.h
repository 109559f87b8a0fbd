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
      : PlantedMethod(std::move(change), nullptr, *methods::find_method(right)) {}
  /// Changes what is said of moving balls.
  explicit PlantedMethod(MovingChange change, std::string_view right = "exact")
      : PlantedMethod(nullptr, std::move(change), *methods::find_method(right)) {}

 private:
  class Prepared final : public cases::PreparedMethod {
   public:
    Prepared(std::unique_ptr<cases::PreparedMethod> right, Change change, MovingChange moving_change)
        : right_(std::move(right)), change_(std::move(change)), moving_change_(std::move(moving_change)) {}
    [[nodiscard]] cases::PartialAnswer ask(const Ball& ball, cases::QueryKind kind) const override {
      return change_ ? change_(*right_, ball, kind) : right_->ask(ball, kind);
    }
    [[nodiscard]] std::optional<cases::PartialAnswer> ask_moving(const Motion& motion) const override {
      auto answer = right_->ask_moving(motion);
      if (answer && moving_change_) moving_change_(*answer, motion);
      return answer;
    }

   private:
    std::unique_ptr<cases::PreparedMethod> right_;
    Change change_;
    MovingChange moving_change_;
  };

  PlantedMethod(const Change& change, const MovingChange& moving_change, const cases::Method& right)
      : Method("planted", "", [change, moving_change, &right](const Polygon& polygon) {
          return std::make_unique<Prepared>(right.prepare(polygon), change, moving_change);
        }) {}
};

}  // namespace touchstone::run_tests
